#include <doctest/doctest.h>

#include <vector>

#include "geometry/make_polygon.hpp"
#include "mass/polygon.hpp"
#include "math/random.hpp"
#include "chapters/support/lying_bodies.hpp"

// What the outline of a body says beside its shape: vertices in the middle of straight sides, and sides in one line.

using namespace flying;
using namespace flying::test;

namespace {

using Ring = std::vector<Vec2>;

RestBody fixed(const Ring& ring, const Vec2& position, double angle, const Material& material)
{
    RestBody body{Polygon({ring}), {}, {}, material};
    body.state.position = position;
    body.state.angle = angle;
    body.is_static = true;
    return body;
}

/// A body of one kilogram a square metre, the origin of its ring at `position`.
RestBody falls(const Ring& ring, const Vec2& position, double tilt, const Material& material)
{
    const Expected<CentredPolygon> centred = make_polygon({ring});
    REQUIRE(centred.has_value());
    const MassProperties mass = mass_of(centred.value().polygon, 1.0);
    RestBody body = faller(centred.value().polygon, position + centred.value().centroid, mass.mass,
                           mass.moment_of_inertia, material);
    body.state.angle = tilt;
    return body;
}

Ring rectangle_ring(double width, double height)
{
    const Polygon polygon = rectangle(width, height);
    return {polygon.vertices().begin(), polygon.vertices().end()};
}

/// The same outline with vertices in the middle of some sides.
Ring with_middles(const Ring& corners, Random& random)
{
    Ring ring;
    for (std::size_t k = 0; k < corners.size(); ++k) {
        ring.push_back(corners[k]);
        const Vec2 way = corners[(k + 1) % corners.size()] - corners[k];
        if (random.below(4) != 0) ring.push_back(corners[k] + random.uniform(0.1, 0.5) * way);
        if (random.below(2) != 0) ring.push_back(corners[k] + random.uniform(0.6, 0.9) * way);
    }
    return ring;
}

const Ring k_plus = {Vec2(-1.5, -0.5), Vec2(-0.5, -0.5), Vec2(-0.5, -1.5), Vec2(0.5, -1.5), Vec2(0.5, -0.5), Vec2(1.5, -0.5),
                     Vec2(1.5, 0.5),   Vec2(0.5, 0.5),   Vec2(0.5, 1.5),   Vec2(-0.5, 1.5), Vec2(-0.5, 0.5), Vec2(-1.5, 0.5)};
const Ring k_t = {Vec2(-0.5, -1.5), Vec2(0.5, -1.5), Vec2(0.5, 0.0),  Vec2(1.5, 0.0),
                  Vec2(1.5, 1.0),   Vec2(-1.5, 1.0), Vec2(-1.5, 0.0), Vec2(-0.5, 0.0)};
const Ring k_comb = {Vec2(-3, -1), Vec2(3, -1), Vec2(3, 1),  Vec2(2, 1),  Vec2(2, 0),  Vec2(1, 0),
                     Vec2(1, 1),   Vec2(-1, 1), Vec2(-1, 0), Vec2(-2, 0), Vec2(-2, 1), Vec2(-3, 1)};

/// All fall asleep within the time, none further from where it began than `way`, and the supports bear what weighs.
void comes_to_lie(const std::vector<RestBody>& bodies, double within, double way)
{
    RestEngine engine(bodies);
    const auto all_asleep = [&] {
        bool all = true;
        for (int k = 0; k < engine.body_count(); ++k) all = all && (bodies[k].is_static || engine.is_asleep(k));
        return all;
    };
    while (!all_asleep() && engine.time() < within) engine.step();
    CHECK(all_asleep());
    double weight = 0.0;
    for (int k = 0; k < engine.body_count(); ++k) {
        if (bodies[k].is_static) continue;
        weight += k_gravity / bodies[k].inertia.inv_mass;
        CAPTURE(k);
        CHECK((engine.state(k).position - bodies[k].state.position).norm() <= way);
    }
    double borne = 0.0;
    for (const RestContact& contact : engine.contacts()) {
        const double up = contact.normal_force * contact.normal.y() + contact.tangent_force * contact.normal.x();
        if (bodies[contact.a].is_static) borne += up;
        else if (bodies[contact.b].is_static) borne -= up;
    }
    CHECK(borne == doctest::Approx(weight).epsilon(1e-9));
}

} // namespace

TEST_CASE("a vertex in the middle of a straight side changes no bit of how a body comes to rest")
{
    // A box over such a vertex was held on one of the two edges only: it sank in, rolled over it, or was never still
    Random random(1106);
    const Ring floor = {Vec2(-3, -1), Vec2(3, -1), Vec2(3, 0), Vec2(-3, 0)};
    for (int k = 0; k < 60; ++k) {
        const Material material{k % 3 == 0 ? 0.3 : 0.0, random.uniform(0.2, 0.8)};
        const double slope = k % 2 == 0 ? 0.0 : random.uniform(-0.1, 0.1);
        const double x = random.uniform(-0.5, 0.5);
        const double tilt = k % 5 == 0 ? slope : random.uniform(-0.5, 0.5);
        const Ring box_ring = rectangle_ring(1.0, random.uniform(0.5, 1.5));
        const RestBody plain = falls(box_ring, Vec2(x, 1.2), tilt, material);
        RestBody more = plain;
        more.shape = Polygon({with_middles(box_ring, random)});
        const RestBody below = k % 4 == 0 ? wall(Vec2(0.0, 1.0), 0.0, material) : fixed(floor, Vec2::Zero(), slope, material);
        RestBody more_below = below;
        if (k % 4 != 0) more_below.shape = Polygon({with_middles(floor, random)});

        RestEngine first({below, plain});
        RestEngine second({more_below, more});
        int differ = 0;
        for (int step = 0; step < 300; ++step) {
            first.step();
            second.step();
            const BodyState a = first.state(1);
            const BodyState b = second.state(1);
            if (a.position != b.position || a.angle != b.angle || a.velocity != b.velocity || a.spin != b.spin) ++differ;
        }
        CAPTURE(k);
        CHECK(differ == 0);
        CHECK(second.is_asleep(1));
    }
}

TEST_CASE("boxes lie still on the arms of a cross, in the gaps of a comb, and where a T hangs between two posts")
{
    // Sides of these stand in one line with the cuts that part them; a box was thought to lie on the cut, and whirled
    const Material material{0.3, 0.5};
    for (const double tilt : {0.0, 0.01, -0.1}) {
        CAPTURE(tilt);
        comes_to_lie({fixed(k_plus, Vec2::Zero(), 0.0, material), falls(rectangle_ring(0.8, 0.8), Vec2(-1.02, 1.2), tilt, material),
                      falls(rectangle_ring(0.8, 0.8), Vec2(1.02, 1.2), tilt, material)},
                     5.0, 0.35);
        comes_to_lie({fixed(k_comb, Vec2::Zero(), 0.0, material), falls(rectangle_ring(0.6, 0.6), Vec2(1.5, 0.5), tilt, material),
                      falls(rectangle_ring(0.6, 0.6), Vec2(-1.5, 0.5), tilt, material),
                      falls(rectangle_ring(1.5, 0.6), Vec2(0.0, 1.5), tilt, material)},
                     5.0, 0.35);
        const RestBody ground = wall(Vec2(0.0, 1.0), 0.0, material);
        const Ring post = rectangle_ring(0.6, 3.0);
        comes_to_lie({ground, fixed(post, Vec2(-1.1, 1.5), 0.0, material), fixed(post, Vec2(1.1, 1.5), 0.0, material),
                      falls(k_t, Vec2(0.0, 3.3), tilt, material)},
                     5.0, 0.5);
        comes_to_lie({ground, falls(k_plus, Vec2(0.0, 1.7), tilt, material),
                      falls(rectangle_ring(0.7, 0.7), Vec2(-1.02, 3.0), tilt, material),
                      falls(rectangle_ring(0.7, 0.7), Vec2(1.02, 3.0), tilt, material)},
                     8.0, 0.7);
    }
}
