#include "draw/picture.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace flying {

namespace {

/// Box of all drawn bodies of one kind; none where there are none.
std::optional<Aabb> extent(const Picture& picture, bool of_static)
{
    std::optional<Aabb> whole;
    for (const DrawnBody& body : picture.bodies) {
        if (body.is_static != of_static || std::holds_alternative<HalfPlane>(body.shape)) continue;
        const Aabb one = bounding_box(body.shape, body.pose);
        whole = whole ? joined(*whole, one) : one;
    }
    return whole;
}

/// The part of `a` that lies in `limits`; they need not meet.
Aabb clamped(const Aabb& a, const Aabb& limits)
{
    return {a.min.cwiseMax(limits.min).cwiseMin(limits.max), a.max.cwiseMin(limits.max).cwiseMax(limits.min)};
}

} // namespace

Aabb joined(const Aabb& a, const Aabb& b)
{
    return {a.min.cwiseMin(b.min), a.max.cwiseMax(b.max)};
}

Aabb fitting_view(const Picture& picture)
{
    if (picture.box) return *picture.box;

    // Show all that moves, and static bodies only where they are near: a floor may be a kilometre long
    Aabb view{Vec2(-1.0, -1.0), Vec2(1.0, 1.0)};
    if (const std::optional<Aabb> moving = extent(picture, false)) {
        view = *moving;
        const Vec2 size = view.max - view.min;
        const double reach = 0.15 * std::max(size.x(), size.y());
        const Aabb neighbourhood{view.min - Vec2(reach, reach), view.max + Vec2(reach, reach)};
        for (const DrawnBody& body : picture.bodies) {
            if (!body.is_static || std::holds_alternative<HalfPlane>(body.shape)) continue;
            const Aabb box = bounding_box(body.shape, body.pose);
            if (overlap(box, neighbourhood)) view = joined(view, clamped(box, neighbourhood));
        }
    } else if (const std::optional<Aabb> standing = extent(picture, true)) {
        view = *standing;
    }
    return view;
}

double trail_width(const Shape& shape)
{
    double radius = 0.0;
    if (const auto* disc = std::get_if<Disc>(&shape)) radius = disc->radius;
    if (const auto* polygon = std::get_if<Polygon>(&shape)) {
        double twice_area = 0.0;
        for (const Edge& edge : polygon->edges()) {
            twice_area += cross(polygon->vertices()[edge.from], polygon->vertices()[edge.to]);
        }
        radius = std::sqrt(0.5 * std::max(0.0, twice_area) / std::numbers::pi);
    }
    return 1.2 * radius;
}

Picture picture_of(const World& world)
{
    Picture picture;
    picture.bodies.reserve(static_cast<std::size_t>(world.body_count()));
    for (int i = 0; i < world.body_count(); ++i) {
        picture.bodies.push_back({world.shape(i), pose_of(world.state(i)), i, world.is_static(i)});
    }
    const auto* central = std::get_if<CentralField>(&world.scene().world.field);
    if (central && central->radius > 0.0) {
        const Pose centre{central->centre, Rotation()};
        picture.bodies.push_back({Disc{central->radius}, centre, world.body_count(), true});
    }
    if (const std::optional<BoxDef>& box = world.scene().world.box) picture.box = Aabb{box->min, box->max};
    picture.title = world.scene().title;
    picture.time = world.time();
    picture.view = fitting_view(picture);
    return picture;
}

void move_bodies(Picture& picture, const World& world)
{
    for (int i = 0; i < world.body_count(); ++i) {
        DrawnBody& body = picture.bodies[static_cast<std::size_t>(i)];
        if (!body.is_static) body.pose = pose_of(world.state(i));
    }
    picture.time = world.time();
}

} // namespace flying
