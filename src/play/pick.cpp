#include "play/pick.hpp"

#include <algorithm>

#include "collide/separation.hpp"
#include "geometry/aabb.hpp"
#include "world/start_overlaps.hpp"

namespace flying {

bool holds(const Shape& shape, const Vec2& local)
{
    if (const auto* disc = std::get_if<Disc>(&shape)) return local.norm() <= disc->radius;
    const auto* polygon = std::get_if<Polygon>(&shape);
    if (!polygon) return false;

    // A ray to the right leaves as often as it enters, plus once where it starts inside
    bool is_inside = false;
    for (const Edge& edge : polygon->edges()) {
        const Vec2& from = polygon->vertices()[static_cast<std::size_t>(edge.from)];
        const Vec2& to = polygon->vertices()[static_cast<std::size_t>(edge.to)];
        if ((from.y() > local.y()) == (to.y() > local.y())) continue;
        const double x = from.x() + (local.y() - from.y()) / (to.y() - from.y()) * (to.x() - from.x());
        if (local.x() < x) is_inside = !is_inside;
    }
    return is_inside;
}

int body_at(const World& world, const Vec2& point, double near)
{
    for (int k = world.body_count() - 1; k >= 0; --k) {
        const Pose pose = pose_of(world.state(k));
        if (holds(world.shape(k), inverse(pose.rotation) * Vec2(point - pose.position))) return k;
    }
    int best = -1;
    for (int k = 0; k < world.body_count(); ++k) {
        const double distance = (world.state(k).position - point).norm();
        if (distance >= near) continue;
        near = distance;
        best = k;
    }
    return best;
}

std::optional<std::string> obstacle(const World& world, const Shape& shape, const Pose& pose, int except)
{
    const double size = bounding_radius(shape);
    const Aabb box = bounding_box(shape, pose);
    const double allowed = start_overlap_allowed(size, pose.position.norm() + size);
    const WorldDef& around = world.scene().world;
    if (around.box) {
        const Vec2 low = around.box->min - box.min;
        const Vec2 high = box.max - around.box->max;
        if (std::max(low.maxCoeff(), high.maxCoeff()) > allowed) return "the box";
    }
    const auto* central = std::get_if<CentralField>(&around.field);
    if (central && pose.position == central->centre) return "the field's centre";
    if (central && central->radius > 0.0 &&
        separation(shape, pose, Disc{central->radius}, {central->centre, Rotation()}) < -allowed) {
        return "the field's core";
    }
    for (int k = 0; k < world.body_count(); ++k) {
        if (k == except) continue;
        const Pose other = pose_of(world.state(k));
        if (!overlap(box, bounding_box(world.shape(k), other))) continue;
        const double least = std::min(size, bounding_radius(world.shape(k)));
        const double room = start_overlap_allowed(least, pose.position.norm() + other.position.norm() + least);
        if (separation(shape, pose, world.shape(k), other) < -room) return body_label(world.scene(), k);
    }
    return std::nullopt;
}

} // namespace flying
