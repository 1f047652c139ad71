// A disc that spun on a smooth floor slowed down by a tenth of a millirad/s in a second, though nothing can turn it,
// where a box leaned on it that a ladder slid down: the limit of energy took what the ladder had gained from the spin
// of all bodies of the island, and the energy of the spin hid some of the gain.

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "support/effort.hpp"
#include "support/worlds.hpp"

using namespace flying;
using namespace flying::testing;

namespace {

/// A ladder of this length and width, that leans on a corner to its left with its foot on the floor.
/// lean  from upright [rad]
[[nodiscard]] BodyDef ladder_on(const Vec2& corner, double width, double length, double lean)
{
    const Vec2 along(-std::sin(lean), std::cos(lean));
    const Vec2 across(std::cos(lean), std::sin(lean));
    const Vec2 foot = corner - (corner.y() / along.y()) * along;
    BodyDef ladder = rectangle(width, length, foot + 0.5 * length * along + 0.5 * width * across);
    ladder.angle = lean;
    return ladder;
}

/// Energy of all but the disc's spin.  [J]
/// sizes  of box and ladder, width and height
[[nodiscard]] double energy_beside_spin(const World& world, double disc_mass, std::span<const Vec2> sizes)
{
    const auto energy = [&](int body, double mass, double moment) {
        const BodyState state = world.state(body);
        return 0.5 * (mass * state.velocity.squaredNorm() + moment * state.spin * state.spin) +
               mass * 9.81 * state.position.y();
    };
    double sum = energy(1, disc_mass, 0.0);
    for (int k = 0; k < 2; ++k) {
        const double mass = sizes[k].prod();
        sum += energy(k + 2, mass, mass * sizes[k].squaredNorm() / 12.0);
    }
    return sum;
}

} // namespace

TEST_CASE("what slides down beside a smooth disc takes none of its spin and none of its energy")
{
    for (const double density : tried({1.0, 30.0, 1000.0})) {
        for (const double lean : {0.2, 0.5, 0.9}) {
            for (const double spin : {20.0, -3.0}) {
                CAPTURE(density);
                CAPTURE(lean);
                CAPTURE(spin);
                const std::array<Vec2, 2> sizes{Vec2(0.5, 0.5), Vec2(0.1, 2.5)};
                Scene scene = on_a_floor(0.0, 0.0);
                scene.bodies.push_back(disc(0.5, {0.0, 0.5}));
                scene.bodies.back().density = density;
                scene.bodies.back().spin = spin;
                scene.bodies.push_back(rectangle(sizes[0].x(), sizes[0].y(), {0.75, 0.25}));
                scene.bodies.push_back(ladder_on({1.0, 0.5}, sizes[1].x(), sizes[1].y(), lean));
                World world = world_of(scene);

                const double disc_mass = density * std::numbers::pi * 0.25;
                double least = energy_beside_spin(world, disc_mass, sizes);
                const double first = least;
                double rise = 0.0;
                for (int k = 1; k <= 60; ++k) {
                    run(world, k / 60.0);
                    const double now = energy_beside_spin(world, disc_mass, sizes);
                    rise = std::max(rise, now - least);
                    least = std::min(least, now);
                }
                CHECK(world.state(1).spin == spin);
                CHECK(rise <= 1e-13 * first);
            }
        }
    }
}
