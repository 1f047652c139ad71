#include <doctest/doctest.h>

#include <cmath>
#include <map>

#include "stress/random_scenes.hpp"
#include "support/effort.hpp"

using namespace flying;
using namespace flying::stress;

TEST_CASE("with any skip off, every bit after every impact is the same, over random scenes of six kinds")
{
    // ./course stress skips goes on with further seeds
    std::map<std::string, int> compared;
    const int count = testing::tried(240);
    for (int seed = 1; seed <= count; ++seed) {
        const Scene scene = random_scene(seed);
        const Trace plain = trace_of(scene, {});
        for (const Skip& skip : plain.skips) {
            if (!skip.active || skip.kind == SkipClass::altering) continue;
            ++compared[skip.name];
            const std::string off = difference(plain, trace_of(scene, {skip.name}));
            if (!off.empty()) FAIL_CHECK("scene " << seed << " without " << skip.name << ": " << off);
        }
    }
    for (const Skip& skip : make_plan(random_scene(1)).skips) {
        if (skip.kind == SkipClass::altering) continue;
        INFO(skip.name);
        CHECK(compared[skip.name] >= count / 12);
    }
}

TEST_CASE("traces that differ in the last bit of one velocity are told apart")
{
    Scene scene = random_scene(1);
    const Trace plain = trace_of(scene, {});
    REQUIRE(plain.moments.size() > 2);
    CHECK(difference(plain, trace_of(scene, {})).empty());
    for (BodyDef& body : scene.bodies) {
        if (body.is_static) continue;
        body.velocity.x() = std::nextafter(body.velocity.x(), 1e9);
        break;
    }
    CHECK_FALSE(difference(plain, trace_of(scene, {})).empty());
}
