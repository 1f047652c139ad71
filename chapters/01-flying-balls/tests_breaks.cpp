#include <algorithm>
#include <cmath>

#include "central.hpp"
#include "many.hpp"
#include "motion/flight.hpp"
#include "orbits.hpp"
#include "support/receipts.hpp"
#include "wrong_degrees.hpp"

using namespace flying;
using namespace flying::steps;

// [breaks.spiral]
TEST_CASE("a planet stays on its orbit: the closed form does, explicit Euler spirals out")
{
    const Orbit o{1.0, 1.0, 0.5};
    const auto axis = [&](const Moving& b) { return -o.mu / (2.0 * energy(b, o.mu)); };
    const double h = o.period() / 1000.0;
    const double by_form = axis(on_ellipse(o, 10.0 * o.period()));
    const Moving end = run(k_euler, on_ellipse(o, 0.0), CentralPull{o.mu}, h, 10000);
    const double by_euler = axis(end);
    CHECK(std::abs(by_form - 1.0) < 1e-14);
    CHECK_FALSE(std::abs(by_euler - 1.0) < 0.5);
    RECORD_VALUE("breaks.spiral.axis", by_euler);
}
// [breaks.spiral]

TEST_CASE("explicit Euler gains energy over a period, but not in every step")
{
    const auto losing = [](double eccentricity) { // share of the steps of a period
        const Orbit o{1.0, 1.0, eccentricity};
        constexpr int k_steps = 100000;
        const double h = o.period() / k_steps;
        Moving b = on_ellipse(o, 0.0);
        const double before = energy(b, o.mu);
        int count = 0;
        for (int k = 0; k < k_steps; ++k) {
            const double w = energy(b, o.mu);
            b = euler(b, CentralPull{o.mu}, h);
            count += energy(b, o.mu) < w ? 1 : 0;
        }
        CHECK(energy(b, o.mu) > before);
        return count / static_cast<double>(k_steps);
    };

    // Falling in at the speed v_r, a step loses where v_r^2 exceeds half of mu/r + v_t^2:
    // long orbits have such places
    CHECK(losing(0.5) == 0.0);
    const double share = losing(0.9);
    CHECK(share > 0.2);
    CHECK(share < 0.35);
    RECORD_VALUE("steps.gain.losing", 100.0 * share);
}

TEST_CASE(
    "symplectic Euler lets the size of an orbit swing within a percent, and brings it back")
{
    const Orbit o{1.0, 1.0, 0.5};
    const double h = o.period() / 1000.0;
    const auto axis = [&](const Moving& b) { return -o.mu / (2.0 * energy(b, o.mu)); };
    Moving b = on_ellipse(o, 0.0);
    double least = 1.0;
    double most = 1.0;
    for (int period = 0; period < 1000; ++period) {
        b = run(k_symplectic, b, CentralPull{o.mu}, h, 1000);
        least = std::min(least, axis(b));
        most = std::max(most, axis(b));
    }
    CHECK(least > 0.99);
    CHECK(most < 1.01);
    RECORD_VALUE("steps.swing.late", axis(b));
}

// [breaks.degrees]
TEST_CASE("a corner is as fast as its spin says: not where polygons turn in degrees")
{
    BodyState body;
    body.angle = 0.5;
    body.spin = 2.0;
    const Vec2 r(0.3, 0.4);
    const double dt = 0x1p-20;
    const BodyState later = flight(body, Vec2::Zero(), dt);
    const auto speed = [&](wrong::Kind kind) { // how far the corner comes in a moment
        return (point_of(kind, later, r) - point_of(kind, body, r)).norm() / dt;
    };
    const double by_spin = velocity_at(body, pose_of(body).rotation * r).norm();
    const double polygon = speed(wrong::Kind::polygon);

    // A chord is shorter than its arc by (spin dt)^2 / 24; the rest is rounding over dt
    CHECK(speed(wrong::Kind::ball) == doctest::Approx(by_spin).epsilon(1e-9));
    CHECK_FALSE(std::abs(polygon - by_spin) < 0.5 * by_spin);
    RECORD_VALUE("breaks.degrees.ratio", by_spin / polygon);
}
// [breaks.degrees]

namespace {

/// Two equal bodies that circle each other, and a light third one further out.
std::vector<Puller> three_bodies()
{
    return {{{Vec2(-0.5, 0.0), Vec2(0.0, -0.6)}, 1.0},
            {{Vec2(0.5, 0.0), Vec2(0.0, 0.8)}, 1.0},
            {{Vec2(0.0, 3.0), Vec2(-0.8, 0.0)}, 0.1}};
}

/// Where the first of the three is after a while, if the list is written from its front or
/// from its back.
template <typename Step>
Vec2 first_after(const Step& step, bool from_back)
{
    std::vector<Puller> bodies = three_bodies();
    if (from_back) std::reverse(bodies.begin(), bodies.end());
    for (int k = 0; k < 500; ++k) step(bodies, 0.01);
    return (from_back ? bodies.back() : bodies.front()).motion.x;
}

Vec2 momentum(const std::vector<Puller>& bodies)
{
    Vec2 sum = Vec2::Zero();
    for (const Puller& b : bodies) sum += b.mu * b.motion.v;
    return sum;
}

} // namespace

// [breaks.order]
TEST_CASE("bodies listed in another order fly alike: not where each moves as it is asked")
{
    const auto apart = [](const auto& step) {
        return (first_after(step, false) - first_after(step, true)).norm();
    };
    const double together = apart(step_together);
    const double in_place = apart(step_in_place);
    CHECK(together == 0.0); // a sum of two terms is the same in either order, to the bit
    CHECK_FALSE(in_place < 1e-3);
    RECORD_VALUE("breaks.order.in-place", in_place);
}
// [breaks.order]

// [breaks.momentum]
TEST_CASE(
    "bodies among themselves keep their momentum: not where each moves as it is asked")
{
    const auto drift = [](const auto& step) {
        std::vector<Puller> bodies = three_bodies();
        const Vec2 before = momentum(bodies);
        double worst = 0.0;
        for (int k = 0; k < 500; ++k) {
            step(bodies, 0.01);
            worst = std::max(worst, (momentum(bodies) - before).norm());
        }
        return worst;
    };
    CHECK(drift(step_together) < 1e-12);
    CHECK_FALSE(drift(step_in_place) < 1e-3);
}
// [breaks.momentum]
