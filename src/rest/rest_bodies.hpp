#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "collide/separation.hpp"
#include "rest/outline.hpp"
#include "rest/rest_body.hpp"

namespace flying {

/// The bodies of an engine, as arrays in the order in which they lie in memory (rest/body_order.hpp).
struct RestBodies
{
    /// order  for each place in memory, the number by which the body there is known outside
    /// time   of all states [s]
    RestBodies(std::vector<RestBody> bodies, std::vector<int> order, double time);

    [[nodiscard]] int count() const { return static_cast<int>(list.size()); }
    /// A body is where this state says from now on.
    void set_pose(int body, const BodyState& state);
    /// One of two bodies is cut into parts, or both are.
    [[nodiscard]] bool has_cuts(int a, int b) const { return shapes[a].parts.size() + shapes[b].parts.size() > 2; }
    /// What lengths between two bodies are compared with: the bounding radius of the smaller one.  [m]
    [[nodiscard]] double size_of(int a, int b) const { return std::min(radius[a], radius[b]); }
    /// What overlaps of two bodies are compared with: a hundredth of a needle's bounding radius may be half its width.
    /// [m]
    [[nodiscard]] double breadth_of(int a, int b) const { return std::min(breadth[a], breadth[b]); }
    /// Velocity of a body's point.  [m/s]
    [[nodiscard]] Vec2 velocity_of(int body, const Vec2& point) const
    {
        return velocity_at(list[body].state, point - poses[body].position);
    }
    /// A gap below which two bodies touch, for all that rounding tells.  [m]
    [[nodiscard]] double touch_gap(int a, int b) const;
    /// The same at other places.
    [[nodiscard]] double touch_gap(int a, const Vec2& place_a, int b, const Vec2& place_b) const;

    std::vector<RestBody> list;
    std::vector<int> order; ///< of each of them, the number by which it is known outside
    std::vector<int> place; ///< of each such number, its place
    std::vector<CollisionShape> shapes;
    std::vector<Outline> outlines;
    /// Of each body and part: for each edge, whether it is a side of the body and no cut; empty where all are.
    std::vector<std::vector<std::vector<char>>> real_edges;
    std::vector<double> radius;      ///< bounding radii [m]
    std::vector<double> breadth;     ///< the same, or, of slim bodies and such with arms, how stout they are [m]
    std::vector<double> turning;     ///< how far a turn may bring any point of each: the radius, 0 for discs [m]
    std::vector<Pose> poses;         ///< as the step, or a part of one, begins
    std::vector<double> angles;      ///< of the poses [rad]
    std::vector<std::int64_t> moves; ///< how often each was put elsewhere, by as little as a bit

    /// How far each has moved, and turned any point at distance 1, at most, in all.
    struct Travel
    {
        double shift = 0.0; ///< [m]
        double turn = 0.0;
    };
    std::vector<Travel> travel;
    std::vector<char> in_large_island; ///< the body's island was a large one in the last step
};

} // namespace flying
