#pragma once

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

#include "scene/generate.hpp"
#include "scene/read.hpp"
#include "world/world.hpp"

// Whole scenes, run, looked at, and gone on with in a right way and in a wrong one.
namespace flying {


/// A scene of the course, by its name.
inline Scene scene_of_course(const std::string& folder, const std::string& name)
{
    return std::move(read_scene_file(folder + "/" + name + ".toml")).value();
}

/// Polygons of all sorts that fall into a heap.
inline Scene rain(int count, std::uint64_t seed)
{
    GenerateOptions options;
    options.count = count;
    options.seed = seed;
    options.packing = 0.12;
    options.gravity = Vec2(0.0, -9.81);
    options.restitution = 0.4;
    options.friction = 0.5;
    options.speed = Bounds{1.0, 3.0};
    options.until = 12.0;
    return std::move(generate("polygons", options)).value();
}



inline World start(const Scene& scene, const WorldOptions& options = {})
{
    return std::move(World::make(scene, options)).value();
}

/// Move on to a time. A run of this chapter that can't is a fault of the chapter.
inline void go(World& world, double time)
{
    if (const auto failure = world.advance(time)) {
        std::fprintf(stderr, "%s\n", failure->message.c_str());
        std::abort();
    }
}



/// How many bodies each integrator has.
struct Shares
{
    int events = 0;
    int rest = 0;
    int asleep = 0;
};

inline Shares shares_of(const World& world)
{
    Shares shares;
    for (int k = 0; k < world.body_count(); ++k) {
        shares.events += world.mover(k) == BodyMover::events;
        shares.rest += world.mover(k) == BodyMover::rest;
        shares.asleep += world.mover(k) == BodyMover::asleep;
    }
    return shares;
}



/// The greatest distance between a body and the same one in another world.  [m]
inline double apart(const World& one, const World& other)
{
    double most = 0.0;
    for (int k = 0; k < one.body_count(); ++k) {
        const Vec2 d = one.state(k).position - other.state(k).position;
        most = std::max(most, d.norm());
    }
    return most;
}



/// A run that is stopped and gone on with as it was.
inline World resumed(const World& world, const WorldOptions& options = {})
{
    const Snapshot snapshot = world.snapshot();
    return std::move(World::resume(world.scene(), snapshot, options)).value();
}



/// A number as it reads after so many significant digits were written.
inline double written(double x, int digits)
{
    char text[40];
    std::snprintf(text, sizeof text, "%.*g", digits, x);
    return std::strtod(text, nullptr);
}

/// WRONG, and it looks right: all that one sees of a world, as the start of another.
/// digits  of each number
inline Scene as_it_looks(const World& world, int digits)
{
    Scene scene = world.scene();
    for (int k = 0; k < world.body_count(); ++k) {
        const BodyState now = world.state(k);
        const auto keep = [&](double x) { return written(x, digits); };
        BodyDef& body = scene.bodies[static_cast<std::size_t>(k)];
        body.position = now.position.unaryExpr(keep);
        body.velocity = now.velocity.unaryExpr(keep);
        body.angle = keep(now.angle);
        body.spin = keep(now.spin);
    }
    return scene;
}


} // namespace flying
