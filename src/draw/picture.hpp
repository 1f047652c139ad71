#pragma once

#include <optional>
#include <string>
#include <vector>

#include "draw/palette.hpp"
#include "geometry/aabb.hpp"
#include "geometry/shape.hpp"
#include "math/rotation.hpp"
#include "world/world.hpp"

namespace flying {

/// One body as it is to be drawn.
struct DrawnBody
{
    Shape shape;                     ///< about the origin of the pose; a half-plane is not drawn
    Pose pose;                       ///< of the shape in the world
    int colour = 0;                  ///< >= 0: place in the palette, usually the body's number; it goes round
    bool is_static = false;          ///< drawn in the neutral tone
    std::optional<Colour> fill = {}; ///< in place of the palette's
};

/// Where a body has been, oldest point first.
struct Trail
{
    int colour = 0;           ///< as the body's
    double width = 0.0;       ///< at the newest point; it tapers towards the oldest, >= 0 [m]
    std::vector<Vec2> points; ///< [m]
};

/// All that a picture of a scene shows, as plain values: nothing here knows of a world or of Cairo.
struct Picture
{
    std::vector<DrawnBody> bodies;
    std::vector<Trail> trails;
    std::optional<Aabb> box;    ///< inner sides of the box's walls, drawn as a frame
    Aabb view;                  ///< what is to be seen of the world; it gets a margin and grows to the picture's shape
    std::string title;          ///< above the picture; empty for none
    std::optional<double> time; ///< in the caption [s]
    bool has_scale_bar = true;
    bool has_shadows = true;  ///< under the bodies; a third of the time that drawing takes
    bool trails_shine = true; ///< through each other; a fifth of the time that trails take
};

/// The world at its clock, without trails: its bodies in order, then the core of a central field. The view is that of
/// `fitting_view`.
[[nodiscard]] Picture picture_of(const World& world);

/// Put the bodies where the world has them now and set the time; everything else stays.
/// picture  made by `picture_of` from a world of the same scene
void move_bodies(Picture& picture, const World& world);

/// The box where there is one; otherwise the smallest view that holds all bodies that move, with what lies near them
/// of the static ones. Never empty.
[[nodiscard]] Aabb fitting_view(const Picture& picture);

/// A fitting width for a body's trail: six tenths of the disc's diameter that has the shape's area; 0 for a half-plane.
/// [m]
[[nodiscard]] double trail_width(const Shape& shape);

/// Smallest box that holds both.
[[nodiscard]] Aabb joined(const Aabb& a, const Aabb& b);

} // namespace flying
