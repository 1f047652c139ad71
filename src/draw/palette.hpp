#pragma once

// The colours of pictures: themes for print and for a dark page, and one for each body.

namespace flying {

/// Red, green and blue, each 0 ... 1.
struct Colour
{
    double red = 0.0;
    double green = 0.0;
    double blue = 0.0;
};

/// The colour that lies the part `share` (0 ... 1) of the way from `a` to `b`.
[[nodiscard]] Colour mixed(const Colour& a, const Colour& b, double share);

/// The tones of a picture that are no body's own.
struct Theme
{
    Colour ground;      ///< around everything
    Colour paper;       ///< inside the box
    Colour wall;        ///< the box's walls
    Colour body_static; ///< static bodies
    Colour ink;         ///< writing, and what outlines are darkened towards
    double lightness;   ///< how far body colours are mixed towards white, 0 ... 1
};

/// Warm paper: for print, and wherever nothing else is asked for.
[[nodiscard]] Theme paper_theme();

/// A deep blue ground: for a dark page.
[[nodiscard]] Theme night_theme();

/// Colour of body number `index` >= 0. Ten hues of like weight take turns; each further ten are a shade apart.
[[nodiscard]] Colour body_colour(int index, const Theme& theme);

/// The tone of an outline around a fill.
[[nodiscard]] Colour outline_of(const Colour& fill, const Theme& theme);

} // namespace flying
