#pragma once

#include <cmath>
#include <cstdint>

#include "math/random.hpp"
#include "support/worlds.hpp"

namespace flying::testing {

/// A floor between walls, from the origin up to `high`; e = 0 and mu = 0.5.
[[nodiscard]] inline Scene rough_pit(const Vec2& high)
{
    Scene scene;
    scene.world.field = UniformField{{0.0, -9.81}};
    scene.world.restitution = 0.0;
    scene.world.friction = 0.5;
    scene.world.box = BoxDef{{0.0, 0.0}, high};
    return scene;
}

/// Discs of 0.42 m in rows of nine in a rough pit; their masses are spread evenly by powers of ten.
///
/// heaviest  against the lightest, which may have 1 kg [kg]
[[nodiscard]] inline Scene heap_of_unequal_masses(int count, double heaviest, std::uint64_t seed)
{
    Random random(seed);
    Scene scene = rough_pit({9.0, 60.0});
    for (int k = 0; k < count; ++k) {
        BodyDef body = disc(0.42, {0.5 + (k % 9) + random.uniform(-0.05, 0.05), 0.5 + 0.95 * (k / 9)});
        body.mass = std::pow(heaviest, random.uniform(0.0, 1.0));
        scene.bodies.push_back(body);
    }
    return scene;
}

} // namespace flying::testing
