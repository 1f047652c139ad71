#include <doctest/doctest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "program.hpp"

using namespace flying::ui;
using nlohmann::json;
using Names = std::vector<std::string>;

namespace {

std::vector<json> lines_of(const std::string& text)
{
    std::vector<json> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) lines.push_back(json::parse(line));
    return lines;
}

} // namespace

TEST_CASE("a report has all its keys and the closed form of a head-on impact in them")
{
    // Equal discs of radius 1/2 that meet head-on at e = 1 swap their velocities, 2 m apart after (4 - 1) m / 6 m/s
    const Folder folder;
    folder.write("s.toml", R"(until = 1.0
[[body]]
name = "a \"quoted\" name"
shape = { kind = "disc", radius = 0.5 }
position = [-2.0, 0.0]
velocity = [3.0, 0.0]
[[body]]
shape = { kind = "disc", radius = 0.5 }
position = [2.0, 0.0]
velocity = [-3.0, 0.0]
[[body]]
shape = { kind = "disc", radius = 0.5 }
position = [0.0, 9.0]
static = true
)");
    REQUIRE(folder.run("$FLYING simulate s.toml --report r.json").status == 0);
    CHECK(folder.names() == Names{"r.json", "s.toml"});
    const json report = json::parse(folder.read("r.json"));
    for (const char* key : {"time", "engine", "events", "collisions", "handovers", "energy", "momentum",
                            "angular_momentum", "max_overlap", "hash", "plan", "stages", "wall_seconds", "bodies"}) {
        CAPTURE(key);
        CHECK(report.contains(key));
    }
    CHECK(!report.contains("failure"));
    CHECK(!report.contains("rest")); // the two only fly
    CHECK(report["time"] == 1.0);
    CHECK(report["engine"] == "events");
    CHECK(report["collisions"] == 1);
    CHECK(report["hash"].get<std::string>().size() == 16);
    for (const char* key : {"kinetic", "potential", "total", "initial_total"}) CHECK(report["energy"].contains(key));
    const json& body = report["bodies"][0];
    for (const char* key : {"name", "position", "angle", "velocity", "spin", "mass", "inertia"})
        CHECK(body.contains(key));
    CHECK(body["name"] == "a \"quoted\" name");

    // Contact after half a second at x = -1/2; half a second back at 3 m/s
    CHECK(body["velocity"][0].get<double>() == doctest::Approx(-3.0).epsilon(1e-15));
    CHECK(body["position"][0].get<double>() == doctest::Approx(-2.0).epsilon(1e-15));
    CHECK(body["mass"].get<double>() == doctest::Approx(std::acos(-1.0) / 4.0).epsilon(1e-15));
    CHECK(report["bodies"][2]["mass"].is_null());
}

TEST_CASE("numbers in a report have seventeen digits")
{
    const Folder folder;
    folder.write("s.toml", two_discs());
    REQUIRE(folder.run("$FLYING simulate s.toml --until 0.1 --report r.json").status == 0);
    CHECK(folder.read("r.json").find("\"time\": 0.10000000000000001,") != std::string::npos);
}

TEST_CASE("a trace has a line for every output time and one for the end")
{
    const Folder folder;
    folder.write("s.toml", two_discs());
    REQUIRE(folder.run("$FLYING simulate s.toml --trace t.ndjson --every 0.75").status == 0);
    const std::vector<json> lines = lines_of(folder.read("t.ndjson"));
    REQUIRE(lines.size() == 4);
    const double times[] = {0.0, 0.75, 1.5, 2.0};
    for (std::size_t i = 0; i < lines.size(); ++i) {
        CHECK(lines[i]["time"] == times[i]);
        REQUIRE(lines[i]["bodies"].size() == 2);
        CHECK(lines[i]["bodies"][1].size() == 6);
    }
    CHECK(lines[0]["bodies"][0] == json({2.0, 2.5, 0.0, 3.0, 0.0, 0.0}));
    // 3 m/s for 0.75 s: still before they meet
    CHECK(lines[1]["bodies"][0][0] == 4.25);

    REQUIRE(folder.run("$FLYING simulate s.toml --trace t.ndjson").status == 0);
    CHECK(lines_of(folder.read("t.ndjson")).size() == 101);
    REQUIRE(folder.run("$FLYING simulate s.toml --until 0 --trace t.ndjson").status == 0);
    CHECK(lines_of(folder.read("t.ndjson")).size() == 1);
}

TEST_CASE("looking on does not change a run")
{
    const Folder folder;
    REQUIRE(folder.run("$FLYING generate polygons --count 12 --seed 2 --until 3 > s.toml").status == 0);
    const auto hash = [&folder](const std::string& options) {
        REQUIRE(folder.run("$FLYING simulate s.toml --report r.json " + options).status == 0);
        return json::parse(folder.read("r.json"))["hash"].get<std::string>();
    };
    const std::string plain = hash("");
    CHECK(hash("--trace t --every 0.001") == plain);
    CHECK(hash("--picture p.png --stats --explain") == plain);
    CHECK(hash("--engine auto --step 0.1") == plain);
    CHECK(hash("--until 2.999") != plain);
}

TEST_CASE("pictures are what their names say")
{
    const Folder folder;
    folder.write("s.toml", two_discs());
    REQUIRE(folder.run("$FLYING simulate s.toml --picture p.png").status == 0);
    CHECK(folder.read("p.png").starts_with("\x89PNG\r\n\x1a\n"));
    REQUIRE(folder.run("$FLYING simulate s.toml --picture p.svg").status == 0);
    CHECK(folder.read("p.svg").find("<svg") != std::string::npos);
    CHECK(folder.read("p.svg").find("</svg>") != std::string::npos);
    REQUIRE(folder.run("$FLYING simulate s.toml --picture P.PDF").status == 0);
    CHECK(folder.read("P.PDF").starts_with("%PDF-"));
    CHECK(folder.read("P.PDF").find("%%EOF") != std::string::npos);
}

TEST_CASE("a film has sixty frames for each second and one for its start")
{
    const Folder folder;
    folder.write("s.toml", two_discs());
    if (!has_program("ffmpeg")) {
        const Outcome outcome = folder.run("$FLYING simulate s.toml --video v.mp4");
        CHECK(outcome.status == 2);
        CHECK(outcome.errors.find("ffmpeg") != std::string::npos);
        return;
    }
    REQUIRE(folder.run("$FLYING simulate s.toml --until 0.5 --video v.mp4").status == 0);
    CHECK(folder.names() == Names{"s.toml", "v.mp4"});
    if (!has_program("ffprobe")) return;
    const Outcome probed =
        folder.run("ffprobe -v error -count_frames -show_entries stream=nb_read_frames,pix_fmt -of json v.mp4");
    const json stream = json::parse(probed.output)["streams"][0];
    CHECK(stream["nb_read_frames"] == "31");
    CHECK(stream["pix_fmt"] == "yuv420p");
}

TEST_CASE("without ffmpeg a film is refused by name")
{
    const Folder folder;
    folder.write("s.toml", two_discs());
    const Outcome outcome = folder.run("PATH=/nowhere $FLYING simulate s.toml --video v.mp4 --report r.json");
    CHECK(outcome.status == 2);
    CHECK(outcome.errors.find("ffmpeg") != std::string::npos);
    CHECK(folder.names() == Names{"s.toml"});
}

TEST_CASE("an older file is replaced, a link is followed, a device is written to")
{
    const Folder folder;
    folder.write("s.toml", two_discs());
    folder.write("old.json", "old");
    REQUIRE(folder.run("chmod 640 old.json && ln -s old.json link.json && $FLYING simulate s.toml --report link.json")
                .status == 0);
    CHECK(json::parse(folder.read("old.json")).contains("hash"));
    CHECK(folder.run("test -L link.json && test \"$(stat -c %a old.json)\" = 640").status == 0);
    CHECK(
        json::parse(folder.run("$FLYING simulate s.toml --quiet --report /dev/stdout | cat").output).contains("hash"));
    CHECK(folder.run("$FLYING simulate s.toml --quiet --report /dev/null && test -c /dev/null").status == 0);
}

TEST_CASE("how the steps of a pile were made stands in its report, and on one line of --stats")
{
    const Folder folder;
    REQUIRE(folder.run("$FLYING generate stack --count 6 --until 1 > s.toml").status == 0);
    const Outcome outcome = folder.run("$FLYING simulate s.toml --report r.json --stats");
    REQUIRE(outcome.status == 0);
    const json rest = json::parse(folder.read("r.json"))["rest"];
    for (const char* key : {"islands", "solved", "swept", "unsolved", "parts", "projected", "limited", "energy_limited"}) {
        CAPTURE(key);
        CHECK(rest.contains(key));
    }
    CHECK(rest["islands"] > 0);
    CHECK(rest["unsolved"] == 0);
    CHECK(contains(outcome.output, "islands at rest: 0 swept, 0 unsolved"));
}
