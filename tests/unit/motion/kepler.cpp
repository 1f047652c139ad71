#include <doctest/doctest.h>

#include <algorithm>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <numbers>

#include "math/random.hpp"
#include "motion/flight.hpp"
#include "motion/kepler.hpp"

using namespace flying;

namespace {

using Real = boost::multiprecision::cpp_bin_float_50;

/// A flight with fifty digits, by the eccentric anomaly (or its hyperbolic sister) and
/// bisection: nothing of the engine's universal variables in it.
struct Oracle
{
    Real x[2], v[2], mu, r, outward, a, root; // a > 0 on either kind; root = sqrt(mu / a)
    bool bound;

    Oracle(const PointMotion& start, double strength)
        : x{start.position.x(), start.position.y()},
          v{start.velocity.x(), start.velocity.y()},
          mu(strength)
    {
        r = sqrt(x[0] * x[0] + x[1] * x[1]);
        outward = x[0] * v[0] + x[1] * v[1];
        const Real binding = 2 * mu / r - (v[0] * v[0] + v[1] * v[1]);
        bound = binding > 0;
        a = mu / abs(binding);
        root = sqrt(mu / a);
    }

    /// Time until the anomaly has grown by E.
    [[nodiscard]] Real time(const Real& E) const
    {
        const Real n = root / a;
        if (bound)
            return (E - (1 - r / a) * sin(E) + outward / (root * a) * (1 - cos(E))) / n;
        return ((1 + r / a) * sinh(E) - E + outward / (root * a) * (cosh(E) - 1)) / n;
    }

    [[nodiscard]] PointMotion after(double t) const
    {
        Real low = -1;
        Real high = 1;
        while (time(low) > t) low *= 2;
        while (time(high) < t) high *= 2;
        for (int k = 0; k < 170; ++k) {
            const Real middle = (low + high) / 2;
            (time(middle) < t ? low : high) = middle;
        }
        const Real E = (low + high) / 2;
        const Real sine = bound ? Real(sin(E)) : Real(sinh(E));
        const Real versed = bound ? Real(1 - cos(E)) : Real(cosh(E) - 1);
        const Real f = 1 - a / r * versed;
        const Real g = a * r / (a * root) * sine + outward * a / mu * versed;
        const Real xx = f * x[0] + g * v[0];
        const Real xy = f * x[1] + g * v[1];
        const Real r_then = sqrt(xx * xx + xy * xy);
        const Real f_rate = -root * a / (r * r_then) * sine;
        const Real g_rate = 1 - a / r_then * versed;
        const Real vx = f_rate * x[0] + g_rate * v[0];
        const Real vy = f_rate * x[1] + g_rate * v[1];
        return {Vec2(xx.convert_to<double>(), xy.convert_to<double>()),
                Vec2(vx.convert_to<double>(), vy.convert_to<double>())};
    }
};

/// At the distance 1 from a centre of strength mu, so that the orbit has this eccentricity
/// and this angle of flight.
PointMotion random_start(Random& random, double mu)
{
    const double speed = std::sqrt(mu) * random.uniform(0.1, 2.5);
    const double angle = random.uniform(0.0, 2.0 * std::numbers::pi);
    const double heading = random.uniform(0.0, 2.0 * std::numbers::pi);
    return {Vec2(std::cos(angle), std::sin(angle)),
            Vec2(speed * std::cos(heading), speed * std::sin(heading))};
}

double energy(const PointMotion& p, double mu)
{
    return 0.5 * p.velocity.squaredNorm() - mu / p.position.norm();
}

Vec2 eccentricity(const PointMotion& p, double mu)
{
    return -(cross(p.position, p.velocity) / mu) * perp(p.velocity) -
           p.position / p.position.norm();
}

bool same(const PointMotion& p, const PointMotion& q)
{
    return p.position == q.position && p.velocity == q.velocity;
}

} // namespace

TEST_CASE(
    "A thousand orbits of eccentricity 0.6 end where they began, to 1e-11 of the axis")
{
    // mu = 1, a = 1: the period is 2 pi, and the flight starts at the nearest, the farthest
    // and some other point
    const double e = 0.6;
    const double turn = 2.0 * std::numbers::pi;
    for (const double E : {0.0, 1.0, 2.5, std::numbers::pi, 4.0}) {
        const double r = 1.0 - e * std::cos(E);
        const double flat = std::sqrt(1.0 - e * e);
        const PointMotion start{Vec2(std::cos(E) - e, flat * std::sin(E)),
                                Vec2(-std::sin(E) / r, flat * std::cos(E) / r)};
        const KeplerFlight orbit(start, 1.0);
        CHECK(orbit.nearest() == doctest::Approx(0.4).epsilon(1e-11));

        // Each turn by itself from the start: the starting numbers' own rounding moves the
        // period by up to 3 a/r e_machine = 8e-16 of itself, which after 1000 turns is
        // 5e-12 of phase, at speeds up to 2
        const PointMotion end = orbit.after(1000.0 * turn);
        CHECK((end.position - start.position).norm() < 1e-11);
        CHECK((end.velocity - start.velocity).norm() < 5e-11);

        // Against fifty digits, the start taken as it is: only the engine's rounding is
        // left
        const PointMotion expected = Oracle(start, 1.0).after(1000.0 * turn);
        CHECK((end.position - expected.position).norm() < 1e-14);
        CHECK((end.velocity - expected.velocity).norm() < 1e-13);
        CHECK(energy(end, 1.0) == doctest::Approx(-0.5).epsilon(1e-14));
    }
}

TEST_CASE("Flights of every regime agree with fifty digits")
{
    // Seed 1. The distance is 1 and the speed about the escape speed. A flight's end is
    // worth an ulp of its start and time: conditioning grows with the way to the far end
    // and back, hence the bound relative to the largest numbers
    Random random(1);
    double worst_position = 0.0;
    double worst_velocity = 0.0;
    for (int k = 0; k < 600; ++k) {
        const double mu = std::exp2(random.uniform(-20.0, 20.0));
        const PointMotion start = random_start(random, mu);
        const double t = random.uniform(-20.0, 20.0) / std::sqrt(mu);
        const KeplerFlight orbit(start, mu);
        const PointMotion end = orbit.after(t);
        const PointMotion expected = Oracle(start, mu).after(t);
        const double l = std::abs(cross(start.position, start.velocity)) / std::sqrt(mu);
        if (l < 0.05) continue; // nearly radial: the next case
        const double nearest = orbit.nearest();
        const double reach = std::max(1.0, expected.position.norm());
        const double top_speed = orbit.greatest_speed(nearest);
        const double condition = 1.0 / (nearest * nearest);
        worst_position =
            std::max(worst_position,
                     (end.position - expected.position).norm() / (reach * condition));
        worst_velocity =
            std::max(worst_velocity, (end.velocity - expected.velocity).norm() /
                                         (top_speed * condition * reach));
    }
    MESSAGE("worst: position " << worst_position << ", velocity " << worst_velocity);
    CHECK(worst_position < 1e-14);
    CHECK(worst_velocity < 1e-14);
}

TEST_CASE("Energy, angular momentum and the eccentricity vector stay as they are")
{
    // Seed 2. Bounds: some ulps of the largest term at either end
    Random random(2);
    for (int k = 0; k < 5000; ++k) {
        const PointMotion start = random_start(random, 1.0);
        const double l = cross(start.position, start.velocity);
        if (std::abs(l) < 0.3) continue;
        const PointMotion end = KeplerFlight(start, 1.0).after(random.uniform(-50.0, 50.0));
        const double reach = std::max(1.0, end.position.norm());
        const double terms = 0.5 * start.velocity.squaredNorm() + 1.0 +
                             0.5 * end.velocity.squaredNorm() + 1.0 / end.position.norm();
        REQUIRE(std::abs(energy(end, 1.0) - energy(start, 1.0)) < 1e-14 * terms * terms);
        REQUIRE(std::abs(cross(end.position, end.velocity) - l) < 1e-14 * reach * terms);
        REQUIRE((eccentricity(end, 1.0) - eccentricity(start, 1.0)).norm() <
                1e-14 * reach * terms);
    }
}

TEST_CASE("A hyperbola turns the flight by 2 asin(1/e)")
{
    for (const double e : {1.01, 1.2, 2.0, 5.0, 50.0}) {
        // At the nearest point of an orbit with mu = 1 and a = 1; far off, the direction is
        // that of the velocity
        const KeplerFlight orbit(
            {Vec2(e - 1.0, 0.0), Vec2(0.0, std::sqrt((e + 1.0) / (e - 1.0)))}, 1.0);
        const double far = 1e12;
        const Vec2 in = orbit.after(-far).velocity;
        const Vec2 out = orbit.after(far).velocity;
        const double turned = std::atan2(cross(in, out), in.dot(out));

        // The direction still misses about 1/far of its turn
        const double expected = 2.0 * std::asin(1.0 / e);
        CHECK(std::abs(turned - expected) < 1e-11);
        CHECK(out.norm() == doctest::Approx(1.0).epsilon(1e-11));
    }
}

TEST_CASE("A radial fall takes sqrt(r0^3 / 2 mu) (acos sqrt x + sqrt(x (1 - x)))")
{
    for (const double mu : {0.01, 1.0, 40.0}) {
        for (const double x : {0.999, 0.9, 0.5, 0.1, 0.01, 1e-4}) {
            const double r0 = 3.0;
            const double t = std::sqrt(r0 * r0 * r0 / (2.0 * mu)) *
                             (std::acos(std::sqrt(x)) + std::sqrt(x * (1.0 - x)));
            const KeplerFlight orbit({Vec2(0.0, r0), Vec2(0.0, 0.0)}, mu);
            const PointMotion end = orbit.after(t);
            const double speed = std::sqrt(2.0 * mu * (1.0 / x - 1.0) / r0);

            // An ulp of the time moves the place by the speed
            CHECK(std::abs(end.position.y() - x * r0) < 1e-14 * r0 + 4e-16 * speed * t);
            CHECK(end.position.x() == 0.0);
            CHECK(-end.velocity.y() == doctest::Approx(speed).epsilon(1e-13 / x));
            CHECK(orbit.nearest() == 0.0);

            // And the way back out of the well: an ulp of r0 in r changes the energy by 1 /
            // x^2 ulps
            const PointMotion top =
                KeplerFlight({end.position, -end.velocity}, mu).after(t);
            CHECK(top.position.y() == doctest::Approx(r0).epsilon(1e-14 / (x * x)));
        }
    }
}

TEST_CASE("Nearly parabolic flights agree with fifty digits")
{
    // Seed 3. The speed is the escape speed, times 1 + 10^-k
    Random random(3);
    for (int k = 0; k < 120; ++k) {
        const double away = std::pow(10.0, -random.uniform(1.0, 15.0)) *
                            (random.below(2) == 0 ? 1.0 : -1.0);
        const double turned = random.below(2) == 0 ? 1.0 : -1.0;
        const double heading = turned * random.uniform(0.3, std::numbers::pi - 0.3);
        const double speed = std::sqrt(2.0) * (1.0 + away);
        const PointMotion start{Vec2(1.0, 0.0),
                                Vec2(speed * std::cos(heading), speed * std::sin(heading))};
        const double side = random.below(2) == 0 ? 1.0 : -1.0;
        const double t = side * std::pow(10.0, random.uniform(-3.0, 6.0));
        const PointMotion end = KeplerFlight(start, 1.0).after(t);
        const PointMotion expected = Oracle(start, 1.0).after(t);
        const double reach = std::max(1.0, expected.position.norm());
        REQUIRE((end.position - expected.position).norm() < 2e-13 * reach);
        REQUIRE((end.velocity - expected.velocity).norm() < 2e-13);
    }
}

TEST_CASE(
    "Forth and back in time is the same flight, and turning time round changes no bit")
{
    Random random(4);
    for (int k = 0; k < 2000; ++k) {
        const PointMotion start = random_start(random, 1.0);
        if (std::abs(cross(start.position, start.velocity)) < 0.3) continue;
        const double t = random.uniform(0.0, 30.0);
        const PointMotion end = KeplerFlight(start, 1.0).after(t);
        const PointMotion turned =
            KeplerFlight({start.position, -start.velocity}, 1.0).after(-t);
        REQUIRE(turned.position == end.position);
        REQUIRE(turned.velocity == -end.velocity);

        const PointMotion back = KeplerFlight(end, 1.0).after(-t);
        const double r = end.position.norm();
        const double condition = std::max(1.0, r) * (1.0 + t) * 40.0;
        REQUIRE((back.position - start.position).norm() < 4e-15 * condition);
    }
}

TEST_CASE("Lengths, times and strengths scale by powers of two bit for bit: so do mirrors "
          "and quarter turns")
{
    Random random(5);
    for (int k = 0; k < 4000; ++k) {
        const PointMotion start = random_start(random, 1.0);
        const double side = random.below(2) == 0 ? 1.0 : -1.0;
        const double t = side * std::exp2(random.uniform(-10.0, 10.0));
        const PointMotion end = KeplerFlight(start, 1.0).after(t);

        // Any exponents: the strength is a length cubed over a time squared
        const int length = random.below(61) - 30;
        const int time = random.below(61) - 30;
        const double speed = std::ldexp(1.0, length - time);
        const double size = std::ldexp(1.0, length);
        const PointMotion scaled =
            KeplerFlight({size * start.position, speed * start.velocity},
                         std::ldexp(1.0, 3 * length - 2 * time))
                .after(std::ldexp(t, time));
        REQUIRE(same(scaled, {size * end.position, speed * end.velocity}));

        const auto mirror = [](const Vec2& a) { return Vec2(-a.x(), a.y()); };
        REQUIRE(same(
            KeplerFlight({mirror(start.position), mirror(start.velocity)}, 1.0).after(t),
            {mirror(end.position), mirror(end.velocity)}));
        REQUIRE(
            same(KeplerFlight({perp(start.position), perp(start.velocity)}, 1.0).after(t),
                 {perp(end.position), perp(end.velocity)}));
    }
}

TEST_CASE("The strangest flights still come back with numbers")
{
    // Straight through the centre, at rest, at the escape speed, hardly bound, as good as
    // free, for ages
    const Vec2 x(1.0, 0.0);
    for (const Vec2& v :
         {Vec2(-1.0, 0.0), Vec2(0.0, 0.0), Vec2(1.0, 0.0), Vec2(std::sqrt(2.0), 0.0),
          Vec2(0.0, 1e-160), Vec2(-std::sqrt(2.0), 0.0), Vec2(0.0, std::sqrt(2.0)),
          Vec2(-1e10, 1e-3), Vec2(0.0, 1e60)}) {
        for (const double mu : {1.0, 1e-60, 1e60}) {
            for (const double t : {0.0, 1e-300, 1e-9, 1.0, 1e5, 1e20, -1.0, -1e20}) {
                const PointMotion end = KeplerFlight({x, v}, mu).after(t);
                INFO(v.x(), " ", v.y(), " mu ", mu, " t ", t);
                CHECK(is_finite(end.position));
                CHECK(is_finite(end.velocity));
            }
        }
    }
}

TEST_CASE("A body in any field flies by that field's closed form, and keeps its spin")
{
    const BodyState body{Vec2(3.0, 1.0), Vec2(0.5, 2.0), 0.3, 2.0, 1.0};
    const CentralField central{Vec2(1.0, 1.0), 8.0, 0.0};
    const BodyState after = flight(body, Field(central), 2.5);
    const PointMotion expected = Oracle({Vec2(2.0, 0.0), Vec2(0.5, 2.0)}, 8.0).after(1.5);
    CHECK((after.position - Vec2(1.0, 1.0) - expected.position).norm() < 1e-15 * 8.0);
    CHECK((after.velocity - expected.velocity).norm() < 1e-15 * 8.0);
    CHECK(after.angle == body.angle + 1.5 * 2.0);
    CHECK(after.spin == 2.0);
    CHECK(after.time == 2.5);

    const UniformField uniform{Vec2(0.0, -9.81)};
    CHECK(flight(body, Field(uniform), 2.5).position ==
          flight(body, uniform.gravity, 2.5).position);
    CHECK(flight(body, Field(NoField{}), 2.5).position ==
          body.position + 1.5 * body.velocity);
}
