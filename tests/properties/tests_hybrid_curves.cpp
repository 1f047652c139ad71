// Closed forms of bodies that turn about a corner or go round another, asked of the whole simulator: how good they are, and
// of which order in the step.

#include <doctest/doctest.h>

#include <cmath>
#include <vector>

#include "support/worlds.hpp"

using namespace flying;
using namespace flying::testing;

namespace {

constexpr double k_g = 9.81; // [m/s^2]

/// [steps^2 per second; steps^2 per second^2] What three impacts may be late by, and what an impact's share may be off by.
constexpr double k_late = 5.0; // measured: up to 3.5; 0.22 for the first impact of the slim block
constexpr double k_kept = 5.0; // measured: up to 3.9 where a step begins a rounding away from touching, else below 1e-3

/// A wide floor under gravity; nothing rebounds.
Scene on_floor(double friction)
{
    Scene scene;
    scene.world.field = UniformField{{0.0, -k_g}};
    scene.world.restitution = 0.0;
    scene.world.friction = friction;
    scene.world.box = BoxDef{{-1000.0, 0.0}, {1000.0, 1000.0}};
    return scene;
}

/// Errors at steps of which each is half of the one before: each is so many times as large as the next.
void check_order(const std::vector<double>& errors, double factor)
{
    for (std::size_t k = 1; k < errors.size(); ++k) {
        CHECK(std::abs(errors[k - 1] / errors[k] / factor - 1.0) <= 0.05);
    }
}

/// A block that rocks on its corners without sliding (Housner, 1963), by its exact equation: theta'' = -p^2 sin(alpha -
/// theta) from one corner to the other.
struct Rocking
{
    double width = 0.0;  // [m]
    double height = 0.0; // [m]

    double alpha() const { return std::atan(width / height); }
    double p() const { return std::sqrt(1.5 * k_g / std::hypot(width, height)); } // [1/s]
    double kept() const { return 1.0 - 1.5 * std::sin(alpha()) * std::sin(alpha()); }

    /// Turning energy by half the moment about a corner, that in the field counted from upright.  [1/s^2]
    double energy(const BodyState& s) const
    {
        return s.spin * s.spin + 2.0 * p() * p() * (std::cos(alpha() - std::abs(s.angle)) - std::cos(alpha()));
    }

    /// Time from rest at a tilt to upright: Simpson's rule over x, where theta = tilt (1 - x^2).  [s]
    double quarter(double tilt) const
    {
        constexpr int k_parts = 2000;
        double sum = 0.0;
        for (int k = 0; k <= k_parts; ++k) {
            const double x = static_cast<double>(k) / k_parts;
            const double rise = 0.5 * tilt * x * x;
            const double share = k == 0 ? std::sqrt(2.0 / tilt) : x / std::sqrt(std::sin(rise));
            const double weight = k == 0 || k == k_parts ? 1.0 : (k % 2 == 1 ? 4.0 : 2.0);
            sum += weight * tilt * share / (p() * std::sqrt(std::sin(alpha() - tilt + rise)));
        }
        return sum / (3.0 * k_parts);
    }

    /// How far it tilts after an impact, if it was tilted so far before.
    double next(double tilt) const
    {
        const double fall = std::cos(alpha() - tilt) - std::cos(alpha());
        return alpha() - std::acos(std::cos(alpha()) + kept() * kept() * fall);
    }

    BodyDef body(double tilt) const
    {
        const double c = std::cos(tilt);
        const double s = std::sin(tilt);
        BodyDef body = rectangle(width, height, 0.5 * Vec2(width * c - height * s, width * s + height * c));
        body.angle = tilt;
        return body;
    }

    /// Time from a state until it stands upright, to the fourth power of that time.  [s]
    double until_upright(const BodyState& state) const
    {
        const double side = state.angle > 0.0 ? 1.0 : -1.0;
        const double theta = side * state.angle;
        const double omega = side * state.spin;
        const double fall = -p() * p() * std::sin(alpha() - theta);
        const double jerk = p() * p() * std::cos(alpha() - theta) * omega;
        double t = 0.0;
        for (int k = 0; k < 50; ++k) {
            const double angle = theta + t * (omega + t * (fall / 2.0 + t * jerk / 6.0));
            t -= angle / (omega + t * (fall + t * jerk / 2.0));
        }
        return t;
    }
};

} // namespace

TEST_CASE("a block rocks: each impact keeps 1 - 1.5 sin^2 a, and comes at its time to second order in the step")
{
    const double tilt = 0.1;
    for (const Rocking& block : {Rocking{0.5, 1.5}, Rocking{0.4, 1.0}}) {
        for (const double friction : {0.5, 3.0}) {
            std::vector<double> late;
            for (const double per_second : {60.0, 120.0, 240.0, 480.0}) {
                Scene scene = on_floor(friction);
                scene.bodies = {block.body(tilt)};
                World world = with_step(scene, 1.0 / per_second);
                INFO("width " << block.width << ", friction " << friction << ", per second " << per_second);
                double top = tilt;
                double expected = block.quarter(tilt);
                BodyState before = world.state(0);
                int impacts = 0;
                for (int k = 1; impacts < 3 && k < 5.0 * per_second; ++k) {
                    run(world, k / per_second);
                    const BodyState now = world.state(0);
                    if (now.angle * before.angle < 0.0) {
                        ++impacts;
                        const double time = (k - 1) / per_second + block.until_upright(before);
                        if (impacts == 1) late.push_back(time - expected);
                        CHECK(std::abs(time - expected) <= k_late / (per_second * per_second));
                        const double kept = std::sqrt(block.energy(now) / block.energy(before));
                        CHECK(std::abs(kept / block.kept() - 1.0) <= k_kept / (per_second * per_second));
                        top = block.next(top);
                        expected += 2.0 * block.quarter(top);
                    }
                    before = now;
                }
                CHECK(impacts == 3);
            }
            check_order(late, 4.0);
        }
    }
}

TEST_CASE("the time of a slender block that rocks is Housner's acosh(1/(1 - theta/alpha))/p")
{
    for (const double alpha : {0.01, 0.02}) {
        const Rocking block{2.0 * std::tan(alpha), 2.0};
        for (const double part : {0.2, 0.5, 0.8}) {
            const double paper = std::acosh(1.0 / (1.0 - part)) / block.p();
            CHECK(std::abs(block.quarter(part * alpha) / paper - 1.0) <= alpha * alpha);
        }
    }
    const Rocking block{0.04, 2.0};
    const double part = 0.5;
    Scene scene = on_floor(1.0);
    scene.bodies = {block.body(part * block.alpha())};
    World world = with_step(scene, 1.0 / 240.0);
    const double paper = std::acosh(1.0 / (1.0 - part)) / block.p();
    const double last = std::floor(paper * 240.0) / 240.0;
    run(world, last);
    CHECK(std::abs((last + block.until_upright(world.state(0))) / paper - 1.0) <= block.alpha() * block.alpha());
}

TEST_CASE("a disc leaves a smooth cylinder at two thirds of the cosine, with the energy that it began with")
{
    // Let go at rest; what is left of the speed sideways when it flies tells where it left
    const double rho = 3.5;
    const double start = 0.1;
    Scene scene = on_floor(0.0);
    scene.world.box.reset();
    scene.bodies = {still(disc(3.0, {0.0, 0.0})), disc(0.5, {rho * std::sin(start), rho * std::cos(start)})};
    std::vector<double> lost;
    for (const double per_second : {60.0, 120.0, 240.0, 960.0}) {
        World world = with_step(scene, 1.0 / per_second);
        run(world, 4.0);
        CHECK(world.mover(1) == World::Mover::events);
        const Vec2 v = world.state(1).velocity;
        const double cosine = std::cbrt(v.x() * v.x() / (k_g * rho)) / std::cos(start);
        INFO("per second " << per_second << ": " << cosine);
        CHECK(std::abs(cosine - 2.0 / 3.0) <= (per_second < 960.0 ? 2e-5 : 1e-7)); // measured: 1.5e-5 to 5e-8
        const double fallen = rho * std::cos(start) - world.state(1).position.y();
        const double part = (0.5 * v.squaredNorm() - k_g * fallen) / (k_g * rho);
        CHECK(std::abs(part) <= 2e-3 / (per_second * per_second)); // 3e-7 at 60
        if (per_second < 960.0) lost.push_back(part);
    }
    check_order(lost, 8.0);
}

TEST_CASE("a ladder between smooth wall and floor leaves the wall at two thirds of its height, to 2e-6, and half the step loses an eighth of the energy")
{
    // From there on nothing pushes it sideways; a millionth of its length is its width, and of what is left half
    const double length = 4.0;
    const double width = 1e-6;
    const double start = 1.2;
    Scene scene = on_floor(0.0);
    scene.world.box = BoxDef{{0.0, 0.0}, {100.0, 100.0}};
    scene.bodies = {rectangle(length, width,
                              {0.5 * length * std::cos(start) + 0.5 * width * std::sin(start),
                               0.5 * length * std::sin(start) + 0.5 * width * std::cos(start)})};
    scene.bodies[0].angle = -start;
    std::vector<double> lost;
    const double expected = std::pow(std::sin(start), 1.5) * std::sqrt(k_g * length) / 3.0;
    for (const double per_second : {60.0, 120.0, 240.0, 960.0}) {
        World world = with_step(scene, 1.0 / per_second);
        run(world, 0.9); // not yet down
        CHECK(world.state(0).position.y() < 2.0 / 3.0 * scene.bodies[0].position.y());
        CHECK(world.state(0).position.y() > 0.3 * scene.bodies[0].position.y());
        INFO("per second " << per_second);
        CHECK(std::abs(world.state(0).velocity.x() / expected - 1.0) <= 2e-6); // measured: 9e-7 to 3e-7
        const BodyState& now = world.state(0);
        const double turning = 0.5 * (length * length + width * width) / 12.0 * now.spin * now.spin;
        if (per_second < 960.0)
            lost.push_back(0.5 * now.velocity.squaredNorm() + turning + k_g * (now.position.y() - scene.bodies[0].position.y()));
    }
    check_order(lost, 8.0);
}

TEST_CASE("a plank a millionth beyond its limit tips as its equation says, to second order in the step")
{
    // About the ledge's corner: (I + m (d^2 + h^2)) theta'' = m g (d cos theta + h sin theta), by Runge and Kutta
    const double beyond = 1e-6;
    const double half = 0.125;
    const double moment = (4.0 + 4.0 * half * half) / 12.0 + half * half + beyond * beyond;
    const auto tips = [&](double angle) {
        return k_g * (beyond * std::cos(angle) + half * std::sin(angle)) / moment;
    };
    double angle = 0.0;
    double spin = 0.0;
    constexpr int k_parts = 40000;
    const double h = 4.0 / k_parts;
    for (int k = 0; k < k_parts; ++k) {
        const double a1 = tips(angle);
        const double a2 = tips(angle + 0.5 * h * spin);
        const double a3 = tips(angle + 0.5 * h * (spin + 0.5 * h * a1));
        const double a4 = tips(angle + h * (spin + 0.5 * h * a2));
        angle += h * (spin + h * (a1 + a2 + a3) / 6.0);
        spin += h * (a1 + 2.0 * a2 + 2.0 * a3 + a4) / 6.0;
    }
    std::vector<double> ahead;
    for (const double per_second : {60.0, 120.0, 240.0, 480.0}) {
        Scene scene = on_floor(1.0);
        scene.world.box->min.y() = -50.0;
        scene.bodies = {still(rectangle(4.0, 1.0, {-2.0, -0.5})), rectangle(2.0, 2.0 * half, {beyond, half})};
        World world = with_step(scene, 1.0 / per_second);
        run(world, 4.0);
        INFO("per second " << per_second);
        // measured: 2.1 steps squared, which is 6e-4 at 60 a second
        ahead.push_back(-world.state(1).angle / angle - 1.0);
        CHECK(std::abs(ahead.back()) <= 2.5 / (per_second * per_second));
    }
    check_order(ahead, 4.0);
}
