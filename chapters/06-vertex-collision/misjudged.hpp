#pragma once

#include <cmath>
#include <numbers>
#include <vector>

#include "math/orientation.hpp"
#include "math/random.hpp"
#include "scenes.hpp"
#include "turns.hpp"

namespace flying::corner {


/// Of `pairs` random pairs of squares with the side `side`, how many the wrong
/// turn takes for apart although their edges cross, or the other way round.
inline int misjudged_pairs(double side, int pairs)
{
    Random random(606);
    const auto square = [&](double reach) {
        const double angle = random.uniform(0.0, 2.0 * std::numbers::pi);
        const Vec2 middle{random.uniform(-reach, reach), random.uniform(-reach, reach)};
        const Pose pose{middle, Rotation::of(angle)};
        std::vector<Vec2> ring;
        const Polygon shape = box(side, side);
        for (const Vec2& vertex : shape.vertices()) ring.push_back(pose * vertex);
        return ring;
    };
    int misjudged = 0;
    for (int k = 0; k < pairs; ++k) {
        const std::vector<Vec2> a = square(side);
        const std::vector<Vec2> b = square(side);
        if (rings_cross(a, b, orientation) != rings_cross(a, b, wrong_turn)) ++misjudged;
    }
    return misjudged;
}


} // namespace flying::corner
