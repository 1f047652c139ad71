#include "play/paint_figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "play/brush.hpp"

namespace flying {

namespace {

constexpr double k_letters = 12.5;                  ///< [pixels]
constexpr double k_edge = 14.0;                     ///< [pixels]
constexpr PixelBox k_roomy{0.0, 0.0, 480.0, 620.0}; ///< as large a surface holds all at their full size [pixels]

struct Curve
{
    const char* name;
    Colour colour;
    std::function<double(const Sample&)> value;
    bool is_dashed = false;
};

/// Curves against time, in a panel; the figure behind each name is its present value.
void paint_strip(cairo_t* cairo, const Stage& stage, const PixelBox& box, const std::vector<Curve>& curves,
                 const char* unit, const Theme& theme)
{
    brush::panel(cairo, box, theme);
    const std::deque<Sample>& samples = stage.watch.samples;
    if (samples.size() < 2) {
        brush::letters(cairo, k_letters);
        brush::use(cairo, theme.ink, 0.7);
        brush::text(cairo, box.left + 10.0, box.top + 18.0, "let time run");
        return;
    }
    double low = 0.0;
    double high = 0.0;
    for (const Sample& sample : samples) {
        for (const Curve& curve : curves) {
            low = std::min(low, curve.value(sample));
            high = std::max(high, curve.value(sample));
        }
    }
    if (!(high - low > 0.0)) high = low + 1.0;
    const PixelBox inside{box.left + 8.0, box.top + 26.0, box.right - 8.0, box.bottom - 8.0};
    const double end = samples.back().time;
    const auto place = [&](double time, double value) {
        return Vec2(inside.right - (end - time) / k_strip_length * inside.width(),
                    inside.bottom - (value - low) / (high - low) * inside.height());
    };
    brush::use(cairo, theme.ink, 0.3);
    cairo_set_line_width(cairo, 1.0);
    const double zero = std::round(place(end, 0.0).y()) + 0.5;
    cairo_move_to(cairo, inside.left, zero);
    cairo_line_to(cairo, inside.right, zero);
    cairo_stroke(cairo);

    double x = box.left + 10.0;
    for (const Curve& curve : curves) {
        const double dashes[] = {5.0, 3.0};
        cairo_set_dash(cairo, dashes, curve.is_dashed ? 2 : 0, 0.0);
        for (const Sample& sample : samples) {
            const Vec2 at = place(sample.time, curve.value(sample));
            cairo_line_to(cairo, at.x(), at.y());
        }
        brush::use(cairo, curve.colour);
        cairo_set_line_width(cairo, 2.0);
        cairo_stroke(cairo);
        cairo_move_to(cairo, x, box.top + 14.0);
        cairo_line_to(cairo, x + 18.0, box.top + 14.0);
        cairo_stroke(cairo);
        cairo_set_dash(cairo, dashes, 0, 0.0);
        brush::letters(cairo, k_letters);
        brush::use(cairo, theme.ink);
        const std::string text = fmt::format("{} {:.4g}{}", curve.name, curve.value(samples.back()),
                                             x > box.left + 11.0 ? std::string() : fmt::format(" {}", unit));
        brush::text(cairo, x + 23.0, box.top + 18.0, text);
        x += 23.0 + brush::text_width(cairo, text) + 14.0;
    }
}

void paint_strips(cairo_t* cairo, const Stage& stage, SurfaceSize size, const Theme& theme)
{
    const double width = std::min(470.0, size.width - 2.0 * k_edge);
    const double left = size.width - k_edge - width;
    const double bottom = size.height - 46.0;
    paint_strip(cairo, stage, {left, bottom - 218.0, left + width, bottom - 108.0},
                {{"total", theme.ink, [](const Sample& s) { return s.kinetic + s.potential; }},
                 {"kinetic", brush::k_vermilion, [](const Sample& s) { return s.kinetic; }},
                 {"potential", brush::k_blue, [](const Sample& s) { return s.potential; }, true}},
                "J", theme);
    paint_strip(cairo, stage, {left, bottom - 100.0, left + width, bottom},
                {{"momentum", theme.ink, [](const Sample& s) { return s.momentum.norm(); }},
                 {"along x", brush::k_vermilion, [](const Sample& s) { return s.momentum.x(); }},
                 {"along y", brush::k_blue, [](const Sample& s) { return s.momentum.y(); }, true}},
                "kg m/s", theme);
}

/// Lines in a panel; returns its lower edge.
double paint_lines(cairo_t* cairo, double left, double top, const std::vector<std::string>& lines, const Theme& theme)
{
    brush::letters(cairo, k_letters);
    double width = 0.0;
    for (const std::string& line : lines) width = std::max(width, brush::text_width(cairo, line));
    const PixelBox box{left, top, left + width + 20.0, top + 17.0 * static_cast<double>(lines.size()) + 14.0};
    brush::panel(cairo, box, theme);
    brush::use(cairo, theme.ink);
    for (std::size_t k = 0; k < lines.size(); ++k) {
        brush::letters(cairo, k_letters, k == 0);
        brush::text(cairo, left + 10.0, top + 19.0 + 17.0 * static_cast<double>(k), lines[k]);
    }
    return box.bottom;
}

std::vector<std::string> cost_lines(const Stage& stage)
{
    const std::deque<double>& frames = stage.watch.frames;
    std::vector<std::string> lines{"cost of a frame"};
    const double span = frames.size() > 1 ? frames.back() - frames.front() : 0.0;
    if (span > 0.0)
        lines.push_back(fmt::format("{:.1f} frames a second", static_cast<double>(frames.size() - 1) / span));
    lines.push_back(fmt::format("simulating {:.2f} ms, drawing {:.2f} ms", 1e3 * stage.clock.mean_simulating,
                                1e3 * stage.clock.mean_drawing));
    lines.push_back(fmt::format("19 frames of 20 within {:.2f} ms and {:.2f} ms",
                                1e3 * stage.watch.simulating.quantile(0.95), 1e3 * stage.watch.drawing.quantile(0.95)));
    lines.push_back(fmt::format("load {:.0f} % of a sixtieth of a second",
                                6e3 * (stage.clock.mean_simulating + stage.clock.mean_drawing)));
    lines.push_back(fmt::format("{} bodies, {} events, {} collisions", stage.run.world().body_count(),
                                stage.run.events(), stage.run.collisions()));
    return lines;
}

std::vector<std::string> plan_lines(const Plan& plan)
{
    std::vector<std::string> lines{"what the plan skips"};
    for (const Skip& skip : plan.skips) {
        const char* kind = skip.kind == SkipClass::neutral   ? "same bits"
                           : skip.kind == SkipClass::ordered ? "same bits, by order"
                                                             : "alters results";
        std::string line = fmt::format("{}  {} ({})", fate_of(skip), skip.name, kind);
        if (skip.active && !skip.saved_unit.empty()) line += fmt::format(": saved {} {}", skip.saved, skip.saved_unit);
        lines.push_back(line);
    }
    return lines;
}

/// What the colours mean, where they mean what moves a body.
void paint_legend(cairo_t* cairo, SurfaceSize size, const Theme& theme)
{
    const char* words[] = {"by events", "by steps", "asleep", "static"};
    const Colour colours[] = {mover_colour(BodyMover::events, theme), mover_colour(BodyMover::rest, theme),
                              mover_colour(BodyMover::asleep, theme), mover_colour(BodyMover::none, theme)};
    brush::letters(cairo, k_letters);
    double width = 10.0;
    for (const char* word : words) width += 20.0 + brush::text_width(cairo, word) + 12.0;
    const PixelBox box{0.5 * (size.width - width), size.height - 36.0, 0.5 * (size.width + width), size.height - 8.0};
    brush::panel(cairo, box, theme);
    double x = box.left + 10.0;
    for (std::size_t k = 0; k < std::size(words); ++k) {
        brush::use(cairo, colours[k]);
        cairo_rectangle(cairo, x, box.top + 8.0, 13.0, 13.0);
        cairo_fill_preserve(cairo);
        brush::use(cairo, theme.ink, 0.7);
        cairo_set_line_width(cairo, 1.0);
        cairo_stroke(cairo);
        brush::use(cairo, theme.ink);
        brush::text(cairo, x + 20.0, box.top + 19.0, words[k]);
        x += 20.0 + brush::text_width(cairo, words[k]) + 12.0;
    }
}

} // namespace

void paint_figures(cairo_t* cairo, const Stage& stage, SurfaceSize size, const Theme& theme)
{
    // On a small surface all shrink, so that none lies on another
    const double scale = std::min({1.0, size.width / k_roomy.width(), size.height / k_roomy.height()});
    if (!(scale > 0.0)) return;
    const SurfaceSize scaled{static_cast<int>(size.width / scale), static_cast<int>(size.height / scale)};
    cairo_save(cairo);
    cairo_scale(cairo, scale, scale);
    double top = k_edge;
    if (stage.look.shows(Layer::costs)) top = paint_lines(cairo, k_edge, top, cost_lines(stage), theme) + 8.0;
    if (stage.look.shows(Layer::plan)) paint_lines(cairo, k_edge, top, plan_lines(stage.watch.plan), theme);
    if (stage.look.shows(Layer::strips)) paint_strips(cairo, stage, scaled, theme);
    if (stage.look.colouring == Colouring::mover) paint_legend(cairo, scaled, theme);
    cairo_restore(cairo);
}

} // namespace flying
