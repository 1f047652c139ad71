// What the parts of the engine cost, one by one.

#include <benchmark/benchmark.h>

#include <cmath>
#include <vector>

#include "09-which-pairs/all_pairs.hpp"
#include "broadphase/grid.hpp"
#include "broadphase/sweep.hpp"
#include "collide/separation.hpp"
#include "events/event_queue.hpp"
#include "math/random.hpp"
#include "math/sine_cosine.hpp"
#include "response/impact.hpp"
#include "toi/predict.hpp"
#include "world/make_shape.hpp"

namespace flying {
namespace {

constexpr int k_many = 1024; // different inputs, so that no branch is learnt by heart
constexpr double k_turn = 6.283185307179586;

/// Calls measure(k) for one input after the other.
template <typename Measure>
void in_turn(benchmark::State& state, const Measure& measure)
{
    int k = 0;
    for (auto _ : state) {
        benchmark::DoNotOptimize(measure(k));
        k = (k + 1) % k_many;
    }
}

void sine_cosine_of_any_angle(benchmark::State& state)
{
    Random random(1);
    std::vector<double> angles;
    for (int k = 0; k < k_many; ++k) angles.push_back(random.uniform(-100.0, 100.0));
    in_turn(state, [&](int k) { return sine_cosine(angles[k]); });
}
BENCHMARK(sine_cosine_of_any_angle);

struct Pair
{
    Flyer a;
    Flyer b;
};

/// Bodies 1.2 m to 3 m apart; every second pair flies at each other.
std::vector<Pair> pairs(std::uint64_t seed, double max_spin)
{
    Random random(seed);
    std::vector<Pair> pairs(k_many);
    for (Pair& pair : pairs) {
        const SineCosine where = sine_cosine(random.uniform(0.0, k_turn));
        pair.b.state.position = random.uniform(1.2, 3.0) * Vec2(where.cosine, where.sine);
        pair.a.state.velocity = Vec2{random.uniform(-5.0, 5.0), random.uniform(-5.0, 5.0)};
        pair.b.state.velocity = Vec2{random.uniform(-5.0, 5.0), random.uniform(-5.0, 5.0)};
        for (Flyer* flyer : {&pair.a, &pair.b}) {
            flyer->state.angle = random.uniform(0.0, k_turn);
            flyer->state.spin = max_spin > 0.0 ? random.uniform(-max_spin, max_spin) : 0.0;
        }
    }
    return pairs;
}

Shape polygon(int sides)
{
    return make_shape(RegularDef{sides, 0.5}).value();
}

void predict_discs(benchmark::State& state)
{
    const Shape disc = Disc{0.5};
    const std::vector<Pair> all = pairs(2, 0.0);
    in_turn(state, [&](int k) { return predict(disc, all[k].a, disc, all[k].b, 0.0); });
}
BENCHMARK(predict_discs);

/// The argument is the number of vertices of each.
void predict_polygons(benchmark::State& state)
{
    const Shape shape = polygon(static_cast<int>(state.range(0)));
    const std::vector<Pair> all = pairs(3, 5.0);
    in_turn(state, [&](int k) { return predict(shape, all[k].a, shape, all[k].b, 0.0); });
}
BENCHMARK(predict_polygons)->Arg(3)->Arg(5)->Arg(10)->Arg(30)->Arg(100);

void predict_polygon_on_wall(benchmark::State& state)
{
    const Shape shape = polygon(static_cast<int>(state.range(0)));
    const Shape wall = HalfPlane{Vec2(0.0, 1.0), -2.0};
    const std::vector<Pair> all = pairs(4, 5.0);
    in_turn(state, [&](int k) { return predict(shape, all[k].a, wall, Flyer{}, 0.0); });
}
BENCHMARK(predict_polygon_on_wall)->Arg(3)->Arg(5)->Arg(30);

void resolve_one_point(benchmark::State& state)
{
    Random random(5);
    std::vector<ImpactBody> bodies(2 * k_many);
    std::vector<ImpactPoint> points(k_many);
    for (ImpactBody& body : bodies) {
        body.inertia = {1.0, 6.0};
        body.velocity = Vec2{random.uniform(-5.0, 5.0), random.uniform(-5.0, 5.0)};
        body.spin = random.uniform(-5.0, 5.0);
    }
    for (ImpactPoint& point : points) {
        const SineCosine way = sine_cosine(random.uniform(0.0, k_turn));
        point.normal = Vec2(way.cosine, way.sine);
        point.r_a = 0.5 * point.normal + Vec2(0.0, random.uniform(-0.1, 0.1));
        point.r_b = -0.5 * point.normal + Vec2(random.uniform(-0.1, 0.1), 0.0);
    }
    // The argument is the friction in hundredths
    const Material material{1.0, 0.01 * static_cast<double>(state.range(0))};
    in_turn(state, [&](int k) {
        return resolve_impact(bodies[2 * k], bodies[2 * k + 1], std::span(&points[k], 1), material);
    });
}
BENCHMARK(resolve_one_point)->Arg(0)->Arg(50);

/// The argument is the number of vertices of each.
void separation_of_polygons(benchmark::State& state)
{
    const CollisionShape shape = make_collision_shape(polygon(static_cast<int>(state.range(0))));
    const std::vector<Pair> all = pairs(6, 0.0);
    std::vector<Pose> poses;
    for (const Pair& pair : all) {
        poses.push_back(pose_of(pair.a.state));
        poses.push_back(pose_of(pair.b.state));
    }
    in_turn(state, [&](int k) { return separation(shape, poses[2 * k], shape, poses[2 * k + 1]); });
}
BENCHMARK(separation_of_polygons)->Arg(4)->Arg(30);

/// The argument is how many events wait: each round takes the first and puts another, as an engine does.
void queue_pop_and_push(benchmark::State& state)
{
    Random random(7);
    EventQueue queue;
    const int waiting = static_cast<int>(state.range(0));
    const auto event_at = [&](double time) {
        Event event;
        event.time = time;
        event.a = random.below(1 << 20);
        event.b = event.a + 1;
        return event;
    };
    for (int k = 0; k < waiting; ++k) queue.push(event_at(random.uniform()));
    queue.keep_if([](const Event&) { return true; });
    for (auto _ : state) {
        const double now = queue.next().time;
        queue.pop();
        queue.push(event_at(now + random.uniform()));
    }
}
BENCHMARK(queue_pop_and_push)->Arg(1000)->Arg(100000);

/// The argument is the number of bodies: one after another moves to the next cell and comes back.
void grid_move(benchmark::State& state)
{
    const int bodies = static_cast<int>(state.range(0));
    Random random(8);
    const double side = std::sqrt(bodies * 0.785 / 0.3);
    Grid grid = make_grid({Vec2(0.0, 0.0), Vec2(side, side)}, 0.5, bodies, bodies);
    for (int k = 0; k < bodies; ++k) {
        grid.insert(k, grid.cell_at(Vec2{random.uniform(0.0, side), random.uniform(0.0, side)}));
    }
    int k = 0;
    int step = 1;
    for (auto _ : state) {
        const Cell from = grid.cell_of(k);
        grid.move(k, {from.column + step, from.row});
        if (++k < bodies) continue;
        k = 0;
        step = -step;
    }
}
BENCHMARK(grid_move)->Arg(1000)->Arg(1000000);

/// A crowd of boxes whose pairs are found again after each has moved by a hundredth of its width. The first argument is
/// their number, the second 1 for a sweep that remembers its order, 0 for one that starts afresh, -1 for all pairs.
void find_pairs_again(benchmark::State& state)
{
    const int count = static_cast<int>(state.range(0));
    const double side = 2.0 * std::sqrt(count);
    Random random(10);
    std::vector<BoxedBody> bodies;
    std::vector<Vec2> steps;
    for (int k = 0; k < count; ++k) {
        const Vec2 x{random.uniform(0.0, side), random.uniform(0.0, side)};
        bodies.push_back({k, false, {x, x + Vec2(1.0, 1.0)}});
        steps.push_back(Vec2{random.uniform(-0.01, 0.01), random.uniform(-0.01, 0.01)});
    }
    Sweep kept;
    double sign = 1.0;
    for (auto _ : state) {
        for (int k = 0; k < count; ++k) {
            bodies[k].box.min += sign * steps[k];
            bodies[k].box.max += sign * steps[k];
        }
        sign = -sign;
        long pairs = 0;
        if (state.range(1) < 0) {
            for_each_pair_of_all(bodies, [&](int, int) { ++pairs; });
        } else {
            Sweep fresh;
            Sweep& sweep = state.range(1) > 0 ? kept : fresh;
            sweep.line_up(bodies);
            sweep.for_each_pair([&](int, int) { return ++pairs, true; });
        }
        benchmark::DoNotOptimize(pairs);
    }
}
BENCHMARK(find_pairs_again)
    ->Args({100, -1})->Args({100, 0})->Args({100, 1})
    ->Args({1000, -1})->Args({1000, 0})->Args({1000, 1});

} // namespace
} // namespace flying

BENCHMARK_MAIN();
