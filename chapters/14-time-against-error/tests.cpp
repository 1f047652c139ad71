// What the chapter says, checked. No clock of the machine is read: those of the tests tick as they are told.

#include <cmath>
#include <doctest/doctest.h>

#include "math/random.hpp"
#include "race.hpp"
#include "record.hpp"
#include "spread.hpp"
#include "support/receipts.hpp"
#include "wrong_blocks.hpp"

using namespace flying;
using namespace flying::work;

namespace {

/// Two contestants on a machine, which take the same.
std::vector<Prepare> two_equals(DriftingMachine& machine)
{
    const Prepare run = [&machine] { return [&machine] { machine.run(); }; };
    return {run, run};
}

double mean(const std::vector<double>& values)
{
    double sum = 0.0;
    for (const double value : values) sum += value;
    return sum / static_cast<double>(values.size());
}

} // namespace

// [time-against-error.tests.euler]
TEST_CASE("a fall by explicit Euler is behind by half a step's way at the last speed")
{
    Random random(1401);
    for (int k = 0; k < 200; ++k) {
        const double g = random.uniform(1.0, 20.0);
        const double h = random.uniform(0.01, 0.5);
        const int n = 1 + random.below(50);
        const auto pull = [g](const Vec2&) { return Vec2(0.0, -g); };
        const steps::Moving end = steps::run(steps::k_euler, steps::Moving{Vec2(0.0, 0.0), Vec2(0.0, 0.0)}, pull, h, n);
        const double T = n * h;
        const double E = end.x.y() + 0.5 * g * T * T;
        CHECK_EQUATION("precision.euler", E, 0.5 * g * T * h, 1e-11, {"g", g}, {"T", T}, {"h", h});
        CHECK_TWIN("precision.euler", E, g * T * h, 1e-11);
    }
}
// [time-against-error.tests.euler]

TEST_CASE("two points of a power law tell its exponent")
{
    Random random(1402);
    for (int k = 0; k < 100; ++k) {
        const double p = random.uniform(0.5, 4.0);
        const double W1 = random.uniform(0.01, 1.0);
        const double W2 = W1 * random.uniform(2.0, 100.0);
        const double E1 = random.uniform(0.1, 10.0);
        const double E2 = E1 * std::pow(W1 / W2, p);
        const double xs[] = {W1, W2};
        const double ys[] = {E1, E2};
        const double found = -slope(xs, ys).value();
        const double closed = std::log(E1 / E2) / std::log(W2 / W1);
        CHECK_EQUATION("precision.slope", found, closed, 1e-12, {"E_1", E1}, {"E_2", E2}, {"W_1", W1}, {"W_2", W2});
        CHECK_TWIN("precision.slope", found, 1.01 * closed, 1e-12);
        CHECK(found == doctest::Approx(p).epsilon(1e-12));
    }
}

// [time-against-error.tests.late]
TEST_CASE("a wall that is found at the end of a step costs v h on average")
{
    Random random(1403);
    for (int k = 0; k < 50; ++k) {
        const double v = random.uniform(0.5, 5.0);
        const double h = random.uniform(0.01, 0.1);
        constexpr int k_phases = 64;
        double sum = 0.0;
        for (int phase = 0; phase < k_phases; ++phase) {
            // The wall is met at this share of the second of three steps
            const double share = (phase + 0.5) / k_phases;
            const walls::Walls room =
                walls::box_walls(Vec2(-10.0, -1.0), Vec2(0.25 + (1.0 + share) * v * h, 1.0), 0.25);
            const BodyState start{Vec2(0.0, 0.0), Vec2(v, 0.0), 0.0, 0.0, 0.0};
            const BodyState late = by_steps(steps::k_verlet, start, room, Vec2(0.0, 0.0), h, 3);
            sum += (late.position - by_walls(start, room, Vec2(0.0, 0.0), 3.0 * h).ball.position).norm();
        }
        CHECK_EQUATION("precision.late", sum / k_phases, v * h, 1e-11, {"v", v}, {"h", h});
        CHECK_TWIN("precision.late", sum / k_phases, 0.5 * v * h, 1e-11);
    }
}
// [time-against-error.tests.late]

// [time-against-error.tests.blocks]
TEST_CASE("an engine is as fast as itself where runs go there and back, and slower than itself "
          "in blocks")
{
    for (int n = 2; n <= 40; n += 2) {
        const double d = 0.001 * n;
        DriftingMachine machine{d};
        const auto clock = [&machine] { return machine.now; };
        const auto blocks = time_in_blocks(two_equals(machine), n, clock);
        const double B = mean(blocks[1]) - mean(blocks[0]);
        CHECK_EQUATION("precision.blocks", B, n * d, 1e-10, {"n", n}, {"d", d});
        CHECK_TWIN("precision.blocks", B, d, 1e-10);

        const auto turns = time_in_turn(two_equals(machine), n, clock);
        CHECK(std::abs(mean(turns[1]) - mean(turns[0])) < 1e-11);
    }
}
// [time-against-error.tests.blocks]

TEST_CASE("quartiles lie where a quarter, half and three quarters of the values are below")
{
    const Spread of_five = spread_of({5.0, 1.0, 4.0, 2.0, 3.0});
    CHECK(of_five.low == 2.0);
    CHECK(of_five.median == 3.0);
    CHECK(of_five.high == 4.0);
    const Spread of_four = spread_of({1.0, 2.0, 3.0, 4.0});
    CHECK(of_four.median == 2.5);
    CHECK(of_four.low == 1.75);
    CHECK(spread_of({7.0}).high == 7.0);
    CHECK(spread_of({}).median == 0.0);

    // One run in twenty that is held up for long
    std::vector<double> times(20, 1.0);
    times[7] = 100.0;
    CHECK(spread_of(times).median == 1.0);
    CHECK(mean(times) > 5.0);
}

TEST_CASE("the time at an error is that of the quickest point which is as good: ratios tell where we don't get")
{
    const std::vector<Point> theirs = {{1.0, 1e-1}, {2.0, 1e-2}, {4.0, 2e-2}, {8.0, 1e-3}};
    CHECK(time_at(theirs, 1e-1).value() == 1.0);
    CHECK(time_at(theirs, 2e-2).value() == 2.0); // the point at 4 s is worse and slower
    CHECK(time_at(theirs, 5e-3).value() == 8.0);
    CHECK_FALSE(time_at(theirs, 1e-4));

    const std::vector<Point> ours = {{3.0, 5e-3}};
    const std::vector<Ratio> all = ratios(ours, theirs);
    REQUIRE(all.size() == 4);
    CHECK(all[0].ours_over_theirs.value() == 3.0);
    CHECK(all[1].ours_over_theirs.value() == 1.5);
    CHECK(all[2].ours_over_theirs.value() == 1.5);
    CHECK(all[3].error == 1e-3);
    CHECK_FALSE(all[3].ours_over_theirs);
}

TEST_CASE("a slope is that of the best straight line, and one point has none")
{
    const double xs[] = {1.0, 10.0, 100.0};
    const double ys[] = {1.0, 1000.0, 100.0};
    CHECK(slope(xs, ys).value() == doctest::Approx(1.0).epsilon(1e-14));
    CHECK_FALSE(slope(std::span(xs).first(1), std::span(ys).first(1)));
}

// [time-against-error.tests.orders]
TEST_CASE("without walls Verlet is of second order and Euler of first: with walls all are of "
          "first, and from wall to wall there is no order at all")
{
    const double orbit = error_of_orbit(steps::k_verlet, 20000) / error_of_orbit(steps::k_verlet, 40000);
    CHECK(orbit == doctest::Approx(4.0).epsilon(0.01));
    const double first = error_of_orbit(steps::k_euler, 100000) / error_of_orbit(steps::k_euler, 200000);
    CHECK(first == doctest::Approx(2.0).epsilon(0.05));

    // One ball has luck with its steps or hasn't; the mean over many races hasn't
    double coarse = 0.0;
    double fine = 0.0;
    for (int k = 0; k < 40; ++k) {
        Race race;
        race.height = 1.0 + 0.02 * k;
        race.speed = 2.0 + 0.05 * k;
        coarse += error_by_steps(race, steps::k_verlet, 10000);
        fine += error_by_steps(race, steps::k_verlet, 80000);
        const Flown flown = by_walls(race.start(), race.walls(), race.gravity(), race.until);
        CHECK(race.error(flown.ball) < 1e-12);
    }
    CHECK(coarse / fine == doctest::Approx(8.0).epsilon(0.25));
}
// [time-against-error.tests.orders]

TEST_CASE("the run that the chapter quotes is one of this format, complete, and made with at least thirty repeats")
{
    const auto records = read_record_file(FLYING_SOURCE_DIR "/chapters/14-time-against-error/measured.jsonl");
    REQUIRE(records);
    CHECK(records->run.repeats >= 30);
    CHECK(records->diagrams.size() >= 25);
    for (const DiagramRecord& diagram : records->diagrams) {
        CAPTURE(diagram.name);
        CHECK_FALSE(our_points(diagram).empty());
    }
}
