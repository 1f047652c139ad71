#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "math/random.hpp"
#include "response/impact.hpp"

// What the tests of impacts share: random bodies, conserved quantities in extended precision, and comparisons of bits
namespace impacts {

using flying::ImpactBody;
using flying::ImpactPoint;
using flying::ImpactResult;
using flying::Material;
using flying::Vec2;
using real = long double;

inline constexpr double k_epsilon = std::numeric_limits<double>::epsilon();

inline bool same_bits(double a, double b)
{
    return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

inline bool same_bits(const Vec2& a, const Vec2& b)
{
    return same_bits(a.x(), b.x()) && same_bits(a.y(), b.y());
}

inline bool same_bits(const ImpactResult& a, const ImpactResult& b)
{
    return same_bits(a.velocity_a, b.velocity_a) && same_bits(a.velocity_b, b.velocity_b) &&
           same_bits(a.spin_a, b.spin_a) && same_bits(a.spin_b, b.spin_b) && a.any_push == b.any_push &&
           a.ended == b.ended;
}

// Log-uniform between low and high
inline double spread(flying::Random& random, double low, double high)
{
    return std::exp(random.uniform(std::log(low), std::log(high)));
}

inline Vec2 unit(double angle)
{
    return {std::cos(angle), std::sin(angle)};
}

inline Vec2 in_square(flying::Random& random, double half)
{
    const double x = random.uniform(-half, half);
    const double y = random.uniform(-half, half);
    return {x, y};
}

inline ImpactBody body(double mass, double moment, const Vec2& velocity, double spin)
{
    return {velocity, spin, {1.0 / mass, 1.0 / moment}};
}

inline const ImpactBody k_wall{};

// Two bodies of spread masses and moments that move anyhow
struct Pair
{
    ImpactBody a;
    ImpactBody b;
};

inline Pair random_pair(flying::Random& random, double ratio)
{
    const auto one = [&] {
        const double mass = spread(random, 1.0 / ratio, ratio);
        const double moment = mass * spread(random, 0.02, 2.0);
        const Vec2 velocity = in_square(random, 1.0);
        return body(mass, moment, velocity, random.uniform(-1.0, 1.0));
    };
    Pair pair;
    pair.a = one();
    pair.b = one();
    if (random.below(4) == 0) pair.a = k_wall;
    return pair;
}

/// Units of mass, length and rate, each a power of two, and what bodies and results are in them.
struct PowerScale
{
    double mass;
    double length;
    double rate;

    static PowerScale random(flying::Random& random)
    {
        const auto power = [&] { return std::ldexp(1.0, random.below(201) - 100); };
        PowerScale scale{};
        scale.mass = power();
        scale.length = power();
        scale.rate = power();
        return scale;
    }

    [[nodiscard]] ImpactBody of(const ImpactBody& from) const
    {
        const Vec2 velocity = from.velocity * length * rate;
        return {velocity,
                from.spin * rate,
                {from.inertia.inv_mass / mass, from.inertia.inv_moment_of_inertia / (mass * length * length)}};
    }
    [[nodiscard]] ImpactPoint of(const ImpactPoint& from) const
    {
        return {from.r_a * length, from.r_b * length, from.normal};
    }
    [[nodiscard]] ImpactResult of(const ImpactResult& from) const
    {
        return {from.velocity_a * length * rate,
                from.velocity_b * length * rate,
                from.spin_a * rate,
                from.spin_b * rate,
                from.any_push,
                from.ended};
    }
};

inline Vec2 point_velocity(const Vec2& velocity, double spin, const Vec2& r)
{
    return velocity + flying::cross(spin, r);
}

inline double normal_speed(const ImpactBody& a, const ImpactBody& b, const ImpactPoint& point)
{
    const Vec2 relative = point_velocity(b.velocity, b.spin, point.r_b) - point_velocity(a.velocity, a.spin, point.r_a);
    return relative.dot(point.normal);
}

inline double normal_speed(const ImpactResult& after, const ImpactPoint& point)
{
    const Vec2 relative = point_velocity(after.velocity_b, after.spin_b, point.r_b) -
                          point_velocity(after.velocity_a, after.spin_a, point.r_a);
    return relative.dot(point.normal);
}

inline double tangent_speed(const ImpactResult& after, const ImpactPoint& point)
{
    const Vec2 relative = point_velocity(after.velocity_b, after.spin_b, point.r_b) -
                          point_velocity(after.velocity_a, after.spin_a, point.r_a);
    return relative.dot(flying::perp(point.normal));
}

inline real half_weighed(double inverse, real squared)
{
    return inverse == 0.0 ? 0.0L : 0.5L * squared / inverse;
}

inline real squared(const Vec2& v)
{
    return static_cast<real>(v.x()) * v.x() + static_cast<real>(v.y()) * v.y();
}

inline real energy(const ImpactBody& body, const Vec2& velocity, double spin)
{
    return half_weighed(body.inertia.inv_mass, squared(velocity)) +
           half_weighed(body.inertia.inv_moment_of_inertia, static_cast<real>(spin) * spin);
}

// Kinetic energy of both before the impact, and after it  [J]
inline real energy(const ImpactBody& a, const ImpactBody& b)
{
    return energy(a, a.velocity, a.spin) + energy(b, b.velocity, b.spin);
}

inline real energy(const ImpactBody& a, const ImpactBody& b, const ImpactResult& after)
{
    return energy(a, after.velocity_a, after.spin_a) + energy(b, after.velocity_b, after.spin_b);
}

// All speeds at hand, before and after
inline double speed_scale(const ImpactBody& a, const ImpactBody& b, const ImpactResult& after, const ImpactPoint& point)
{
    const double before = a.velocity.norm() + b.velocity.norm() + std::abs(a.spin) * point.r_a.norm() +
                          std::abs(b.spin) * point.r_b.norm();
    const double later = after.velocity_a.norm() + after.velocity_b.norm() + std::abs(after.spin_a) * point.r_a.norm() +
                         std::abs(after.spin_b) * point.r_b.norm();
    return std::max(before, later);
}

} // namespace impacts
