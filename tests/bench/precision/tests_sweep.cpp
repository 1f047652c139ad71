// The harness itself: errors, lines of JSON, going on after a cut, and never a real clock.

#include <doctest/doctest.h>

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "sweep.hpp"

using namespace flying::bench;
namespace work = flying::work;
using flying::BodyState;
using flying::Vec2;

namespace {

/// A clock that goes on by a quarter of a second each time it is asked.
double g_now = 0.0;
double ticking()
{
    return g_now += 0.25;
}

/// One disc that flies straight at 1 m/s.
Trial straight()
{
    Trial trial;
    trial.name = "straight";
    flying::BodyDef body;
    body.shape = flying::DiscDef{0.5};
    body.velocity = Vec2(1.0, 0.0);
    trial.scene.bodies = {body};
    trial.until = 2.0;
    trial.looks = {0.0, 1.0, 2.0};
    trial.measures = {median_distance(trial.scene,
                                      [](int, double t) {
                                          return Place{Vec2(t, 0.0), 0.0};
                                      }),
                      energy_drift(trial.scene)};
    return trial;
}

/// An engine that is off by a share of the step.
Engine off_by(double share)
{
    return {"off", [](const Trial&) { return true; }, [](const Trial&) { return std::string(); },
            [](const Trial&) { return true; },
            [share](const flying::Scene&, const Setting& setting) {
                const auto time = std::make_shared<double>(0.0);
                Run run;
                run.advance = [=](double t) { *time = t; };
                run.states = [=] {
                    return std::vector<BodyState>{
                        {Vec2(*time * (1.0 + share / setting.hertz), 0.0), Vec2(1.0, 0.0), 0.0, 0.0, *time}};
                };
                return run;
            }};
}

work::RunRecord a_run()
{
    return {"quick", "2026-11-23", "a machine", "a compiler", {"one", "other"}, 3, 100.0};
}

std::string text_of_file(const std::string& path)
{
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

} // namespace

TEST_CASE("an engine's error is the largest distance over all looks, angles as ways of the rim")
{
    const Trial trial = straight();
    Story story;
    story.looks = {{0.0, {{Vec2(0.0, 0.0), Vec2(1.0, 0.0), 0.0, 0.0, 0.0}}},
                   {1.0, {{Vec2(1.0, 0.25), Vec2(1.0, 0.0), 0.0, 0.0, 1.0}}},
                   {2.0, {{Vec2(2.0, 0.0), Vec2(2.0, 0.0), 0.25, 0.0, 2.0}}}};
    CHECK(trial.measures[0].of(story).value() == 0.25);
    story.looks[2].states[0].angle = 1.0; // half a metre from the centre
    CHECK(trial.measures[0].of(story).value() == 0.5);
    CHECK(trial.measures[1].of(story).value() == 3.0); // twice the speed, four times the energy
    story.looks[1].states[0].position.x() = std::nan("");
    CHECK(trial.measures[0].of(story).value() == HUGE_VAL);
}

TEST_CASE("overlap, shift and gain of energy are what they are by hand")
{
    flying::Scene scene;
    flying::BodyDef body;
    body.shape = flying::SquareDef{1.0};
    body.mass = 2.0;
    scene.bodies = {body, body};
    scene.bodies[1].position = Vec2(2.0, 0.0);
    Story story;
    const auto at = [](double x, double speed) { return BodyState{Vec2(x, 0.0), Vec2(speed, 0.0), 0.0, 0.0, 0.0}; };
    story.looks = {
        {0.0, {at(0.0, 2.0), at(2.0, 0.0)}}, {1.0, {at(0.0, 1.0), at(0.75, 0.0)}}, {2.0, {at(0.0, 3.0), at(2.5, 0.0)}}};
    CHECK(deepest_overlap(scene).of(story).value() == doctest::Approx(0.25).epsilon(1e-15));
    CHECK(largest_shift().of(story).value() == 0.5);
    CHECK(energy_gain(scene).of(story).value() == 2.0); // from 1 J to 9 J, of 4 J
}

TEST_CASE("a sweep measures each setting, and leaves out steps that take too long")
{
    const Trial trial = straight();
    const std::vector<Engine> engines = {off_by(0.5)};
    SweepOptions options;
    options.repeats = 3;
    options.most = 100.0;
    options.hertz = {1.0, 2.0, 4.0};
    options.seconds = ticking;
    const work::DiagramRecord record = sweep(trial, engines, options, [](const std::string&) {});
    REQUIRE(record.curves.size() == 1);
    REQUIRE(record.curves[0].points.size() == 3);
    CHECK(record.curves[0].points[0].measures[0] == 1.0); // after two seconds, half a step in each
    CHECK(record.curves[0].points[2].measures[0] == 0.25);
    CHECK(record.curves[0].points[2].seconds.median == 0.25);

    // Each look lets the clock go on by a quarter: three of them are longer than half a second
    options.most = 0.5;
    const work::DiagramRecord none = sweep(trial, engines, options, [](const std::string&) {});
    CHECK(none.curves[0].points.empty());
    CHECK_FALSE(none.curves[0].why_not.empty());
}

TEST_CASE("records come back from their lines as they were")
{
    work::DiagramRecord diagram{"a", "title", "why", "truth", 3, 1.5, {"m [m]"}, {}};
    diagram.curves = {{"one", {{60.0, {0.1, 0.2, 0.30000000000000004}, {1e-300, -1.0}}}, ""}, {"two", {}, "too slow"}};
    work::GrowthRecord growth{"g", "title", "seconds", {{"one", {{10.0, 1e-3}, {100.0, 1.0 / 3.0}}}}, {{"one", 64.0}}};
    work::SkipsRecord skips{
        "s", 2.0, {{"", {1.0, 2.0, 3.0}, 0, true, false}, {"grid", {4.0, 5.0, 6.0}, 7, false, true}}};
    const std::string text = work::line_of("run", a_run()) + "\n" + work::line_of("diagram", diagram) + "\n" +
                             work::line_of("growth", growth) + "\n" + work::line_of("skips", skips) + "\n";
    const auto records = work::read_records(text);
    REQUIRE(records);
    CHECK(records->run.peers == a_run().peers);
    CHECK(records->run.most == 100.0);
    REQUIRE(records->diagram("a"));
    CHECK(work::line_of("diagram", *records->diagram("a")) == work::line_of("diagram", diagram));
    CHECK(records->diagram("a")->curves[0].points[0].seconds.high == 0.30000000000000004);
    CHECK(records->growths.at(0).curves.at("one")[1].second == 1.0 / 3.0);
    CHECK(records->growths.at(0).bytes_per_body.at("one") == 64.0);
    CHECK(work::line_of("skips", records->skips.at(0)) == work::line_of("skips", skips));

    CHECK_FALSE(work::read_records(""));
    CHECK_FALSE(work::read_records("no line at all"));
    CHECK_FALSE(work::read_records(work::line_of("diagram", diagram) + "\n")); // a run comes first
    CHECK_FALSE(work::read_records(work::line_of("run", a_run()) + "\nnonsense\n"));
}

TEST_CASE("a run that was cut off within a line goes on behind the last whole one")
{
    const std::string path = (std::filesystem::temp_directory_path() / "flying-bench-resume.jsonl").string();
    std::filesystem::remove(path);
    const work::DiagramRecord first{"first", "", "", "", 1, 1.0, {}, {}};
    const work::DiagramRecord second{"second", "", "", "", 1, 1.0, {}, {}};
    {
        auto file = RecordFile::open(path, a_run());
        REQUIRE(file);
        file.value().add(first);
        file.value().add(second);
    }
    const std::string whole = text_of_file(path);
    std::ofstream(path, std::ios::binary) << whole.substr(0, whole.size() - 20);
    {
        auto file = RecordFile::open(path, a_run());
        REQUIRE(file);
        CHECK(file.value().has_diagram("first"));
        CHECK_FALSE(file.value().has_diagram("second"));
        file.value().add(second);
    }
    CHECK(text_of_file(path) == whole);

    // Another machine's figures don't mix with these
    work::RunRecord other = a_run();
    other.machine = "another machine";
    const auto refused = RecordFile::open(path, other);
    REQUIRE_FALSE(refused);
    CHECK(refused.faults().front().expected.find("--fresh") != std::string::npos);
    std::filesystem::remove(path);
}

TEST_CASE("every trial is a valid scene whose looks are moments that all steps hit")
{
    for (const TrialMaker& maker : trial_makers()) {
        CAPTURE(maker.name);
        const Trial trial = maker.make(Coarseness::quick);
        CHECK(trial.name == maker.name);
        CHECK(flying::validate(trial.scene).empty());
        REQUIRE(trial.looks.size() >= 2);
        CHECK(trial.looks.front() == 0.0);
        CHECK(trial.looks.back() == trial.until);
        for (const double time : trial.looks) CHECK(std::abs(time * 60.0 - std::round(time * 60.0)) < 1e-9);
        CHECK_FALSE(trial.measures.empty());
        CHECK_FALSE(trial.why.empty());
        CHECK_FALSE(trial.truth.empty());
    }
}

TEST_CASE("this engine is right in every scene with a closed form of flights and impacts")
{
    for (const char* name : {"bounce-elastic", "bounce-half", "billiard", "kepler", "cradle-gaps", "galperin", "row-10",
                             "corner-impact", "oblique-impact"}) {
        for (const TrialMaker& maker : trial_makers()) {
            if (maker.name != name) continue;
            CAPTURE(maker.name);
            const Trial trial = maker.make(Coarseness::quick);
            SweepOptions options;
            options.repeats = 1;
            options.most = 1e9;
            options.hertz = {60.0};
            options.seconds = ticking;
            const std::vector<Engine> engines = {own_engine(false)};
            const work::DiagramRecord record = sweep(trial, engines, options, [](const std::string&) {});
            REQUIRE(record.curves.at(0).points.size() == 1);
            // Rounding, grown over some hundreds of impacts
            CHECK(record.curves[0].points[0].measures[0] < 1e-10);
        }
    }
}
