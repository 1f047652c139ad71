#include <doctest/doctest.h>

#include <cmath>

#include "chapters/support/lying_bodies.hpp"

using namespace flying;
using namespace flying::test;

namespace {

const double k_epsilon = 0x1p-52;
const double k_rocking_error = 1e-8;

} // namespace

TEST_CASE("free fall is the parabola at any step")
{
    for (const double step : {1.0 / 960.0, 1.0 / 60.0, 0.25}) {
        RestBody body = box(1.0, 1.0, Vec2(0.0, 100.0), 2.0, {0.0, 0.0});
        body.state.velocity = Vec2(3.0, 4.0);
        body.state.spin = 2.0;
        RestOptions options;
        options.step = step;
        RestEngine engine({body}, options);
        engine.advance(2.0);
        CHECK(engine.time() == doctest::Approx(2.0));
        // A rounding of coordinates near 100 m at each step
        const double bound = 2.0 / step * 128.0 * k_epsilon;
        CHECK(std::abs(engine.state(0).position.x() - 6.0) < bound);
        CHECK(std::abs(engine.state(0).position.y() - (108.0 - 2.0 * k_gravity)) < bound);
        CHECK(std::abs(engine.state(0).angle - 4.0) < bound);
    }
}

TEST_CASE("a block slides down a slope with g (sin t - mu cos t), at any step")
{
    const Slope slope{0.35};
    const double mu = 0.2;
    for (const double step : {1.0 / 60.0, 0.125}) {
        RestOptions options;
        options.step = step;
        RestEngine engine = on_slope(slope, box(1.0, 0.5, Vec2::Zero(), 3.0, {0.0, mu}), 0.25, options);
        engine.advance(2.0);
        const double way = 2.0 * k_gravity * (std::sin(slope.angle) - mu * std::cos(slope.angle));
        const Vec2 expected = 0.25 * slope.normal() - way * slope.up();
        CHECK((engine.state(1).position - expected).norm() < 1e-12);
        CHECK(std::abs(engine.state(1).angle - slope.angle) < 1e-12);
    }
}

TEST_CASE("a block on a slope sticks exactly where mu is at least the tangent, to 1e-10")
{
    const Slope slope{0.5};
    for (const double off : {1e-9, -1e-9, 1e-10, -1e-10}) {
        const Material material{0.0, (1.0 - off) * std::tan(slope.angle)};
        RestEngine engine = on_slope(slope, box(1.0, 1.0, Vec2::Zero(), 1.0, material), 0.5);
        const Vec2 start = engine.state(1).position;
        engine.advance(10.0);
        const double moved = (engine.state(1).position - start).dot(-slope.up());
        // a = g sin t times how far it is off, of which the angle's and the friction's rounding take up to 1e-5
        const double expected = 0.5 * k_gravity * std::sin(slope.angle) * off * 100.0;
        if (off > 0.0) CHECK(std::abs(moved - expected) < 1e-4 * expected);
        else CHECK(moved == 0.0);
    }
}

TEST_CASE("at mu = 1.001 tan a block doesn't creep by a bit in an hour")
{
    const Slope slope{0.5};
    RestOptions options;
    options.sleeps = false;
    RestEngine engine =
        on_slope(slope, box(1.0, 1.0, Vec2::Zero(), 1.0, {0.0, 1.001 * std::tan(slope.angle)}), 0.5, options);
    const Vec2 start = engine.state(1).position;
    engine.advance(3600.0);
    CHECK(engine.state(1).position == start);
    CHECK(engine.is_asleep(1));
}

TEST_CASE("a block on a rough slope tips where the tangent passes width over height, to 1e-9")
{
    const double width = 0.7;
    const double height = 1.0;
    for (const double part : {1.0 - 1e-9, 1.0 + 1e-9}) {
        const Slope slope{std::atan(part * width / height)};
        RestEngine engine = on_slope(slope, box(width, height, Vec2::Zero(), 1.0, {0.0, 5.0}), 0.5 * height);
        engine.advance(2.0);
        if (part < 1.0) CHECK(engine.state(1).angle == slope.angle);
        else CHECK(std::abs(engine.state(1).angle - slope.angle) > 1e-9);
    }
}

TEST_CASE("a disc and an annulus roll down a slope with g sin t / (1 + k^2 / R^2)")
{
    const Slope slope{0.3};
    for (const double shape : {0.5, 0.5 * (1.0 + 0.36)}) { // k^2/R^2 of a disc; of an annulus with 0.6 R inside
        RestBody body = faller(Disc{0.5}, Vec2::Zero(), 2.0, 2.0 * 0.25 * shape, {0.0, 1.0});
        RestEngine engine = on_slope(slope, body, 0.5);
        engine.advance(2.0);
        const double way = 2.0 * k_gravity * std::sin(slope.angle) / (1.0 + shape);
        CHECK((engine.state(1).position - (0.5 * slope.normal() - way * slope.up())).norm() < 1e-12);
        CHECK(std::abs(engine.state(1).angle - slope.angle - way / 0.5) < 1e-12);
    }
}

TEST_CASE("a thrown block stops after v^2 / (2 mu g)")
{
    const double mu = 0.3;
    RestBody body = box(1.0, 1.0, Vec2(0.0, 0.5), 1.0, {0.0, mu});
    body.state.velocity = Vec2(2.0, 0.0);
    RestEngine engine({wall(Vec2(0.0, 1.0), 0.0, {0.0, mu}), body});
    engine.advance(3.0);
    CHECK(engine.state(1).velocity == Vec2(0.0, 0.0));
    CHECK(std::abs(engine.state(1).position.x() - 4.0 / (2.0 * mu * k_gravity)) < 1e-9);
}

TEST_CASE("a thrown disc slides for v / (3 mu g), then rolls at two thirds of its speed")
{
    const double mu = 0.3;
    RestBody body = disc(0.5, Vec2(0.0, 0.5), 1.0, {0.0, mu});
    body.state.velocity = Vec2(2.0, 0.0);
    RestEngine engine({wall(Vec2(0.0, 1.0), 0.0, {0.0, mu}), body});
    engine.advance(3.0);
    const double t = 2.0 / (3.0 * mu * k_gravity);
    const double way = 2.0 * t - 0.5 * mu * k_gravity * t * t + 4.0 / 3.0 * (3.0 - t);
    CHECK(std::abs(engine.state(1).velocity.x() - 4.0 / 3.0) < 1e-9);
    CHECK(std::abs(engine.state(1).spin + 8.0 / 3.0) < 1e-9);
    CHECK(std::abs(engine.state(1).position.x() - way) < 1e-9);
}

TEST_CASE("a ball thrown back by e = 1 keeps its height over a hundred bounces")
{
    RestEngine engine({wall(Vec2(0.0, 1.0), 0.0, {1.0, 0.0}), disc(0.5, Vec2(0.0, 5.4), 1.0, {1.0, 0.0})});
    const double start = energy(engine);
    for (int k = 0; k < 60 * 200; ++k) {
        engine.step();
        REQUIRE(std::abs(energy(engine) / start - 1.0) < 1e-10);
    }
}

TEST_CASE("a rocking block keeps 1 - 1.5 sin^2 a of its spin at each stroke")
{
    // Released at a small angle on one corner; the first stroke is read where the spin's size falls by a jump
    const double width = 0.5;
    const double height = 1.5;
    const double a = std::atan(width / height);
    RestBody body = box(width, height, Vec2::Zero(), 1.0, {0.0, 3.0});
    const double tilt = 0.02;
    const Rotation turn = Rotation::of(tilt);
    body.state.angle = tilt;
    body.state.position = turn * Vec2(0.5 * width, 0.5 * height) - Vec2(0.5 * width, 0.0);
    body.state.position.y() = std::abs((turn * Vec2(-0.5 * width, -0.5 * height)).y());
    const double expected = 1.0 - 1.5 * std::sin(a) * std::sin(a);
    for (const double step : {1.0 / 240.0, 1.0 / 1920.0}) {
        RestOptions options;
        options.step = step;
        RestEngine engine({wall(Vec2(0.0, 1.0), 0.0, {0.0, 3.0}), body}, options);
        // At the stroke, upright, all energy above that of standing is turning
        const double standing = 0.5 * k_gravity * height;
        double before = 0.0;
        while (engine.state(1).angle > 0.0) {
            before = energy(engine) - standing;
            engine.step();
        }
        const double ratio = std::sqrt((energy(engine) - standing) / before);
        CAPTURE(step);
        CHECK(std::abs(ratio / expected - 1.0) < k_rocking_error);
    }
}
