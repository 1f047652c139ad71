#include "play/panels.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "play/brush.hpp"
#include "play/keys.hpp"

namespace flying {

namespace {

constexpr double k_panel_letters = 14.0; ///< [pixels]
constexpr double k_margin = 14.0;        ///< of panels from the edge [pixels]
constexpr double k_inside = 10.0;        ///< of writing from its panel's edge [pixels]

/// A line of text in a panel, its middle above there.
void paint_pill(cairo_t* cairo, double middle, double top, const std::string& text, const Theme& theme,
                const Colour* mark)
{
    brush::letters(cairo, k_panel_letters);
    const double width = brush::text_width(cairo, text) + 2.0 * k_inside + (mark ? 16.0 : 0.0);
    const PixelBox box{middle - 0.5 * width, top, middle + 0.5 * width, top + 28.0};
    brush::panel(cairo, box, theme);
    double x = box.left + k_inside;
    if (mark) {
        brush::use(cairo, *mark);
        brush::dot(cairo, Vec2(x + 5.0, top + 14.0), 5.0);
        x += 16.0;
    }
    brush::use(cairo, theme.ink);
    brush::text(cairo, x, top + 19.0, text);
}

/// How time runs, where it isn't simply.
void paint_clock(cairo_t* cairo, const Stage& stage, SurfaceSize size, const Theme& theme)
{
    const double middle = 0.5 * size.width;
    if (stage.clock.is_paused) {
        const std::string speed = stage.clock.speed == 1.0 ? "" : ", " + speed_text(stage.clock.speed);
        paint_pill(cairo, middle, k_margin, "paused" + speed, theme, &brush::k_orange);
    } else if (stage.clock.is_behind()) {
        paint_pill(
            cairo, middle, k_margin,
            fmt::format("can't keep up: {:.0f} % of {}", 100.0 * stage.clock.share, speed_text(stage.clock.speed)),
            theme, &brush::k_vermilion);
    } else if (stage.clock.speed != 1.0) {
        paint_pill(cairo, middle, k_margin, "time runs at " + speed_text(stage.clock.speed), theme, nullptr);
    }
}

/// The bar of the restitution, as long as e.
void paint_restitution(cairo_t* cairo, const Stage& stage, SurfaceSize size, const Theme& theme)
{
    const double e = stage.run.scene().world.restitution;
    const PixelBox box{k_margin, size.height - 104.0, k_margin + 260.0, size.height - 50.0};
    brush::panel(cairo, box, theme);
    brush::letters(cairo, k_panel_letters);
    brush::use(cairo, theme.ink);
    brush::text(cairo, box.left + k_inside, box.top + 20.0, fmt::format("restitution e = {:g}", e));
    const PixelBox bar{box.left + k_inside, box.top + 30.0, box.right - k_inside, box.top + 42.0};
    brush::rounded(cairo, bar, 3.0);
    brush::use(cairo, theme.ink, 0.15);
    cairo_fill(cairo);
    brush::rounded(cairo, {bar.left, bar.top, bar.left + std::max(1.0, e * bar.width()), bar.bottom}, 3.0);
    brush::use(cairo, brush::k_orange);
    cairo_fill(cairo);
}

/// The gravity as a line with a dot at its end, or a central field's strength in figures.
void paint_gravity(cairo_t* cairo, const Stage& stage, SurfaceSize size, const Theme& theme)
{
    const Field& field = stage.run.scene().world.field;
    const auto* central = std::get_if<CentralField>(&field);
    const double height = central ? 90.0 : 120.0;
    const PixelBox box{k_margin, size.height - 50.0 - height, k_margin + 260.0, size.height - 50.0};
    brush::panel(cairo, box, theme);
    brush::letters(cairo, k_panel_letters);
    brush::use(cairo, theme.ink);
    const double x = box.left + k_inside;
    if (central) {
        brush::text(cairo, x, box.top + 24.0, "central field");
        brush::text(cairo, x, box.top + 52.0, fmt::format("strength {:.4g} m\u00b3/s\u00b2   (up, down)", central->mu));
        brush::text(cairo, x, box.top + 76.0, fmt::format("radius {:.3g} m   (left, right)", central->radius));
        return;
    }
    const Vec2 gravity = uniform_acceleration(field);
    brush::text(cairo, x, box.top + 20.0, fmt::format("gravity ({:.3g}, {:.3g}) m/s\u00b2", gravity.x(), gravity.y()));
    const Vec2 middle(0.5 * (box.left + box.right), 0.5 * (box.top + box.bottom) + 8.0);
    const double most = 40.0;
    const double length = most * (1.0 - std::exp(-gravity.norm() / (10.0 * gravity_step(stage))));
    const double size_of = gravity.norm();
    const Vec2 end = size_of > 0.0 ? Vec2(middle + (length / size_of) * Vec2(gravity.x(), -gravity.y())) : middle;
    cairo_move_to(cairo, middle.x(), middle.y());
    cairo_line_to(cairo, end.x(), end.y());
    brush::use(cairo, theme.ink);
    cairo_set_line_width(cairo, 3.0);
    cairo_stroke(cairo);
    brush::use(cairo, brush::k_orange);
    brush::dot(cairo, end, 5.0);
}

/// Cut to lines no longer than the width.
std::vector<std::string> wrapped(cairo_t* cairo, const std::string& text, double width)
{
    std::vector<std::string> lines(1);
    std::size_t at = 0;
    while (at < text.size()) {
        const std::size_t end = std::min(text.find(' ', at), text.size());
        const std::string word = text.substr(at, end - at);
        const std::string longer = lines.back().empty() ? word : lines.back() + " " + word;
        if (!lines.back().empty() && brush::text_width(cairo, longer) > width) lines.push_back(word);
        else lines.back() = longer;
        at = end + 1;
    }
    return lines;
}

void paint_notice(cairo_t* cairo, const Stage& stage, SurfaceSize size, const Theme& theme)
{
    if (stage.notice.text.empty() || stage.now >= stage.notice.until) return;
    brush::letters(cairo, k_panel_letters);
    const double widest = std::min(760.0, size.width - 4.0 * k_margin);
    const std::vector<std::string> lines = wrapped(cairo, stage.notice.text, widest);
    double width = 0.0;
    for (const std::string& line : lines) width = std::max(width, brush::text_width(cairo, line));
    const double height = 20.0 * static_cast<double>(lines.size()) + 12.0;
    const double left = 0.5 * (size.width - width) - k_inside;
    const PixelBox box{left, size.height - 46.0 - height, left + width + 2.0 * k_inside, size.height - 46.0};
    brush::panel(cairo, box, theme);
    if (stage.notice.is_fault) {
        cairo_rectangle(cairo, box.left, box.top + 6.0, 4.0, height - 12.0);
        brush::use(cairo, brush::k_vermilion);
        cairo_fill(cairo);
    }
    brush::use(cairo, theme.ink);
    for (std::size_t k = 0; k < lines.size(); ++k) {
        brush::text(cairo, box.left + k_inside, box.top + 21.0 + 20.0 * static_cast<double>(k), lines[k]);
    }
}

void paint_help(cairo_t* cairo, SurfaceSize size, const Theme& theme)
{
    std::vector<const Binding*> rows;
    for (const Binding& binding : bindings()) {
        if (!binding.what.empty()) rows.push_back(&binding);
    }
    brush::letters(cairo, 13.0);
    double keys = 0.0;
    double words = 0.0;
    for (const Binding* row : rows) {
        keys = std::max(keys, brush::text_width(cairo, row->shown));
        words = std::max(words, brush::text_width(cairo, row->what));
    }

    // The columns with which letters can be the largest; in a small window all shrink
    const double line = 21.0;
    const double column = keys + words + 40.0;
    std::size_t per_column = rows.size();
    double scale = 0.0;
    double width = 0.0;
    double height = 0.0;
    for (std::size_t columns = 1; columns <= 5; ++columns) {
        const std::size_t longest = (rows.size() + columns - 1) / columns;
        const double wide = static_cast<double>(columns) * column + 2.0 * k_inside;
        const double high = line * static_cast<double>(longest) + 30.0;
        const double fits = std::min({1.0, (size.width - 8.0) / wide, (size.height - 8.0) / high});
        if (fits <= scale) continue;
        scale = fits;
        per_column = longest;
        width = wide;
        height = high;
    }
    if (!(scale > 0.0)) return;
    cairo_save(cairo);
    cairo_translate(cairo, 0.5 * size.width, 0.5 * size.height);
    cairo_scale(cairo, scale, scale);
    const PixelBox box{-0.5 * width, -0.5 * height, 0.5 * width, 0.5 * height};
    brush::panel(cairo, box, theme, 1.0);
    for (std::size_t k = 0; k < rows.size(); ++k) {
        const double x = box.left + 2.0 * k_inside + static_cast<double>(k / per_column) * column;
        const double y = box.top + 27.0 + line * static_cast<double>(k % per_column);
        brush::letters(cairo, 13.0, true);
        brush::use(cairo, theme.ink);
        brush::text(cairo, x, y, rows[k]->shown);
        brush::letters(cairo, 13.0);
        brush::use(cairo, theme.ink, 0.85);
        brush::text(cairo, x + keys + 16.0, y, rows[k]->what);
    }
    cairo_restore(cairo);
}

} // namespace

std::string speed_text(double speed)
{
    if (speed >= 1.0) return fmt::format("{:g}x", std::round(10.0 * speed) / 10.0);
    return fmt::format("1/{:g}x", std::round(10.0 / speed) / 10.0);
}

void paint_panels(cairo_t* cairo, const Stage& stage, SurfaceSize size, const Theme& theme)
{
    cairo_set_line_join(cairo, CAIRO_LINE_JOIN_ROUND);
    paint_clock(cairo, stage, size, theme);
    if (stage.now < stage.mode_until) {
        if (stage.arrow_keys == ArrowKeys::restitution) paint_restitution(cairo, stage, size, theme);
        if (stage.arrow_keys == ArrowKeys::gravity) paint_gravity(cairo, stage, size, theme);
    }
    paint_notice(cairo, stage, size, theme);
    if (stage.look.shows(Layer::help)) paint_help(cairo, size, theme);
}

} // namespace flying
