#include <doctest/doctest.h>

#include <vector>

#include "rest/rest_engine.hpp"
#include "stages.hpp"

using namespace flying;
using namespace flying::testing;

namespace {

/// A disc that rolls over the ground without slipping, beside so many boxes.
std::vector<RestBody> rolling_beside(int boxes)
{
    std::vector<RestBody> bodies{ground()};
    RestBody disc{Disc{0.5}, {}, {1.0, 8.0}, {0.0, 0.5}};
    disc.state.position = Vec2(0.0, 0.5);
    disc.state.velocity = Vec2(-3.0, 0.0);
    disc.state.spin = 6.0;
    disc.acceleration = Vec2(0.0, -k_g);
    bodies.push_back(disc);
    for (int k = 0; k < boxes; ++k) bodies.push_back(box_at(Vec2(5.0 + 1.2 * (k / 2), 0.5 + k % 2)));
    return bodies;
}

struct Work
{
    std::int64_t looks;
    std::int64_t boxes;
    std::int64_t pairs;
    std::int64_t manifolds;
    friend bool operator==(const Work&, const Work&) = default;
};

/// What the steps of the second second take, by which the boxes sleep.
Work work_beside(int boxes, BodyState& disc)
{
    RestEngine engine(rolling_beside(boxes));
    engine.advance(1.0);
    CHECK(engine.is_asleep(1) == false);
    for (int k = 2; k < engine.body_count(); ++k) CHECK(engine.is_asleep(k));
    const RestCounts before = engine.counts();
    engine.advance(2.0);
    const RestCounts& after = engine.counts();
    disc = engine.state(1);
    return {after.looks - before.looks, after.boxes - before.boxes, after.pairs - before.pairs,
            after.manifolds - before.manifolds};
}

} // namespace

TEST_CASE("what rolls beside sleepers costs as much work as alone, and rolls to the same place")
{
    BodyState alone;
    BodyState beside;
    const Work work = work_beside(0, alone);
    CHECK(work.looks > 1);
    for (const int boxes : {2, 60, 600}) {
        CAPTURE(boxes);
        CHECK(work_beside(boxes, beside) == work);
        CHECK(beside.position == alone.position);
        CHECK(beside.velocity == alone.velocity);
        CHECK(beside.spin == alone.spin);
    }
}

TEST_CASE("a sleeper that was struck wakes what it touches, and all that wakes is watched from then on")
{
    // Boxes side by side sleep; one is thrown against the others, step by step as in a world that begins with the blow
    std::vector<RestBody> bodies = rolling_beside(40);
    RestEngine engine(bodies);
    engine.advance(1.0);
    BodyState thrown = engine.state(3);
    thrown.position.x() -= 1.5;
    thrown.velocity = Vec2(4.0, 1.0);
    engine.set_state(3, thrown);
    RestEngine anew(bodies);
    anew.go_on_from(engine.memory());
    for (int step = 0; step < 120; ++step) {
        engine.step();
        anew.step();
        REQUIRE(engine.hash() == anew.hash());
    }
    CHECK(engine.max_overlap() < 1e-6);
}
