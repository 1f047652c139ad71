#pragma once

#include <cairo-svg.h>
#include <cairo.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "math/vec2.hpp"

/// A small drawing board over Cairo: world coordinates with y up, lines as long as their
/// points, words beside them.
namespace flying::board {

struct Ink
{
    double red, green, blue;
};

inline constexpr Ink k_dark{0.20, 0.22, 0.25};
inline constexpr Ink k_grey{0.42, 0.46, 0.51};
inline constexpr Ink k_faint{0.83, 0.85, 0.87};
inline constexpr Ink k_blue{0.12, 0.44, 0.71};
inline constexpr Ink k_orange{0.77, 0.32, 0.09};
inline constexpr Ink k_green{0.17, 0.51, 0.32};
inline constexpr Ink k_violet{0.50, 0.29, 0.60};
inline constexpr Ink k_sun{0.93, 0.66, 0.14};

/// Where words stand from their point: 0 left of them, 0.5 centred, 1 right of them.
struct Words
{
    double along = 0.0;
    double size = 19.0; ///< [points]
};

class Canvas
{
public:
    /// An SVG of the given size that shows the world from `low` on, y up.   scale
    /// [points/m]
    Canvas(const std::string& path, double width, double height, const Vec2& low,
           double scale)
        : height_(height),
          low_(low),
          scale_(scale),
          surface_(cairo_svg_surface_create(path.c_str(), width, height)),
          cairo_(cairo_create(surface_))
    {
        cairo_set_line_join(cairo_, CAIRO_LINE_JOIN_ROUND);
        cairo_set_line_cap(cairo_, CAIRO_LINE_CAP_ROUND);
        cairo_select_font_face(cairo_, "sans-serif", CAIRO_FONT_SLANT_NORMAL,
                               CAIRO_FONT_WEIGHT_NORMAL);
    }
    ~Canvas()
    {
        cairo_destroy(cairo_);
        cairo_surface_destroy(surface_);
    }
    Canvas(const Canvas&) = delete;
    Canvas& operator=(const Canvas&) = delete;

    [[nodiscard]] Vec2 at(const Vec2& p) const
    {
        return Vec2(scale_ * (p.x() - low_.x()), height_ - scale_ * (p.y() - low_.y()));
    }

    void ink(const Ink& c, double opacity = 1.0)
    {
        cairo_set_source_rgba(cairo_, c.red, c.green, c.blue, opacity);
    }

    void line(const std::vector<Vec2>& points, double width = 2.0, bool dashed = false)
    {
        path(points);
        stroke(width, dashed);
    }
    void area(const std::vector<Vec2>& points)
    {
        path(points);
        cairo_fill(cairo_);
    }
    void dot(const Vec2& p, double radius)
    {
        const Vec2 q = at(p);
        cairo_arc(cairo_, q.x(), q.y(), radius, 0.0, 2.0 * std::numbers::pi);
        cairo_fill(cairo_);
    }
    void ring(const Vec2& p, double radius, double width = 1.5, bool dashed = false)
    {
        const Vec2 q = at(p);
        cairo_new_sub_path(cairo_);
        cairo_arc(cairo_, q.x(), q.y(), radius, 0.0, 2.0 * std::numbers::pi);
        stroke(width, dashed);
    }
    /// A piece of a circle of `radius` points about p, from one angle to another.
    void arc(const Vec2& p, double radius, double from, double to, double width = 1.5)
    {
        const Vec2 q = at(p);
        cairo_new_sub_path(cairo_);
        cairo_arc_negative(cairo_, q.x(), q.y(), radius, -from, -to);
        stroke(width, false);
    }
    void arrow(const Vec2& from, const Vec2& to, double width = 2.0)
    {
        const Vec2 a = at(from);
        const Vec2 b = at(to);
        const double length = (b - a).norm();
        if (length < 1.0) return;
        const Vec2 d = (b - a) / length;
        const Vec2 n = perp(d);
        const double head = std::min(10.0, 0.5 * length);
        const Vec2 foot = b - head * d;
        cairo_move_to(cairo_, a.x(), a.y());
        cairo_line_to(cairo_, foot.x(), foot.y());
        stroke(width, false);
        cairo_move_to(cairo_, b.x(), b.y());
        cairo_line_to(cairo_, foot.x() + 0.42 * head * n.x(),
                      foot.y() + 0.42 * head * n.y());
        cairo_line_to(cairo_, foot.x() - 0.42 * head * n.x(),
                      foot.y() - 0.42 * head * n.y());
        cairo_close_path(cairo_);
        cairo_fill(cairo_);
    }
    /// Words beside p, moved by some points to the right and up.
    void words(const Vec2& p, const std::string& text, const Vec2& shift = Vec2(0.0, 0.0),
               Words how = {})
    {
        const Vec2 q = at(p);
        cairo_set_font_size(cairo_, how.size);
        cairo_text_extents_t extents;
        cairo_text_extents(cairo_, text.c_str(), &extents);
        cairo_move_to(cairo_, q.x() + shift.x() - how.along * extents.x_advance,
                      q.y() - shift.y() + 0.35 * how.size);
        cairo_show_text(cairo_, text.c_str());
    }

private:
    void path(const std::vector<Vec2>& points)
    {
        cairo_new_path(cairo_);
        for (const Vec2& p : points) {
            const Vec2 q = at(p);
            cairo_line_to(cairo_, q.x(), q.y());
        }
    }
    void stroke(double width, bool dashed)
    {
        const double dashes[] = {5.0, 5.0};
        cairo_set_dash(cairo_, dashes, dashed ? 2 : 0, 0.0);
        cairo_set_line_width(cairo_, width);
        cairo_stroke(cairo_);
    }

    double height_;
    Vec2 low_;
    double scale_;
    cairo_surface_t* surface_;
    cairo_t* cairo_;
};

} // namespace flying::board
