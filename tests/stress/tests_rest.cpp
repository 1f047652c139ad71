#include <doctest/doctest.h>

#include "rest_trial.hpp"

using namespace flying::stress;

TEST_CASE("random scenes at rest: energy never rises, nothing becomes no number")
{
    // The same scenes as flying_rest_fuzz, which goes on for as many as one likes
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
        const RestScene scene = make_rest_scene(seed);
        CAPTURE(seed);
        CAPTURE(scene.label);
        if (scene.bodies.size() > 20) continue;
        const RestFindings findings = run_rest_scene(scene, 10);
        CHECK(findings.finite);
        CHECK(findings.lost == 0);
        CHECK(findings.rise <= k_rise_allowed);
    }
}
