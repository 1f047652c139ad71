#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "chapters/support/lying_bodies.hpp"
#include "rest/body_order.hpp"

using namespace flying;
using namespace flying::test;

namespace {

constexpr int k_columns = 22;
constexpr int k_rows = 21;
constexpr int k_discs = k_columns * k_rows; // more than are solved whole
constexpr int k_floor = 200;                // its number, among those of the discs

/// Rows of discs, the lowest of which lies on the floor, numbered across the plane.
std::vector<RestBody> scattered_rows()
{
    std::vector<RestBody> bodies;
    for (int k = 0; k < k_discs; ++k) {
        const int place = (101 * k) % k_discs; // 101 shares no divisor with their number
        if (k == k_floor) bodies.push_back(wall(Vec2(0.0, 1.0), 0.0, {0.0, 0.5}));
        bodies.push_back(
            disc(0.4, Vec2(1.0 + 3.0 * (place % k_columns), 0.4 + 3.0 * (place / k_columns)), 1.0, {0.0, 0.5}));
        if (place >= k_columns) bodies.back().state.velocity = Vec2(0.01 * k, 0.0);
    }
    return bodies;
}

double length_of_way(const std::vector<RestBody>& bodies, const std::vector<int>& order)
{
    double length = 0.0;
    for (std::size_t k = 1; k < order.size(); ++k) {
        const RestBody& from = bodies[order[k - 1]];
        const RestBody& to = bodies[order[k]];
        if (!from.is_static && !to.is_static) length += (to.state.position - from.state.position).norm();
    }
    return length;
}

} // namespace

TEST_CASE("the order of bodies in memory goes from neighbour to neighbour, and names each once")
{
    const std::vector<RestBody> bodies = scattered_rows();
    std::vector<int> given(bodies.size());
    std::iota(given.begin(), given.end(), 0);
    CHECK(order_in_memory(bodies, k_discs) == given);

    std::vector<int> order = order_in_memory(bodies, k_discs - 1);
    CHECK(order[0] == k_floor);
    CHECK(length_of_way(bodies, order) < 0.25 * length_of_way(bodies, given));
    std::sort(order.begin(), order.end());
    CHECK(order == given);
}

TEST_CASE("whatever the order in memory, bodies keep their numbers")
{
    const std::vector<RestBody> bodies = scattered_rows();
    RestEngine engine(bodies);
    for (int k = 0; k < 12; ++k) engine.step();
    const double t = engine.time();
    REQUIRE(engine.body_count() == static_cast<int>(bodies.size()));
    for (int k = 0; k < engine.body_count(); ++k) {
        CAPTURE(k);
        const BodyState& start = bodies[k].state;
        const bool falls = !bodies[k].is_static && start.position.y() > 1.0;
        const Vec2 fall(0.0, falls ? -0.5 * k_gravity * t * t : 0.0);
        CHECK((engine.state(k).position - (start.position + t * start.velocity + fall)).norm() < 1e-12);
        CHECK(engine.is_asleep(k) == (!bodies[k].is_static && !falls));
        CHECK(engine.body(k).is_static == (k == k_floor));
    }

    // Contacts are named from the lower number to the higher, in order
    const std::vector<RestContact> contacts = engine.contacts();
    CHECK(contacts.size() == k_columns);
    int last = -1;
    for (const RestContact& contact : contacts) {
        const int disc = contact.a == k_floor ? contact.b : contact.a;
        CAPTURE(disc);
        CHECK(contact.a < contact.b);
        CHECK((contact.a == k_floor || contact.b == k_floor));
        CHECK(contact.normal.y() == (contact.a == k_floor ? 1.0 : -1.0));
        CHECK(std::abs(contact.normal_force - k_gravity) < 1e-9);
        CHECK(engine.is_asleep(disc));
        CHECK(contact.a >= last);
        last = contact.a;
    }
    const std::vector<int> islands = engine.islands();
    for (int k = 0; k < engine.body_count(); ++k) CHECK(islands[k] == (k == k_floor ? -1 : k));

    // Who is put elsewhere, or taken out, is who was meant
    BodyState state = engine.state(7);
    state.position.x() = -50.0;
    engine.set_state(7, state);
    engine.set_active(8, false);
    const BodyState taken = engine.state(8);
    engine.step();
    CHECK(engine.state(7).position.x() < -49.0);
    CHECK(engine.state(8).position == taken.position);
    CHECK(!engine.body(8).is_active);
    CHECK(engine.body(9).is_active);
}

TEST_CASE("what goes on from a memory goes on in its order, wherever its own bodies lay")
{
    const auto on_each_other = [] {
        std::vector<RestBody> bodies = scattered_rows();
        for (RestBody& body : bodies) {
            if (!body.is_static) body.state.position *= 0.3;
            if (!body.is_static) body.state.position.y() += 0.3;
        }
        return bodies;
    };
    RestEngine one(on_each_other());
    for (int k = 0; k < 60; ++k) one.step();
    std::vector<RestBody> moved = on_each_other();
    for (int k = 0; k < one.body_count(); ++k) moved[k].state = one.state((k + 1) % one.body_count());
    RestEngine other(moved);
    other.go_on_from(one.memory());
    CHECK(other.hash() == one.hash());
    for (int k = 0; k < 30; ++k) {
        one.step();
        other.step();
    }
    CHECK(other.hash() == one.hash());
}
