#include "draw/layout.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace flying {

namespace {

constexpr double k_side = 3.2;    ///< margin left and right [units]
constexpr double k_bare = 3.2;    ///< margin above and below where nothing is written [units]
constexpr double k_written = 5.6; ///< margin above and below where something is [units]
constexpr double k_flattest = 2.4;
constexpr double k_air = 0.06; ///< around the bodies where no box holds them, of the view's longer side

double top_margin(const Picture& picture)
{
    return picture.title.empty() ? k_bare : k_written;
}

double bottom_margin(const Picture& picture)
{
    return picture.time || picture.has_scale_bar ? k_written : k_bare;
}

/// The view with the air around it, of a size that is not nothing.
Aabb aired(const Picture& picture)
{
    Aabb view = picture.view;
    const Vec2 size = view.max - view.min;
    double longest = std::max(size.x(), size.y());
    if (!(longest > 0.0) || !std::isfinite(longest)) longest = 1.0;

    // A row of balls must not become a strip: neither side under a fifth of the other
    const Vec2 least(std::max(0.0, 0.2 * longest - size.x()), std::max(0.0, 0.2 * longest - size.y()));
    const double air = picture.box ? 0.0 : k_air * longest;
    const Vec2 more = 0.5 * (picture.box ? Vec2(Vec2::Zero()) : least) + Vec2(air, air);
    return {view.min - more, view.max + more};
}

int even(double length)
{
    return 2 * static_cast<int>(std::lround(0.5 * length));
}

std::string formatted(const char* format, double number, const char* unit)
{
    std::array<char, 64> text{};
    std::snprintf(text.data(), text.size(), format, number, unit);
    return text.data();
}

} // namespace

SurfaceSize fitting_size(const Picture& picture, int longest)
{
    const Aabb view = aired(picture);
    const Vec2 size = view.max - view.min;
    const double ratio = size.y() / size.x();
    const double unit = longest / 100.0;
    const double across = 2.0 * k_side * unit;
    const double down = (top_margin(picture) + bottom_margin(picture)) * unit;

    // Fill the width, or else the height
    double width = longest;
    double height = (width - across) * ratio + down;
    if (height > longest) {
        height = longest;
        width = (height - down) / ratio + across;
    }
    const double least = longest / k_flattest;
    return {even(std::max(width, least)), even(std::max(height, least))};
}

Layout layout_of(const Picture& picture, SurfaceSize size)
{
    Layout layout;
    layout.unit = std::max(size.width, size.height) / 100.0;
    layout.panel = {k_side * layout.unit, top_margin(picture) * layout.unit, size.width - k_side * layout.unit,
                    size.height - bottom_margin(picture) * layout.unit};

    // Equal scale in x and y, centred
    const Aabb view = aired(picture);
    const Vec2 extent = view.max - view.min;
    const double scale = std::min(layout.panel.width() / extent.x(), layout.panel.height() / extent.y());
    const Vec2 middle = 0.5 * view.min + 0.5 * view.max;
    const double middle_x = 0.5 * (layout.panel.left + layout.panel.right);
    const double middle_y = 0.5 * (layout.panel.top + layout.panel.bottom);
    layout.map.scale = scale;
    layout.map.origin = Vec2(middle_x - scale * middle.x(), middle_y + scale * middle.y());
    return layout;
}

ViewMap view_map(const Picture& picture, SurfaceSize size)
{
    return layout_of(picture, size).map;
}

double round_length(double length)
{
    const double power = std::pow(10.0, std::floor(std::log10(length)));
    for (const double step : {5.0, 2.0}) {
        if (step * power <= length) return step * power;
    }
    return power;
}

std::string length_text(double length)
{
    // The rounding up before the comparison keeps 0.01 m, which is no sum of powers of two, from becoming 10 mm
    const double nearly = 1.0 + 1e-9;
    if (length * nearly >= 1e6 || length * nearly < 1e-6) return formatted("%.0e %s", length, "m");
    if (length * nearly >= 1e3) return formatted("%.0f %s", length / 1e3, "km");
    if (length * nearly >= 1.0) return formatted("%.0f %s", length, "m");
    if (length * nearly >= 1e-2) return formatted("%.0f %s", length / 1e-2, "cm");
    if (length * nearly >= 1e-3) return formatted("%.0f %s", length / 1e-3, "mm");
    return formatted("%.0f %s", length / 1e-6, "µm");
}

std::string time_text(double time)
{
    const double size = std::abs(time);
    if (size != 0.0 && (size < 0.1 || size >= 1e5)) return formatted("t = %.3e %s", time, "s");
    return formatted("t = %.2f %s", time, "s");
}

} // namespace flying
