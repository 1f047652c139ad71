#include <doctest/doctest.h>

#include <cmath>

#include "stages.hpp"

using namespace flying;
using namespace flying::testing;

TEST_CASE("a contact foresees when a falling box closes its gap, and how fast")
{
    const double gap = 0.01;  // [m]
    const double speed = 1.0; // [m/s]
    RestData data = data_of({ground(), box_at({0.0, 0.5 + gap}, {0.0, -speed})});
    const std::vector<ContactPoint> found = contacts_of(data);
    REQUIRE(found.size() == 2);
    // gap = v t + g t^2 / 2
    const double arrival = (std::sqrt(speed * speed + 2.0 * k_g * gap) - speed) / k_g;
    for (const ContactPoint& c : found) {
        CHECK(c.gap == doctest::Approx(gap).epsilon(1e-12));
        CHECK(c.closes_at == doctest::Approx(arrival).epsilon(1e-12));
        CHECK(c.closing_speed == doctest::Approx(speed + k_g * arrival).epsilon(1e-12));
        CHECK(c.normal == 0.0);
        CHECK(c.n_y == 1.0);
    }
}

TEST_CASE("what flies away, or lies where it is, closes nothing")
{
    RestData data = data_of({ground(), box_at({0.0, 0.5}), box_at({4.0, 0.51}, {0.0, 1.0})});
    for (const ContactPoint& c : contacts_of(data)) CHECK(std::isinf(c.closes_at));
}

TEST_CASE("a corner at the bottom of a notch touches both flanks, along their normals")
{
    // A static V of right angle, and a box that stands in it on one corner
    for (const double lean : {0.0, 0.1, -0.3}) {
        RestBody notch{Polygon({{Vec2(-2.0, 1.0), Vec2(-2.0, -1.0), Vec2(2.0, -1.0), Vec2(2.0, 1.0), Vec2(1.0, 1.0),
                                 Vec2(0.0, 0.0), Vec2(-1.0, 1.0)}}),
                       {}, {}, {0.0, 0.5}};
        notch.is_static = true;
        const std::vector<Vec2> spike = {Vec2(0.0, 0.0), Vec2(0.1, 0.5), Vec2(-0.1, 0.5)};
        RestBody rod{Polygon({spike}), {}, {1.0, 6.0}, {0.0, 0.5}};
        rod.acceleration = Vec2(0.0, -k_g);
        rod.state.angle = lean;
        RestData data = data_of({notch, rod});
        const std::vector<ContactPoint> found = contacts_of(data);
        REQUIRE(found.size() == 2);
        const double share = std::sqrt(0.5);
        for (const ContactPoint& c : found) {
            CHECK(std::abs(c.gap) <= 1e-15);
            CHECK(c.n_y == doctest::Approx(share).epsilon(1e-12));
            CHECK(std::abs(c.n_x) == doctest::Approx(share).epsilon(1e-12));
        }
        CHECK(found[0].n_x * found[1].n_x < 0.0);
    }
}
