#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "rest/rest_engine.hpp"
#include "world/make_shape.hpp"

// Asked for its contacts before its first step, a resting engine that went on from a memory read the list of pairs by an
// index that was empty, or that of other pairs: it crashed, or looked at neighbours that were none.

using namespace flying;

namespace {

RestBody box(double width, double height, const Vec2& position, const Vec2& velocity, bool is_static)
{
    RestBody body{make_shape(RectangleDef{width, height}).value(), {}, {}, {}, {}, is_static};
    body.state.position = position;
    if (is_static) return body;
    const double mass = width * height;
    body.state.velocity = velocity;
    body.inertia = {1.0 / mass, 12.0 / (mass * (width * width + height * height))};
    body.acceleration = Vec2(0.0, -9.81);
    return body;
}

/// Boxes side by side that slide over a floor, and one that slides over them faster: it passes their seams.
std::vector<RestBody> row_of_boxes()
{
    std::vector<RestBody> bodies{box(20.0, 1.0, {5.0, -0.5}, Vec2::Zero(), true)};
    for (int k = 0; k < 4; ++k) bodies.push_back(box(0.8, 0.8, {0.4 + 0.8 * k, 0.4}, {0.5, 0.0}, false));
    bodies.push_back(box(0.8, 0.8, {0.5, 1.2}, {1.5, 0.0}, false));
    return bodies;
}

} // namespace

TEST_CASE("a resting engine that goes on from a memory has the contacts that it had")
{
    RestEngine engine(row_of_boxes());
    for (int step = 0; step < 90; ++step) {
        engine.step();
        RestEngine resumed(row_of_boxes());
        resumed.go_on_from(engine.memory());
        const std::vector<RestContact> before = engine.contacts();
        const std::vector<RestContact> after = resumed.contacts();
        CAPTURE(step);
        REQUIRE(before.size() >= 8);
        REQUIRE(after.size() == before.size());
        for (std::size_t k = 0; k < before.size(); ++k) {
            CHECK(after[k].a == before[k].a);
            CHECK(after[k].b == before[k].b);
            CHECK(after[k].normal == before[k].normal);
            CHECK(after[k].normal_force == before[k].normal_force);
        }
        CHECK(resumed.islands() == engine.islands());

        // Back to an earlier memory: its contacts, not those of the steps after
        if (step % 10 != 9) continue;
        const RestEngine::Memory memory = engine.memory();
        RestEngine other(row_of_boxes());
        other.step();
        other.go_on_from(memory);
        CHECK(other.contacts().size() == before.size());
    }
}
