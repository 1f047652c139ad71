// What fell at 30 m/s and more onto a layer at rest sank into it by up to 0.38 of a radius in one step. Bodies that are
// struck as a step goes on get further than they were thought to, and the step goes back to where they met what they
// had no points with; but it did so only if the whole step took them further, not a part of it; islands that went back
// in one round stood still in the next; and what slept never took part.

#include <doctest/doctest.h>

#include <cmath>

#include "chapters/support/lying_bodies.hpp"
#include "math/random.hpp"

using namespace flying;
using namespace flying::test;

namespace {

constexpr double k_smallest = 0.36; // [m]
constexpr int k_columns = 12;

enum class Kind
{
    discs,
    boxes
};

/// Rows of bodies between two walls, the upper half of them falling already.
RestEngine rows_of(Kind kind, int count, double speed, std::uint64_t seed, bool sleeps = true)
{
    Random random(seed);
    const Material material{0.0, 0.5};
    std::vector<RestBody> bodies{wall({0.0, 1.0}, 0.0, material), wall({1.0, 0.0}, 0.0, material),
                                 wall({-1.0, 0.0}, -k_columns, material)};
    for (int k = 0; k < count; ++k) {
        const double radius = random.uniform(k_smallest, 0.45);
        const Vec2 place(0.5 + k % k_columns + random.uniform(-0.04, 0.04), 0.5 + k / k_columns);
        const double side = std::sqrt(2.0) * radius;
        if (kind == Kind::discs) bodies.push_back(disc(radius, place, radius * radius, material));
        else bodies.push_back(box(side, side, place, radius * radius, material));
        if (k >= count / 2) bodies.back().state.velocity = {0.0, -speed};
    }
    RestOptions options;
    options.sleeps = sleeps;
    return RestEngine(bodies, options);
}

/// The deepest that any step begins with, in radii of the smallest.
double overlap_of(Kind kind, int count, double speed, std::uint64_t seed)
{
    RestEngine engine = rows_of(kind, count, speed, seed);
    for (int step = 0; step < 40; ++step) engine.step();
    return engine.max_overlap() / k_smallest;
}

} // namespace

TEST_CASE("what falls fast onto bodies at rest overlaps none of them by more than a hundredth")
{
    for (const int seed : {10, 12, 14, 49, 54}) {
        CAPTURE(seed);
        CHECK(overlap_of(Kind::discs, 120, 40.0, seed) <= 0.01);
        CHECK(overlap_of(Kind::boxes, 120, 40.0, seed) <= 0.01);
    }
    for (const int seed : {7, 12, 24}) {
        CAPTURE(seed);
        CHECK(overlap_of(Kind::discs, 240, 30.0, seed) <= 0.01);
    }
}

TEST_CASE("what falls fast onto sleepers does what it would do if they were awake")
{
    for (const Kind kind : {Kind::discs, Kind::boxes}) {
        for (int seed = 1; seed <= 4; ++seed) {
            CAPTURE(seed);
            RestEngine sleeps = rows_of(kind, 120, 40.0, seed, true);
            RestEngine wakes = rows_of(kind, 120, 40.0, seed, false);
            for (int step = 0; step < 30; ++step) {
                sleeps.step();
                wakes.step();
                REQUIRE(sleeps.hash() == wakes.hash());
            }
        }
    }
}
