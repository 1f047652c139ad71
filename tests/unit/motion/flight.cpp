#include "motion/flight.hpp"

#include <cmath>

#include <boost/multiprecision/cpp_int.hpp>
#include <doctest/doctest.h>

#include "math/random.hpp"
#include "motion/field.hpp"

using namespace flying;
using Rational = boost::multiprecision::cpp_rational;

namespace {

BodyState random_body(Random& random, double size)
{
    BodyState body;
    body.position = Vec2{random.uniform(-size, size), random.uniform(-size, size)};
    body.velocity = Vec2{random.uniform(-size, size), random.uniform(-size, size)};
    body.angle = random.uniform(-3.0, 3.0);
    body.spin = random.uniform(-9.0, 9.0);
    body.time = random.uniform(-1.0, 1.0);
    return body;
}

} // namespace

TEST_CASE("a ball thrown up comes back down with the speed it left with")
{
    // v = 10 m/s, g = 8 m/s^2: at the top after 1.25 s at 6.25 m, back after 2.5 s; every
    // number is a double
    BodyState ball;
    ball.velocity = Vec2(3.0, 10.0);
    const Vec2 g(0.0, -8.0);
    const BodyState top = flight(ball, g, 1.25);
    CHECK(top.position == Vec2(3.75, 6.25));
    CHECK(top.velocity == Vec2(3.0, 0.0));
    const BodyState down = flight(ball, g, 2.5);
    CHECK(down.position == Vec2(7.5, 0.0));
    CHECK(down.velocity == Vec2(3.0, -10.0));
    CHECK(down.time == 2.5);
}

TEST_CASE("flight is the closed form to rounding, however far the step")
{
    // Exact rationals as oracle. Each coordinate passes six roundings; two ulp of the
    // largest term of the sum bound them
    Random random(21);
    for (int k = 0; k < 3000; ++k) {
        BodyState body = random_body(random, 100.0);
        body.time = 0.0; // so that the duration is exact
        const Vec2 g{random.uniform(-10.0, 10.0), random.uniform(-10.0, 10.0)};
        const double t = std::exp2(random.uniform(-40.0, 40.0));
        const BodyState after = flight(body, g, t);

        for (int axis = 0; axis < 2; ++axis) {
            const Rational duration(t);
            const Rational x = Rational(body.position[axis]) +
                               Rational(body.velocity[axis]) * duration +
                               Rational(g[axis]) * duration * duration / 2;
            const Rational v = Rational(body.velocity[axis]) + Rational(g[axis]) * duration;
            const double x_size = std::abs(body.position[axis]) +
                                  std::abs(body.velocity[axis] * t) +
                                  std::abs(0.5 * g[axis] * t * t);
            const double v_size = std::abs(body.velocity[axis]) + std::abs(g[axis] * t);
            REQUIRE(std::abs(static_cast<double>(x - Rational(after.position[axis]))) <=
                    2.0 * 0x1p-52 * x_size);
            REQUIRE(std::abs(static_cast<double>(v - Rational(after.velocity[axis]))) <=
                    0x1p-52 * v_size);
        }
        const Rational angle = Rational(body.angle) + Rational(body.spin) * Rational(t);
        const double angle_size = std::abs(body.angle) + std::abs(body.spin * t);
        REQUIRE(std::abs(static_cast<double>(angle - Rational(after.angle))) <=
                0x1p-52 * angle_size);
    }
}

TEST_CASE("a spin of 1 rad/s turns by a million radians in a million seconds, exactly")
{
    BodyState body;
    body.spin = 1.0;
    CHECK(flight(body, Vec2::Zero(), 1e6).angle == 1e6);
}

TEST_CASE("flying back in time returns to the start")
{
    // Both flights round: a few ulp of the farthest point reached
    Random random(22);
    for (int k = 0; k < 1000; ++k) {
        const BodyState body = random_body(random, 10.0);
        const Vec2 g{random.uniform(-10.0, 10.0), random.uniform(-10.0, 10.0)};
        const double time = random.uniform(-30.0, 30.0);
        const BodyState there = flight(body, g, time);
        const BodyState back = flight(there, g, body.time);
        const double duration = std::abs(time - body.time);
        const double size = 10.0 + duration * (10.0 + 10.0 * duration);
        REQUIRE((back.position - body.position).norm() <= 8.0 * 0x1p-52 * size);
        REQUIRE((back.velocity - body.velocity).norm() <=
                8.0 * 0x1p-52 * (10.0 + 10.0 * duration));
        REQUIRE(back.time == body.time);
    }
}

TEST_CASE("energy in a uniform field does not change in flight")
{
    Random random(23);
    for (int k = 0; k < 1000; ++k) {
        const BodyState body = random_body(random, 10.0);
        const Vec2 g(0.0, -9.81);
        const BodyState after = flight(body, g, body.time + random.uniform(0.0, 100.0));
        const double before = 0.5 * body.velocity.squaredNorm() - g.dot(body.position);
        const double now = 0.5 * after.velocity.squaredNorm() - g.dot(after.position);
        const double largest = 0.5 * after.velocity.squaredNorm() +
                               std::abs(g.dot(after.position)) + std::abs(before);
        REQUIRE(std::abs(now - before) <= 16.0 * 0x1p-52 * largest);
    }
}

TEST_CASE("flight scales with lengths and times by powers of two, to the bit")
{
    Random random(24);
    for (int k = 0; k < 1000; ++k) {
        const BodyState body = random_body(random, 10.0);
        const Vec2 g{random.uniform(-10.0, 10.0), random.uniform(-10.0, 10.0)};
        const double time = random.uniform(-30.0, 30.0);
        const double length = std::exp2(random.below(201) - 100);
        const double duration = std::exp2(random.below(201) - 100);

        BodyState scaled = body;
        scaled.position = length * body.position;
        scaled.velocity = (length / duration) * body.velocity;
        scaled.spin = body.spin / duration;
        scaled.time = duration * body.time;
        const Vec2 scaled_g = (length / duration / duration) * g;
        const BodyState plain_after = flight(body, g, time);
        const BodyState scaled_after = flight(scaled, scaled_g, duration * time);
        REQUIRE(scaled_after.position == Vec2(length * plain_after.position));
        REQUIRE(scaled_after.velocity == Vec2((length / duration) * plain_after.velocity));
        REQUIRE(scaled_after.angle == plain_after.angle);
    }
}

TEST_CASE("a field that is the same everywhere pulls the same, and no field not at all")
{
    CHECK(uniform_acceleration(NoField{}) == Vec2(0.0, 0.0));
    CHECK(uniform_acceleration(UniformField{Vec2(1.0, -9.81)}) == Vec2(1.0, -9.81));
}

TEST_CASE("a point of a turning body moves across its arm")
{
    BodyState body;
    body.velocity = Vec2(1.0, 2.0);
    body.spin = 3.0;
    CHECK(velocity_at(body, Vec2(0.5, 0.0)) == Vec2(1.0, 3.5));
    CHECK(velocity_at(body, Vec2(0.0, 0.5)) == Vec2(-0.5, 2.0));
}
