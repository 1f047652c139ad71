// flying_bench_piles: what lies and stands, in this engine beside Chipmunk and Box2D, in one run.

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <string>

#include "machine.hpp"
#include "resting.hpp"
#include "scenes.hpp"
#include "simulators.hpp"
#include "weighed.hpp"

using namespace flying;
using namespace flying::bench;

namespace {

constexpr double k_hertz = 60.0;

struct Case
{
    const char* name;
    const char* kind;
    GenerateOptions options;
    int settle; ///< steps before the clock runs
};

std::vector<Case> cases()
{
    GenerateOptions boxes;
    boxes.seed = 5;
    boxes.count = 5000;
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
    return {{"pile of 5000 boxes", "pile", boxes, 600},
            {"pile of 5000 discs", "pile", discs, 600},
            {"stack of 50", "stack", stack, 600},
            {"pyramid of base 20", "pyramid", pyramid, 600}};
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
};

} // namespace

int main(int count, char** words)
{
    int steps = 60;
    std::string only;
    std::string engine;
    for (int k = 1; k + 1 < count; k += 2) {
        if (std::strcmp(words[k], "--steps") == 0) steps = std::atoi(words[k + 1]);
        else if (std::strcmp(words[k], "--scene") == 0) only = words[k + 1];
        else if (std::strcmp(words[k], "--engine") == 0) engine = words[k + 1];
        else return 2;
    }
    std::printf("Steps of 1/60 s, nobody sleeps. Debian builds Chipmunk and Box2D with assertions on.\n"
                "%-20s %-9s %10s %12s %10s %12s %12s\n",
                "scene", "engine", "ms a step", "of Chipmunk", "touching", "mean overlap", "worst (radii)");
    for (const Case& c : cases()) {
        if (!only.empty() && only != c.name) continue;
        const Scene scene = scene_of(c.kind, c.options);
        const std::vector<WeighedBody> bodies = weigh(scene);
        Chipmunk chipmunk(scene, k_hertz);
        Box2d box2d(scene, k_hertz);
        Resting resting(scene, k_hertz, false);
        long chipmunk_steps = 0;
        long box2d_steps = 0;
        const std::vector<Runner> runners = {
            {"Chipmunk", [&] { chipmunk.advance(static_cast<double>(++chipmunk_steps) / k_hertz); },
             [&] { return chipmunk.states(); }},
            {"Box2D", [&] { box2d.advance(static_cast<double>(++box2d_steps) / k_hertz); },
             [&] { return box2d.states(); }},
            {"flying", [&] { resting.step(); }, [&] { return resting.states(); }}};
        double chipmunk_ms = 0.0;
        for (const Runner& runner : runners) {
            if (!engine.empty() && runner.name != engine) continue;
            for (int k = 0; k < c.settle; ++k) runner.step();
            const double start = cpu_seconds();
            for (int k = 0; k < steps; ++k) runner.step();
            const double ms = (cpu_seconds() - start) / steps * 1e3;
            if (chipmunk_ms == 0.0) chipmunk_ms = ms;
            const Depths depths = depths_of(bodies, runner.states());
            std::printf("%-20s %-9s %10.3f %12.3f %10ld %12.1e %12.1e\n", c.name, runner.name.c_str(), ms,
                        ms / chipmunk_ms, depths.touching, depths.mean, depths.worst);
            std::fflush(stdout);
        }
    }
    return 0;
}
