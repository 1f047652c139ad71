#include <doctest/doctest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "program.hpp"

using namespace flying::ui;
using Names = std::vector<std::string>;

TEST_CASE("a place that can't be written to is refused before the run, with status 2 and nothing written")
{
    const Folder folder;
    folder.write("s.toml", two_discs());
    REQUIRE(folder.run("mkdir f").status == 0);
    // Below a file, in a folder that isn't there, and where a folder stands: refused to the superuser too
    for (const std::string place : {"s.toml/x", "nowhere/x", "f", "f/"}) {
        for (const std::string option : {"--report", "--trace"}) {
            CAPTURE(place);
            const Outcome outcome = folder.run("$FLYING simulate s.toml --picture p.png " + option + " " + place);
            CHECK(outcome.status == 2);
            CHECK(contains(outcome.errors, place + ": "));
            CHECK(contains(outcome.errors, "nothing was written"));
            CHECK(outcome.output.empty());
            CHECK(folder.names() == Names{"f", "s.toml"});
        }
    }
    const Outcome film = folder.run("$FLYING simulate s.toml --video s.toml/x.mp4");
    CHECK(film.status == 2);
    CHECK(folder.names() == Names{"f", "s.toml"});
}

TEST_CASE("a run that fails leaves its report alone, with the place of the failure, and status 1")
{
    // The bounces of a ball at e = 1/2, dropped from h, end after sqrt(2 h / g) (1 + e) / (1 - e): no engine of events
    // alone gets past that
    const Folder folder;
    folder.write("s.toml", R"(until = 10.0
[world]
field = { kind = "uniform", gravity = [0.0, -9.81] }
restitution = 0.5
box = { min = [-1.0, 0.0], max = [1.0, 5.0] }
[[body]]
name = "ball"
shape = { kind = "disc", radius = 0.1 }
position = [0.0, 2.0]
)");
    const Outcome outcome = folder.run("$FLYING simulate --engine events s.toml --report r.json --trace t.ndjson --picture p.png");
    CHECK(outcome.status == 1);
    CHECK(contains(outcome.errors, "ball"));
    CHECK(folder.names() == Names{"r.json", "s.toml"});
    const nlohmann::json report = nlohmann::json::parse(folder.read("r.json"));
    REQUIRE(report.contains("failure"));
    CHECK(report["failure"]["bodies"] == nlohmann::json::array({0}));
    CHECK(contains(report["failure"]["message"].get<std::string>(), "ball"));
    CHECK(report["failure"]["time"].get<double>() == doctest::Approx(3.0 * std::sqrt(2.0 * 1.9 / 9.81)).epsilon(1e-9));
    CHECK(report["time"] == report["failure"]["time"]);
}

TEST_CASE("a file that grows too large leaves nothing behind, with status 1")
{
    // The limit is 4 blocks of 1024 bytes; the trace has 2001 lines, the report waits beside it
    const Folder folder;
    folder.write("s.toml", two_discs());
    folder.write("old.ndjson", "old");
    const Outcome outcome = folder.run(
        "bash -c 'ulimit -f 4; exec $FLYING simulate s.toml --report r.json --trace old.ndjson --every 0.001'");
    CHECK(outcome.status == 1);
    CHECK(contains(outcome.errors, "old.ndjson: File too large"));
    CHECK(folder.names() == Names{"old.ndjson", "s.toml"});
    CHECK(folder.read("old.ndjson") == "old");

    const Outcome picture =
        folder.run("bash -c 'ulimit -f 4; exec $FLYING simulate s.toml --report r.json --picture p.png'");
    CHECK(picture.status == 1);
    CHECK(contains(picture.errors, "p.png: "));
    CHECK(folder.names() == Names{"old.ndjson", "s.toml"});
}

TEST_CASE("a film that does not fit leaves nothing behind, with status 1")
{
    if (!has_program("ffmpeg")) {
        MESSAGE("left out: no ffmpeg");
        return;
    }
    const Folder folder;
    folder.write("s.toml", two_discs());
    const Outcome outcome = folder.run("bash -c 'ulimit -f 4; exec $FLYING simulate s.toml --until 0.5 --video v.mp4'");
    CHECK(outcome.status == 1);
    CHECK(contains(outcome.errors, "v.mp4: "));
    CHECK(folder.names() == Names{"s.toml"});
}

TEST_CASE("a full disk is told by name and leaves nothing behind")
{
    const Folder folder;
    folder.write("s.toml", two_discs());
    const std::string disk = (folder.path() / "disk").string();
    if (folder.run("mkdir '" + disk + "' && mount -t tmpfs -o size=64k tmpfs '" + disk + "'").status != 0) {
        MESSAGE("left out: no small file system can be mounted here");
        return;
    }
    const Outcome outcome = folder.run("$FLYING simulate s.toml --trace '" + disk + "/t' --every 0.001");
    const Outcome left = folder.run("ls -A '" + disk + "'");
    const Outcome unmounted = folder.run("umount '" + disk + "'");
    CHECK(outcome.status == 1);
    CHECK(contains(outcome.errors, "/t: No space left on device"));
    CHECK(left.output.empty());
    CHECK(unmounted.status == 0);
}

TEST_CASE("standard output that can't take a scene is a failure")
{
    const Folder folder;
    const Outcome outcome = folder.run("$FLYING generate balls > /dev/full");
    CHECK(outcome.status == 1);
    CHECK(contains(outcome.errors, "No space left on device"));
}

TEST_CASE("a signal stops a run, takes its files away and gives status 128 and the signal's number")
{
    // A shell without job control makes the programs it puts behind deaf to Ctrl-C; env gives them their hearing back.
    // In the foreground, timeout sends its signal once; else again to the group, in which the program then is, too, and
    // whether it has seen the first by then is up to the machine
    struct Case
    {
        std::string signal;
        int status;
    };
    for (const Case& one : {Case{"INT", 130}, Case{"TERM", 143}}) {
        for (const bool once : {true, false}) {
            CAPTURE(one.signal);
            CAPTURE(once);
            const Folder folder;
            REQUIRE(folder.run("$FLYING generate gas --count 200 --until 1e7 > s.toml").status == 0);
            const Outcome outcome =
                folder.run("timeout --preserve-status " + std::string(once ? "--foreground " : "") + "-s " +
                           one.signal + " 1 env --default-signal=INT $FLYING simulate s.toml --trace t.ndjson " +
                           "--every 1 --report r.json");
            CAPTURE(outcome.errors);
            CHECK(outcome.status == one.status);
            if (once) {
                CHECK(contains(outcome.errors, "s; nothing was written"));
            } else {
                CHECK(contains(outcome.errors, "flying: stopped at "));
            }
            CHECK(folder.names() == Names{"s.toml"});
        }
    }
}

TEST_CASE("a signal ends at once what only reads a scene")
{
    // The pipe is open, and nothing comes
    for (const std::string command : {"check", "explain", "simulate --report r.json"}) {
        CAPTURE(command);
        const Folder folder;
        const Outcome outcome =
            folder.run("mkfifo s.toml && { sleep 4 > s.toml & } && timeout --preserve-status --foreground -s INT "
                       "-k 2 1 env --default-signal=INT $FLYING " +
                       command + " s.toml");
        CAPTURE(outcome.errors);
        CHECK(outcome.status == 130);
        CHECK(folder.names() == Names{"s.toml"});
    }
}

TEST_CASE("a signal soon stops a run whose steps are slow")
{
    // Signals were looked at after every 500 events, steps of a large heap among them: that is half a minute and more
    const Folder folder;
    REQUIRE(folder.run("$FLYING generate pile --count 20000 --until 100 > s.toml").status == 0);
    const Outcome outcome =
        folder.run("timeout --preserve-status --foreground -s TERM -k 10 2 $FLYING simulate s.toml --engine rest");
    CAPTURE(outcome.errors);
    CHECK(outcome.status == 143);
}

TEST_CASE("a second signal ends a run at once, takes its files away and says so")
{
    // It is held once its trace is begun, so that both wait for it when it goes on: it handles one right after the other,
    // or within, and never comes to its own end
    const Folder folder;
    REQUIRE(folder.run("$FLYING generate gas --count 200 --until 1e7 > s.toml").status == 0);
    const Outcome outcome = folder.run(
        "bash -c '$FLYING simulate s.toml --trace t.ndjson --every 1 & "
        "while test $(ls -A | wc -l) = 1; do sleep 0.05; done; kill -STOP $!; kill -TERM $!; kill -HUP $!; kill -CONT $!; wait $!'");
    CAPTURE(outcome.errors);
    CHECK((outcome.status == 129 || outcome.status == 143));
    CHECK(outcome.errors == "flying: stopped at once; unfinished files are removed\n");
    CHECK(folder.names() == Names{"s.toml"});
}
