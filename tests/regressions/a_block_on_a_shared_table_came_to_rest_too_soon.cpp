#include <doctest/doctest.h>

#include <cmath>
#include <vector>

#include "support/worlds.hpp"

// A block that rocked on a table lost its swing as soon as eleven others stood on it, metres away: the table made them
// one island, of too many bodies for impacts at moments of their own.

using namespace flying;
using namespace flying::testing;

namespace {

constexpr double k_between = 3.0; ///< blocks [m]

/// A block that leans, so that it rocks on its lower edge.
[[nodiscard]] BodyDef leaning(double width, double height, double lean, double x)
{
    BodyDef block = rectangle(width, height, {x, 0.5 * (height * std::cos(lean) + width * std::sin(lean))});
    block.angle = lean;
    block.mass = 1.0;
    return block;
}

/// The blocks on a floor that never moves, or on a table of so many kilograms that lies on one.
[[nodiscard]] Scene with_blocks(const std::vector<BodyDef>& blocks, double restitution, double table)
{
    Scene scene = on_a_floor(restitution, 0.4);
    if (table > 0.0) {
        scene.bodies.front() = still(rectangle(400.0, 1.0, {0.0, -1.5}));
        scene.bodies.front().friction = 1e4;
        BodyDef top = rectangle(k_between * static_cast<double>(blocks.size() + 2), 1.0,
                                {0.5 * k_between * static_cast<double>(blocks.size() - 1), -0.5});
        top.mass = table;
        scene.bodies.push_back(top);
    }
    scene.bodies.insert(scene.bodies.end(), blocks.begin(), blocks.end());
    return scene;
}

/// How far angles of the blocks on a table are from those on a floor, at most, until so many seconds.  [rad]
[[nodiscard]] double off_by(const std::vector<BodyDef>& blocks, double restitution, double table, double until)
{
    World floor = world_of(with_blocks(blocks, restitution, 0.0));
    World shared = world_of(with_blocks(blocks, restitution, table));
    double worst = 0.0;
    for (double time = 0.05; time <= until; time += 0.05) {
        run(floor, time);
        run(shared, time);
        for (int k = 1; k <= static_cast<int>(blocks.size()); ++k)
            worst = std::max(worst, std::abs(floor.state(k).angle - shared.state(k + 1).angle));
    }
    return worst;
}

} // namespace

TEST_CASE("a block rocks on a table that others stand on as on a floor")
{
    for (const int others : {11, 14, 49}) {
        for (const double restitution : {0.0, 0.5}) {
            std::vector<BodyDef> blocks{leaning(0.3, 0.9, 0.2, 0.0)};
            for (int k = 1; k <= others; ++k) blocks.push_back(leaning(0.3, 0.4, 0.0, k_between * k));
            CAPTURE(others);
            CAPTURE(restitution);
            CHECK(off_by(blocks, restitution, 1e4 * others, 1.0) < 1e-3);
        }
    }
}

TEST_CASE("over a dozen blocks rock on one table as on a floor")
{
    for (const int count : {13, 20}) {
        std::vector<BodyDef> blocks;
        for (int k = 0; k < count; ++k) blocks.push_back(leaning(0.3, 0.9, 0.05 + 0.007 * k, k_between * k));
        CAPTURE(count);
        CHECK(off_by(blocks, 0.0, 1e4 * count, 1.0) < 1e-3);
        CHECK(off_by(blocks, 0.8, 1e4 * count, 0.5) < 1e-3);
    }
}
