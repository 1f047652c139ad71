// A wall that was shot to pieces took forty times the work, and ever more: bricks that fly side by side come into each
// other's cells whenever one of them crosses a border, and each time they were looked at anew, beside the looks that
// were foreseen of them already. Each of these led to the next: 46 million looks for 60 bricks.

#include <cstdint>

#include "support/effort.hpp"
#include "support/worlds.hpp"

using namespace flying;
using namespace flying::testing;

namespace {

/// Blocks that fly up and to the right, next to each other and a little apart, each turning as it will.
[[nodiscard]] Scene debris(int columns, int rows, double speed, double width)
{
    Scene scene = on_a_floor(0.3, 0.5);
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column) {
            const double part = 0.01 * ((7 * row + 3 * column) % 11);
            BodyDef block =
                rectangle(width, 0.2, {1.3 * width * column, 30.0 + 0.3 * row}, {speed * (1.0 + part / speed), part});
            block.spin = 0.2 * ((5 * row + column) % 7 - 3);
            scene.bodies.push_back(block);
        }
    }
    return scene;
}

[[nodiscard]] std::int64_t looks_in(World& world)
{
    for (const StageCost& stage : world.report().stages) {
        if (stage.name == "look again") return stage.count;
    }
    return 0;
}

} // namespace

TEST_CASE(
    "blocks that fly side by side are looked at no more often after thousands of borders of cells than after a few")
{
    for (const double speed : tried({3000.0, 500.0})) {
        for (const double width : {0.2, 0.25}) {
            CAPTURE(speed);
            CAPTURE(width);
            World world = world_of(debris(4, 5, speed, width));
            run(world, 0.5);
            const std::int64_t first = looks_in(world);
            run(world, 2.0);
            CHECK(looks_in(world) <= 1.5 * static_cast<double>(first) + 1000.0);
        }
    }
}
