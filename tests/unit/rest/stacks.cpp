#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "chapters/support/lying_bodies.hpp"
#include "math/random.hpp"

using namespace flying;
using namespace flying::test;

namespace {

/// Greatest relative error of the forces between the boxes of a stack: each bears what is above it.
double worst_force(const RestEngine& engine)
{
    std::map<int, double> force;
    for (const RestContact& contact : engine.contacts()) force[contact.b] += contact.normal_force;
    double weight = 0.0;
    double worst = 0.0;
    for (int k = engine.body_count() - 1; k > 0; --k) {
        weight += k_gravity / engine.body(k).inertia.inv_mass;
        worst = std::max(worst, std::abs(force[k] / weight - 1.0));
    }
    return worst;
}

double worst_drift(const RestEngine& engine, const std::vector<RestBody>& start)
{
    double worst = 0.0;
    for (std::size_t k = 0; k < start.size(); ++k) {
        worst = std::max(worst, (engine.state(static_cast<int>(k)).position - start[k].state.position).norm());
    }
    return worst;
}

} // namespace

TEST_CASE("stacks of 10, 50 and 200 boxes stand for a minute, and bear the weights above them")
{
    for (const int count : {10, 50, 200}) {
        const std::vector<RestBody> bodies = stack(count);
        RestEngine engine(bodies);
        engine.advance(60.0);
        CAPTURE(count);
        CHECK(worst_drift(engine, bodies) < 1e-9);
        CHECK(worst_force(engine) < 1e-6);
        CHECK(engine.is_asleep(count));
        CHECK(engine.max_overlap() < 1e-9);
    }
}

TEST_CASE("a stack of 1000 boxes stands for a minute without drift")
{
    const std::vector<RestBody> bodies = stack(1000);
    RestEngine engine(bodies);
    engine.advance(60.0);
    CHECK(worst_drift(engine, bodies) < 1e-9);
    CHECK(worst_force(engine) < 1e-6);
    CHECK(engine.is_asleep(1000));
}

TEST_CASE("a heavy box stands on a light one, up to 1e9 times its mass")
{
    // At 1e9 the forces keep only four digits: the light box's share of them is the rounding of the heavy one's
    for (const double ratio : {1e2, 1e3, 1e4, 1e6, 1e9}) {
        std::vector<RestBody> bodies = stack(2);
        bodies[2].inertia.inv_mass /= ratio;
        bodies[2].inertia.inv_moment_of_inertia /= ratio;
        RestEngine engine(bodies);
        engine.advance(20.0);
        CAPTURE(ratio);
        CHECK(worst_drift(engine, bodies) < 1e-9);
        CHECK(worst_force(engine) < std::max(1e-6, 1e-12 * ratio));
        CHECK(engine.max_overlap() < 1e-9);
    }
}

TEST_CASE("a pyramid of base 20 stands")
{
    const Material material{0.0, 0.5};
    std::vector<RestBody> bodies = {wall(Vec2(0.0, 1.0), 0.0, material)};
    for (int row = 0; row < 20; ++row) {
        for (int k = 0; k < 20 - row; ++k) {
            bodies.push_back(box(1.0, 1.0, Vec2(1.125 * (k + 0.5 * row), 0.5 + row), 1.0, material));
        }
    }
    RestEngine engine(bodies);
    engine.advance(10.0);
    CHECK(worst_drift(engine, bodies) < 1e-9);
    CHECK(engine.is_asleep(1));
}

TEST_CASE("planks overhang by half the harmonic series, and no further")
{
    for (const double part : {1.0 - 1e-6, 1.0 + 1e-6}) {
        // A ledge, and planks of length 2 on it: from above, the k-th reaches 1/k beyond the one below
        const int count = 5;
        const Material material{0.0, 1.0};
        RestBody ledge{rectangle(4.0, 1.0), {}, {}, material};
        ledge.state.position = Vec2(-2.0, -0.5);
        ledge.is_static = true;
        std::vector<RestBody> bodies = {ledge};
        double end = 0.0;
        for (int k = count; k > 0; --k) {
            end += part / k;
            bodies.push_back(box(2.0, 0.25, Vec2(end - 1.0, 0.125 + 0.25 * (count - k)), 1.0, material));
        }
        RestEngine engine(bodies);
        engine.advance(10.0);
        CAPTURE(part);
        if (part < 1.0) CHECK(worst_drift(engine, bodies) == 0.0);
        else CHECK(worst_drift(engine, bodies) > 1e-6);
    }
}

namespace {

/// A stack that falls asleep, and a disc that is thrown at it.
[[nodiscard]] std::vector<RestBody> stack_and_disc()
{
    std::vector<RestBody> bodies = stack(8, {0.3, 0.5});
    bodies.push_back(disc(0.5, Vec2(-8.0, 7.2), 1.0, {0.3, 0.5}));
    bodies.back().state.velocity = Vec2(8.0, 6.0);
    return bodies;
}

} // namespace

TEST_CASE("sleep changes no bit, and a sleeper wakes in the step in which it is touched")
{
    const std::vector<RestBody> bodies = stack_and_disc();
    RestOptions awake;
    awake.sleeps = false;
    RestEngine one(bodies);
    RestEngine other(bodies, awake);
    bool slept = false;
    bool woke = false;
    for (int k = 0; k < 60 * 40; ++k) {
        one.step();
        other.step();
        REQUIRE(one.hash() == other.hash());
        woke = woke || (slept && !one.is_asleep(8));
        slept = slept || one.is_asleep(8);
    }
    CHECK(slept);
    CHECK(woke);
    CHECK(one.counts().asleep > 1000);
    CHECK(other.counts().asleep == 0);
}

TEST_CASE("sleep changes no bit where steps are halved now and then")
{
    const std::vector<RestBody> bodies = stack_and_disc();
    RestOptions awake;
    awake.sleeps = false;
    const double whole = awake.step;
    RestEngine one(bodies);
    RestEngine other(bodies, awake);
    Random random(1801);
    bool slept = false;
    for (int k = 0; k < 60 * 20; ++k) {
        const int parts = 1 << (k / 60 % 2 == 0 ? 1 : random.below(3));
        for (int part = 1; part <= parts; ++part) {
            one.step_by(whole / parts, (k + static_cast<double>(part) / parts) * whole);
            other.step_by(whole / parts, (k + static_cast<double>(part) / parts) * whole);
            REQUIRE(one.hash() == other.hash());
        }
        slept = slept || one.is_asleep(8);
    }
    CHECK(slept);
}

TEST_CASE("lengths, times and masses by powers of two give the same bits")
{
    const auto run = [](double length, double time, double mass) {
        std::vector<RestBody> bodies = stack(4, {0.25, 0.5});
        bodies.push_back(disc(0.5, Vec2(-3.0, 4.0), 1.5, {0.25, 0.5}));
        bodies.back().state.velocity = Vec2(5.0, 1.0);
        bodies[4].state.angle = 0.125;
        bodies[4].state.position.y() += 0.5;
        for (RestBody& body : bodies) {
            BodyState& s = body.state;
            if (auto* polygon = std::get_if<Polygon>(&body.shape)) {
                (void)polygon;
                body.shape = rectangle(length, length);
            } else if (auto* round = std::get_if<Disc>(&body.shape)) round->radius *= length;
            s.position *= length;
            s.velocity *= length / time;
            body.acceleration *= length / (time * time);
            body.inertia.inv_mass /= mass;
            body.inertia.inv_moment_of_inertia /= mass * length * length;
        }
        RestOptions options;
        options.step = time / 64.0;
        RestEngine engine(bodies, options);
        for (int k = 0; k < 300; ++k) engine.step();
        std::vector<double> result;
        for (int k = 0; k < engine.body_count(); ++k) {
            const RestBody& body = engine.body(k);
            for (const double x : {body.state.position.x() / length, body.state.position.y() / length, body.state.angle,
                                   body.state.velocity.x() * time / length, body.state.spin * time}) {
                result.push_back(x);
            }
        }
        return result;
    };
    const std::vector<double> plain = run(1.0, 1.0, 1.0);
    CHECK(run(0x1p40, 1.0, 1.0) == plain);
    CHECK(run(1.0, 0x1p-30, 1.0) == plain);
    CHECK(run(1.0, 1.0, 0x1p50) == plain);
    CHECK(run(0x1p-20, 0x1p10, 0x1p-60) == plain);
}

TEST_CASE("bodies come and go: what stood on one that leaves falls")
{
    std::vector<RestBody> bodies = stack(3);
    RestEngine engine(bodies);
    engine.advance(1.0);
    CHECK(engine.is_asleep(3));
    CHECK(engine.islands() == std::vector<int>{-1, 1, 1, 1});
    engine.set_active(1, false);
    engine.step();
    CHECK(engine.state(2).velocity.y() < 0.0);
    CHECK(engine.state(1).position == bodies[1].state.position);
    engine.advance(3.0);
    CHECK(std::abs(engine.state(2).position.y() - 0.5) < 1e-9);
    CHECK(engine.islands() == std::vector<int>{-1, -1, 2, 2});
}

TEST_CASE("energy never rises as boxes fall on each other and come to rest")
{
    for (const double e : {0.0, 0.5, 1.0}) {
        const Material material{e, 0.4};
        std::vector<RestBody> bodies = {wall(Vec2(0.0, 1.0), 0.0, material)};
        for (int k = 0; k < 6; ++k) {
            bodies.push_back(box(1.0, 1.0, Vec2(0.15 * (k % 3), 1.0 + 1.5 * k), 1.0, material));
            bodies.back().state.angle = 0.3 * k;
        }
        RestEngine engine(bodies);
        const double start = energy(engine);
        double most = start;
        for (int k = 0; k < 60 * 10; ++k) {
            engine.step();
            most = std::max(most, energy(engine));
        }
        CAPTURE(e);
        CHECK(most <= start * (1.0 + 1e-9));
    }
}

TEST_CASE("a box that is put down askew comes to lie, whatever its sides, its tilt and its motion")
{
    // Some rocked on from step to step for ever: an impact that took the push of the other corner for a load threw the
    // box up, and what that cost was paid by stopping it in the air
    Random random(1);
    for (int k = 0; k < 1500; ++k) {
        const double width = random.uniform(0.4, 0.9);
        const double height = random.uniform(0.4, 0.9);
        const double tilt = (k % 2 == 0 ? 1.0 : -1.0) * std::pow(10.0, random.uniform(-7.0, -1.0));
        const double low = 0.5 * (height * std::cos(tilt) + width * std::sin(std::abs(tilt)));
        const Material material{0.0, random.uniform(0.2, 1.2)};
        RestBody body = box(width, height, Vec2(0.0, low + std::pow(10.0, random.uniform(-9.0, -5.0))), 1.0, material);
        body.state.angle = tilt;
        if (k % 3 != 0) {
            const double speed = std::pow(10.0, random.uniform(-3.0, -1.0));
            body.state.velocity = speed * Vec2(random.uniform(-1.0, 1.0), random.uniform(-1.0, 0.0));
            body.state.spin = speed * random.uniform(-1.0, 1.0);
        }
        RestEngine engine({wall(Vec2(0.0, 1.0), 0.0, material), body});
        while (!engine.is_asleep(1) && engine.time() < 5.0) engine.step();
        CAPTURE(k);
        CHECK(engine.is_asleep(1));
        CHECK(std::abs(engine.state(1).position.y() - 0.5 * height) < 1e-9);
        CHECK(std::abs(engine.state(1).angle) < 1e-9);
    }
}

TEST_CASE("a disc that rolls with less than a hair of energy stops, and with more rolls on as fast")
{
    Random random(32);
    for (int k = 0; k < 50; ++k) {
        const double radius = std::pow(10.0, random.uniform(-1.5, 1.0));
        // The energy 3/4 m v^2 against the lift by its own size, m g r
        const double edge = std::sqrt(0x1p-46 * k_gravity * radius / 0.75);
        for (const double share : {0.5, 2.0}) {
            CAPTURE(k);
            CAPTURE(share);
            const Material material{0.0, 0.5};
            RestBody body = disc(radius, Vec2(0.0, radius), 1.0, material);
            body.state.velocity = Vec2(share * edge, 0.0);
            body.state.spin = -share * edge / radius;
            RestEngine engine({wall(Vec2(0.0, 1.0), 0.0, material), body});
            for (int step = 0; step < 60; ++step) engine.step();
            CHECK(engine.is_asleep(1) == (share < 1.0));
            if (share > 1.0) CHECK(engine.state(1).velocity.x() == doctest::Approx(share * edge).epsilon(1e-12));
        }
    }
}

TEST_CASE("a light ball that rolls slowly on a heavy slab rolls on")
{
    for (const double heavy : {1.0, 1e3, 1e6}) {
        CAPTURE(heavy);
        const Material material{0.0, 0.5};
        const RestBody slab = box(4.0, 1.0, Vec2(0.0, 0.5), heavy, material);
        RestBody ball = disc(0.5, Vec2(0.0, 1.5), 1.0, material);
        const double speed = 1e-4;
        ball.state.velocity = Vec2(speed, 0.0);
        ball.state.spin = -speed / 0.5;
        RestEngine engine({wall(Vec2(0.0, 1.0), 0.0, material), slab, ball});
        for (int step = 0; step < 60; ++step) engine.step();
        CHECK(engine.state(2).velocity.x() == doctest::Approx(speed).epsilon(1e-9));
    }
}
