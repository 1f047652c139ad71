#include <cmath>
#include <doctest/doctest.h>
#include <string>

#include "runs.hpp"
#include "scene/fault.hpp"
#include "support/receipts.hpp"
#include "weighing.hpp"

using namespace flying;

// [simulator.tests.saved]
TEST_CASE("a run that was saved and gone on with has the bits of one that never stopped")
{
    for (const Scene& scene :
         {rain(16, 3), scene_of_course(FLYING_SCENES, "original-polygons"),
          scene_of_course(FLYING_SCENES, "original-polygons-gravity")}) {
        World whole = start(scene);
        World broken = start(scene);
        for (int k = 1; k <= 24; ++k) {
            const double t = 0.31 * k;
            go(whole, t);
            go(broken, t);
            broken = resumed(broken);
            CHECK(apart(whole, broken) == 0.0);
        }
        CHECK(broken.report().hash == whole.report().hash);
        CHECK(broken.report().energy.total() == whole.report().energy.total());
        CHECK(broken.handovers().size() == whole.handovers().size());
    }
}
// [simulator.tests.saved]

// [simulator.tests.by_eye]
TEST_CASE(
    "what one sees of a run isn't enough to go on with: seventeen digits of it lead to "
    "another future")
{
    const Scene scene = scene_of_course(FLYING_SCENES, "original-polygons");
    World whole = start(scene);
    go(whole, 10.0);
    World by_eye = start(as_it_looks(whole, 17));
    CHECK(apart(whole, by_eye) == 0.0);
    go(whole, 11.0);
    go(by_eye, 1.0);
    CHECK(apart(whole, by_eye) > 0.0);
    CHECK(apart(whole, by_eye) < 1e-13);
    go(whole, 50.0);
    go(by_eye, 40.0);
    CHECK(apart(whole, by_eye) > 0.1);

    // Energy, which is as good as ever, sees nothing
    const double energy = whole.report().energy.total();
    CHECK(std::abs(by_eye.report().energy.total() - energy) < 1e-12 * energy);
}
// [simulator.tests.by_eye]

// [simulator.tests.asked]
TEST_CASE("what happens doesn't depend on who looks, or how often")
{
    World once = start(rain(16, 3));
    go(once, 6.0);
    for (const double every : {1.0 / 144.0, 0.05, 0.73}) {
        World often = start(rain(16, 3));
        for (int k = 1; k * every < 6.0; ++k) {
            go(often, k * every);
            CHECK(std::isfinite(apart(often, often)));
        }
        go(often, 6.0);
        CHECK(often.report().hash == once.report().hash);
    }
}
// [simulator.tests.asked]

// [simulator.tests.frames]
TEST_CASE("where steps follow the frames, each rate of frames has a future of its own")
{
    WorldOptions slow;
    slow.step = 1.0 / 30.0;
    WorldOptions fast;
    fast.step = 1.0 / 144.0;
    World one = start(rain(24, 5), slow);
    World two = start(rain(24, 5), fast);
    go(one, 12.0);
    go(two, 12.0);
    CHECK(apart(one, two) > 0.1);
}
// [simulator.tests.frames]

// [simulator.tests.faults]
TEST_CASE(
    "all faults of a scene come at once, each with its line, in the order of the text")
{
    const Expected<Scene> scene = read_scene_file(FLYING_HERE "/five-faults.toml");
    REQUIRE_FALSE(scene.has_value());
    const Faults& faults = scene.faults();
    REQUIRE(faults.size() == 5);
    const char* places[] = {"restitution", "position", "velocty", "vertices", "position"};
    const char* lines[] = {":5:", ":16:", ":22:", ":26:", ":32:"};
    for (std::size_t k = 0; k < 5; ++k) {
        INFO(format_fault(faults[k]));
        CHECK(format_fault(faults[k]).find(places[k]) != std::string::npos);
        CHECK(faults[k].place.find(lines[k]) != std::string::npos);
    }
}
// [simulator.tests.faults]

// [simulator.tests.together]
TEST_CASE(
    "bodies change hands both ways, at no cost of energy, and overlap by next to nothing")
{
    World world = start(rain(24, 5));
    go(world, 12.0);
    const Report report = world.report();
    int to_rest = 0;
    int to_events = 0;
    double cost = 0.0;
    for (const Handover& handover : report.handovers) {
        (handover.to == Handover::To::rest ? to_rest : to_events) += 1;
        cost = std::max(cost, std::abs(handover.energy_change));
    }
    CHECK(to_rest > 0);
    CHECK(to_events > 0);
    CHECK(cost < 1e-12 * report.initial_total);
    CHECK(shares_of(world).events == 0);
    RECORD_VALUE("simulator.to_rest", to_rest);
    RECORD_VALUE("simulator.to_events", to_events);
    RECORD_VALUE("simulator.overlap", report.max_overlap);
}
// [simulator.tests.together]

// [simulator.tests.original]
TEST_CASE(
    "the original's scales: its dumbbell is a third too heavy, and its house has its "
    "centre in the wrong place")
{
    const Scene scene = scene_of_course(FLYING_SCENES, "original-polygons");
    for (const BodyDef& def : scene.bodies) {
        if (!std::holds_alternative<PolygonDef>(def.shape)) continue;
        const Shape shape = make_shape(def.shape).value();
        const Polygon& polygon = std::get<Polygon>(shape);
        const AreaMoments ours = moments_by(Scales::right, def.shape, polygon);
        const AreaMoments its = moments_by(Scales::original, def.shape, polygon);
        const double off = (its.centroid - ours.centroid).norm();
        if (def.name == "dumbbell") {
            CHECK(ours.area == doctest::Approx(0.96));
            CHECK(its.area == doctest::Approx(1.28));
            CHECK(off < 1e-15);
            RECORD_VALUE("simulator.dumbbell",
                         its.second_moment / ours.second_moment - 1.0);
        } else {
            // A house of a square and half a square: 70 for 63 1/3 of its pixels
            CHECK(off == doctest::Approx(0.7 - 0.19 / 0.3).epsilon(1e-9));
            CHECK(its.area == doctest::Approx(ours.area));
            RECORD_VALUE("simulator.house", off);
        }
    }
}
// [simulator.tests.original]
