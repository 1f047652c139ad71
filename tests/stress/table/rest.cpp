// One body or a few that lean: heavy on light, tall, on slopes; the end of the bounces.

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "table/trials.hpp"

namespace flying::stress {
namespace {

/// Unit boxes one on the other over a floor.
Scene stack_of(int count)
{
    Scene scene = over_floor(0.0, 0.5);
    for (int k = 0; k < count; ++k) scene.bodies.push_back(rectangle(1.0, 1.0, {0.0, 0.5 + k}));
    return scene;
}

double farthest_from_start(const World& world)
{
    double farthest = 0.0;
    for (int k = 0; k < world.body_count(); ++k) {
        const Vec2 start = world.scene().bodies[static_cast<std::size_t>(k)].position;
        farthest = std::max(farthest, (world.state(k).position - start).norm());
    }
    return farthest;
}

Reached heavy_on_light(const Share&)
{
    Reached reached;
    double worst = 0.0;
    for (const double ratio : {1e2, 1e3, 1e4, 1e6, 1e9, 1e12}) {
        Scene scene = stack_of(2);
        scene.bodies[1].density = ratio;
        World world = world_of(scene);
        run_to(world, 20.0);
        const double moved = std::max(farthest_from_start(world), world.report().max_overlap);
        if (moved > 1e-3) break;
        worst = std::max(worst, moved);
        reached.value = ratio;
    }
    reached.amount = "20 s at each of 1e2, 1e3, 1e4, 1e6, 1e9, 1e12";
    reached.remark = fmt::format("moves by {:.1e} sides at most", worst);
    return reached;
}

Reached tall_stack(const Share&)
{
    Reached reached;
    double sag = 0.0;
    for (const int count : {10, 50, 200, 1000}) {
        World world = world_of(stack_of(count));
        run_to(world, 60.0);
        sag = count - 0.5 - world.state(count - 1).position.y();
        if (std::abs(sag) > 0.01 || farthest_from_start(world) > 0.01) break;
        reached.value = count;
    }
    reached.amount = "60 s at each of 10, 50, 200, 1000";
    reached.remark = fmt::format("the last one's top sinks by {:.1e} m", sag);
    return reached;
}

/// How far a block has gone on a slope after a time; it is too flat to tip.
double slid(double tilt, double mu, double time, const WorldOptions& options = {})
{
    Scene scene = over_floor(0.0, mu, tilt);
    scene.bodies = {rectangle(4.0, 1.0, {0.0, 0.5})};
    World world = world_of(scene, options);
    run_to(world, time);
    return (world.state(0).position - scene.bodies[0].position).norm();
}

Reached stick(const Share&)
{
    Reached reached;
    reached.value = 1.0;
    for (const double off : {1e-3, 1e-6, 1e-9, 1e-10, 1e-11, 1e-12}) {
        bool is_right = true;
        for (const double tilt : {0.1, 0.5, 1.0}) {
            const double tangent = std::tan(tilt);
            const double way = 50.0 * k_gravity * std::sin(tilt) * off;
            is_right = is_right && slid(tilt, (1.0 + off) * tangent, 10.0) == 0.0;
            is_right = is_right && std::abs(slid(tilt, (1.0 - off) * tangent, 10.0) / way - 1.0) < 0.01;
        }
        if (!is_right) break;
        reached.value = off;
    }
    reached.amount = "three slopes, 10 s each";
    reached.remark = "below, rounding of sine, cosine and friction decides";
    return reached;
}

Reached tip(const Share&)
{
    Reached reached;
    reached.value = 1.0;
    for (const double off : {1e-3, 1e-6, 1e-9, 1e-10, 1e-11, 1e-12}) {
        bool is_right = true;
        for (const double more : {-off, off}) {
            Scene scene = over_floor(0.0, 5.0, std::atan((1.0 + more) * 0.7));
            scene.bodies = {rectangle(0.7, 1.0, {0.0, 0.5})};
            World world = world_of(scene);
            run_to(world, 10.0);
            is_right = is_right && (std::abs(world.state(0).angle) > off) == (more > 0.0);
        }
        if (!is_right) break;
        reached.value = off;
    }
    reached.amount = "a block on a rough slope, 10 s each";
    return reached;
}

Reached creep(const Share&)
{
    WorldOptions awake;
    awake.without = {"sleeping"};
    Reached reached;
    for (const double tilt : {0.1, 0.5, 1.0}) {
        reached.value = std::max(reached.value, slid(tilt, 1.001 * std::tan(tilt), 3600.0));
        reached.value = std::max(reached.value, slid(tilt, 1.001 * std::tan(tilt), 3600.0, awake));
    }
    reached.amount = "three slopes, an hour of 216000 steps each, asleep and kept awake";
    return reached;
}

Reached last_bounce(const Share&)
{
    Reached reached;
    int tried = 0;
    for (const double e : {0.1, 0.3, 0.5, 0.7, 0.9}) {
        for (const double height : {1e-3, 4.9, 1e3}) {
            Scene scene = over_floor(e, 0.0);
            scene.bodies = {disc(0.5, {0.0, 0.5 + height})};
            World world = world_of(scene);
            const double fall = scene.bodies[0].position.y() - 0.5; // what rounding has left of the height
            const double end = std::sqrt(2.0 * fall / k_gravity) * (1.0 + e) / (1.0 - e);
            run_to(world, 1.01 * end);
            if (world.handovers().empty()) throw std::runtime_error("no hand-over");
            reached.value = std::max(reached.value, std::abs(world.handovers()[0].time / end - 1.0));
            ++tried;
        }
    }
    reached.amount = fmt::format("{} balls of e from 0.1 to 0.9, from 1 mm, 4.9 m and 1 km", tried);
    return reached;
}

constexpr std::array k_trials = {
    Trial{1, "a heavy box on a light one", "largest ratio of masses that stands", 1e4, true, "1e2 at 60 steps a second",
          heavy_on_light},
    Trial{2, "a stack of boxes", "boxes that stand for a minute", 200.0, true, "50, sagging by 0.85", tall_stack},
    Trial{10, "sticking on a slope", "distance from mu = tan t still told", 1e-9, false, "1e-2", stick},
    Trial{10, "tipping on a slope", "distance from tan t = b/h still told", 1e-9, false, "5e-3", tip},
    Trial{10, "creep on a slope", "way in an hour [m]", 0.0, false, "", creep},
    Trial{11, "the end of the bounces", "relative error of its time", 1e-12, false, "5e-2", last_bounce},
};

} // namespace

std::span<const Trial> trials_of_rest()
{
    return k_trials;
}

} // namespace flying::stress
