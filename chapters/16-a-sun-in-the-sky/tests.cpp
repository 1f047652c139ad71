#include <cmath>
#include <numbers>

#include <boost/math/quadrature/tanh_sinh.hpp>

#include "../01-flying-balls/orbits.hpp"
#include "math/random.hpp"
#include "motion/kepler.hpp"
#include "support/receipts.hpp"
#include "wrong_turns.hpp"

using namespace flying;
using namespace flying::steps;

namespace {

constexpr double k_ulp = 0x1p-52;

Orbit random_ellipse(Random& random)
{
    return {random.uniform(0.5, 5.0), random.uniform(0.5, 5.0), random.uniform(0.05, 0.9)};
}

} // namespace

TEST_CASE(
    "a place on the orbit obeys the equation of the conic section, ellipse or hyperbola")
{
    Random random(41);
    for (int k = 0; k < 1000; ++k) {
        Orbit o = random_ellipse(random);
        const bool bound = k % 2 == 0;
        if (!bound) o.ecc += 1.0;
        const double t = random.uniform(-3.0, 3.0) / o.mean_motion();
        const Moving b = bound ? on_ellipse(o, t) : on_hyperbola(o, t);
        const double l = std::sqrt(o.mu * o.a * std::abs(1.0 - o.ecc * o.ecc));
        const double nu = std::atan2(b.x.y(), b.x.x());
        const double r = l * l / o.mu / (1.0 + o.ecc * std::cos(nu));

        // Far out on a hyperbola 1 + ecc cos nu cancels, and l^2 does where ecc is near 1:
        // three digits at the most
        CHECK_EQUATION("kepler.conic", b.x.norm(), r, 1e-12, {"l", l}, {"\\mu", o.mu},
                       {"\\varepsilon", o.ecc}, {"\\nu", nu});
        CHECK_TWIN("kepler.conic", b.x.norm(),
                   l * l / o.mu / (1.0 + 1.1 * o.ecc * std::cos(nu + 0.1)), 1e-12);
        CHECK(std::abs(angular_momentum(b) - l) <= 1e-13 * l);
    }
}

// [flying.tests.kepler]
TEST_CASE(
    "Kepler's equation is solved to rounding at any eccentricity, near the parabola too")
{
    Random random(43);
    for (int k = 0; k < 3000; ++k) {
        const double gap =
            k % 2 == 0 ? random.uniform() : std::exp2(random.uniform(-50.0, -1.0));
        const double ecc = 1.0 - gap;
        const double M = std::numbers::pi * random.uniform();
        const double E = eccentric_anomaly(M, ecc);

        // The rounding of E, which is at most pi
        CHECK_EQUATION_SCALED("kepler.equation", M, E - ecc * std::sin(E), std::numbers::pi,
                              2.0 * k_ulp, {"E", E}, {"\\varepsilon", ecc});
        CHECK_TWIN_SCALED("kepler.equation", M, E + ecc * std::sin(E), std::numbers::pi,
                          2.0 * k_ulp);
    }
}
// [flying.tests.kepler]

TEST_CASE(
    "energy, angular momentum and the eccentricity vector stay over a thousand periods "
    "of the closed form")
{
    Random random(45);
    double worst = 0.0;
    for (int k = 0; k < 100; ++k) {
        const Orbit o = random_ellipse(random);
        for (int j = 0; j < 100; ++j) {
            const Moving b = on_ellipse(o, random.uniform(0.0, 1000.0) * o.period());
            worst = std::max(worst, (eccentricity(b, o.mu) - Vec2(o.ecc, 0.0)).norm());
        }
    }
    // Near the centre v l / mu is up to 2, and v is the quotient of numbers that cancel to
    // a tenth
    CHECK(worst <= 100.0 * k_ulp);
    RECORD_VALUE("kepler.eccentricity.worst", worst);
}

TEST_CASE("a passer-by is turned by twice the arc sine of 1 over the eccentricity")
{
    Random random(46);
    for (int k = 0; k < 300; ++k) {
        const Orbit o{1.0, random.uniform(0.5, 5.0), random.uniform(1.1, 5.0)};
        const Vec2 before = on_hyperbola(o, -1e17).v;
        const Vec2 after = on_hyperbola(o, 1e17).v;
        const double delta = std::atan2(cross(before, after), before.dot(after));

        // Directions at a distance of 1e16 differ from the last ones by its inverse
        CHECK_EQUATION("kepler.deflection", delta, 2.0 * std::asin(1.0 / o.ecc), 1e-13,
                       {"\\varepsilon", o.ecc});
        CHECK_TWIN("kepler.deflection", delta, std::asin(1.0 / o.ecc), 1e-13);

        const double M = random.uniform(0.01, 10.0);
        const double H = hyperbolic_anomaly(M, o.ecc);
        CHECK_EQUATION("kepler.hyperbola", M, o.ecc * std::sinh(H) - H, 1e-13,
                       {"\\varepsilon", o.ecc}, {"H", H});
        CHECK_TWIN("kepler.hyperbola", M, o.ecc * std::sinh(H) + H, 1e-13);
    }
}

TEST_CASE("Verlet finds the hyperbola too")
{
    // A flight by a centre, from far before to far after; error of second order
    const Orbit o{1.0, 1.0, 1.5};
    const auto error = [&](long n) {
        const Moving end = run(k_verlet, on_hyperbola(o, -5.0), CentralPull{o.mu},
                               10.0 / static_cast<double>(n), n);
        return (end.x - on_hyperbola(o, 5.0).x).norm();
    };
    CHECK(std::log2(error(20000) / error(40000)) == doctest::Approx(2.0).epsilon(1e-3));
    CHECK(error(40000) < 1e-5);
}

TEST_CASE("a body let go falls into the centre in the time that its energy says")
{
    boost::math::quadrature::tanh_sinh<double> quadrature;
    Random random(47);
    for (int k = 0; k < 200; ++k) {
        const double mu = random.uniform(0.5, 5.0);
        const double r_0 = random.uniform(1.0, 5.0);
        const double r = r_0 * random.uniform(0.0, 0.9);

        // Add up dr over the speed; s = r_0 - r keeps the singular end exact
        const auto slowness = [&](double s) {
            return std::sqrt((r_0 - s) * r_0 / (2.0 * mu * s));
        };
        const double summed = quadrature.integrate(slowness, 0.0, r_0 - r, 1e-13);
        const double q = r / r_0;
        const double closed = std::sqrt(r_0 * r_0 * r_0 / (2.0 * mu)) *
                              (std::acos(std::sqrt(q)) + std::sqrt(q * (1.0 - q)));
        CHECK_EQUATION("kepler.fall", fall_time(mu, r_0, r), closed, 1e-14, {"r_0", r_0},
                       {"\\mu", mu}, {"q", q});
        CHECK_TWIN("kepler.fall", fall_time(mu, r_0, r), 1.1 * closed, 1e-14);
        CHECK(std::abs(fall_time(mu, r_0, r) - summed) <= 1e-11 * summed);
    }

    // The whole way is half the period of a flat ellipse of half the size
    const Orbit flat{2.0, 0.5 * 3.0, 0.0};
    CHECK(fall_time(2.0, 3.0, 0.0) == doctest::Approx(0.5 * flat.period()).epsilon(1e-14));
    RECORD_VALUE("kepler.fall.days",
                 fall_time(1.32712440018e20, 1.495978707e11, 0.0) / 86400.0);
}

namespace {

/// G1, G2 and G3 at s, for a binding that doesn't vanish, with 64 bits.
struct ThreeFunctions
{
    long double g_1, g_2, g_3;
};
ThreeFunctions universal_functions(long double beta, long double s)
{
    const long double root = std::sqrt(std::abs(beta));
    const long double g_1 = (beta > 0.0L ? std::sin(root * s) : std::sinh(root * s)) / root;
    const long double g_0 = beta > 0.0L ? std::cos(root * s) : std::cosh(root * s);
    return {g_1, (1.0L - g_0) / beta, (s - g_1) / beta};
}

} // namespace

TEST_CASE("the engine's one form takes the time that the sum of G1, G2 and G3 says")
{
    Random random(49);
    for (int k = 0; k < 1000; ++k) {
        PointMotion start;
        start.position = Vec2{random.uniform(0.5, 2.0), random.uniform(-1.0, 1.0)};
        start.velocity = Vec2{random.uniform(-1.0, 1.0), random.uniform(0.3, 2.0)};
        const double mu = random.uniform(0.5, 3.0);
        const double t = random.uniform(0.5, 3.0);
        const KeplerFlight orbit(start, mu);
        const double beta = orbit.binding();
        if (std::abs(beta) < 0.1) continue; // the test's own functions cancel there

        // sigma grows by mu s - beta t, which tells s; its turns are those of the engine's
        // flight only while the body has not come round
        if (beta > 0.0 && t * beta * std::sqrt(beta) > 2.0 * mu) continue;
        const PointMotion end = orbit.after(t);
        const double sigma_0 = start.position.dot(start.velocity);
        const double s = (beta * t + end.position.dot(end.velocity) - sigma_0) / mu;
        const ThreeFunctions g = universal_functions(beta, s);
        const double r_0 = start.position.norm();
        const auto sum = static_cast<double>(r_0 * g.g_1 + sigma_0 * g.g_2 + mu * g.g_3);

        // sigma is rounded at sizes up to 20, and near the centre the place changes fast
        CHECK_EQUATION("kepler.time", t, sum, 1e-12, {"r_0", r_0}, {"G_1", g.g_1},
                       {"\\sigma_0", sigma_0}, {"G_2", g.g_2}, {"\\mu", mu},
                       {"G_3", g.g_3});
        CHECK_TWIN("kepler.time", t, sum + 0.1 * mu * static_cast<double>(g.g_3), 1e-12);
    }
}

TEST_CASE("the engine's one form flies as the ellipse's and the hyperbola's forms do")
{
    Random random(50);
    double worst = 0.0;
    for (int k = 0; k < 1000; ++k) {
        const bool is_near = k % 2 == 0;
        const double gap =
            is_near ? std::exp2(random.uniform(-10.0, -3.0)) : random.uniform(0.1, 0.9);
        const bool bound = k % 4 < 2;
        const Orbit o{1.0, 1.0, bound ? 1.0 - gap : 1.0 + gap};
        const auto form = [&](double t) {
            return bound ? on_ellipse(o, t) : on_hyperbola(o, t);
        };
        const double from = random.uniform(-2.0, 2.0);
        const double wait = random.uniform(0.0, 4.0);
        const Moving start = form(from);
        const Moving end = form(from + wait);
        const PointMotion found = KeplerFlight({start.x, start.v}, o.mu).after(wait);
        worst = std::max(worst, (found.position - end.x).norm() / end.x.norm());
    }
    // Near the parabola the forms lose three digits, and a start near the centre spreads
    // them
    CHECK(worst < 1e-9);
    RECORD_VALUE("kepler.engine.worst", worst);
}

TEST_CASE("what hardly changes need not be nearly there: Kepler's equation by turns")
{
    const double ecc = 0.999;
    const double M = 1e-4;
    const double small = 1e-6;
    const wrong::ByTurns by_turns = wrong::anomaly_by_turns(M, ecc, small);
    // [flying.tests.turns]
    const double error = std::abs(by_turns.E - eccentric_anomaly(M, ecc));
    CHECK_FALSE(error <= 10.0 * small);
    // [flying.tests.turns]
    CHECK(std::abs(by_turns.E - M - ecc * std::sin(by_turns.E)) <= small);
    RECORD_VALUE("kepler.turns.rounds", by_turns.rounds);
    RECORD_VALUE("kepler.turns.worse", error / small);
}

TEST_CASE("near the sun the angle E grows fast, far from it slowly")
{
    const auto growth = [](int eighth) {
        const double quarter = 0.25 * std::numbers::pi;
        return eccentric_anomaly(quarter * eighth, 0.5) - eccentric_anomaly(quarter * (eighth - 1), 0.5);
    };
    CHECK(growth(1) > growth(4));
    RECORD_VALUE("kepler.first-eighth", growth(1));
    RECORD_VALUE("kepler.fourth-eighth", growth(4));
}
