#include "play/brush.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

namespace flying::brush {

void use(cairo_t* cairo, const Colour& colour, double opacity)
{
    cairo_set_source_rgba(cairo, colour.red, colour.green, colour.blue, opacity);
}

void rounded(cairo_t* cairo, const PixelBox& box, double radius)
{
    const double r = std::max(0.0, std::min({radius, 0.5 * box.width(), 0.5 * box.height()}));
    const double quarter = 0.5 * std::numbers::pi;
    cairo_new_sub_path(cairo);
    cairo_arc(cairo, box.right - r, box.top + r, r, -quarter, 0.0);
    cairo_arc(cairo, box.right - r, box.bottom - r, r, 0.0, quarter);
    cairo_arc(cairo, box.left + r, box.bottom - r, r, quarter, 2.0 * quarter);
    cairo_arc(cairo, box.left + r, box.top + r, r, 2.0 * quarter, 3.0 * quarter);
    cairo_close_path(cairo);
}

void panel(cairo_t* cairo, const PixelBox& box, const Theme& theme, double opacity)
{
    rounded(cairo, box, 7.0);
    use(cairo, theme.ground, opacity);
    cairo_fill_preserve(cairo);
    use(cairo, theme.ink, 0.18);
    cairo_set_line_width(cairo, 1.0);
    cairo_stroke(cairo);
}

void add_arrow(cairo_t* cairo, const Vec2& from, const Vec2& to, double width)
{
    const Vec2 way = to - from;
    const double length = way.norm();
    if (!(length > 0.5) || length > 1e5) return;
    const Vec2 along = way / length;
    const Vec2 across = perp(along);
    const double head = std::min(4.5 * width, 0.6 * length);
    const double half = 0.5 * std::min(width, 0.3 * length);
    const Vec2 neck = to - head * along;
    cairo_new_sub_path(cairo);
    for (const Vec2& corner :
         {Vec2(from + half * across), Vec2(neck + half * across), Vec2(neck + 0.45 * head * across), to,
          Vec2(neck - 0.45 * head * across), Vec2(neck - half * across), Vec2(from - half * across)}) {
        cairo_line_to(cairo, corner.x(), corner.y());
    }
    cairo_close_path(cairo);
}

void arrow(cairo_t* cairo, const Vec2& from, const Vec2& to, double width)
{
    cairo_new_path(cairo);
    add_arrow(cairo, from, to, width);
    cairo_fill(cairo);
}

void add_dot(cairo_t* cairo, const Vec2& at, double radius)
{
    cairo_new_sub_path(cairo);
    cairo_arc(cairo, at.x(), at.y(), radius, 0.0, 2.0 * std::numbers::pi);
    cairo_close_path(cairo);
}

void dot(cairo_t* cairo, const Vec2& at, double radius)
{
    add_dot(cairo, at, radius);
    cairo_fill(cairo);
}

void add_circle(cairo_t* cairo, const Vec2& at, double radius, double width)
{
    add_dot(cairo, at, radius + 0.5 * width);
    if (radius <= 0.5 * width) return;
    cairo_new_sub_path(cairo);
    cairo_arc_negative(cairo, at.x(), at.y(), radius - 0.5 * width, 2.0 * std::numbers::pi, 0.0);
    cairo_close_path(cairo);
}

void letters(cairo_t* cairo, double size, bool bold)
{
    cairo_select_font_face(cairo, "sans-serif", CAIRO_FONT_SLANT_NORMAL,
                           bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_font_size(cairo, size);
}

double text_width(cairo_t* cairo, std::string_view text)
{
    cairo_text_extents_t extents{};
    cairo_text_extents(cairo, std::string(text).c_str(), &extents);
    return extents.x_advance;
}

void text(cairo_t* cairo, double x, double y, std::string_view text)
{
    cairo_move_to(cairo, x, y);
    cairo_show_text(cairo, std::string(text).c_str());
    cairo_new_path(cairo); // or the next line would begin where the text has ended
}

Writing::Writing(cairo_t* cairo) : cairo_(cairo), font_(cairo_get_scaled_font(cairo)) {}

double Writing::add_about(double x, double y, std::string_view text)
{
    cairo_glyph_t* glyphs = nullptr;
    int count = 0;
    const int size = static_cast<int>(text.size());
    const cairo_status_t status =
        cairo_scaled_font_text_to_glyphs(font_, 0.0, y, text.data(), size, &glyphs, &count, nullptr, nullptr, nullptr);
    if (status != CAIRO_STATUS_SUCCESS) return 0.0;
    cairo_text_extents_t extents{};
    cairo_scaled_font_glyph_extents(font_, glyphs, count, &extents);
    for (int k = 0; k < count; ++k) {
        glyphs[k].x += x - 0.5 * extents.x_advance;
        glyphs_.push_back(glyphs[k]);
    }
    cairo_glyph_free(glyphs);
    return extents.x_advance;
}

void Writing::show()
{
    cairo_show_glyphs(cairo_, glyphs_.data(), static_cast<int>(glyphs_.size()));
    glyphs_.clear();
}

} // namespace flying::brush
