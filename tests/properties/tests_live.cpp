#include <doctest/doctest.h>

#include <cmath>
#include <limits>

#include "scene/generate_words.hpp"
#include "live/pieces.hpp"
#include "live/run.hpp"
#include "scene/generate.hpp"
#include "scene/write.hpp"

using namespace flying;

namespace {

const std::string k_fall = R"(
[world]
field = { kind = "uniform", gravity = [0.0, -10.0] }
[[body]]
shape = { kind = "disc", radius = 0.5 }
position = [0.0, 8.0]
velocity = [1.0, 0.0]
[[body]]
shape = { kind = "rectangle", width = 2.0, height = 1.0 }
position = [4.0, 8.0]
static = true
)";

} // namespace

TEST_CASE("a live run hands out states and outlines as plain numbers")
{
    LiveRun run(k_fall, {});
    REQUIRE(run.is_ready());
    CHECK(run.message().empty());
    CHECK(run.advance(0.5, 100) == LiveEnd::there);
    CHECK(run.states() == std::vector<double>{0.5, 6.75, 0.0, 1.0, -5.0, 0.0, 4.0, 8.0, 0.0, 0.0, 0.0, 0.0});
    CHECK(run.outline(0) == std::vector<double>{0.0, 0.5});
    const std::vector<double> rectangle = run.outline(1);
    REQUIRE(rectangle.size() == 9);
    CHECK(rectangle[0] == 4.0);
    for (std::size_t k = 1; k < 9; ++k) CHECK(std::fabs(rectangle[k]) == (k % 2 == 1 ? 1.0 : 0.5));
    CHECK(run.box().empty());
}

TEST_CASE("a live run that may handle only a few events at a time gets where the world gets, with the same bits")
{
    const Expected<std::string> text = generate_from_words("gas --count 40 --seed 3 --until 2");
    REQUIRE(text);
    LiveRun whole(text.value(), {});
    LiveRun bitten(text.value(), {});
    CHECK(whole.advance(2.0, 1'000'000) == LiveEnd::there);
    int bites = 1;
    while (bitten.advance(2.0, 5) == LiveEnd::on_the_way) ++bites;
    CHECK(bites > 5);
    CHECK(bitten.world().report().hash == whole.world().report().hash);
}

TEST_CASE("a live run of a text that is no scene says all that is wrong and is not ready")
{
    const LiveRun run("[[body]]\nshape = { kind = \"disc\", radius = -1.0 }\nname = 3\n", {});
    CHECK_FALSE(run.is_ready());
    CHECK(run.message().find("scene:1:1: body 0, position") != std::string::npos);
    CHECK(run.message().find("scene:3:8: body 0, name") != std::string::npos);
}

TEST_CASE("a live run that fails says why, and stays where it failed")
{
    // A ball that bounces lower and lower, on an engine that knows impacts only
    const std::string scene = R"(
[world]
field = { kind = "uniform", gravity = [0.0, -10.0] }
restitution = 0.5
box = { min = [-5.0, 0.0], max = [5.0, 10.0] }
[[body]]
shape = { kind = "disc", radius = 0.5 }
position = [0.0, 2.0]
)";
    WorldOptions options;
    options.engine = EngineChoice::events;
    LiveRun run(scene, options);
    REQUIRE(run.is_ready());
    CHECK(run.advance(10.0, 1'000'000) == LiveEnd::stopped);
    CHECK_FALSE(run.message().empty());
    const double stopped = run.world().time();
    CHECK(stopped < 10.0);
    CHECK(run.advance(10.0, 1'000'000) == LiveEnd::stopped);
    CHECK(run.world().time() == stopped);
}

TEST_CASE("a steered body goes on with its new velocity, from where it is, at the same time of the run")
{
    LiveRun run(k_fall, {});
    CHECK(run.advance(0.5, 100) == LiveEnd::there);
    REQUIRE(run.steer(0, Vec2(-2.0, 1.0)));
    CHECK(run.time() == 0.5);
    CHECK(run.advance(0.75, 100) == LiveEnd::there);
    CHECK(run.time() == 0.75);
    CHECK(run.states()[0] == 0.0);    // 1 / 2 - 2 / 4
    CHECK(run.states()[1] == 6.6875); // 27 / 4 + 1 / 4 - 10 / 2 / 16
    CHECK(!run.steer(1, Vec2(1.0, 0.0)));
    CHECK(!run.steer(2, Vec2(1.0, 0.0)));
    CHECK(!run.steer(-1, Vec2(1.0, 0.0)));
}

TEST_CASE("a piece answers by its name, and nothing where it is asked amiss")
{
    const double falls[] = {10.0, 0.5, 1.0};
    const auto answer = live::answer_of("fall", falls);
    REQUIRE(answer);
    CHECK(answer->engine == live::Numbers{2.5, 5.0}); // the second step alone has a speed: 5 m/s for half a second
    CHECK(answer->paper.empty());
    const double later[] = {10.0, 0.5, 1.5};
    CHECK(live::answer_of("fall", later)->hash() != answer->hash());
    CHECK(!live::answer_of("fall", std::span(falls).first(2)));
    CHECK(!live::answer_of("rise", falls));
    const double bad[] = {10.0, 0.5, std::numeric_limits<double>::quiet_NaN()};
    CHECK(!live::answer_of("fall", bad));
}

TEST_CASE("the words of generate make the scene that its options make")
{
    GenerateOptions options;
    options.seed = 7;
    options.count = 12;
    options.radius = Bounds{0.2, 0.4};
    options.max_spin = 2.5;
    options.gravity = Vec2(0.0, -9.81);
    options.box = BoxDef{Vec2(-6.0, -1.0), Vec2(6.0, 8.5)};
    const Expected<Scene> scene = generate("polygons", options);
    REQUIRE(scene);
    const std::string words = "polygons --seed 7 --count 12 --radius 0.2 0.4 --max-spin 2.5 --gravity 0 -9.81 --box -6 -1 6 8.5";
    const Expected<std::string> text = generate_from_words(words);
    REQUIRE(text);
    CHECK(text.value() == write_scene(scene.value(), "flying generate " + words));
}

TEST_CASE("every option of every kind of scene can be said in words")
{
    for (const GeneratorKind& kind : generator_kinds()) {
        for (std::string option : kind.options) {
            for (char& c : option) c = c == '_' ? '-' : c;
            const Expected<std::string> text = generate_from_words(kind.name + " --" + option);
            REQUIRE_FALSE(text);
            CAPTURE(kind.name);
            CHECK(text.faults() == Faults{{"--" + option, "\"\"", "the values that it takes"}});
        }
    }
}

TEST_CASE("words that make no scene are all told")
{
    const Expected<std::string> text = generate_from_words("gas 3 --seed -1 --radius 1 2 3 --colour red");
    REQUIRE_FALSE(text);
    CHECK(text.faults() == Faults{{"3", "a value without an option", "--name before it"},
                                  {"--seed", "\"-1\"", "the values that it takes"},
                                  {"--radius", "\"1 2 3\"", "the values that it takes"},
                                  {"--colour", "no such option", ""}});
    CHECK_FALSE(generate_from_words(""));
    CHECK_FALSE(generate_from_words("nothing"));
}
