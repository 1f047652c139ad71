#include <cairo.h>

#include "math/random.hpp"
#include "stages.hpp"

using namespace flying;
using namespace flying::testing;

namespace {

/// The mouse at random: it goes somewhere, presses, lets go, scrolls.
void move_at_random(Stage& stage, Random& random)
{
    const Vec2 extent = stage.picture.view.max - stage.picture.view.min;
    switch (random.below(6)) {
    case 0:
    case 1:
        point(stage, stage.picture.view.min + Vec2(random.uniform() * extent.x(), random.uniform() * extent.y()));
        break;
    case 2: press_button(stage, Button::left); break;
    case 3: release_button(stage); break;
    case 4: press_button(stage, Button::right); break;
    case 5: steer(stage, random.below(3) - 1, random.below(3) - 1); break;
    }
}

/// Keys and mouse at random, time between them, and a picture now and then: whatever is done, the stage stays in order.
void play_at_random(Stage& stage, std::uint64_t seed, int strokes)
{
    Random random(seed);
    cairo_surface_t* surface = cairo_image_surface_create(CAIRO_FORMAT_RGB24, 640, 400);
    cairo_t* cairo = cairo_create(surface);
    for (int k = 0; k < strokes; ++k) {
        const Binding& binding = bindings()[static_cast<std::size_t>(random.below(static_cast<int>(bindings().size())))];
        press(stage, binding.keys.substr(0, binding.keys.find(' ')));
        for (int moves = random.below(4); moves > 0; --moves) move_at_random(stage, random);
        for (int frame = random.below(4); frame > 0; --frame) stage.advance(random.uniform(0.0, 0.05), no_time);
        if (k % 8 == 0) paint_stage(cairo, stage, {640, 400});
        REQUIRE(stage.picture.bodies.size() >= stage.run.scene().bodies.size());
        stage.requests.clear();
        REQUIRE(stage.run.world().body_count() < 400);
        REQUIRE(stage.clock.speed >= k_slowest);
        REQUIRE(stage.clock.speed <= k_fastest);
        for (const double number : numbers_of(stage)) REQUIRE(std::isfinite(number));
    }
    CHECK(cairo_status(cairo) == CAIRO_STATUS_SUCCESS);
    cairo_destroy(cairo);
    cairo_surface_destroy(surface);
}

} // namespace

TEST_CASE("random hands break nothing: three bodies")
{
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
        CAPTURE(seed);
        Stage stage = stage_of(three_bodies());
        play_at_random(stage, seed, 150);
    }
}

TEST_CASE("random hands break nothing: a gas")
{
    for (std::uint64_t seed = 11; seed <= 12; ++seed) {
        CAPTURE(seed);
        Stage stage = stage_of(gas(25, seed));
        play_at_random(stage, seed, 100);
    }
}

TEST_CASE("random hands break nothing: a pyramid")
{
    GenerateOptions options;
    options.count = 4;
    const Expected<Scene> pyramid = generate("pyramid", options);
    REQUIRE(pyramid.has_value());
    for (std::uint64_t seed = 21; seed <= 22; ++seed) {
        CAPTURE(seed);
        Stage stage = stage_of(pyramid.value());
        play_at_random(stage, seed, 100);
    }
}
