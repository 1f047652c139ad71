#include "piles.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "compare.hpp"
#include "machine.hpp"
#include "resting.hpp"
#include "scenes.hpp"
#include "simulators.hpp"
#include "weighed.hpp"

namespace flying::bench {
namespace {

constexpr double k_hertz = 60.0;
constexpr int k_steps_a_round = 10;
constexpr int k_asleep_steps = 10000;

struct Case
{
    std::string name;
    const char* kind;
    GenerateOptions options;
    int settle;       ///< steps before the clock runs
    int most_to_rest; ///< steps until all must sleep
};

std::vector<Case> cases(Extent extent)
{
    GenerateOptions boxes;
    boxes.seed = 5;
    boxes.count = extent == Extent::full ? 5000 : 1000;
    boxes.shape = "box";
    boxes.restitution = 0.0;
    boxes.friction = 0.5;
    GenerateOptions discs = boxes;
    discs.shape = "disc";
    GenerateOptions stack;
    stack.count = 50;
    stack.restitution = 0.0;
    stack.friction = 0.5;
    GenerateOptions pyramid = stack;
    pyramid.count = 20;
    return {{fmt::format("pile of {} boxes", *boxes.count), "pile", boxes, 600, 2400},
            {fmt::format("pile of {} discs", *discs.count), "pile", discs, 600, 2400},
            {"stack of 50", "stack", stack, 300, 600},
            {"pyramid of base 20", "pyramid", pyramid, 300, 600}};
}

/// How deep the pairs that touch overlap, by one ruler for all.
struct Depths
{
    long touching = 0; ///< pairs nearer than a thousandth of their size
    double mean = 0.0; ///< over those [radii]
    double worst = 0.0;
};

Depths depths_of(const std::vector<WeighedBody>& bodies, const std::vector<BodyState>& states)
{
    std::vector<std::size_t> order;
    for (std::size_t k = 0; k < bodies.size(); ++k) order.push_back(k);
    const auto low = [&](std::size_t k) { return states[k].position.x() - bodies[k].radius; };
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return low(a) < low(b); });
    std::vector<CollisionShape> shapes;
    for (const WeighedBody& body : bodies) shapes.push_back(make_collision_shape(body.shape));
    Depths depths;
    for (std::size_t i = 0; i < order.size(); ++i) {
        const std::size_t a = order[i];
        for (std::size_t j = i + 1; j < order.size(); ++j) {
            const std::size_t b = order[j];
            if (low(b) > states[a].position.x() + bodies[a].radius) break;
            const double reach = bodies[a].radius + bodies[b].radius;
            if ((states[a].position - states[b].position).squaredNorm() > reach * reach) continue;
            const double gap = separation(shapes[a], pose_of(states[a]), shapes[b], pose_of(states[b]));
            const double size = std::min(bodies[a].radius, bodies[b].radius);
            if (gap > 1e-3 * size) continue;
            ++depths.touching;
            depths.mean += std::max(-gap, 0.0) / size;
            depths.worst = std::max(depths.worst, -gap / size);
        }
    }
    depths.mean /= std::max(1.0, static_cast<double>(depths.touching));
    return depths;
}

struct Runner
{
    std::string name;
    std::function<void()> step;
    std::function<std::vector<BodyState>()> states;
    std::vector<double> rounds = {}; ///< milliseconds a step
    double worst = 0.0;              ///< [ms]
};

void settle(Runner& runner, int steps)
{
    for (int k = 0; k < steps; ++k) {
        const double start = cpu_seconds();
        runner.step();
        runner.worst = std::max(runner.worst, (cpu_seconds() - start) * 1e3);
    }
}

void measure(Runner& runner)
{
    const double start = cpu_seconds();
    for (int k = 0; k < k_steps_a_round; ++k) runner.step();
    runner.rounds.push_back((cpu_seconds() - start) / k_steps_a_round * 1e3);
}

void lay_to_sleep(PileComparison& result, const Scene& scene, const Case& of)
{
    Resting resting(scene, k_hertz, true);
    const RestEngine& engine = resting.engine();
    int moving = 0;
    int asleep = 0;
    int steps = 0;
    do {
        resting.step();
        ++steps;
        moving = asleep = 0;
        for (int k = 0; k < engine.body_count(); ++k) {
            moving += engine.body(k).is_static ? 0 : 1;
            asleep += engine.is_asleep(k) ? 1 : 0;
        }
    } while (asleep < moving && steps < of.most_to_rest);
    result.asleep_after = static_cast<double>(asleep) / std::max(1, moving);
    if (asleep < moving) return;
    result.asleep_at = steps / k_hertz;
    const double start = cpu_seconds();
    for (int k = 0; k < k_asleep_steps; ++k) resting.step();
    result.asleep_micros = (cpu_seconds() - start) / k_asleep_steps * 1e6;
}

PileComparison compare_one(const Case& of, int rounds, const std::function<void(const std::string&)>& tell)
{
    const Scene scene = scene_of(of.kind, of.options);
    const std::vector<WeighedBody> bodies = weigh(scene);
    Chipmunk chipmunk(scene, k_hertz);
    Box2d box2d(scene, k_hertz);
    Resting resting(scene, k_hertz, false);
    long chipmunk_steps = 0;
    long box2d_steps = 0;
    std::vector<Runner> runners = {
        {"chipmunk", [&] { chipmunk.advance(static_cast<double>(++chipmunk_steps) / k_hertz); },
         [&] { return chipmunk.states(); }},
        {"box2d", [&] { box2d.advance(static_cast<double>(++box2d_steps) / k_hertz); }, [&] { return box2d.states(); }},
        {"flying", [&] { resting.step(); }, [&] { return resting.states(); }}};
    for (Runner& runner : runners) {
        tell(of.name + ": " + runner.name + " settles");
        settle(runner, of.settle);
    }

    // In turns, so that whatever else the machine does concerns all
    tell(of.name + ": rounds");
    for (int round = 0; round < rounds; ++round) {
        for (Runner& runner : runners) measure(runner);
    }
    PileComparison result;
    result.name = of.name;
    result.settled = of.settle;
    for (const Runner& runner : runners) {
        const Depths depths = depths_of(bodies, runner.states());
        result.showings.push_back(
            {runner.name, median(runner.rounds), runner.worst, depths.touching, depths.mean, depths.worst});
    }
    tell(of.name + ": falling asleep");
    lay_to_sleep(result, scene, of);
    return result;
}

} // namespace

std::vector<PileComparison> measure_piles(Extent extent, int rounds,
                                          const std::function<void(const std::string&)>& tell)
{
    std::vector<PileComparison> results;
    for (const Case& of : cases(extent)) results.push_back(compare_one(of, rounds, tell));
    return results;
}

} // namespace flying::bench
