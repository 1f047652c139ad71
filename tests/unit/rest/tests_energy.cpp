#include <doctest/doctest.h>

#include <cmath>

#include "rest/energy_limit.hpp"
#include "stages.hpp"

using namespace flying;
using namespace flying::testing;

namespace {

struct Motion
{
    Vec2 momentum = Vec2::Zero();
    double angular = 0.0; // about the origin [kg m^2/s]
    double energy = 0.0;
};

Motion motion_of(const RestData& data, const std::vector<Mover>& movers)
{
    Motion sum;
    for (const int k : moved_in(data)) {
        const Mover& mover = movers[k];
        const Vec2 v(mover.v_x, mover.v_y);
        sum.momentum += v / mover.inv_mass;
        sum.angular += cross(data.bodies.list[k].state.position, v) / mover.inv_mass + mover.spin / mover.inv_moment;
        sum.energy += 0.5 * (v.squaredNorm() / mover.inv_mass + mover.spin * mover.spin / mover.inv_moment);
    }
    return sum;
}

} // namespace

TEST_CASE("the limit takes what a free island has gained, and none of its momentum")
{
    RestData data = data_of({box_at({0.0, 0.0}, {1.0, 0.5}, 0.3), box_at({1.0, 0.2}, {-0.4, 0.7}, -1.0),
                             box_at({0.5, 1.2}, {0.2, -0.6}, 2.0)});
    for (Vec2& field : data.motion.field) field.setZero();
    std::vector<int> members = moved_in(data);
    std::vector<ContactPoint> none;
    Island island;
    island.members = members;
    const Motion start = motion_of(data, data.motion.before);

    // Velocities that no step may end with, of the same momentum: more motion relative to each other
    data.motion.now[0].v_x += 0.8;
    data.motion.now[2].v_x -= 0.8;
    data.motion.now[1].spin += 1.5;
    const Motion wrong = motion_of(data, data.motion.now);
    REQUIRE(wrong.energy > start.energy);
    CHECK(gain_of(data, island).gained == doctest::Approx(wrong.energy - start.energy).epsilon(1e-14));

    limit_energy(data, island);
    const Motion after = motion_of(data, data.motion.now);
    CHECK(after.energy == doctest::Approx(start.energy).epsilon(1e-14));
    CHECK((after.momentum - wrong.momentum).norm() <= 1e-15);
    CHECK(after.angular == doctest::Approx(wrong.angular).epsilon(1e-14));
    CHECK(data.counts.limited == 1);
    CHECK(data.counts.energy_limited == doctest::Approx(wrong.energy - start.energy).epsilon(1e-14));
}

TEST_CASE("what falls gains what the field gives, and the limit leaves it to the bit")
{
    RestData data = data_of({box_at({0.0, 5.0}, {3.0, 0.0}, 1.0)});
    std::vector<int> members = moved_in(data);
    Island island;
    island.members = members;
    fly(data, island);
    const Mover& old = data.motion.before[0];
    const Mover& now = data.motion.now[0];
    data.motion.shift[0] = data.motion.span * Vec2(0.5 * (old.v_x + now.v_x), 0.5 * (old.v_y + now.v_y));
    const Mover fallen = now;
    limit_energy(data, island);
    CHECK(data.motion.now[0].v_y == fallen.v_y);
    CHECK(data.motion.now[0].spin == fallen.spin);
    CHECK(data.counts.limited == 0);
}

TEST_CASE("the limit doesn't press a light body into the floor that bears nothing in this step")
{
    // A pebble on the floor, and a heavy box on it that comes down and has gained energy: as one rigid body that nothing
    // holds, they would fall
    for (const double heavy : {10.0, 1e4, 1e8}) {
        RestBody pebble{Disc{0.01}, {}, {1.0, 2e4}, {0.5, 0.3}};
        pebble.state.position = Vec2(0.0, 0.01);
        pebble.acceleration = Vec2(0.0, -k_g);
        RestBody box = box_at({0.0, 0.52}, {2.0, -1.0});
        box.inertia = {1.0 / heavy, 6.0 / heavy};
        RestData data = data_of({ground(), pebble, box});
        std::vector<ContactPoint> points = contacts_of(data);
        for (ContactPoint& c : points) c.normal = c.tangent = 0.0;
        std::vector<int> members = moved_in(data);
        Island island;
        island.members = members;
        island.points = points;
        for (const int k : members) data.motion.now[k] = data.motion.before[k];
        data.motion.shift[2] = Vec2(0.0, 1e-4); // lifted, against its weight
        REQUIRE(gain_of(data, island).gained > 0.0);
        limit_energy(data, island);
        CAPTURE(heavy);
        CHECK(gain_of(data, island).gained <= 1e-13 * gain_of(data, island).scale);
        CHECK(data.motion.now[1].v_y >= -1e-15);
        CHECK(data.motion.shift[1].y() >= -1e-15);
    }
}
