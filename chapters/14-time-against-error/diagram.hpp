#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "record.hpp"
#include "support/sketch.hpp"

/// Draws what a run of the benchmarks wrote down.
namespace flying::work {

using namespace flying::sketch;

/// How a curve looks.
struct Look
{
    Tone tone = k_soft;
    double width = 2.2;
    bool is_hollow = false; ///< marks are rings, the line is dashed
};

[[nodiscard]] inline Look look_of(const std::string& engine)
{
    if (engine == "flying" || engine == "from wall to wall") return {k_teal, 3.2, false};
    if (engine == "flying, kept awake") return {k_teal, 2.0, false};
    if (engine.starts_with("flying")) return {k_teal, 2.0, true};
    if (engine == "Chipmunk") return {k_ochre, 2.2, false};
    if (engine.starts_with("Chipmunk")) return {k_ochre, 2.0, true};
    if (engine == "Box2D") return {k_rust, 2.2, false};
    if (engine.starts_with("Box2D")) return {k_rust, 2.0, true};
    if (engine == "Siconos, sweeps") return {k_blue, 2.2, false};
    if (engine.starts_with("Siconos")) return {k_blue, 2.0, true};
    if (engine == "doubles") return {k_teal, 2.2, false};
    if (engine == "floats") return {k_rust, 2.2, true};
    if (engine == "Verlet") return {k_blue, 2.0, false};
    if (engine == "symplectic Euler") return {k_blue, 2.0, true};
    return {k_soft, 2.0, false};
}

/// What stands below this is drawn on the lower edge: exact to the last bit has no logarithm.
inline constexpr double k_least_error = 1e-16;
/// What stands above is drawn on the upper edge: a ball that has left the room.
inline constexpr double k_most_error = 1e3;

[[nodiscard]] inline double shown_error(double error)
{
    return std::clamp(error, k_least_error, k_most_error);
}

/// Powers of ten that enclose all values.
[[nodiscard]] inline Vec2 decades(const std::vector<double>& values)
{
    double low = 1e300;
    double high = 1e-300;
    for (const double value : values) {
        low = std::min(low, value);
        high = std::max(high, value);
    }
    if (low > high) return Vec2(0.0, 1.0);
    const double first = std::floor(std::log10(low) + 1e-9);
    const double last = std::ceil(std::log10(high) - 1e-9);
    return Vec2(first, std::max(last, first + 1.0));
}

/// Every how many decades a label fits.
[[nodiscard]] inline int label_step(const Vec2& range, int most)
{
    return std::max(1, static_cast<int>(std::ceil((range.y() - range.x()) / most)));
}

/// Curves of time (to the right) and another number (upwards), both on powers of ten.
class Panel
{
public:
    struct Spot
    {
        double x, low, high; ///< the middle, and a bar from low to high
        double y;
        bool is_cut = false; ///< beyond the edge at which it is drawn
    };
    struct Curve
    {
        std::string name;
        std::vector<Spot> spots;
    };

    Panel(Sketch& sketch, std::vector<Curve> curves, const Vec2& corner, const Vec2& size)
        : sketch_(sketch), curves_(std::move(curves)), corner_(corner), size_(size)
    {
        std::vector<double> xs;
        std::vector<double> ys;
        for (const Curve& curve : curves_) {
            for (const Spot& spot : curve.spots) {
                xs.push_back(spot.x);
                ys.push_back(spot.y);
            }
        }
        x_ = decades(xs);
        y_ = decades(ys);
    }

    void draw(const std::string& along, const std::string& up) const
    {
        const Vec2 low_left(corner_.x() + 62.0, corner_.y() + size_.y() - 46.0);
        const Vec2 up_right(corner_.x() + size_.x() - 26.0, corner_.y() + 28.0);
        const LogPlot plot(sketch_, low_left, up_right, Vec2(x_.x(), y_.x()), Vec2(x_.y(), y_.y()));
        plot.axes(label_step(x_, 6), label_step(y_, 7));
        sketch_.words(Vec2(up_right.x(), low_left.y() + 42.0), along, Anchor::right, k_soft, 14.0);
        sketch_.words(Vec2(corner_.x() + 6.0, corner_.y() + 16.0), up, Anchor::left, k_soft, 14.0);
        for (const Curve& curve : curves_) {
            const Look look = look_of(curve.name);
            std::vector<Vec2> line;
            for (const Spot& spot : curve.spots) {
                const Vec2 at = plot.at(spot.x, spot.y);
                line.push_back(at);
                sketch_.line(plot.at(spot.low, spot.y), plot.at(spot.high, spot.y), pale(look.tone, 0.55), 5.0);
            }
            for (std::size_t k = 0; k + 1 < line.size(); ++k) {
                if (look.is_hollow) sketch_.dashed(line[k], line[k + 1], look.tone, look.width);
                else sketch_.line(line[k], line[k + 1], look.tone, look.width);
            }
            for (std::size_t k = 0; k < line.size(); ++k) mark(line[k], look, curve.spots[k].is_cut);
        }
    }

    /// The names of the curves, in columns.
    void legend(const Vec2& corner, double column, int columns) const
    {
        for (std::size_t k = 0; k < curves_.size(); ++k) {
            const Vec2 at =
                corner + Vec2(column * static_cast<double>(k % columns), 21.0 * static_cast<double>(k / columns));
            const Look look = look_of(curves_[k].name);
            if (look.is_hollow) sketch_.dashed(at, at + Vec2(26.0, 0.0), look.tone, look.width);
            else sketch_.line(at, at + Vec2(26.0, 0.0), look.tone, look.width);
            mark(at + Vec2(13.0, 0.0), look, false);
            sketch_.words(at + Vec2(34.0, 5.0), curves_[k].name, Anchor::left, k_ink, 14.0);
        }
    }
    [[nodiscard]] double legend_height(int columns) const
    {
        return 21.0 * static_cast<double>((curves_.size() + columns - 1) / columns);
    }

private:
    void mark(const Vec2& at, const Look& look, bool is_cut) const
    {
        constexpr Tone k_paper{0xffffff, 1.0};
        if (is_cut) {
            sketch_.polygon({at + Vec2(-6.0, -4.0), at + Vec2(6.0, -4.0), at + Vec2(0.0, 6.0)}, look.tone, k_none);
            return;
        }
        sketch_.disc(at, look.width > 3.0 ? 5.5 : 4.0, look.is_hollow ? k_paper : look.tone, look.tone, 1.6);
    }

    Sketch& sketch_;
    std::vector<Curve> curves_;
    Vec2 corner_;
    Vec2 size_;
    Vec2 x_;
    Vec2 y_;
};

/// What a diagram shows by one of its measures.
[[nodiscard]] inline std::vector<Panel::Curve> curves_of(const DiagramRecord& diagram, std::size_t measure)
{
    std::vector<Panel::Curve> curves;
    for (const CurveRecord& curve : diagram.curves) {
        Panel::Curve shown{curve.engine, {}};
        for (const PointRecord& point : curve.points) {
            const double error = point.measures.at(measure);
            if (error < 0.0) continue; // the engine doesn't tell
            shown.spots.push_back({point.seconds.median, point.seconds.low, point.seconds.high, shown_error(error),
                                   error < k_least_error});
        }
        if (!shown.spots.empty()) curves.push_back(std::move(shown));
    }
    return curves;
}

/// One diagram on a sheet of its own.
inline void draw_diagram(const std::string& path, const DiagramRecord& diagram, std::size_t measure = 0)
{
    constexpr double k_width = 560.0;
    constexpr double k_plot = 380.0;
    const std::vector<Panel::Curve> curves = curves_of(diagram, measure);
    const double rows = std::ceil(static_cast<double>(curves.size()) / 2.0);
    Sketch sketch(path, k_width, k_plot + 16.0 + 21.0 * rows);
    const Panel panel(sketch, curves, Vec2(0.0, 0.0), Vec2(k_width, k_plot));
    panel.draw("seconds of computing", diagram.measures.at(measure));
    panel.legend(Vec2(62.0, k_plot + 14.0), 250.0, 2);
}

/// Seconds against size, with the exponent of each curve's larger half.
inline void draw_growth(const std::string& path, const GrowthRecord& growth)
{
    constexpr double k_width = 560.0;
    constexpr double k_plot = 360.0;
    std::vector<Panel::Curve> curves;
    std::vector<std::string> names;
    for (const auto& [engine, points] : growth.curves) {
        Panel::Curve curve{engine, {}};
        for (const auto& [size, seconds] : points) curve.spots.push_back({size, size, size, seconds, false});
        curves.push_back(std::move(curve));
    }
    Sketch sketch(path, k_width, k_plot + 16.0 + 21.0 * std::ceil(static_cast<double>(curves.size()) / 2.0));
    const Panel panel(sketch, curves, Vec2(0.0, 0.0), Vec2(k_width, k_plot));
    panel.draw("bodies", growth.what);
    panel.legend(Vec2(62.0, k_plot + 14.0), 250.0, 2);
}

/// The best of the peers' points, whatever their curves.
[[nodiscard]] inline std::vector<Point> peers_points(const DiagramRecord& diagram)
{
    std::vector<Point> all;
    for (const CurveRecord& curve : diagram.curves) {
        if (!is_peer(curve.engine)) continue;
        for (const Point& point : points_of(diagram, curve.engine)) all.push_back(point);
    }
    return all;
}

/// Our time over the best peer's, at every error that a peer reaches: a row for each scene.
inline void draw_ratios(const std::string& path, const Records& records)
{
    constexpr double k_row = 27.0;
    constexpr double k_left = 214.0;
    constexpr double k_right = 546.0;
    constexpr double k_low = -5.0;
    constexpr double k_high = 2.0;
    const auto rows = std::count_if(records.diagrams.begin(), records.diagrams.end(), is_race);
    const double height = 72.0 + k_row * static_cast<double>(rows);
    Sketch sketch(path, 560.0, height);
    const auto x = [&](double ratio) {
        const double log = std::clamp(std::log10(ratio), k_low, k_high);
        return k_left + (log - k_low) / (k_high - k_low) * (k_right - k_left);
    };
    for (int power = static_cast<int>(k_low); power <= static_cast<int>(k_high); ++power) {
        const double at = x(std::pow(10.0, power));
        sketch.line(Vec2(at, 12.0), Vec2(at, height - 54.0), power == 0 ? k_ink : pale(k_soft, 0.3),
                    power == 0 ? 1.8 : 1.0);
        const std::string label =
            power == 0   ? "1"
            : power == 1 ? "10"
                         : "10^{" + std::string(power < 0 ? "\u2212" : "") + std::to_string(std::abs(power)) + "}";
        sketch.formula(Vec2(at, height - 30.0), label, Anchor::middle, k_ink, 18.0);
    }
    sketch.words(Vec2(k_right, height - 4.0), "our time over the best peer's", Anchor::right, k_soft, 18.0);
    double y = 24.0;
    for (const DiagramRecord& diagram : records.diagrams) {
        if (!is_race(diagram)) continue;
        sketch.words(Vec2(k_left - 12.0, y + 6.0), diagram.name, Anchor::right, k_ink, 18.0);
        sketch.line(Vec2(k_left, y), Vec2(k_right, y), pale(k_soft, 0.25), 1.0);
        const std::vector<Point> ours = our_points(diagram);
        for (const Ratio& ratio : ratios(ours, peers_points(diagram))) {
            if (!ratio.ours_over_theirs) {
                sketch.words(Vec2(k_right - 4.0, y + 5.0), "\u00d7", Anchor::middle, k_rust, 16.0);
                continue;
            }
            sketch.disc(Vec2(x(*ratio.ours_over_theirs), y), 4.0,
                        pale(*ratio.ours_over_theirs < 1.0 ? k_teal : k_rust, 0.55), k_none);
        }
        y += k_row;
    }
}

/// A row for each scene, a column for each skip: time without it as a multiple of that with all. Other bits have a
/// frame.
inline void draw_skips(const std::string& path, const Records& records)
{
    constexpr double k_row = 24.0;
    constexpr double k_left = 196.0;
    std::vector<std::string> names;
    for (const SkipsRecord& skips : records.skips) {
        for (const SkipsRecord::Entry& entry : skips.entries) {
            if (!entry.without.empty() && std::find(names.begin(), names.end(), entry.without) == names.end()) {
                names.push_back(entry.without);
            }
        }
    }
    const double column = (556.0 - k_left) / std::max(1.0, static_cast<double>(names.size()));
    const double keys = std::ceil(static_cast<double>(names.size()) / 3.0);
    const double bottom = 30.0 + k_row * static_cast<double>(records.skips.size());
    Sketch sketch(path, 560.0, bottom + 22.0 + 20.0 * keys);
    const auto x = [&](std::size_t k) { return k_left + (static_cast<double>(k) + 0.5) * column; };
    for (std::size_t k = 0; k < names.size(); ++k) {
        const std::string letter(1, static_cast<char>('a' + k));
        sketch.words(Vec2(x(k), 16.0), letter, Anchor::middle, k_ink, 14.0);
        const Vec2 at(10.0 + 186.0 * static_cast<double>(k % 3), bottom + 24.0 + 20.0 * static_cast<double>(k / 3));
        sketch.words(at, letter + "  " + names[k], Anchor::left, k_ink, 14.0);
    }
    double y = 36.0;
    for (const SkipsRecord& skips : records.skips) {
        sketch.words(Vec2(k_left - 8.0, y + 5.0), skips.scene, Anchor::right, k_ink, 13.0);
        for (const SkipsRecord::Entry& entry : skips.entries) {
            if (entry.without.empty()) continue;
            const auto place =
                static_cast<std::size_t>(std::find(names.begin(), names.end(), entry.without) - names.begin());
            const double factor = entry.seconds.median / skips.entries.front().seconds.median;
            const double depth = std::clamp(std::abs(std::log10(factor)) / 1.5, 0.0, 1.0);
            const Tone fill = factor > 1.0 ? pale(k_teal, 0.08 + 0.6 * depth) : pale(k_ochre, 0.08 + 0.6 * depth);
            sketch.polygon(box(Vec2(x(place), y), column - 4.0, k_row - 4.0), fill, entry.same_bits ? k_none : k_rust,
                           2.0);
            sketch.words(Vec2(x(place), y + 4.5), text_of(factor < 9.95 ? "%.1f" : "%.0f", factor), Anchor::middle,
                         k_ink, 12.0);
        }
        y += k_row;
    }
}

} // namespace flying::work
