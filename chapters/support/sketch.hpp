#pragma once

#include <cairo-svg.h>
#include <cmath>
#include <cstdio>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

#include "math/vec2.hpp"

/// A drawing on an SVG of its own: points in pixels, y down, writing that keeps to one size. For figures of chapters.
namespace flying::sketch {

/// Red, green and blue as 0xRRGGBB, and how much they cover.
struct Tone
{
    unsigned code = 0x2c2d38;
    double cover = 1.0;
};

inline constexpr Tone k_ink{0x2c2d38, 1.0};
inline constexpr Tone k_soft{0x69717a, 1.0};
inline constexpr Tone k_rust{0xc8501e, 1.0};
inline constexpr Tone k_teal{0x22737a, 1.0};
inline constexpr Tone k_ochre{0xd9982a, 1.0};
inline constexpr Tone k_amber{0x966510, 1.0}; ///< the same for letters and thin lines, which would be too pale
inline constexpr Tone k_blue{0x3f62a3, 1.0};
inline constexpr Tone k_none{0x000000, 0.0};

inline Tone pale(Tone tone, double cover = 0.22)
{
    return {tone.code, cover};
}

/// Where a label's point lies in it.
enum class Anchor
{
    left,
    middle,
    right
};

/// A number as printf writes it.
inline std::string text_of(const char* format, double value)
{
    char text[64];
    std::snprintf(text, sizeof text, format, value);
    return text;
}

class Sketch
{
public:
    Sketch(const std::string& path, double width, double height)
        : surface_(cairo_svg_surface_create(path.c_str(), width, height)), cairo_(cairo_create(surface_))
    {
        cairo_set_line_join(cairo_, CAIRO_LINE_JOIN_ROUND);
        cairo_set_line_cap(cairo_, CAIRO_LINE_CAP_ROUND);
    }
    ~Sketch()
    {
        cairo_destroy(cairo_);
        cairo_surface_destroy(surface_);
    }
    Sketch(const Sketch&) = delete;
    Sketch& operator=(const Sketch&) = delete;

    void line(const Vec2& a, const Vec2& b, Tone tone = k_ink, double width = 1.6) { path({a, b}, tone, width); }

    void dashed(const Vec2& a, const Vec2& b, Tone tone = k_soft, double width = 1.4)
    {
        const double dash[] = {5.0, 5.0};
        cairo_set_dash(cairo_, dash, 2, 0.0);
        line(a, b, tone, width);
        cairo_set_dash(cairo_, nullptr, 0, 0.0);
    }

    void path(const std::vector<Vec2>& points, Tone tone = k_ink, double width = 1.6)
    {
        trace(points);
        stroke(tone, width);
    }

    void polygon(const std::vector<Vec2>& points, Tone fill, Tone edge = k_ink, double width = 1.6)
    {
        trace(points);
        cairo_close_path(cairo_);
        paint(fill, edge, width);
    }

    /// Between two angles, counter-clockwise as seen. The whole circle if none are given.
    void disc(const Vec2& centre, double radius, Tone fill, Tone edge = k_ink, double width = 1.6)
    {
        cairo_new_path(cairo_);
        cairo_arc(cairo_, centre.x(), centre.y(), radius, 0.0, 2.0 * std::numbers::pi);
        paint(fill, edge, width);
    }
    void arc(const Vec2& centre, double radius, double from, double to, Tone tone = k_ink, double width = 1.4)
    {
        cairo_new_path(cairo_);
        cairo_arc_negative(cairo_, centre.x(), centre.y(), radius, -from, -to);
        stroke(tone, width);
    }
    void ring(const Vec2& centre, double inner, double outer, Tone fill, Tone edge = k_ink, double width = 1.6)
    {
        cairo_new_path(cairo_);
        cairo_arc(cairo_, centre.x(), centre.y(), outer, 0.0, 2.0 * std::numbers::pi);
        cairo_new_sub_path(cairo_);
        cairo_arc_negative(cairo_, centre.x(), centre.y(), inner, 2.0 * std::numbers::pi, 0.0);
        cairo_close_path(cairo_);
        paint(fill, edge, width);
    }

    void arrow(const Vec2& from, const Vec2& to, Tone tone = k_ink, double width = 2.0)
    {
        const Vec2 along = (to - from).normalized();
        const Vec2 across(-along.y(), along.x());
        const double head = 4.0 + 2.6 * width;
        const Vec2 neck = to - head * along;
        line(from, neck, tone, width);
        polygon({to, neck + 0.45 * head * across, neck - 0.45 * head * across}, tone, k_none);
    }

    /// A span with a bar at either end.
    void measure(const Vec2& a, const Vec2& b, Tone tone = k_soft)
    {
        const Vec2 along = (b - a).normalized();
        const Vec2 across = 5.0 * Vec2(-along.y(), along.x());
        line(a, b, tone, 1.2);
        line(a - across, a + across, tone, 1.2);
        line(b - across, b + across, tone, 1.2);
    }

    /// Plain words.
    void words(const Vec2& at, const std::string& text, Anchor anchor = Anchor::middle, Tone tone = k_ink,
               double size = 16.0)
    {
        cairo_select_font_face(cairo_, "DejaVu Sans", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
        cairo_set_font_size(cairo_, size);
        set(tone);
        cairo_move_to(cairo_, at.x() - share(anchor) * advance(text), at.y());
        cairo_show_text(cairo_, text.c_str());
    }

    /// A symbol or a short formula in slanted letters; what follows `_` or `^`, a letter or a group in braces, is
    /// lowered or raised.
    void formula(const Vec2& at, const std::string& text, Anchor anchor = Anchor::middle, Tone tone = k_ink,
                 double size = 19.0)
    {
        set(tone);
        const double width = run_formula(Vec2::Zero(), text, size, false);
        run_formula(Vec2(at.x() - share(anchor) * width, at.y()), text, size, true);
    }

private:
    static double share(Anchor anchor) { return anchor == Anchor::left ? 0.0 : anchor == Anchor::middle ? 0.5 : 1.0; }

    double advance(const std::string& text)
    {
        cairo_text_extents_t extents;
        cairo_text_extents(cairo_, text.c_str(), &extents);
        return extents.x_advance;
    }

    double run_formula(const Vec2& at, const std::string& text, double size, bool draw)
    {
        double x = at.x();
        std::size_t k = 0;
        const auto unit = [&] { // one character, of however many bytes
            std::size_t end = k + 1;
            while (end < text.size() && (static_cast<unsigned char>(text[end]) & 0xc0u) == 0x80u) ++end;
            std::string one = text.substr(k, end - k);
            k = end;
            return one;
        };
        while (k < text.size()) {
            std::string piece = unit();
            double drop = 0.0;
            double scale = 1.0;
            if (piece == "_" || piece == "^") {
                drop = piece == "_" ? 0.22 * size : -0.38 * size;
                scale = 0.72;
                if (text[k] == '{') {
                    const std::size_t close = text.find('}', k);
                    piece = text.substr(k + 1, close - k - 1);
                    k = close + 1;
                } else {
                    piece = unit();
                }
            }
            const bool letter =
                std::isalpha(static_cast<unsigned char>(piece[0])) != 0 || piece[0] == '\xce' || piece[0] == '\xcf';
            cairo_select_font_face(cairo_, "DejaVu Serif", letter ? CAIRO_FONT_SLANT_ITALIC : CAIRO_FONT_SLANT_NORMAL,
                                   CAIRO_FONT_WEIGHT_NORMAL);
            cairo_set_font_size(cairo_, scale * size);
            if (draw) {
                cairo_move_to(cairo_, x, at.y() + drop);
                cairo_show_text(cairo_, piece.c_str());
            }
            x += advance(piece);
        }
        return x - at.x();
    }

    void set(Tone tone)
    {
        cairo_set_source_rgba(cairo_, ((tone.code >> 16) & 0xffu) / 255.0, ((tone.code >> 8) & 0xffu) / 255.0,
                              (tone.code & 0xffu) / 255.0, tone.cover);
    }
    void trace(const std::vector<Vec2>& points)
    {
        cairo_new_path(cairo_);
        for (const Vec2& p : points) cairo_line_to(cairo_, p.x(), p.y());
    }
    void stroke(Tone tone, double width)
    {
        set(tone);
        cairo_set_line_width(cairo_, width);
        cairo_stroke(cairo_);
    }
    void paint(Tone fill, Tone edge, double width)
    {
        set(fill);
        if (edge.cover == 0.0) {
            cairo_fill(cairo_);
            return;
        }
        cairo_fill_preserve(cairo_);
        stroke(edge, width);
    }

    cairo_surface_t* surface_;
    cairo_t* cairo_;
};

/// Points of a rectangle about a centre.
inline std::vector<Vec2> box(const Vec2& centre, double width, double height)
{
    const Vec2 x(0.5 * width, 0.0);
    const Vec2 y(0.0, 0.5 * height);
    return {centre - x - y, centre + x - y, centre + x + y, centre - x + y};
}

/// Axes of powers of ten, and what belongs on them.
class LogPlot
{
public:
    LogPlot(Sketch& sketch, const Vec2& low_left, const Vec2& up_right, const Vec2& low, const Vec2& high)
        : sketch_(sketch), a_(low_left), b_(up_right), low_(low), high_(high)
    {
    }

    /// Where a point of positive values lies.
    [[nodiscard]] Vec2 at(double x, double y) const
    {
        const double u = (std::log10(x) - low_.x()) / (high_.x() - low_.x());
        const double v = (std::log10(y) - low_.y()) / (high_.y() - low_.y());
        return Vec2(a_.x() + u * (b_.x() - a_.x()), a_.y() + v * (b_.y() - a_.y()));
    }

    /// Lines at the powers of ten; every `step`th is labelled.
    void axes(int step_x, int step_y) const
    {
        const auto ten = [](int k) {
            std::string text = std::to_string(k);
            if (k < 0) text = "\u2212" + text.substr(1);
            return k == 0 ? std::string("1") : k == 1 ? std::string("10") : "10^{" + text + "}";
        };
        for (int k = static_cast<int>(low_.x()); k <= static_cast<int>(high_.x()); ++k) {
            const double x = at(std::pow(10.0, k), 1.0).x();
            sketch_.line(Vec2(x, a_.y()), Vec2(x, b_.y()), pale(k_soft, 0.3), 1.0);
            if (k % step_x == 0) sketch_.formula(Vec2(x, a_.y() + 24.0), ten(k), Anchor::middle, k_ink, 16.0);
        }
        for (int k = static_cast<int>(low_.y()); k <= static_cast<int>(high_.y()); ++k) {
            if (k % step_y != 0) continue;
            const double y = at(1.0, std::pow(10.0, k)).y();
            sketch_.line(Vec2(a_.x(), y), Vec2(b_.x(), y), pale(k_soft, 0.3), 1.0);
            sketch_.formula(Vec2(a_.x() - 9.0, y + 6.0), ten(k), Anchor::right, k_ink, 16.0);
        }
        sketch_.line(a_, Vec2(b_.x(), a_.y()), k_soft, 1.4);
        sketch_.line(a_, Vec2(a_.x(), b_.y()), k_soft, 1.4);
    }

    /// The values of a function at points a constant ratio apart.
    void curve(double from, double to, const std::function<double(double)>& value, Tone tone) const
    {
        std::vector<Vec2> points;
        for (int k = 0; k <= 120; ++k) {
            const double x = from * std::pow(to / from, k / 120.0);
            points.push_back(at(x, value(x)));
        }
        sketch_.path(points, tone, 2.6);
    }

    void dot(double x, double y, Tone tone) const { sketch_.disc(at(x, y), 4.5, tone, k_none); }

private:
    Sketch& sketch_;
    Vec2 a_;
    Vec2 b_;
    Vec2 low_;
    Vec2 high_;
};

} // namespace flying::sketch
