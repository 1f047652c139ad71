// A hexagon that stands on a floor has its centre 0.8660254... above it. With seven digits it overlaps the floor by
// 4e-7 m, and the scene was refused; so was every arch and house of cards whose corners had been typed.

#include <doctest/doctest.h>

#include <cmath>
#include <iomanip>
#include <sstream>
#include <string>

#include "scene/read.hpp"
#include "support/worlds.hpp"
#include "world/make_room.hpp"

using namespace flying;
using namespace flying::testing;

namespace {

/// Hexagons with sides of 1 m in a column on a floor, each number with so many digits after the point.
[[nodiscard]] std::string column_text(int count, int digits)
{
    const double half = std::sqrt(0.75);
    std::ostringstream text;
    text << std::fixed << std::setprecision(digits)
         << "[world]\nfield = { kind = \"uniform\", gravity = [0.0, -9.81] }\nrestitution = 0.0\nfriction = 0.5\n"
            "[[body]]\nshape = { kind = \"rectangle\", width = 10.0, height = 1.0 }\nposition = [0.0, -0.5]\n"
            "static = true\n";
    for (int k = 0; k < count; ++k) {
        // A little lower than it should be, as numbers are that were cut off
        const double place = half * (2 * k + 1) - std::pow(10.0, -digits);
        text << "[[body]]\nshape = { kind = \"polygon\", vertices = [[1.0, 0.0], [0.5, " << half << "], [-0.5, " << half
             << "], [-1.0, 0.0], [-0.5, " << -half << "], [0.5, " << -half << "]] }\nposition = [0.0, " << place
             << "]\n";
    }
    return text.str();
}

} // namespace

TEST_CASE("bodies that overlap by the digits that nobody typed are moved apart and stand")
{
    for (const int digits : {5, 6, 7, 9, 12}) {
        for (const int count : {1, 2, 4, 12}) {
            if (digits == 5 && count > 4) continue; // too far off in all
            CAPTURE(digits);
            CAPTURE(count);
            const std::string text = column_text(count, digits);
            CHECK_FALSE(read_scene_text(text, "typed"));
            const Expected<Scene> scene = read_scene_text(text, "typed", make_room_for_digits);
            REQUIRE(scene);

            World world = world_of(scene.value());
            run(world, 2.0);
            for (int k = 1; k <= count; ++k) {
                const BodyState state = world.state(k);
                const double off = 2.0 * (count + 1) * std::pow(10.0, -digits); // its own and those of all below
                CHECK(std::abs(state.position.y() - std::sqrt(0.75) * (2 * k - 1)) <= off);
                CHECK(state.velocity.norm() == 0.0);
            }
        }
    }
}

TEST_CASE("what overlaps by more than its digits explain is refused, and stays as it was")
{
    CHECK_FALSE(read_scene_text(column_text(2, 3), "typed", make_room_for_digits));
    Scene scene = read_scene_text(column_text(1, 3), "typed", [](Scene&) { return true; }).value();
    const Vec2 before = scene.bodies[1].position;
    CHECK_FALSE(make_room_for_digits(scene));
    CHECK(scene.bodies[1].position == before);
}
