#include <cmath>
#include <numbers>

#include "math/random.hpp"
#include "orbits.hpp"
#include "support/receipts.hpp"

using namespace flying;
using namespace flying::steps;

namespace {

constexpr double k_last_place = 0x1p-52;

double miss(const auto& step, const Orbit& orbit, long n)
{
    const double t = 0.75 * orbit.period();
    const Moving found = run(step, on_ellipse(orbit, 0.0), CentralPull{orbit.mu},
                             t / static_cast<double>(n), n);
    return (found.x - on_ellipse(orbit, t).x).norm() / orbit.a;
}

Orbit random_ellipse(Random& random)
{
    return {random.uniform(0.5, 5.0), random.uniform(0.5, 5.0), random.uniform(0.05, 0.9)};
}

} // namespace

TEST_CASE("half the long axis follows from the energy alone")
{
    Random random(42);
    for (int k = 0; k < 1000; ++k) {
        const Orbit o = random_ellipse(random);
        const double w = energy(on_ellipse(o, random.uniform(-9.0, 9.0)), o.mu);

        // Near the centre two terms of up to 20 times their sum cancel
        CHECK_EQUATION("kepler.axis", o.a, -o.mu / (2.0 * w), 1e-13, {"\\mu", o.mu},
                       {"w", w});
        CHECK_TWIN("kepler.axis", o.a, -o.mu / (2.1 * w), 1e-13);
    }
}

TEST_CASE("the period is the time that Verlet needs to come round")
{
    // Two runs of second order, extrapolated: what is left is of fourth order
    Random random(44);
    for (int k = 0; k < 20; ++k) {
        const Orbit o{random.uniform(0.5, 5.0), random.uniform(0.5, 5.0),
                      random.uniform(0.1, 0.4)};
        const double T = 2.0 * std::numbers::pi * std::sqrt(o.a * o.a * o.a / o.mu);
        const auto time_round = [&](long n) {
            const double h = T / static_cast<double>(n);
            Moving b = run(k_verlet, on_ellipse(o, 0.0), CentralPull{o.mu}, h, n);
            // What is missing to the x axis, at the speed across it
            return T - b.x.y() / b.v.y();
        };
        const double found = (4.0 * time_round(20000) - time_round(10000)) / 3.0;
        CHECK_EQUATION("kepler.period", found, T, 1e-7, {"a", o.a}, {"\\mu", o.mu});
        CHECK_TWIN("kepler.period", found, 6.28 * std::sqrt(o.a * o.a * o.a / o.mu), 1e-7);
        CHECK(std::abs(o.period() - T) <= 4.0 * k_last_place * T);
    }
}

TEST_CASE("Euler and symplectic Euler are of first order, Verlet is of second")
{
    const Orbit orbit{1.0, 1.0, 0.5};
    const auto order = [&](const auto& step) {
        return std::log10(miss(step, orbit, 40000) / miss(step, orbit, 400000));
    };
    CHECK(std::abs(order(k_euler) - 1.0) < 0.03);
    CHECK(std::abs(order(k_symplectic) - 1.0) < 0.01);
    CHECK(std::abs(order(k_verlet) - 2.0) < 0.01);
}

TEST_CASE("one step of explicit Euler across the pull gains energy")
{
    Random random(48);
    for (int k = 0; k < 1000; ++k) {
        const double mu = random.uniform(0.5, 5.0);
        const double r = random.uniform(0.5, 5.0);
        const double v = random.uniform(0.3, 3.0);
        const double h = random.uniform(0.1, 0.9) * r / v;
        const Moving before{Vec2(r, 0.0), Vec2(0.0, v)};
        const Moving after = euler(before, CentralPull{mu}, h);
        const double gain = energy(after, mu) - energy(before, mu);

        // Energies are at most 25 times their smallest gain, and pass ten roundings
        const double closed = h * h * mu * mu / (2 * r * r * r * r) + mu / r -
                              mu / std::sqrt(r * r + h * h * v * v);
        const double scale = v * v + mu / r;
        CHECK_EQUATION_SCALED("steps.gain", gain, closed, scale, 1e-13, {"h", h},
                              {"\\mu", mu}, {"r", r}, {"v", v});
        CHECK_TWIN_SCALED("steps.gain", gain, closed + 0.1 * mu / r, scale, 1e-13);
        CHECK(gain > 0.0);
    }

    // By hand: mu, r and v are 1, the step is 1/2
    const Moving once = euler({Vec2(1.0, 0.0), Vec2(0.0, 1.0)}, CentralPull{1.0}, 0.5);
    CHECK(once.x == Vec2(1.0, 0.5));
    CHECK(once.v == Vec2(-0.5, 1.0));
    RECORD_VALUE("steps.gain.by-hand", energy(once, 1.0));
}

// [flying.tests.back]
TEST_CASE("Verlet flown back in time returns to its start, explicit Euler does not")
{
    const Orbit o{1.0, 1.0, 0.5};
    const double h = o.period() / 1000.0;
    const auto there_and_back = [&](const auto& step) {
        const Moving start = on_ellipse(o, 0.0);
        const Moving there = run(step, start, CentralPull{o.mu}, h, 1000);
        const Moving back = run(step, there, CentralPull{o.mu}, -h, 1000);
        return (back.x - start.x).norm() / o.a;
    };
    const double by_verlet = there_and_back(k_verlet);
    const double by_euler = there_and_back(k_euler);
    CHECK(by_verlet < 1e-11); // 2000 steps of some ulp, spread a hundredfold by the orbit
    CHECK(by_euler > 0.1);
    RECORD_VALUE("steps.back.verlet", by_verlet);
    RECORD_VALUE("steps.back.euler", by_euler);
}
// [flying.tests.back]
