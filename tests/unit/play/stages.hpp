#pragma once

#include <doctest/doctest.h>

#include <string>
#include <utility>

#include "play/keys.hpp"
#include "play/paint_stage.hpp"
#include "play/stage.hpp"
#include "scene/generate.hpp"
#include "support/worlds.hpp"

/// Stages that several files of these tests play with.
namespace flying::testing {

/// A clock that stands still: the budget of a frame is never used up.
inline double no_time() { return 0.0; }

/// Each call is a second later: one portion of events uses up the budget.
inline double short_of_time()
{
    static double now = 0.0;
    return now += 1.0;
}

/// A disc, a box and a triangle in a box of 10 m x 8 m under gravity.
inline Scene three_bodies()
{
    Scene scene;
    scene.title = "three bodies";
    scene.world.field = UniformField{{0.0, -1.0}};
    scene.world.box = BoxDef{{0.0, 0.0}, {10.0, 8.0}};
    BodyDef triangle;
    triangle.shape = RegularDef{3, 0.6};
    triangle.position = {7.0, 5.0};
    triangle.spin = 1.0;
    scene.bodies = {disc(0.5, {2.0, 4.0}, {1.0, 0.0}), rectangle(1.0, 0.6, {5.0, 2.0}), triangle};
    scene.bodies[0].name = "ball";
    scene.bodies[1].name = "box";
    return scene;
}

inline Stage stage_of(const Scene& scene)
{
    Expected<Stage> stage = Stage::open(scene);
    REQUIRE(stage.has_value());
    return std::move(stage).value();
}

/// A generated gas of polygons.
inline Scene gas(int count, std::uint64_t seed = 1)
{
    GenerateOptions options;
    options.seed = seed;
    options.count = count;
    options.shape = "polygon";
    const Expected<Scene> scene = generate("gas", options);
    REQUIRE(scene.has_value());
    return scene.value();
}

inline void play(Stage& stage, double seconds, double frame = 1.0 / 60.0)
{
    for (double t = 0.0; t < seconds - 0.5 * frame; t += frame) stage.advance(frame, no_time);
}

/// The mouse goes there, and the frame that is told of it is in time.
inline void point(Stage& stage, const Vec2& place)
{
    point_at_world(stage, place, stage.now);
}

/// All numbers of all bodies, for comparing bit by bit.
inline std::vector<double> numbers_of(const Stage& stage)
{
    std::vector<double> all;
    for (int k = 0; k < stage.run.world().body_count(); ++k) {
        const BodyState s = stage.run.world().state(k);
        all.insert(all.end(), {s.position.x(), s.position.y(), s.velocity.x(), s.velocity.y(), s.angle, s.spin});
    }
    return all;
}

inline double energy_of(Stage& stage) { return stage.run.world().report().energy.total(); }

} // namespace flying::testing
