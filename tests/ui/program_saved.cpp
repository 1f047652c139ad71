#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include "program.hpp"

using namespace flying::ui;
using nlohmann::json;

namespace {

/// What a run reports that mustn't depend on whether it was stopped on the way.
json told(const Folder& folder)
{
    const json report = json::parse(folder.read("r.json"));
    json same;
    for (const char* key : {"time", "engine", "hash", "collisions", "handovers", "handover_log", "energy",
                            "energy_changes", "momentum", "angular_momentum", "max_overlap", "bodies"}) {
        same[key] = report[key];
    }
    return same;
}

} // namespace

TEST_CASE("a run that was stopped and saved goes on with the same bits, whatever moves its bodies")
{
    const Folder folder;
    const std::vector<std::string> scenes = {"gas --count 30 --seed 4 --until 3", "polygons --count 12 --seed 5 --until 3",
                                             "pile --count 12 --seed 6 --until 3", "stack --count 6 --until 3"};
    for (const std::string& scene : scenes) {
        REQUIRE(folder.run("$FLYING generate " + scene + " > s.toml").status == 0);
        for (const std::string engine : {"auto", "rest"}) {
            CAPTURE(scene);
            CAPTURE(engine);
            const std::string run = "$FLYING simulate s.toml --quiet --report r.json ";
            REQUIRE(folder.run(run + "--engine " + engine).status == 0);
            const json whole = told(folder);
            REQUIRE(folder.run(run + "--until 0.7331 --save one.json --engine " + engine).status == 0);
            REQUIRE(folder.run(run + "--until 1.5 --resume one.json --save two.json").status == 0);
            REQUIRE(folder.run(run + "--resume two.json --trace t.ndjson --every 0.5").status == 0);
            CHECK(told(folder) == whole);
            CHECK(folder.read("t.ndjson").starts_with("{\"time\":1.5,"));
        }
    }
}

TEST_CASE("a saved run that doesn't fit is refused with what was found and what was expected, and nothing is written")
{
    const Folder folder;
    folder.write("s.toml", two_discs());
    REQUIRE(folder.run("$FLYING simulate s.toml --quiet --until 1 --save one.json").status == 0);
    const std::string text = folder.read("one.json");
    folder.write("other.toml", two_discs() + "density = 3.0\n");
    folder.write("cut.json", text.substr(0, text.size() / 2));
    folder.write("foreign.json", "{\"a\": 1}\n");
    std::string changed = text;
    const std::size_t digit = changed.find("\"time\":1.0");
    REQUIRE(digit != std::string::npos);
    changed.replace(digit, 10, "\"time\":1.5");
    folder.write("changed.json", changed);
    std::string newer = text;
    newer.replace(newer.find("\"version\":1"), 11, "\"version\":9");
    folder.write("newer.json", newer);

    struct Case
    {
        std::string options;
        std::string told;
    };
    const Case cases[] = {{"s.toml --resume none.json", "none.json"},
                          {"s.toml --resume cut.json", "cut short"},
                          {"s.toml --resume foreign.json", "JSON of another kind"},
                          {"s.toml --resume changed.json", "fingerprint"},
                          {"s.toml --resume newer.json", "version 9"},
                          {"other.toml --resume one.json", "fingerprint"},
                          {"s.toml --resume one.json --engine rest", "the saved run has auto"},
                          {"s.toml --resume one.json --step 0.5", "--step 0.5"},
                          {"s.toml --resume one.json --without grid", "--without grid"},
                          {"s.toml --resume one.json --until 0.5", "has come to 1 s"}};
    for (const Case& one : cases) {
        CAPTURE(one.options);
        const Outcome outcome = folder.run("$FLYING simulate " + one.options + " --quiet --report r.json --save later.json");
        CHECK(outcome.status == 2);
        CHECK(contains(outcome.errors, one.told));
        CHECK(folder.run("test -e r.json").status != 0);
        CHECK(folder.run("test -e later.json").status != 0);
    }
}
