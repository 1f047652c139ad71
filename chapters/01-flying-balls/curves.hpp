#pragma once

#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include "canvas.hpp"

/// Curves as points, and colours for many bodies.
namespace flying::board {

/// The points of a curve over a parameter.
inline std::vector<Vec2> curve(const std::function<Vec2(double)>& place, double from, double to,
                        int pieces = 200)
{
    std::vector<Vec2> points;
    for (int k = 0; k <= pieces; ++k)
        points.push_back(place(from + (to - from) * k / pieces));
    return points;
}

inline std::vector<Vec2> circle(const Vec2& centre, double r)
{
    return curve(
        [&](double w) { return Vec2(centre + r * Vec2(std::cos(w), std::sin(w))); }, 0.0,
        2.0 * std::numbers::pi, 96);
}

inline constexpr std::array<Ink, 6> k_hues = {
    k_blue, k_orange, k_green, k_violet, Ink{0.80, 0.55, 0.10}, Ink{0.72, 0.22, 0.35}};

} // namespace flying::board
