#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "math/random.hpp"
#include "support/bodies.hpp"
#include "support/heaps.hpp"
#include "support/overlap.hpp"

/// Crowds as users let them loose: each row of them falls onto those below.
namespace flying::testing {

/// Where a crowd's k-th body starts: in rows of so many, the first of them `spacing` beside the last.
inline Vec2 place_in_rows(int k, int columns, double spacing)
{
    return Vec2(0.5, 0.5) + spacing * Vec2(k % columns, k / columns);
}

/// Two discs and then a box, without end, of 0.2 to 0.35 m; in a smooth pit.
inline Scene smooth_crowd(int count, int columns, std::uint64_t seed)
{
    Random random(seed);
    Scene scene = rough_pit({0.76 * columns + 0.8, 60.0});
    scene.world.restitution = 0.4;
    scene.world.friction = 0.0;
    for (int k = 0; k < count; ++k) {
        const double size = random.uniform(0.2, 0.35);
        const Vec2 place = place_in_rows(k, columns, 0.76);
        scene.bodies.push_back(k % 3 == 2 ? rectangle(1.2 * size, size, place) : disc(size, place));
        scene.bodies.back().angle = random.uniform(0.0, 3.0);
    }
    return scene;
}

/// Boxes with gaps between them that fall all at once, and a disc that is shot into them from above.
inline Scene shot_into_falling_boxes(std::uint64_t seed)
{
    Random random(seed);
    Scene scene = rough_pit({10.0, 60.0});
    for (int k = 0; k < 200; ++k) {
        const double width = random.uniform(0.3, 0.5);
        scene.bodies.push_back(rectangle(width, random.uniform(0.3, 0.5), place_in_rows(k, 13, 0.72)));
        scene.bodies.back().angle = random.uniform(0.0, 3.0);
    }
    const double across = random.uniform(-5.0, 5.0);
    scene.bodies.push_back(disc(0.5, {5.0, 20.0}, {across, -random.uniform(20.0, 60.0)}));
    scene.bodies.back().mass = random.uniform(1.0, 50.0);
    return scene;
}

/// Boxes and discs by turns, the largest twenty times as large as the smallest.
inline Scene crowd_of_all_sizes(std::uint64_t seed)
{
    Random random(seed);
    Scene scene = rough_pit({9.0, 60.0});
    for (int k = 0; k < 100; ++k) {
        const double size = 0.9 * std::pow(20.0, -random.uniform(0.0, 1.0));
        const Vec2 place(1.2 + 2.0 * (k % 4), 1.2 + 2.0 * (k / 4));
        scene.bodies.push_back(k % 2 == 0 ? rectangle(1.4 * size, size, place) : disc(size, place));
        scene.bodies.back().angle = random.uniform(0.0, 3.0);
    }
    return scene;
}

/// The deepest overlap of any step's end until a moment [s].  [bounding radii of the smaller one]
inline double deepest_until(World& world, double until)
{
    double deepest = 0.0;
    for (int step = 1; step <= std::lround(60.0 * until); ++step) {
        run(world, step / 60.0);
        deepest = std::max(deepest, deepest_overlap(world));
    }
    return deepest;
}

} // namespace flying::testing
