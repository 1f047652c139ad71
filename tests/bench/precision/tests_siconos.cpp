// Siconos behind the same functions as every engine: where its method is exact, so must the adapter be.

#include <doctest/doctest.h>

#include "siconos.hpp"

using namespace flying::bench;

namespace {

Story story_of(const Trial& trial, double hertz, Siconos::Solver solver)
{
    Siconos engine(trial.scene, hertz, solver);
    Story story;
    for (const double time : trial.looks) {
        if (time > 0.0) engine.advance(time);
        story.looks.push_back({time, engine.states()});
    }
    story.loads = engine.loads();
    story.knows_loads = true;
    CHECK_FALSE(engine.failure());
    return story;
}

Trial trial_of(const std::string& name)
{
    for (const TrialMaker& maker : trial_makers()) {
        if (maker.name == name) return maker.make(Coarseness::quick);
    }
    FAIL("no trial of that name");
    return {};
}

} // namespace

TEST_CASE("under constant forces Moreau-Jean steps are exact: discs roll and blocks slide as the closed forms say")
{
    // Its solver leaves 1e-10 of each step's impulse
    for (const char* name : {"rolling", "incline"}) {
        CAPTURE(name);
        const Trial trial = trial_of(name);
        CHECK(trial.measures[0].of(story_of(trial, 60.0, Siconos::Solver::sweeps)).value() < 1e-9);
    }
}

TEST_CASE("Lemke's pivots hold a box of ten thousand times the mass on a light one, and tell its weight")
{
    const Trial trial = trial_of("mass-ratio");
    const Story story = story_of(trial, 60.0, Siconos::Solver::lemke);
    CHECK(trial.measures[0].of(story).value() < 1e-8);
    CHECK(trial.measures[1].of(story).value() < 1e-8);
}
