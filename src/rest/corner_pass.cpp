#include "rest/corner_pass.hpp"

#include <algorithm>

#include "collide/ways_out.hpp"
#include "rest/rest_tolerance.hpp"

namespace flying {

bool comes_near(const RestData& data, const RestPair& pair, double approach)
{
    const double field = std::max(data.motion.field_size[pair.a], data.motion.field_size[pair.b]);
    return approach > rest_tolerance::k_still * data.options.step * field;
}

std::optional<Vec2> side_at_passing(const RestData& data, const RestPair& pair, const Manifold& manifold,
                                    const Pose& pose_a, const Pose& pose_b)
{
    const double near = rest_tolerance::k_closed * data.bodies.size_of(pair.a, pair.b);
    const Contact& contact = manifold.contacts[0];
    if (manifold.count == 0 || contact.separation > near) return std::nullopt;
    if (manifold.count == 2 && (manifold.contacts[1].point - contact.point).squaredNorm() > near * near)
        return std::nullopt;
    const auto velocity_of = [&](int body, const Pose& pose) {
        return velocity_at(data.bodies.list[body].state, contact.point - pose.position);
    };
    const Vec2 velocity = velocity_of(pair.b, pose_b) - velocity_of(pair.a, pose_a);
    if (!comes_near(data, pair, -contact.normal.dot(velocity))) return std::nullopt;

    const double touch = data.bodies.touch_gap(pair.a, pose_a.position, pair.b, pose_b.position);
    const auto is_here = [&](const Outline::Corner& corner, const Vec2& point) {
        return (corner.place - point).squaredNorm() <= near * near;
    };
    const Pose b_from_a = relative_pose(pose_b, pose_a);
    const Vec2 seen_by_a = inverse(pose_a.rotation) * Vec2(contact.point - pose_a.position);
    const Vec2 seen_by_b = inverse(pose_b.rotation) * Vec2(contact.point - pose_b.position);
    for (const Outline::Corner& a : data.bodies.outlines[pair.a].corners()) {
        if (!is_here(a, seen_by_a)) continue;
        for (const Outline::Corner& b : data.bodies.outlines[pair.b].corners()) {
            if (!is_here(b, seen_by_b)) continue;
            const WaysOut of_a = b_from_a.rotation * WaysOut{a.before, a.after};
            const std::optional<Vec2> side =
                side_slid_along(of_a, {b.before, b.after}, b.place - b_from_a * a.place,
                                inverse(pose_b.rotation) * velocity, touch);
            if (side) return pose_b.rotation * *side;
        }
    }
    return std::nullopt;
}

} // namespace flying
