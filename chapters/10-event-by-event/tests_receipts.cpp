#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include <doctest/doctest.h>

#include "../18-two-balls/few.hpp"
#include "../18-two-balls/wrong_loops.hpp"
#include "billiard.hpp"
#include "gas.hpp"
#include "math/random.hpp"
#include "response/impact.hpp"
#include "room.hpp"
#include "support/receipts.hpp"
#include "three.hpp"
#include "wrong_cells.hpp"

using namespace flying;

namespace {

constexpr double k_pi = std::numbers::pi;
constexpr double k_epsilon = std::numeric_limits<double>::epsilon();

/// Everything up to the next impact; false where none is left.
bool advance_one_impact(EventEngine& engine)
{
    const std::int64_t before = engine.counts().impacts;
    while (engine.counts().impacts == before) {
        const std::int64_t events = engine.counts().events;
        if (engine.advance(1e12, 1)) return false;
        if (engine.counts().events == events) return false;
    }
    return true;
}

} // namespace

TEST_CASE("the billiard of 1 : 100^7 counts eight digits")
{
    // Nine seconds on a plain build; with sanitizers a tenth of it will do
#ifdef FLYING_SANITIZED
    const int k = 6;
#else
    const int k = 7;
#endif
    const double ratio = std::pow(100.0, k);
    EventEngine engine = billiard(ratio);
    REQUIRE_FALSE(engine.advance(1e3, -1).has_value());
    CHECK(engine.counts().impacts == (k == 7 ? 31'415'926 : 3'141'592));
    CHECK(engine.counts().impacts == whole_steps_below_pi(billiard_angle(ratio)));
    RECORD_VALUE("events.longest", engine.counts().impacts);
    RECORD_VALUE("events.longest.overlap", engine.max_overlap());
}

// [events.tests.wedge]
TEST_CASE("between its impacts, too, the billiard is where the folded line is")
{
    double worst = 0.0;
    for (const double ratio : {1.0, 16.0, 100.0, 1e4}) {
        EventEngine engine = billiard(ratio);
        for (int k = 1; k <= 300; ++k) {
            const double time = 0.01 * k;
            REQUIRE_FALSE(engine.advance(time, -1).has_value());
            const BilliardPlaces places = billiard_places(ratio, time);
            const double light = state_at(engine.flyer(0), time).position.x();
            const double heavy = state_at(engine.flyer(1), time).position.x();
            worst = std::max(
                {worst, std::abs(light - places.light), std::abs(heavy - places.heavy)});
        }
    }
    // A few roundings for each of up to 314 impacts
    CHECK(worst < 314 * 4.0 * k_epsilon);
    RECORD_VALUE("events.wedge.off", worst);
}
// [events.tests.wedge]

TEST_CASE("a ball in a room is where the strip of paper says, a thousand bounces long")
{
    const Room room;
    EventEngine engine = room_of(room);
    for (int k = 1; k <= 1000; ++k) {
        const double time = 1.37 * k;
        REQUIRE_FALSE(engine.advance(time, -1).has_value());
        const double x = room.x.x() + time * room.v.x();
        const double place = state_at(engine.flyer(0), time).position.x() - 0.125;
        CHECK(std::abs(place - folded(x, room.width)) < 1e-12);
        const double folded_by_cosine =
            room.width / k_pi * std::acos(std::cos(k_pi * x / room.width));
        // The arc cosine loses half of its digits near the walls
        CHECK_EQUATION_SCALED("events.fold", place, folded_by_cosine, room.width, 1e-7,
                              {"w", room.width}, {"x", x});
        CHECK_TWIN_SCALED("events.fold", place, folded_by_cosine + 0.001 * room.width,
                          room.width, 1e-7);
    }
    const double x = room.x.x() + engine.time() * room.v.x();
    const double y = room.x.y() + engine.time() * room.v.y();
    CHECK(engine.counts().impacts ==
          std::floor(x / room.width) + std::floor(y / room.height));
}

// [events.tests.looks]
TEST_CASE("what happens does not depend on how often we look")
{
    EventEngine once = gas_of(10, 0.3, 1012);
    EventEngine often = gas_of(10, 0.3, 1012);
    REQUIRE_FALSE(once.advance(10.0, -1).has_value());
    for (int k = 1; k <= 10'000; ++k)
        REQUIRE_FALSE(often.advance(0.001 * k, -1).has_value());
    CHECK(once.counts().impacts == often.counts().impacts);
    CHECK(once.log_hash() == often.log_hash());
}
// [events.tests.looks]

TEST_CASE("cells leave out looks and no impact: the log is that of all pairs, to the bit")
{
    for (const double packing : {0.05, 0.3, 0.6}) {
        EventEngine all = gas_of(12, packing, 1013, PairFinder::all_pairs);
        EventEngine near = gas_of(12, packing, 1013, PairFinder::grid);
        REQUIRE_FALSE(all.advance(10.0, -1).has_value());
        REQUIRE_FALSE(near.advance(10.0, -1).has_value());
        CHECK(all.counts().impacts > 100);
        CHECK(all.log_hash() == near.log_hash());
        CHECK(near.counts().predictions < all.counts().predictions / 2);
    }
}

TEST_CASE("a gas has the rate of impacts and the pressure of the theory")
{
    for (const double packing : {0.1, 0.2, 0.29}) {
        EventEngine gas = gas_of(20, packing, 109);
        GasWatch watch(gas, 400);
        watch.follow(12.0 + 1.0 / packing);
        const GasMeasure m = watch.measure(20.0, 20);

        // Four standard errors; that of the packing enters the theory
        const double z = compressibility(m.packing.mean);
        const double slope = compressibility(m.packing.mean + m.packing.error) - z;
        const double rate = gas_rate(z, 0.5, 1.0, 1.0);
        const double slope_of_rate = gas_rate(1.0 + slope, 0.5, 1.0, 1.0);
        const double rate_error = std::hypot(m.rate.error, slope_of_rate);
        const double walls_error = std::hypot(m.from_walls.error, slope);
        CHECK(std::abs(m.rate.mean - rate) < 4.0 * rate_error);
        CHECK(std::abs(m.from_walls.mean - z) < 4.0 * walls_error);
        CHECK(4.0 * rate_error < 0.05 * rate);
        CHECK_EQUATION("events.rate", m.rate.mean, rate, 0.05, {"z", z - 1.0}, {"k", 0.5},
                       {"T", 1.0}, {"m", 1.0}, {"\\sigma", 1.0});
        CHECK_TWIN("events.rate", m.rate.mean, 0.9 * rate, 0.05);
    }
    CHECK(std::abs(compressibility(0.3) - 2.0632) < 5e-5);
    RECORD_VALUE("events.z_03", compressibility(0.3));
}

TEST_CASE("the energies of a gas are the pieces of a broken stick")
{
    EventEngine gas = gas_of(20, 0.29, 109);
    GasWatch watch(gas, 400);
    watch.follow(12.0);
    const GasMeasure m = watch.measure(20.0, 20);

    // 400 discs, 1600 times, a quarter of a second apart: most are independent
    for (const int tenths : {4, 8, 12, 16, 20}) {
        const double v = 0.1 * tenths;
        std::int64_t above = 0;
        for (std::size_t k = static_cast<std::size_t>(tenths); k < m.speeds.size(); ++k) {
            above += m.speeds[k];
        }
        const double share = static_cast<double>(above) / static_cast<double>(m.samples);
        CHECK_EQUATION_SCALED("events.stick", share, std::pow(1 - v * v / 400, 399), 1.0,
                              0.01, {"v", v}, {"N", 400}, {"k", 0.5}, {"T", 1.0},
                              {"m", 1.0});
        if (tenths > 8) continue;
        CHECK_TWIN_SCALED("events.stick", share, std::pow(1 - v * v / 800, 399), 1.0, 0.01);
    }
}

TEST_CASE("with all velocities turned round, a gas goes back the way it came")
{
    const double time = 4.0;
    EventEngine there = gas_of(10, 0.1, 7);
    const EventEngine start = gas_of(10, 0.1, 7);
    REQUIRE_FALSE(there.advance(time, -1).has_value());
    EventEngine back = turned_round(there, 100);
    REQUIRE_FALSE(back.advance(time, -1).has_value());
    CHECK(back.counts().impacts == there.counts().impacts);
    CHECK(there.counts().impacts > 50);
    double worst = 0.0;
    for (int k = 0; k < 100; ++k) {
        const BodyState end = state_at(back.flyer(k), time);
        const BodyState& begin = start.flyer(k).state;
        worst = std::max(worst, (end.position - begin.position).norm());
        CHECK((end.velocity + begin.velocity).norm() < 1e-9);
    }
    // Rounding, times the growth of a few impacts in a row
    CHECK(worst < 1e-9);
    RECORD_VALUE("events.reversal.off", worst);
}

TEST_CASE("three balls in a row meet as often as the angle allows")
{
    for (int i = 0; i <= 90; ++i) {
        const double e = 0.076 + 0.01 * i;
        EventEngine engine = three_in_a_row(e);
        double u_before = 0.0;
        double u = 1.0;
        for (int n = 0; advance_one_impact(engine); ++n) {
            // The pair that meets next is the one that was not pushed now
            const int left = n % 2 == 0 ? 1 : 0;
            const double next = engine.flyer(left).state.velocity.x() -
                                engine.flyer(left + 1).state.velocity.x();
            const double s = (1 + e) / 2;
            const double speed = std::abs(u) + std::abs(u_before);
            CHECK_EQUATION_SCALED("events.row_step", next, s * u - e * u_before, speed,
                                  1e-8, {"s", s}, {"u_n", u}, {"e", e},
                                  {"u_{n-1}", u_before});
            CHECK_TWIN_SCALED("events.row_step", next, s * u - 0.9 * e * u_before - 0.1 * u,
                              speed, 1e-8);
            u_before = u;
            u = next;
        }
        const double n = static_cast<double>(engine.counts().impacts);
        const double phi = row_angle(e);
        CHECK_EQUATION("events.row_count", n, std::ceil(k_pi / phi) - 1, 0.0,
                       {"\\varphi", phi});
        CHECK_TWIN("events.row_count", n, std::ceil(k_pi / phi), 0.0);
    }
}

TEST_CASE("below the threshold the impacts of three balls follow each other ever faster")
{
    for (const double e : {0.03, 0.04, 0.05}) {
        const double s = (1 + e) / 2;
        const double lambda = (s + std::sqrt(s * s - 4 * e)) / 2;
        EventEngine engine = three_in_a_row(e);
        std::vector<double> times;
        while (times.size() < 11 && advance_one_impact(engine)) {
            times.push_back(engine.time());
        }
        REQUIRE(times.size() == 11);

        // Eight impacts leave nothing of the smaller root; two more, and the clock's
        // steps show
        for (std::size_t n = 8; n < 10; ++n) {
            const double ratio = (times[n + 1] - times[n]) / (times[n] - times[n - 1]);
            CHECK_EQUATION("events.row_times", ratio, e / (lambda * lambda), 2e-3, {"e", e},
                           {"\\lambda", lambda});
            CHECK_TWIN("events.row_times", ratio, e / lambda, 2e-3);
        }
    }
}

TEST_CASE("below e = 7 - 4 sqrt 3 the blows among three balls have no end")
{
    // Velocities alone, so that no gap can be too small: does the pair whose turn it
    // is still approach?
    const auto goes_on = [](double e) {
        const ImpactPoint point{{0.5, 0.0}, {-0.5, 0.0}, {1.0, 0.0}};
        std::array<double, 3> v{1.0, 0.0, 0.0};
        for (int n = 0; n < 400; ++n) {
            const int k = n % 2;
            const ImpactBody left{{v[k], 0.0}, 0.0, {1.0, 8.0}};
            const ImpactBody right{{v[k + 1], 0.0}, 0.0, {1.0, 8.0}};
            const ImpactResult after = resolve_impact(left, right, {&point, 1}, {e, 0.0});
            if (!after.any_push) return false;
            v[k] = after.velocity_a.x();
            v[k + 1] = after.velocity_b.x();

            // Watch from the middle ball, in units of the last approach, so that no
            // digit gets lost
            const double middle = v[1];
            const double unit = std::max(std::abs(v[0] - middle), std::abs(v[2] - middle));
            for (double& each : v) each = (each - middle) / unit;
        }
        return true;
    };
    double low = 0.0;
    double high = 1.0;
    for (int k = 0; k < 50; ++k) {
        const double e = 0.5 * (low + high);
        (goes_on(e) ? low : high) = e;
    }
    CHECK_EQUATION("events.threshold", low, 7 - 4 * std::sqrt(3.0), 3e-4,
                   {"e", 7 - 4 * std::sqrt(3.0)});
    CHECK_TWIN("events.threshold", low, 7 - 4 * std::sqrt(3.01), 3e-4);
}

TEST_CASE("the page of code and the engine agree on every impact of twenty-five discs")
{
    Few few = crowd_of(5);
    std::vector<EventBody> bodies;
    for (const Clocked& c : few.discs) {
        const discs::Disc& d = c.disc;
        bodies.push_back(ball(d.r, d.m, {d.x, d.y}, {d.vx, d.vy}));
    }
    EventEngine engine(std::move(bodies), {PairFinder::all_pairs});
    few.run(100.0);
    REQUIRE_FALSE(engine.advance(100.0, -1).has_value());
    CHECK(engine.counts().impacts == static_cast<long>(few.handled.size()));
    for (int k = 0; k < 25; ++k) {
        const Vec2 v(few.discs[k].disc.vx, few.discs[k].disc.vy);
        CHECK((engine.flyer(k).state.velocity - v).norm() < 1e-9);
    }
}

// [events.tests.wrong_cells]
TEST_CASE("cells without crossings let discs through each other, "
          "and no conserved quantity notices")
{
    Few right = crowd_of(5);
    Few wrong = right;
    const FewSums start = sums_of(right);
    const auto all = [](Few& few, int a, double) { few.foresee(a); };
    CHECK(run_looking(right, 100.0, all) < 1e-12);
    CHECK_FALSE(run_looking(wrong, 100.0, LookAround{1.25}) < 1e-12);
    CHECK(wrong.handled.size() < right.handled.size());
    RECORD_VALUE("events.cells.missed", right.handled.size() - wrong.handled.size());
    CHECK(std::abs(sums_of(wrong).energy - start.energy) < 1e-13);
    CHECK((sums_of(wrong).momentum - start.momentum).norm() < 1e-13);
}
// [events.tests.wrong_cells]

// [events.tests.wrong_hops]
TEST_CASE("where a loop of hops never ends, the engine stops and says so")
{
    const Hops hops = hop_until(10.0, 4.9, 0.5, 9.8, 1'000'000);

    // The first rebound of the engine's ball has the same speed: dropped at 9.8 m/s,
    // after a second of fall
    EventBody body = ball(0.1, 1.0, {0.0, 5.0}, {0.0, 0.0}, 0.5);
    body.flyer.acceleration = Vec2(0.0, -9.8);
    EventEngine engine({body, wall({0.0, 1.0}, 0.0, 0.5)}, {PairFinder::all_pairs});
    const std::optional<EventFailure> failure = engine.advance(10.0, -1);
    REQUIRE(failure.has_value());
    CHECK(failure->kind == EventFailure::Kind::crowded);
    CHECK(failure->time == doctest::Approx(1.0 + hops.time).epsilon(1e-12));
    RECORD_VALUE("events.hops.impacts", engine.counts().impacts);
    RECORD_VALUE("events.hops.end", failure->time);
}
// [events.tests.wrong_hops]
