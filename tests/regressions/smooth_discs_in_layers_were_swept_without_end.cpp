// Six hundred smooth discs of one size that came to lie in layers took five times as long as they fell, in steps of up to
// 0.7 s: sweeps led on by one layer each, went on as long as they may, and left what they could not do.

#include "support/effort.hpp"
#include "support/worlds.hpp"

using namespace flying;
using namespace flying::testing;

namespace {

/// Columns of discs with a little room, all with a little speed to one side or the other.
[[nodiscard]] Scene layers(int columns, int rows, double radius, double room)
{
    Scene scene;
    scene.world.field = UniformField{{0.0, -9.81}};
    scene.world.restitution = 0.0;
    scene.world.friction = 0.0;
    const double side = 2.0 * radius + room;
    scene.world.box = BoxDef{{0.0, 0.0}, {columns * side, 2.0 * rows * side}};
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column) {
            const double v = 0.01 * ((13 * row + 7 * column) % 11 - 5);
            scene.bodies.push_back(disc(radius, {(column + 0.5) * side, (row + 0.6) * side}, {v, 0.0}));
        }
    }
    return scene;
}

} // namespace

TEST_CASE("smooth discs in thirty layers take few islands, and stay out of each other")
{
    for (const int columns : tried({20, 12})) {
        World world = world_of(layers(columns, 30, 0.15, 0.02));
        run(world, 2.5);
        const Report report = world.report();
        CHECK(report.rest.value_or(RestAccount{}).islands <= 300);
        CHECK(report.max_overlap <= 0.01 * 0.15);
    }
}
