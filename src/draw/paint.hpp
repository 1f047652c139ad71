#pragma once

#include <cstddef>

#include <cairo.h>

#include "draw/palette.hpp"
#include "draw/picture.hpp"

namespace flying {

/// Size of a drawing surface.
struct SurfaceSize
{
    int width = 0;  ///< > 0 [pixels, or points in SVG and PDF]
    int height = 0; ///< > 0
};

/// The size that suits a picture's view: its longer side is `longest`, the sides' ratio is the view's, though never
/// narrower or flatter than 1 : 2.4; both sides even, as video wants them.
/// longest  >= 64 [pixels]
[[nodiscard]] SurfaceSize fitting_size(const Picture& picture, int longest);

/// How points of the world come to lie on a surface: equal scale in x and y, y up in the world and down on the surface.
struct ViewMap
{
    double scale = 1.0;         ///< [pixels/m]
    Vec2 origin = Vec2::Zero(); ///< where the world's origin lies [pixels]

    [[nodiscard]] Vec2 operator()(const Vec2& world) const
    {
        return Vec2(origin.x() + scale * world.x(), origin.y() - scale * world.y());
    }
    /// The point of the world at a point of the surface.
    [[nodiscard]] Vec2 world_at(const Vec2& pixel) const
    {
        return Vec2((pixel.x() - origin.x()) / scale, (origin.y() - pixel.y()) / scale);
    }
};

/// The map that `paint` uses for this picture on a surface of this size.
[[nodiscard]] ViewMap view_map(const Picture& picture, SurfaceSize size);

/// How finely edges are smoothed: coarsely, in half the time, where there are many things to draw.
void smooth_edges(cairo_t* cairo, std::size_t things);

/// Draw the whole picture, ground and all, on a surface of this size.
/// cairo  fresh or restored to its initial transformation; its state comes back as it was
void paint(cairo_t* cairo, const Picture& picture, SurfaceSize size, const Theme& theme);

} // namespace flying
