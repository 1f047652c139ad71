#pragma once

#include "math/random.hpp"
#include "math/rotation.hpp"
#include "motion/body.hpp"
#include "motion/flight.hpp"
#include "toi/bend.hpp"

namespace flying {


/// A vertex of a body P that flies and turns, and an edge of a body Q that does: the gap between them.
struct TwoFlyers
{
    BodyState p;
    BodyState q;
    Vec2 acceleration = Vec2::Zero(); ///< of P [m/s^2]
    Vec2 vertex = Vec2::Zero();       ///< of P, from its centre, in its own frame [m]

    /// The normal of the edge, which lies half a metre along it from Q's centre. Q's own frame has it along y.
    [[nodiscard]] double gap(double time) const
    {
        const BodyState p_then = flight(p, acceleration, time);
        const BodyState q_then = flight(q, Vec2::Zero(), time);
        const Vec2 n = Rotation::of(q_then.angle) * Vec2(0.0, 1.0);
        const Vec2 at_vertex = p_then.position + Rotation::of(p_then.angle) * vertex;
        const Vec2 at_edge = q_then.position + 0.5 * n;
        return n.dot(at_vertex - at_edge);
    }


    struct AtEdge
    {
        Vec2 n; ///< the normal
        Vec2 u; ///< velocity of the vertex [m/s]
        Vec2 w; ///< velocity of the point that moves with Q where the vertex is [m/s]
    };
    [[nodiscard]] AtEdge at_edge(double time) const
    {
        const BodyState p_then = flight(p, acceleration, time);
        const BodyState q_then = flight(q, Vec2::Zero(), time);
        const Vec2 arm = Rotation::of(p_then.angle) * vertex;
        const Vec2 from_q = p_then.position + arm - q_then.position;
        return {Rotation::of(q_then.angle) * Vec2(0.0, 1.0), velocity_at(p_then, arm), velocity_at(q_then, from_q)};
    }

    /// First and second derivative of the gap by differences, fourth order in the step.
    [[nodiscard]] double rate_by_differences(double t) const
    {
        constexpr double h = 1.0 / 512.0;
        return (8.0 * (gap(t + h) - gap(t - h)) - (gap(t + 2 * h) - gap(t - 2 * h))) / (12.0 * h);
    }
    [[nodiscard]] double bend_by_differences(double t) const
    {
        constexpr double h = 1.0 / 256.0;
        const double near = gap(t + h) + gap(t - h);
        const double far = gap(t + 2 * h) + gap(t - 2 * h);
        return (16.0 * near - far - 30.0 * gap(t)) / (12.0 * h * h);
    }

    /// The engine's bound, at the moment.
    [[nodiscard]] double bend_bound() const
    {
        const double distance = (p.position - q.position).norm();
        const double speed = (p.velocity - q.velocity).norm();
        return bend_of_point(acceleration.norm(), speed, distance, vertex.norm(), p.spin, q.spin);
    }
};

inline TwoFlyers random_two(Random& random)
{
    const auto vector = [&](double size) {
        const double x = random.uniform(-size, size);
        return Vec2(x, random.uniform(-size, size));
    };
    TwoFlyers two;
    two.p.position = vector(2.0);
    two.p.velocity = vector(2.0);
    two.p.angle = random.uniform(-3.0, 3.0);
    two.p.spin = random.uniform(-3.0, 3.0);
    two.q.position = vector(2.0);
    two.q.velocity = vector(2.0);
    two.q.angle = random.uniform(-3.0, 3.0);
    two.q.spin = random.uniform(-3.0, 3.0);
    two.acceleration = vector(2.0);
    two.vertex = vector(1.0);
    return two;
}

} // namespace flying
