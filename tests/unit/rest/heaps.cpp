#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "chapters/support/lying_bodies.hpp"
#include "support/effort.hpp"

using namespace flying;
using namespace flying::test;
using flying::testing::is_sanitized;

namespace {

/// What lies between 0 and 1 as evenly as may be, and in no order.
double scattered(int k)
{
    const double x = 0.61803398874989485 * k;
    return x - std::floor(x);
}

/// A bin of width 16, above which bodies hang in rows that have not fallen yet; each number makes other ones. Its floor
/// slopes by 0.05, since on a level one a disc that nobody leans on rolls until it touches another.
std::vector<RestBody> heap(int count, bool discs, int number = 0)
{
    const Material material{0.0, 0.5};
    std::vector<RestBody> bodies = {wall(Vec2(-0.05, 1.0).normalized(), 0.0, material),
                                    wall(Vec2(1.0, 0.0), 0.0, material), wall(Vec2(-1.0, 0.0), -16.0, material)};
    for (int k = 0; k < count; ++k) {
        const double size = 0.5 + 0.3 * scattered(k + 5000 * number);
        const Vec2 place(0.8 + 1.1 * (k % 14) + 0.1 * scattered(3 * k + 7000 * number), 1.6 + 1.3 * (k / 14));
        bodies.push_back(discs ? disc(0.5 * size, place, size * size, material)
                               : box(size, 0.9 * size, place, size * size, material));
        bodies.back().state.angle = scattered(7 * k);
    }
    return bodies;
}

/// Discs and boxes above a bin hardly wider than they need.
std::vector<RestBody> narrow_heap(int count, int seed)
{
    const Material material{0.0, 0.5};
    const double half = 0.45 * std::sqrt(count);
    std::vector<RestBody> bodies = {wall(Vec2(0.0, 1.0), 0.0, material), wall(Vec2(1.0, 0.0), -half, material),
                                    wall(Vec2(-1.0, 0.0), -half, material)};
    const int row = static_cast<int>(2.0 * half / 1.1);
    for (int k = 0; k < count; ++k) {
        const int number = 4 * (count * seed + k);
        const double size = 0.6 + 0.3 * scattered(number);
        const Vec2 place(0.55 - half + 1.1 * (k % row) + 0.05 * scattered(number + 1), 0.6 + 1.1 * (k / row));
        bodies.push_back(k % 2 == 0 ? disc(0.5 * size, place, size * size, material)
                                    : box(0.7 * size, 0.7 * size, place, size * size, material));
        bodies.back().state.velocity.x() = scattered(number + 2) - 0.5;
    }
    return bodies;
}

/// Heaps that are swept, small enough to be watched.
RestOptions swept()
{
    RestOptions options;
    options.most_solved = 20;
    return options;
}

/// Over all contacts that bear.  [m]
double mean_overlap(const RestEngine& engine)
{
    double sum = 0.0;
    int count = 0;
    for (const RestContact& contact : engine.contacts()) {
        if (contact.normal_force == 0.0) continue;
        sum += std::max(-contact.gap, 0.0);
        ++count;
    }
    REQUIRE(count > 300);
    return sum / count;
}

} // namespace

TEST_CASE("heaps that are swept fall asleep once they have settled: then steps are no work, and a blow wakes them")
{
    std::vector<double> after; // so long [s]
    int lying = 0;             // balls that fell in and lie still
    for (int number = 0; number < 16; ++number) {
        const int counts[] = {98, 126, 110, 133};
        const int count = counts[number / 2 % 4];
        const bool discs = number % 2 == 0;
        CAPTURE(discs);
        CAPTURE(count);
        std::vector<RestBody> bodies = heap(count, discs, number);
        bodies.push_back(disc(0.4, Vec2(8.0, 60.0), 1.0, {0.0, 0.5}));
        bodies.back().is_active = false;
        const int ball = static_cast<int>(bodies.size()) - 1;
        RestEngine engine(bodies, swept());
        const auto sleepers = [&] {
            int asleep = 0;
            for (int k = 3; k < ball; ++k) asleep += engine.is_asleep(k) ? 1 : 0;
            return asleep;
        };
        int steps = 0;
        for (; steps < 60 * 20 && sleepers() < count; ++steps) engine.step();
        after.push_back(steps / 60.0);
        REQUIRE(sleepers() == count);

        // Nothing is looked at, solved or moved any more
        const RestCounts before = engine.counts();
        const std::uint64_t hash = engine.hash();
        for (int k = 0; k < 600; ++k) engine.step();
        CHECK(engine.hash() == hash);
        CHECK(engine.counts().looks == before.looks);
        CHECK(engine.counts().manifolds == before.manifolds);
        CHECK(engine.counts().points == before.points);
        CHECK(engine.counts().islands == before.islands);

        // A ball that falls in wakes what it strikes, and lies on top in the end
        BodyState state = bodies[ball].state;
        state.velocity = Vec2(0.0, -10.0);
        engine.set_active(ball, true);
        engine.set_state(ball, state);
        bool woke = false;
        for (int k = 0; k < 60 * 15; ++k) {
            engine.step();
            woke = woke || sleepers() < count;
        }
        CHECK(woke);
        CHECK(engine.state(ball).position.y() > 5.0 * count / 294);
        lying += engine.state(ball).velocity.norm() < 1e-2 ? 1 : 0;
    }
    std::sort(after.begin(), after.end());
    MESSAGE("asleep after " << after[7] << " s in the median, " << after[11] << " s, " << lying << " lying");
    CHECK(after.front() > 1.0); // none before it has come down
    CHECK(after[7] < 6.0);
    CHECK(lying >= 12);
}

TEST_CASE("sleep changes no bit of a heap that is swept")
{
    RestOptions awake = swept();
    awake.sleeps = false;
    RestEngine one(heap(120, false), swept());
    RestEngine other(heap(120, false), awake);
    for (int k = 0; k < 60 * 20; ++k) {
        one.step();
        other.step();
        REQUIRE(one.hash() == other.hash());
    }
    CHECK(one.counts().asleep > 120 * 60);
    CHECK(other.counts().asleep == 0);
}

TEST_CASE("a heap that is swept has no more energy than it began with, and lies with little overlap")
{
    RestEngine engine(heap(300, false), swept());
    const double start = energy(engine);
    double last = start;
    double worst_rise = 0.0;
    for (int k = 0; k < 60 * 10; ++k) {
        engine.step();
        const double now = energy(engine);
        worst_rise = std::max(worst_rise, (now - last) / start);
        last = now;
    }
    MESSAGE("energy " << last / start << " of that before, worst rise in a step " << worst_rise);
    CHECK(last < 0.5 * start);
    CHECK(worst_rise < 1e-12);
    CHECK(mean_overlap(engine) < 0.01);
}

TEST_CASE("a tall heap that lands goes on to move until it lies, and isn't crushed")
{
    // Sweeps that go on from the impulses of the landing bear too much. All motion was taken to pay for what they
    // lifted, step after step, and the heap hung as it was, unfinished, for seconds
    RestOptions options;
    options.sleeps = false;
    RestEngine engine(heap(1400, false), options);
    int standing = 0; // steps that have left no body moving, to this one
    int hung = 0;     // those after which a body has moved
    for (int k = 0; k < 60 * 8; ++k) {
        engine.step();
        bool stands = true;
        for (int i = 0; i < engine.body_count(); ++i) {
            const BodyState& state = engine.body(i).state;
            stands = stands && state.velocity.isZero(0.0) && state.spin == 0.0;
        }
        if (!stands) hung += standing;
        standing = stands ? standing + 1 : 0;
    }
    MESSAGE("hung for " << hung << " steps, mean overlap " << mean_overlap(engine) << " m");
    CHECK(hung == 0);
    CHECK(mean_overlap(engine) < 0.003);
}

TEST_CASE("small heaps of discs and boxes win no energy, keep apart, and none lies still to the bit for long and "
          "doesn't sleep")
{
    // In some a disc goes on to roll, and keeps those awake on which it lies
    int awake = 0;
    for (int number = 0; number < 24; number += is_sanitized() ? 5 : 1) {
        const int count = number < 16 ? 20 : 40;
        CAPTURE(number);
        RestEngine engine(narrow_heap(count, 1 + number % 16));
        const double start = energy(engine);
        double before = start;
        double worst_rise = 0.0;
        int still = 0;
        for (int k = 0; k < 60 * 12 && still < 180; ++k) {
            engine.step();
            const double now = energy(engine);
            worst_rise = std::max(worst_rise, now - before);
            before = now;
            double speed = 0.0;
            bool asleep = true;
            for (int body = 3; body < count + 3; ++body) {
                const BodyState state = engine.state(body);
                speed = std::max({speed, state.velocity.norm(), std::abs(state.spin)});
                asleep = asleep && engine.is_asleep(body);
            }
            if (asleep) break;
            still = speed == 0.0 ? still + 1 : 0;
        }
        CHECK(worst_rise <= 1e-14 * start);
        CHECK(engine.max_overlap() < 0.01 * 0.7 * 0.6 * std::numbers::sqrt2 / 2.0); // of the smallest box's size
        awake += still == 180 ? 1 : 0;
    }
    CHECK(awake == 0);
}

TEST_CASE("sleep changes no bit of heaps that are solved whole, whether a solve has made their loads right or not")
{
    RestOptions awake;
    awake.sleeps = false;
    for (int seed = 1; seed <= 20; ++seed) {
        CAPTURE(seed);
        RestEngine one(narrow_heap(20, seed));
        RestEngine other(narrow_heap(20, seed), awake);
        for (int k = 0; k < 60 * 6; ++k) {
            one.step();
            other.step();
            REQUIRE(one.hash() == other.hash());
        }
    }
}
