#pragma once

#include <string_view>
#include <vector>

#include <cairo.h>

#include "draw/layout.hpp"
#include "draw/palette.hpp"

namespace flying {

/// The few strokes of which everything beside the bodies is made.
namespace brush {

/// Colours by which things are told apart, also by those who see fewer hues: Okabe and Ito, "Color Universal Design",
/// 2008.
inline constexpr Colour k_orange{0.902, 0.624, 0.0};
inline constexpr Colour k_sky{0.337, 0.706, 0.914};
inline constexpr Colour k_green{0.0, 0.620, 0.451};
inline constexpr Colour k_yellow{0.941, 0.894, 0.259};
inline constexpr Colour k_blue{0.0, 0.447, 0.698};
inline constexpr Colour k_vermilion{0.835, 0.369, 0.0};
inline constexpr Colour k_purple{0.800, 0.475, 0.655};

void use(cairo_t* cairo, const Colour& colour, double opacity = 1.0);

/// A box with round corners, added to the path.
void rounded(cairo_t* cairo, const PixelBox& box, double radius);

/// A panel to write on.
/// opacity  1 where it lies on other writing
void panel(cairo_t* cairo, const PixelBox& box, const Theme& theme, double opacity = 0.93);

/// From one point to another, with a head that shrinks with it, added to the path: many can be one fill.
/// width  of the shaft [pixels]
void add_arrow(cairo_t* cairo, const Vec2& from, const Vec2& to, double width);
/// The same, filled.
void arrow(cairo_t* cairo, const Vec2& from, const Vec2& to, double width);

/// A disc, added to the path.
void add_dot(cairo_t* cairo, const Vec2& at, double radius);
/// The same, filled.
void dot(cairo_t* cairo, const Vec2& at, double radius);

/// A circle as a fill by the winding rule, added to the path: a stroke would take three times as long.
/// width  of its line, at most twice the radius [pixels]
void add_circle(cairo_t* cairo, const Vec2& at, double radius, double width);

/// Sets the letters' size for what follows. [pixels]
void letters(cairo_t* cairo, double size, bool bold = false);

[[nodiscard]] double text_width(cairo_t* cairo, std::string_view text);

/// Text whose baseline begins there.
void text(cairo_t* cairo, double x, double y, std::string_view text);

/// Many short texts in the letters of the moment it was made, shown at once.
class Writing
{
public:
    explicit Writing(cairo_t* cairo);
    /// Lay out a text about a point of its baseline; returns its width. [pixels]
    double add_about(double x, double y, std::string_view text);
    /// Show all of them in the present colour.
    void show();

private:
    cairo_t* cairo_;
    cairo_scaled_font_t* font_;
    std::vector<cairo_glyph_t> glyphs_;
};

} // namespace brush
} // namespace flying
