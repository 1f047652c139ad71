#include "events/encounter.hpp"

#include <algorithm>
#include <cmath>
#include <variant>

#include "math/tolerance.hpp"
#include "response/impacts_at_once.hpp"

namespace flying {
namespace {

[[nodiscard]] ImpactBody impact_body(const BodyRows& bodies, int row)
{
    return {bodies[row].velocity, bodies.sheet(row).spin, bodies.sheet(row).inertia};
}

[[nodiscard]] Material material_of(const BodyRows& bodies, const Encounter& one)
{
    return combine(bodies.sheet(one.a).material, bodies.sheet(one.b).material);
}

/// A body after an impact; it stands where it would be slower than any search could follow.
[[nodiscard]] Push::Motion motion_after(int row, const Vec2& velocity, double spin)
{
    const double top = std::max({std::abs(velocity.x()), std::abs(velocity.y()), std::abs(spin)});
    if (top < tolerance::k_least_speed) return {row, Vec2::Zero(), 0.0};
    return {row, velocity, spin};
}

/// They touch corner on corner, and nowhere else.
[[nodiscard]] bool is_at_corner(const Encounter& one)
{
    return one.meeting.touches.size() == 1 && one.meeting.touches.front().feature.kind == FeatureKind::corner;
}

void push_together(const BodyRows& bodies, std::span<const Encounter> all, Push& push)
{
    // Two corners that meet may slide past each other, if others push first
    const bool all_at_corners = std::all_of(all.begin(), all.end(), is_at_corner);
    std::vector<ImpactPair> pairs;
    std::vector<ImpactPoint> points;
    std::vector<double> slowest;
    for (const Encounter& one : all) {
        const std::size_t first = points.size();
        if (all_at_corners || !is_at_corner(one))
            points.insert(points.end(), one.meeting.points.begin(), one.meeting.points.end());
        slowest.resize(points.size(), tolerance::k_approach * (bodies.top_speed(one.a) + bodies.top_speed(one.b)));
        pairs.push_back({one.a, one.b, first, points.size(), material_of(bodies, one)});
    }
    const std::vector<int> rows = number_anew(pairs);
    std::vector<ImpactBody> struck;
    for (const int row : rows) struck.push_back(impact_body(bodies, row));
    push.impacts = resolve_impacts(struck, pairs, points, slowest, 1);
    push.ended = true;
    push.motions.clear();
    for (std::size_t k = 0; k < rows.size(); ++k)
        push.motions.push_back(motion_after(rows[k], struck[k].velocity, struck[k].spin));
}

} // namespace

const Event* meet(BodyRows& bodies, const StaticSurfaces& surfaces, std::span<const Event> impacts,
                  std::span<Encounter> encounters)
{
    // [events.impact.meet]
    // Bring the two bodies of each impact, and no other, to its moment
    const double time = impacts[0].time;
    for (std::size_t k = 0; k < impacts.size(); ++k) {
        Encounter& one = encounters[k];
        one.impact = impacts[k];
        one.a = bodies.row_of(impacts[k].a);
        one.b = bodies.row_of(impacts[k].b);
        one.since = time_since_impact(bodies, one.a, one.b, time);
        one.bounces_end.reset();
        one.stays = false;
    }
    std::vector<int> moved; // of a group, whose members are brought there once
    const auto move = [&](int row) {
        const bool has_moved = bodies.move_to(row, time);
        if (has_moved && impacts.size() > 1) moved.push_back(row);
        return has_moved || std::find(moved.begin(), moved.end(), row) != moved.end();
    };
    for (std::size_t k = 0; k < impacts.size(); ++k) {
        Encounter& one = encounters[k];
        const bool a_moved = move(one.a);
        const bool b_moved = move(one.b);
        one.moved = a_moved || b_moved;
        if (bodies.has_spun_out(one.a) || bodies.has_spun_out(one.b)) return &impacts[k];
    }
    for (Encounter& one : encounters) find_meeting(bodies, surfaces, one.a, one.b, time, one.meeting);
    // [events.impact.meet]
    return nullptr;
}

bool judge_room(const BodyRows& bodies, double shortest_bounce, Encounter& one)
{
    // [events.impact.crowding]
    // Where neither went anywhere since its last impact, or next to nowhere, or they creep
    // into each other, both are being crowded; a heavy body that hardly moves between the
    // blows of a light one is not
    const bool is_held = one.since.last() < shortest_bounce && is_cramped(bodies, one.a, one.b, one.meeting, one.since);
    const bool creeps = is_creeping(bodies, one.a, one.b, one.meeting);
    one.has_room = !creeps && one.moved;
    // [events.impact.crowding]

    one.sinks = false;
    if (one.has_room) return !is_held;

    // Each of many impacts at one moment may come late by a rounding. Beyond the tolerance of touching, what has
    // come behind a side would be lost to the search
    const auto is_polygon = [&](int body) { return std::holds_alternative<Polygon>(bodies.shape_of(body)); };
    const auto is_wall = [&](int body) { return std::holds_alternative<HalfPlane>(bodies.shape_of(body)); };
    const bool has_sides = (is_polygon(one.a) && !is_wall(one.b)) || (is_polygon(one.b) && !is_wall(one.a));
    const auto is_deep = [&](const Touch& point) { return point.separation < -0.5 * one.meeting.touch; };
    one.sinks = has_sides && std::any_of(one.meeting.touches.begin(), one.meeting.touches.end(), is_deep);
    return false;
}

void push_apart(const BodyRows& bodies, std::span<const Encounter> encounters, Push& push)
{
    if (encounters.size() > 1) {
        push_together(bodies, encounters, push);
        return;
    }

    // [events.impact.push]
    const Encounter& one = encounters[0];
    const ImpactResult result = resolve_impact(impact_body(bodies, one.a), impact_body(bodies, one.b),
                                               one.meeting.points, material_of(bodies, one));
    // [events.impact.push]
    push.impacts = result.any_push ? 1 : 0;
    push.ended = result.ended;
    push.motions.assign(
        {motion_after(one.a, result.velocity_a, result.spin_a), motion_after(one.b, result.velocity_b, result.spin_b)});
}

} // namespace flying
