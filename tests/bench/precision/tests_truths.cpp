// The closed forms of the diagrams, at inputs whose answers are known exactly.

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "trial.hpp"
#include "truths.hpp"

using namespace flying::bench;
using flying::Vec2;

TEST_CASE("a ball let go at 4.9 m in a field of 9.8 m/s^2 is on the floor after one second, and up again after three")
{
    CHECK(bounce_height(4.9, 9.8, 1.0, 0.5) == doctest::Approx(3.675).epsilon(1e-15));
    CHECK(std::abs(bounce_height(4.9, 9.8, 1.0, 1.0)) < 1e-15);
    CHECK(bounce_height(4.9, 9.8, 1.0, 2.0) == doctest::Approx(4.9).epsilon(1e-15));
    CHECK(bounce_height(4.9, 9.8, 1.0, 4.0) == doctest::Approx(4.9).epsilon(1e-14));
    CHECK(end_of_bounces(4.9, 9.8, 0.5) == doctest::Approx(3.0).epsilon(1e-15));

    // At e = 1/2: apexes of a quarter and a sixteenth, half-way through hops of 1 s and 1/2 s
    CHECK(bounce_height(4.9, 9.8, 0.5, 1.5) == doctest::Approx(4.9 / 4.0).epsilon(1e-14));
    CHECK(bounce_height(4.9, 9.8, 0.5, 2.25) == doctest::Approx(4.9 / 16.0).epsilon(1e-14));
    CHECK(bounce_height(4.9, 9.8, 0.5, 3.0) == 0.0);
    CHECK(bounce_height(4.9, 9.8, 0.5, 7.0) == 0.0);
}

TEST_CASE("a point between two walls turns round at each")
{
    CHECK(folded(1.0, 2.0, 0.5, 0.0, 4.0) == 2.0);
    CHECK(folded(1.0, 2.0, 2.0, 0.0, 4.0) == 3.0);  // 5 is 1 beyond
    CHECK(folded(1.0, -2.0, 1.0, 0.0, 4.0) == 1.0); // -1 mirrored
    CHECK(folded(1.0, 2.0, 4.0, 0.0, 4.0) == 1.0);  // 9 is one room and back
}

TEST_CASE("a corner impact turns all approach round and keeps the energy")
{
    const Vec2 r(0.25, -0.5);
    const Struck after = strike_floor(Vec2(0.5, -3.0), 2.0, r, 2.0, 0.5, 1.0);
    CHECK(after.velocity.x() == 0.5);
    const double before = -3.0 + 2.0 * 0.25;
    CHECK(after.velocity.y() + after.spin * 0.25 == doctest::Approx(-before).epsilon(1e-15));
    CHECK(0.5 * 2.0 * after.velocity.squaredNorm() + 0.5 * 0.5 * after.spin * after.spin ==
          doctest::Approx(0.5 * 2.0 * 9.25 + 0.5 * 0.5 * 4.0).epsilon(1e-15));
}

TEST_CASE("a disc on a rough floor sticks up to 3 mu (1+e) times the speed of the approach, and slides beyond")
{
    // 3 * 0.2 * 1.5 * 2 = 1.8
    const Struck sticks = strike_floor_rough(Vec2(1.7, -2.0), 0.5, 0.5, 0.2);
    CHECK(sticks.velocity.x() + 0.5 * sticks.spin == doctest::Approx(0.0).epsilon(1e-15));
    CHECK(sticks.velocity.y() == doctest::Approx(1.0));
    const Struck slides = strike_floor_rough(Vec2(1.9, -2.0), 0.5, 0.5, 0.2);
    CHECK(slides.velocity.x() == doctest::Approx(1.9 - 0.2 * 3.0).epsilon(1e-15));
    CHECK(slides.velocity.x() + 0.5 * slides.spin == doctest::Approx(0.1).epsilon(1e-12));
}

TEST_CASE("slopes and floors: a block stays where mu is the tangent, and a thrown disc ends at two thirds of its speed")
{
    CHECK(slid(10.0, std::numbers::pi / 4.0, 1.0 + 1e-12, 3.0) == 0.0);
    CHECK(slid(10.0, std::numbers::pi / 6.0, 0.0, 2.0) == doctest::Approx(10.0).epsilon(1e-15));

    // v0 / (3 mu g) = 3 / (3 * 0.1 * 10) = 1 s; way 3 - 0.5 = 2.5 m; then 2 m/s
    const Rolled then = slid_to_roll(3.0, 0.1, 10.0, 0.5, 1.0);
    CHECK(then.way == doctest::Approx(2.5).epsilon(1e-15));
    CHECK(then.angle == doctest::Approx(-2.0).epsilon(1e-15));
    const Rolled later = slid_to_roll(3.0, 0.1, 10.0, 0.5, 2.0);
    CHECK(later.way == doctest::Approx(4.5).epsilon(1e-15));
    CHECK(later.angle == doctest::Approx(-6.0).epsilon(1e-15));
}

TEST_CASE("Galperin's balls count pi and keep their energy")
{
    CHECK(parted(1.0).collisions == 3);
    CHECK(parted(100.0).collisions == 31);
    const Parted after = parted(1e4);
    CHECK(after.collisions == 314);
    CHECK(1e4 * after.heavy * after.heavy + after.light * after.light == doctest::Approx(1e4).epsilon(1e-14));
    CHECK(after.heavy >= after.light);
}

TEST_CASE("equal balls on a line swap velocities")
{
    // The first meets the second after a second; in places, that is as if both went on as points
    const std::vector<double> places = row_places({1.0, 3.0}, {1.0, 0.0}, 0.5, 0.0, 10.0, 2.0);
    CHECK(places[0] == doctest::Approx(2.0).epsilon(1e-15));
    CHECK(places[1] == doctest::Approx(4.0).epsilon(1e-15));
}

TEST_CASE("a rocking block loses at each impact what the closed form says, and rocks with the period of small angles")
{
    // Alone on its corner it falls as a pendulum that stands on its head: energy tells the spin before the impact
    const double b = 0.1;
    const double h = 1.0;
    const double g = 9.81;
    const double alpha = std::atan2(b, h);
    const double start = 0.5 * alpha;
    std::vector<double> times;
    for (int k = 0; k <= 4000; ++k) times.push_back(k * 0.001);
    const std::vector<double> angles = rocking(b, h, g, start, times);
    CHECK(angles.front() == start);

    // The first swing to the other side: by energy, 1 - cos(alpha - peak) keeps the square of the factor of what there
    // was
    const double kept = 1.0 - 1.5 * std::sin(alpha) * std::sin(alpha);
    const double drop = std::cos(alpha - start) - std::cos(alpha);
    const double peak = alpha - std::acos(std::cos(alpha) + kept * kept * drop);
    double lowest = 0.0;
    for (std::size_t k = 0; k < angles.size() && (k == 0 || angles[k - 1] >= angles[k] || angles[k] > 0.0); ++k) {
        lowest = std::min(lowest, angles[k]);
    }
    CHECK(lowest == doctest::Approx(-peak).epsilon(1e-5)); // between two of the moments asked for
}

TEST_CASE("no square of the corner impacts touches the floor a second time before it is looked at")
{
    for (const TrialMaker& maker : trial_makers()) {
        if (maker.name != "corner-impact") continue;
        const Trial trial = maker.make(Coarseness::quick);
        for (const flying::BodyDef& body : trial.scene.bodies) {
            const double offset = body.angle + 0.25 * std::numbers::pi;
            const double reach = std::sqrt(0.5);
            const Vec2 arm(reach * std::sin(offset), -reach * std::cos(offset));
            const Struck after = strike_floor(body.velocity, 0.0, arm, 1.0, 1.0 / 6.0, 1.0);
            const double met = (body.position.y() + arm.y()) / 3.0;
            for (double t = 0.005; t < trial.until - met; t += 0.001) {
                const double angle = body.angle + after.spin * t;
                double lowest = 1e9;
                for (int k = 0; k < 4; ++k) {
                    lowest = std::min(lowest, reach * std::sin(angle + (0.25 + 0.5 * k) * std::numbers::pi));
                }
                CHECK(-arm.y() + after.velocity.y() * t + lowest > 0.0);
            }
        }
    }
}
