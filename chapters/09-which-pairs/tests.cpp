#include <doctest/doctest.h>
#include <filesystem>
#include <limits>
#include <string>

#include "boxes.hpp"
#include "scene/read.hpp"
#include "support/receipts.hpp"
#include "world/make_shape.hpp"
#include "world/world.hpp"

using namespace flying;

namespace {

/// Bodies of every size, some static, some of them on a lattice so that ends are equal and
/// boxes just touch.
std::vector<BoxedBody> random_boxes(Random& random)
{
    const int n = random.below(60);
    const bool on_lattice = random.below(3) == 0;
    const double W = random.uniform(0.5, 20.0);
    const double H = random.uniform(0.5, 20.0);
    std::vector<BoxedBody> bodies;
    for (int k = 0; k < n; ++k) {
        Vec2 x{random.uniform(0.0, W), random.uniform(0.0, H)};
        Vec2 half{random.uniform(0.0, 1.5), random.uniform(0.0, 1.5)};
        if (on_lattice) x = x.array().floor().matrix(), half = half.array().ceil().matrix();
        bodies.push_back({k, random.below(4) == 0, {x - half, x + half}});
    }
    return bodies;
}

/// Radius of the circle round a box; of the largest that moves.
double largest_radius(const std::vector<BoxedBody>& bodies)
{
    double largest = 0.0;
    for (const BoxedBody& body : bodies) {
        if (!body.is_static)
            largest = std::max(largest, 0.5 * (body.box.max - body.box.min).norm());
    }
    return largest;
}

} // namespace

// [which-pairs.tests.same]
TEST_CASE("sweep and grid find the pairs of the oracle, among boxes of every kind")
{
    Random random(901);
    Sweep sweep; // one for all, so that it always comes with the order of something else
    long pairs = 0;
    for (int k = 0; k < 3000; ++k) {
        const std::vector<BoxedBody> bodies = random_boxes(random);
        const Pairs expected = pairs_of_all(bodies);
        sweep.line_up(bodies);
        CHECK(pairs_of_sweep(sweep) == expected);
        const double radius = largest_radius(bodies);
        if (radius > 0.0)
            CHECK(pairs_of_grid(filled_grid(bodies, radius), bodies).pairs == expected);
        pairs += static_cast<long>(expected.size());
    }
    CHECK(pairs > 30'000);
}
// [which-pairs.tests.same]


TEST_CASE("a sweep that remembers finds the pairs of the oracle at every step of a motion, "
          "in the order of a fresh one")
{
    Random random(902);
    for (int run = 0; run < 20; ++run) {
        std::vector<BoxedBody> bodies = discs_in_room(80, 0.4, 8.0, 6.0, random);
        std::vector<Vec2> velocity;
        for (int k = 0; k < 80; ++k)
            velocity.push_back(Vec2{random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0)});
        Sweep sweep;
        for (int step = 0; step < 100; ++step) {
            // Now and then the motion is fast, the room is turned on its side, or a body
            // comes in
            const double dt = step % 17 == 0 ? 3.0 : 0.03;
            for (std::size_t k = 0; k < bodies.size(); ++k) {
                Aabb& box = bodies[k].box;
                box = {box.min + dt * velocity[k], box.max + dt * velocity[k]};
                if (step % 41 == 40)
                    box = {Vec2(box.min.y(), box.min.x()), Vec2(box.max.y(), box.max.x())};
            }
            if (step == 50) {
                bodies.push_back({80, true, {Vec2(-1.0, 2.0), Vec2(9.0, 2.5)}});
                velocity.push_back(Vec2::Zero());
            }
            sweep.line_up(bodies);
            Sweep fresh;
            fresh.line_up(bodies);
            CHECK(pairs_of_sweep(sweep) == pairs_of_all(bodies));
            Pairs order;
            Pairs fresh_order;
            sweep.for_each_pair(
                [&](int a, int b) { return order.emplace_back(a, b), true; });
            fresh.for_each_pair(
                [&](int a, int b) { return fresh_order.emplace_back(a, b), true; });
            CHECK(order == fresh_order);
        }
        CHECK(sweep.shifts() > 0);
    }
}



TEST_CASE("on every scene of the course, at any time, sweep and grid find the pairs of the "
          "oracle")
{
    int scenes = 0;
    for (const auto& entry : std::filesystem::directory_iterator(FLYING_SCENES)) {
        const Expected<Scene> scene = read_scene_file(entry.path().string());
        REQUIRE(scene);
        Expected<World> made = World::make(scene.value(), {});
        REQUIRE(made);
        World world = std::move(made).value();
        ++scenes;
        Sweep sweep;
        for (int step = 0; step <= 20; ++step) {
            CHECK_FALSE(world.advance(0.05 * step, 100'000));
            std::vector<BoxedBody> bodies;
            double radius = 0.0;
            for (int k = 0; k < world.body_count(); ++k) {
                // A little room, as the engine gives it, so that neighbours count
                const Aabb box = bounding_box(world.shape(k), pose_of(world.state(k)));
                const Vec2 room = Vec2::Constant(0.5 * bounding_radius(world.shape(k)));
                bodies.push_back({k, world.is_static(k), {box.min - room, box.max + room}});
                if (!world.is_static(k))
                    radius =
                        std::max(radius, 0.5 * (box.max - box.min + 2.0 * room).norm());
            }
            const Pairs expected = pairs_of_all(bodies);
            sweep.line_up(bodies);
            CHECK(pairs_of_sweep(sweep) == expected);
            CHECK(pairs_of_grid(filled_grid(bodies, radius), bodies).pairs == expected);
        }
    }
    CHECK(scenes >= 11);
}



TEST_CASE("a static box without end overlaps all, and a sweep ends when it is told to")
{
    Random random(903);
    constexpr double k_infinite = std::numeric_limits<double>::infinity();
    std::vector<BoxedBody> bodies = discs_in_room(30, 0.3, 9.0, 3.0, random);
    bodies.push_back(
        {30, true, {Vec2(-k_infinite, -k_infinite), Vec2(k_infinite, k_infinite)}});
    bodies.push_back({31, true, {Vec2(2.0, -k_infinite), Vec2(3.0, k_infinite)}});
    Sweep sweep;
    sweep.line_up(bodies);
    CHECK(sweep.axis() == 0);
    CHECK(pairs_of_sweep(sweep) == pairs_of_all(bodies));
    CHECK(pairs_of_sweep(sweep).size() >= 30);

    int visits = 0;
    sweep.for_each_pair([&](int, int) { return ++visits < 7; });
    CHECK(visits == 7);
}



TEST_CASE("lengths by powers of two leave the order of the sweep and the cells of the grid "
          "as they are")
{
    Random random(904);
    const std::vector<BoxedBody> bodies = discs_in_room(200, 0.3, 9.0, 7.0, random);
    std::vector<BoxedBody> large = bodies;
    for (BoxedBody& body : large) body.box = {0x1p90 * body.box.min, 0x1p90 * body.box.max};
    Sweep one;
    Sweep two;
    one.line_up(bodies);
    two.line_up(large);
    CHECK(pairs_of_sweep(one) == pairs_of_sweep(two));
    const Grid grid = filled_grid(bodies, 0.3);
    const Grid large_grid = filled_grid(large, 0x1p90 * 0.3);
    CHECK(large_grid.cell_size() == 0x1p90 * grid.cell_size());
    for (int k = 0; k < 200; ++k) CHECK(large_grid.cell_of(k) == grid.cell_of(k));
}

