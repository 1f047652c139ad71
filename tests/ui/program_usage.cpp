#include <doctest/doctest.h>

#include "program.hpp"

using namespace flying::ui;
using Names = std::vector<std::string>;

TEST_CASE("help and version go to standard output with status 0")
{
    const Folder folder;
    for (const std::string command : {"--help", "--version", "simulate --help", "check --help", "explain --help",
                                      "generate --help", "window --help", "help", "help generate"}) {
        CAPTURE(command);
        const Outcome outcome = folder.run("$FLYING " + command);
        CHECK(outcome.status == 0);
        CHECK(!outcome.output.empty());
        CHECK(outcome.errors.empty());
    }
    const std::string help = folder.run("$FLYING simulate --help").output;
    for (const std::string option : {"--until", "--engine", "--step", "--without", "--save", "--resume", "--report", "--trace",
                                     "--every", "--picture", "--video", "--explain", "--stats", "--quiet"}) {
        CAPTURE(option);
        CHECK(contains(help, option));
    }
}

TEST_CASE("bad usage says what is wrong, ends with status 2 and writes nothing")
{
    struct Case
    {
        std::string command;
        std::string complaint;
    };
    const std::vector<Case> cases{
        {"", "Usage"},
        {"simulat s.toml", "did you mean simulate?"},
        {"simulate", "SCENE"},
        {"simulate s.toml --pictur x.png", "did you mean --picture?"},
        {"simulate s.toml --until -1", "--until: found -1"},
        {"simulate s.toml --until nan", "--until: found nan"},
        {"simulate s.toml --until ten", "--until: found ten, expected a number"},
        {"simulate s.toml --until", "--until: found nothing, expected T"},
        {"simulate s.toml --until 1 --until 2", "--until: found 2 values, expected at most 1"},
        {"simulate s.toml --report ''", "--report: found an empty name"},
        {"simulate s.toml --report nowhere/r.json", "found no directory nowhere"},
        {"simulate ''", "SCENE: found an empty name"},
        {"help simulat", "did you mean simulate?"},
        {"simulate s.toml --engine evnts", "--engine: found evnts, expected one of auto, events, rest; did you mean events?"},
        {"simulate s.toml --engine rest --step 0 --report r.json", "--step"},
        {"simulate s.toml --step 0 --report r.json", "--step: found 0"},
        {"simulate s.toml --without gird --report r.json", "did you mean grid?"},
        {"simulate s.toml --every 0.1 --report r.json", "needs --trace"},
        {"simulate s.toml --trace t.ndjson --every 0", "--every: found 0"},
        {"simulate s.toml --trace t.ndjson --every 1e-12", "lines until 2 s"},
        {"simulate s.toml --until 1e9 --video v.mp4", "frames until"},
        {"simulate s.toml --picture p.gif", ".png, .svg or .pdf"},
        {"simulate s.toml --video v.avi", ".mp4"},
        {"simulate s.toml --report s.toml", "the same file as the scene"},
        {"simulate s.toml --report a --trace ./a", "the same file as --report"},
        {"generate", "KIND"},
        {"generate heap", "heap"},
        {"generate balls --gap 1", "--gap"},
        {"generate balls --count 1e3", "--count: found 1e3, expected a whole number"},
        {"generate balls --seed -1", "--seed: found -1, expected a whole number from 0"},
        {"generate balls --seed 18446744073709551616", "--seed: found 18446744073709551616"},
        {"generate balls --box 1 1", "--box"},
        {"generate balls --box 1 1 --count 2", "--box"},
        {"generate balls --gravity 1 --count 2", "--gravity"},
        {"generate gas --packing 0.99", "that take 0.99 of a box"},
    };
    for (const Case& one : cases) {
        const Folder folder;
        folder.write("s.toml", two_discs());
        CAPTURE(one.command);
        const Outcome outcome = folder.run("$FLYING " + one.command);
        CAPTURE(outcome.errors);
        CHECK(outcome.status == 2);
        CHECK(outcome.output.empty());
        CHECK(contains(outcome.errors, one.complaint));
        CHECK(folder.names() == Names{"s.toml"});
        CHECK(folder.read("s.toml") == two_discs());
    }
}

TEST_CASE("every fault of a scene is told with its line and column")
{
    const Folder folder;
    folder.write("bad.toml", R"([world]
restitution = 2.0
[[body]]
shape = { kind = "disc", radius = -1.0 }
position = [0.0, 0.0]
[[body]]
shape = { kind = "disc", radius = 1.0 }
position = [5.0, 0.0]
velocty = [1.0, 0.0]
rest = 1.0
)");
    for (const std::string command : {"check", "explain", "simulate --report r.json"}) {
        CAPTURE(command);
        const Outcome outcome = folder.run("$FLYING " + command + " bad.toml");
        CHECK(outcome.status == 2);
        CHECK(outcome.output.empty());
        CHECK(contains(outcome.errors, "bad.toml:2:"));
        CHECK(contains(outcome.errors, "bad.toml:4:"));
        CHECK(contains(outcome.errors, "bad.toml:9:"));
        CHECK(contains(outcome.errors, "did you mean restitution?"));
        CHECK(folder.names() == Names{"bad.toml"});
    }
}

TEST_CASE("a missing scene and a folder in its place are told by name")
{
    const Folder folder;
    const Outcome missing = folder.run("$FLYING simulate nowhere.toml");
    CHECK(missing.status == 2);
    CHECK(contains(missing.errors, "nowhere.toml"));
    const Outcome a_folder = folder.run("mkdir f && $FLYING check f");
    CHECK(a_folder.status == 2);
    CHECK(contains(a_folder.errors, "directory"));
}

TEST_CASE("check and explain say what they found")
{
    const Folder folder;
    folder.write("s.toml", two_discs());
    const Outcome checked = folder.run("$FLYING check s.toml");
    CHECK(checked.status == 0);
    CHECK(contains(checked.output, "2 bodies"));
    const Outcome explained = folder.run("$FLYING explain s.toml");
    CHECK(explained.status == 0);
    CHECK(contains(explained.output, "static-pairs"));
    CHECK(folder.names() == Names{"s.toml"});
}

TEST_CASE("a plan tells work that is left out, work that is done, and work of which there is none")
{
    const Folder folder;
    folder.write("s.toml", two_discs());
    const std::string plan = folder.run("$FLYING explain s.toml").output;
    for (const std::string line : {"skipped  cells", "done     grid", "none     rings", "none     far-vertices"}) {
        CAPTURE(line);
        CHECK(contains(plan, line));
    }
}

TEST_CASE("what generate prints is a scene that runs")
{
    const Folder folder;
    for (const std::string kind : {"balls --count 5 --gravity 0 -9.81", "gas --count 9 --radius 0.1",
                                   "polygons --count 3 --seed 9", "cradle", "billiard --billiard pi --exponent 1"}) {
        CAPTURE(kind);
        const Outcome outcome =
            folder.run("$FLYING generate " + kind + " > s.toml && $FLYING simulate s.toml --until 1");
        CAPTURE(outcome.errors);
        CHECK(outcome.status == 0);
        CHECK(folder.read("s.toml").starts_with("# flying generate " + kind));
    }
    CHECK(folder.run("$FLYING generate balls --seed 4 > a; $FLYING generate balls --seed 4 > b; cmp a b").status == 0);
    CHECK(folder.run("$FLYING generate balls --seed 5 | sed 1d > b; sed 1d a | cmp -s - b").status == 1);
}

TEST_CASE("a quiet run prints nothing, and no run paints progress where there is no terminal")
{
    const Folder folder;
    folder.write("s.toml", two_discs());
    const Outcome quiet = folder.run("$FLYING simulate s.toml --quiet");
    CHECK(quiet.status == 0);
    CHECK(quiet.output.empty());
    CHECK(quiet.errors.empty());
    const Outcome plain = folder.run("$FLYING simulate s.toml --stats --explain");
    CHECK(plain.errors.empty());
    for (const std::string word : {"two discs", "energy", "hash", "predict", "events/s", "static-pairs"}) {
        CAPTURE(word);
        CHECK(contains(plain.output, word));
    }
}

TEST_CASE("without a display, or in a build without gtkmm, the window says what is missing")
{
    const Folder folder;
    folder.write("s.toml", two_discs());
    const Outcome outcome = folder.run("env -u DISPLAY -u WAYLAND_DISPLAY XDG_RUNTIME_DIR=. $FLYING window s.toml");
    CAPTURE(outcome.errors);
    CHECK((outcome.status == 1 || outcome.status == 2));
    CHECK(outcome.output.empty());
    CHECK((contains(outcome.errors, "no display to open a window on") || contains(outcome.errors, "libgtkmm-4.0-dev")));
    CHECK(folder.names() == Names{"s.toml"});
}
