#pragma once

#include "collide/separating_axis.hpp"
#include "shadows.hpp"
#include "wrong_edge.hpp"

namespace flying {

/// What decides along which normal the squares push each other.
enum class Rule
{
    greatest_separation,
    nearest_edge
};

/// Two equal squares of side 1 that meet with 1 m/s each.
struct HeadOn
{
    Pose pose_a = placed(-1.01, 0.0);
    Pose pose_b = placed(1.01, 0.0);
    Vec2 v_a = Vec2(1.0, 0.0); ///< [m/s]
    Vec2 v_b = Vec2(-1.0, 0.0);

    // [separating-axis.head_on]
    /// Fly for a moment; where the squares overlap and approach, exchange their speeds
    /// along the normal.
    void step(Rule rule, double dt)
    {
        pose_a.position += dt * v_a;
        pose_b.position += dt * v_b;
        const Polygon square = box_of(1.0, 1.0);
        const Axis axis =
            greatest_separation(square, square, relative_pose(pose_a, pose_b));
        if (axis.separation > 0.0) return;
        const Vec2 n_best = axis.owner == Owner::a ? square.edges()[axis.edge].normal
                                                   : -square.edges()[axis.edge].normal;
        const Vec2 n = rule == Rule::greatest_separation
                           ? n_best
                           : wrong_normal(square, pose_a, square, pose_b);
        const double approach = n.dot(v_b - v_a);
        if (approach >= 0.0) return;
        v_a += approach * n;
        v_b -= approach * n;
    }
    // [separating-axis.head_on]
};

} // namespace flying
