#pragma once

#include <cmath>
#include <numbers>

#include "math/random.hpp"
#include "math/vec2.hpp"

/// What random pairs and random scenes draw alike.
namespace flying::stress {

inline constexpr double k_pi = std::numbers::pi;

[[nodiscard]] inline Vec2 direction(double angle)
{
    return {std::cos(angle), std::sin(angle)};
}

/// Any number between two positive ones, each decade as likely as the next.
[[nodiscard]] inline double log_uniform(Random& random, double low, double high)
{
    return std::exp(random.uniform(std::log(low), std::log(high)));
}

} // namespace flying::stress
