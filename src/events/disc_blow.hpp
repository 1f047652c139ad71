#pragma once

#include <algorithm>
#include <optional>

#include "events/body_rows.hpp"
#include "math/exact.hpp"
#include "math/tolerance.hpp"

namespace flying {

/// What an impact makes of two discs.
struct DiscBlow
{
    Vec2 position_a = Vec2::Zero(); ///< at the impact, like the rest
    Vec2 position_b = Vec2::Zero();
    Vec2 velocity_a = Vec2::Zero(); ///< after it
    Vec2 velocity_b = Vec2::Zero();
    double overlap = 0.0; ///< below 0 where rounding leaves them apart [m]
};

/// How two bodies strike each other that are discs on straight paths, neither rub nor spin, and hardly touch: what most
/// large scenes are made of. The numbers are those that any two bodies get, to the bit. Nothing where they are anything
/// else.
///
/// a, b  rows
/// time  of the impact [s]
[[nodiscard]] inline std::optional<DiscBlow> blow_of_discs(const BodyRows& bodies, int a, int b, double time)
{
    const BodyRows::Row& row_a = bodies[a];
    const BodyRows::Row& row_b = bodies[b];
    if (row_a.kind != BodyRows::Kind::disc || row_b.kind != BodyRows::Kind::disc) return std::nullopt;
    const BodyRows::Sheet& sheet_a = bodies.sheet(a);
    const BodyRows::Sheet& sheet_b = bodies.sheet(b);
    if (sheet_a.spin != 0.0 || sheet_b.spin != 0.0) return std::nullopt;
    if (sheet_a.material.friction * sheet_b.material.friction != 0.0) return std::nullopt;
    if (bodies.has_spun_out(a) || bodies.has_spun_out(b)) return std::nullopt;

    // Bring them to the moment; leave to others what hardly moved, or does not quite touch
    const double t_a = time - row_a.time;
    const double t_b = time - row_b.time;
    if (!(row_a.velocity.norm() * t_a > tolerance::k_touch * row_a.radius) &&
        !(row_b.velocity.norm() * t_b > tolerance::k_touch * row_b.radius)) {
        return std::nullopt;
    }
    DiscBlow blow;
    blow.position_a = row_a.position + t_a * row_a.velocity;
    blow.position_b = row_b.position + t_b * row_b.velocity;
    const Vec2 b_to_a = blow.position_a - blow.position_b;
    const double distance = b_to_a.norm();
    const double gap = distance - (row_a.radius + row_b.radius);
    if (!(gap <= tolerance::k_touch * std::min(row_a.radius, row_b.radius)) || distance == 0.0) return std::nullopt;
    blow.overlap = -gap;

    // Push along the line of centres, which has no arms: nothing turns
    const Vec2 normal = -b_to_a / distance;
    const double approach = (row_b.velocity - row_a.velocity).dot(normal);
    if (!(approach < 0.0) || approach * approach == 0.0) return std::nullopt;
    const double e = std::max(sheet_a.material.restitution, sheet_b.material.restitution);
    const double j = -(1.0 + e) * approach / (sheet_a.inertia.inv_mass + sheet_b.inertia.inv_mass);
    const Vec2 impulse = (j - j * excess_of_unit(normal.x(), normal.y())) * normal;
    blow.velocity_a = row_a.velocity - sheet_a.inertia.inv_mass * impulse;
    blow.velocity_b = row_b.velocity + sheet_b.inertia.inv_mass * impulse;
    if (!((blow.velocity_b - blow.velocity_a).dot(normal) >= 0.0)) return std::nullopt;
    return blow;
}

} // namespace flying
