#include <doctest/doctest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>

#include "chapters/support/lying_bodies.hpp"
#include "math/block_system.hpp"
#include "math/random.hpp"
#include "rest/local_sweeps.hpp"
#include "rest/sweep_batches.hpp"
#include "rest/sweeps.hpp"

using namespace flying;
using namespace flying::test;

namespace {

/// Points of random pairs among a few bodies, the first of which nothing moves. One pair in three has one point.
struct Tangle
{
    std::vector<Mover> movers;
    std::vector<int> members;
    std::vector<ContactPoint> points;
};

Tangle tangle(std::uint64_t seed, int bodies, int pairs)
{
    Random random(seed);
    Tangle t;
    t.movers.push_back({});
    for (int k = 1; k <= bodies; ++k) {
        const double mass = std::exp2(random.uniform(-10.0, 10.0));
        t.movers.push_back(
            {random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0), 1.0 / mass, 6.0 / mass});
        t.members.push_back(k);
    }
    for (int pair = 0; pair < pairs; ++pair) {
        const int a = random.below(bodies + 1);
        const int b = 1 + random.below(bodies);
        if (a == b) continue;
        const Rotation way = Rotation::of(random.uniform(0.0, 6.28));
        for (int i = 0; i < (pair % 3 == 0 ? 1 : 2); ++i) {
            ContactPoint c;
            c.a = a;
            c.b = b;
            c.pair = pair;
            c.n_x = way.cosine;
            c.n_y = way.sine;
            c.normal_arm_a = random.uniform(-1.0, 1.0);
            c.normal_arm_b = random.uniform(-1.0, 1.0);
            c.tangent_arm_a = random.uniform(-1.0, 1.0);
            c.tangent_arm_b = random.uniform(-1.0, 1.0);
            const Mover& one = t.movers[a];
            const Mover& two = t.movers[b];
            const double shift = one.inv_mass + two.inv_mass;
            c.normal_mass = 1.0 / (shift + one.inv_moment * c.normal_arm_a * c.normal_arm_a +
                                   two.inv_moment * c.normal_arm_b * c.normal_arm_b);
            c.tangent_mass = 1.0 / (shift + one.inv_moment * c.tangent_arm_a * c.tangent_arm_a +
                                    two.inv_moment * c.tangent_arm_b * c.tangent_arm_b);
            c.friction = 0.25 * (pair % 4);
            c.bound = random.uniform(-0.1, 0.1);
            if (random.uniform(0.0, 1.0) < 0.9) t.points.push_back(c);
        }
    }
    return t;
}

bool same_bits(double x, double y)
{
    return std::bit_cast<std::uint64_t>(x) == std::bit_cast<std::uint64_t>(y);
}

} // namespace

TEST_CASE("sweeps where something is missed: where all points miss, the bits of the plain sweep")
{
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        CAPTURE(seed);
        Tangle t = tangle(seed, 30, 100);
        Tangle plain = t;
        const std::vector<double> allowed(t.points.size(), -std::numeric_limits<double>::infinity());
        int pairs = 0;
        for (std::size_t k = 0; k < t.points.size(); ++k)
            pairs += k == 0 || t.points[k].pair != t.points[k - 1].pair ? 1 : 0;
        LocalSweeps local;
        CHECK_FALSE(local.sweep(t.movers, t.points, allowed, pairs));
        sweep(plain.points, plain.movers);
        for (std::size_t k = 0; k < t.points.size(); ++k) {
            CHECK(same_bits(t.points[k].normal, plain.points[k].normal));
            CHECK(same_bits(t.points[k].tangent, plain.points[k].tangent));
        }
    }
}

TEST_CASE("sweeps where something is missed end where nothing is, with impulses that friction allows")
{
    constexpr double k_allowed = 1e-6; // [m/s]
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        CAPTURE(seed);
        Tangle t = tangle(seed, 30, 30);
        for (ContactPoint& c : t.points) c.bound = -std::abs(c.bound); // so that there is an answer: stand still
        std::vector<Mover> pushed = t.movers;
        LocalSweeps local;
        CHECK(local.sweep(t.movers, t.points, std::vector<double>(t.points.size(), k_allowed), 10'000'000));
        for (const ContactPoint& c : t.points) {
            CHECK(c.bound - normal_speed(c, t.movers[c.a], t.movers[c.b]) <= k_allowed);
            CHECK(c.normal >= 0.0);
            CHECK(std::abs(c.tangent) <= c.friction * c.normal);
            push(c, c.normal, c.tangent, pushed[c.a], pushed[c.b]);
        }
        for (const int member : t.members) {
            const double size = 1.0 + std::abs(pushed[member].v_x);
            CHECK(t.movers[member].v_x == doctest::Approx(pushed[member].v_x).epsilon(1e-9 * size));
        }
    }
}

TEST_CASE("sweeps where something is missed leave alone what a blow doesn't get to")
{
    // Of a row of balls that lie loosely, the first rolls against the second. Each hands on half, and keeps half
    constexpr int k_balls = 200;
    std::vector<Mover> movers(k_balls, Mover{0.0, 0.0, 0.0, 1.0, 2.0});
    movers[0].v_x = 1.0;
    std::vector<ContactPoint> points;
    for (int k = 0; k + 1 < k_balls; ++k) {
        ContactPoint c;
        c.a = c.pair = k;
        c.b = k + 1;
        c.n_x = 1.0;
        c.normal_mass = 0.5;
        c.tangent_mass = 0.5;
        points.push_back(c);
    }
    LocalSweeps local;
    CHECK(local.sweep(movers, points, std::vector<double>(points.size(), 0.01), 100'000));
    double momentum = 0.0;
    for (const Mover& mover : movers) momentum += mover.v_x;
    CHECK(momentum == doctest::Approx(1.0).epsilon(1e-12));
    CHECK(movers[5].v_x > 0.0);
    for (int k = 60; k < k_balls; ++k) CHECK(movers[k].v_x == 0.0);
}

TEST_CASE("sweeps over batches find the bits of the plain sweep, whichever contacts share bodies")
{
    std::uint64_t seed = 1;
    const std::pair<int, int> sizes[] = {{1, 3}, {2, 1}, {3, 40}, {3, 300}, {30, 200}, {400, 900}};
    for (const auto& [bodies, pairs] : sizes) {
        for (int repeat = 0; repeat < 20; ++repeat) {
            CAPTURE(seed);
            Tangle t = tangle(seed++, bodies, pairs);
            SweepBatches batches;
            batches.lay_out(t.points, t.movers, t.members);
            const std::vector<int> order = batches.order();
            std::vector<int> all(t.points.size());
            std::iota(all.begin(), all.end(), 0);
            CHECK(std::is_permutation(order.begin(), order.end(), all.begin(), all.end()));
            std::vector<Mover> movers = t.movers;
            std::vector<ContactPoint> plain;
            for (const int k : order) plain.push_back(t.points[k]);
            for (int k = 0; k < 5; ++k) {
                sweep(plain, movers);
                CHECK(batches.sweep_ahead({1, 1, 0.0}) == 1);
            }

            batches.get_impulses(t.points);
            batches.get_velocities(t.movers, t.members);
            bool same = true;
            for (std::size_t k = 0; k < plain.size(); ++k) {
                const ContactPoint& c = t.points[order[k]];
                same = same && same_bits(c.normal, plain[k].normal) && same_bits(c.tangent, plain[k].tangent);
            }
            for (const int k : t.members) {
                same = same && same_bits(t.movers[k].v_x, movers[k].v_x) && same_bits(t.movers[k].v_y, movers[k].v_y) &&
                       same_bits(t.movers[k].spin, movers[k].spin);
            }
            CHECK(same);
        }
    }
}

TEST_CASE("what a look remembers changes no bit of what follows, and saves looks")
{
    // A heap of boxes, discs and corners looking inwards falls into a bin
    const Material material{0.0, 0.5};
    std::vector<RestBody> bodies = {wall(Vec2(0.0, 1.0), 0.0, material), wall(Vec2(1.0, 0.0), 0.0, material),
                                    wall(Vec2(-1.0, 0.0), -10.0, material)};
    const Polygon angle({{{-0.3, -0.3}, {0.5, -0.3}, {0.5, 0.0}, {0.0, 0.0}, {0.0, 0.5}, {-0.3, 0.5}}});
    Random random(3);
    for (int k = 0; k < 90; ++k) {
        const Vec2 place(0.8 + 1.2 * (k % 8) + random.uniform(-0.1, 0.1), 0.8 + 1.2 * (k / 8));
        const double size = random.uniform(0.4, 0.8);
        if (k % 3 == 0) bodies.push_back(disc(0.5 * size, place, 1.0, material));
        else bodies.push_back(box(size, 0.8 * size, place, 1.0, material));
        if (k % 9 == 4) bodies.back().shape = angle;
        bodies.back().state.angle = random.uniform(0.0, 6.0);
        bodies.back().state.spin = random.uniform(-30.0, 30.0);
    }
    for (const int most_solved : {20, 400}) {
        CAPTURE(most_solved);
        RestOptions options;
        options.most_solved = most_solved;
        options.sleeps = false;
        RestEngine remembers(bodies, options);
        RestEngine forgets(bodies, options);
        bool same = true;
        for (int k = 0; k < 400; ++k) {
            forgets.go_on_from(forgets.memory());
            forgets.step();
            remembers.step();
            same = same && forgets.hash() == remembers.hash();
        }
        CHECK(same);
        MESSAGE("looks with, without memory: " << remembers.counts().manifolds << ", " << forgets.counts().manifolds);
        CHECK(remembers.counts().manifolds < forgets.counts().manifolds);
    }
}

TEST_CASE("a block system that is used again has the bits of a new one, whether bodies touch as they did or not")
{
    // More bodies than are eliminated as they come
    constexpr int k_count = 24;
    using Edges = std::vector<BlockSystem::Edge>;
    Edges ring = {{0, k_count - 1}};
    Edges ladder;
    for (int k = 1; k < k_count; ++k) {
        ring.push_back({k - 1, k});
        if (k % 2 == 1) ladder.push_back({k - 1, k});
        if (k > 1) ladder.push_back({k - 2, k});
    }
    const auto solve = [](BlockSystem& system, const Edges& edges) {
        system.set_pattern(k_count, edges);
        system.clear();
        for (int k = 0; k < k_count; ++k) {
            for (int i = 0; i < 3; ++i) system.diagonal(k).at[i][i] = 7.0 + k + i;
        }
        for (std::size_t k = 0; k < edges.size(); ++k) {
            const BlockSystem::Place& place = system.place(static_cast<int>(k));
            for (int i = 0; i < 3; ++i) {
                system.block(place.first_second).at[i][i] = 1.0 / (1.0 + static_cast<double>(k));
                system.block(place.second_first).at[i][2 - i] = -0.5;
            }
        }
        CHECK(system.factorise());
        std::vector<double> x(3 * k_count);
        std::iota(x.begin(), x.end(), 1.0);
        system.solve(x);
        return x;
    };
    BlockSystem again;
    for (const Edges* edges : {&ring, &ring, &ladder, &ladder, &ring}) {
        BlockSystem fresh;
        CHECK(solve(again, *edges) == solve(fresh, *edges));
    }
}

TEST_CASE("a symmetric block system has the answer that it has when all its blocks are read")
{
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        CAPTURE(seed);
        Random random(seed);
        const int count = 1 + random.below(80);
        std::vector<BlockSystem::Edge> edges;
        for (int k = 1; k < count; ++k) {
            edges.push_back({random.below(k), k});
            if (k > 2 && random.below(2) == 0) edges.push_back({k - 2, k});
        }
        BlockSystem system;
        system.set_pattern(count, edges);
        system.clear();
        for (std::size_t k = 0; k < edges.size(); ++k) {
            const BlockSystem::Place& place = system.place(static_cast<int>(k));
            for (int i = 0; i < 3; ++i) {
                for (int j = 0; j < 3; ++j) {
                    const double coupling = random.uniform(-1.0, 1.0);
                    system.block(place.first_second).at[i][j] += coupling;
                    system.block(place.second_first).at[j][i] += coupling;
                    // So much on the diagonal that it dominates
                    for (const int body : {edges[k].first, edges[k].second}) system.diagonal(body).at[i][i] += 3.0;
                }
            }
        }
        for (int k = 0; k < count; ++k) {
            for (int i = 0; i < 3; ++i) system.diagonal(k).at[i][i] += 1.0;
        }
        REQUIRE(system.factorise());
        std::vector<double> all(3 * static_cast<std::size_t>(count));
        for (double& x : all) x = random.uniform(-1.0, 1.0);
        std::vector<double> half = all;
        system.solve(all);
        system.solve_symmetric(half);
        for (std::size_t k = 0; k < all.size(); ++k) CHECK(std::abs(half[k] - all[k]) <= 1e-14);
    }
}
