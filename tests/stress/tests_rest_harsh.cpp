#include <cmath>

#include <doctest/doctest.h>

#include "collide/separation.hpp"
#include "geometry/make_polygon.hpp"
#include "mass/polygon.hpp"
#include "math/random.hpp"
#include "rest/outline_points.hpp"
#include "rest/rest_engine.hpp"
#include "rest_trial.hpp"
#include "support/effort.hpp"
#include "support/overlap.hpp"
#include "support/random_polygons.hpp"

using namespace flying;

namespace {

RestBody moving(const Shape& shape, double density, const Vec2& position, const Vec2& velocity, double spin,
                const Vec2& field, const Material& material)
{
    const MassProperties mass = mass_of(shape, density);
    RestBody body{shape, {}, {1.0 / mass.mass, 1.0 / mass.moment_of_inertia}, material};
    body.state.position = position;
    body.state.velocity = velocity;
    body.state.spin = spin;
    body.acceleration = field;
    return body;
}

RestBody fixed(const Shape& shape, const Vec2& position, const Material& material)
{
    RestBody body{shape, {}, {}, material};
    body.state.position = position;
    body.is_static = true;
    return body;
}

} // namespace

TEST_CASE("who lies still while others have a step made anew still lies on the ground after it")
{
    // The first try had put the box to sleep; the second left its contact out, and it fell for a step
    const Vec2 field(0.0, -10.0);
    std::vector<RestBody> bodies = {fixed(HalfPlane{{0.0, 1.0}, 0.0}, Vec2::Zero(), {0.0, 0.5})};
    bodies.push_back(moving(flying::testing::box(1.0, 1.0), 1.0, Vec2(0.0, 0.5), Vec2::Zero(), 0.0, field, {0.0, 0.5}));
    // A heavy disc strikes the end of a light stick, which whirls away faster than anything did before
    bodies.push_back(
        moving(flying::testing::box(1.0, 0.1), 1e-3, Vec2(0.0, 10.0), Vec2::Zero(), 0.0, Vec2::Zero(), {1.0, 0.0}));
    bodies.push_back(moving(Disc{0.2}, 1e3, Vec2(0.4, 0.0), Vec2(0.0, 20.0), 0.0, Vec2::Zero(), {1.0, 0.0}));
    for (int strike = 0; strike < 5; ++strike) {
        bodies[3].state.position.y() = 9.75 - (strike + 0.5) * 20.0 / 60.0;
        RestEngine engine(bodies);
        CAPTURE(strike);
        for (int k = 0; k < 6; ++k) {
            engine.step();
            CHECK(engine.body(1).state.position.y() == 0.5);
            CHECK(engine.body(1).state.velocity.y() == 0.0);
        }
    }
}

TEST_CASE("a corner in a notch leaves it over the sides of the notch, whatever parts the body is cut into")
{
    // A plus sign, whose middle part has cuts alone, and a box in the notch at its upper left corner
    const Shape plus = Polygon(
        {{Vec2(-0.5, -1.5), Vec2(0.5, -1.5), Vec2(0.5, -0.5), Vec2(1.5, -0.5), Vec2(1.5, 0.5), Vec2(0.5, 0.5),
          Vec2(0.5, 1.5), Vec2(-0.5, 1.5), Vec2(-0.5, 0.5), Vec2(-1.5, 0.5), Vec2(-1.5, -0.5), Vec2(-0.5, -0.5)}});
    const Shape box = flying::testing::box(0.4, 0.4);
    const CollisionShape parts = make_collision_shape(plus);
    const Outline outline(plus, parts);
    const Outline box_outline(box, make_collision_shape(box));
    REQUIRE(parts.parts.size() == 5);
    for (const double overlap : {1e-15, 1e-3, 0.2}) {
        const Pose pose{Vec2(-0.7 + overlap, 0.7 - overlap), Rotation()};
        bool leaves_upwards = false;
        bool leaves_to_the_left = false;
        for (int part = 0; part < 5; ++part) {
            const Manifold manifold = outline_points({outline, part, Pose()}, {box_outline, 0, pose}, 0.01, 1e-12);
            for (int k = 0; k < manifold.count; ++k) {
                CHECK(manifold.contacts[k].separation == doctest::Approx(-overlap).epsilon(1e-9));
                leaves_upwards = leaves_upwards || manifold.contacts[k].normal.y() == 1.0;
                leaves_to_the_left = leaves_to_the_left || manifold.contacts[k].normal.x() == -1.0;
            }
        }
        CAPTURE(overlap);
        CHECK(leaves_upwards);
        CHECK(leaves_to_the_left);
    }
}

TEST_CASE("small bodies thrown into the notches of a concave one don't get into it")
{
    // In a notch the line of a cut parts two shapes best, but the cut itself lies elsewhere
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        Random random(seed);
        const Polygon star = flying::testing::random_star(random, false);
        const double size = star.radius();
        std::vector<RestBody> bodies = {fixed(star, Vec2::Zero(), {0.5, 0.3})};
        for (const auto& [normal, offset] : {std::pair(Vec2(1.0, 0.0), -1.2), std::pair(Vec2(-1.0, 0.0), -1.2),
                                             std::pair(Vec2(0.0, 1.0), -1.2), std::pair(Vec2(0.0, -1.0), -1.2)})
            bodies.push_back(fixed(HalfPlane{normal, size * offset}, Vec2::Zero(), {0.5, 0.3}));
        const CollisionShape star_shape = make_collision_shape(star);
        for (int k = 0; k < 40; ++k) {
            const double x = size * random.uniform(-1.0, 1.0);
            const double y = size * random.uniform(-1.0, 1.0);
            const double v_x = size * random.uniform(-3.0, 3.0);
            const double v_y = size * random.uniform(-3.0, 3.0);
            RestBody body = moving(flying::testing::box(0.03 * size, 0.03 * size), 1.0, Vec2(x, y), Vec2(v_x, v_y),
                                   random.uniform(-10.0, 10.0), Vec2::Zero(), {0.5, 0.3});
            const double gap =
                separation(star_shape, pose_of(bodies[0].state), make_collision_shape(body.shape), pose_of(body.state));
            if (gap > 0.0 && k % 8 == 0) bodies.push_back(body);
        }
        RestEngine engine(bodies);
        CAPTURE(seed);
        double worst = testing::deepest_overlap(engine);
        if (worst > 0.0) continue; // two stand in one place
        for (int k = 0; k < 60; ++k) {
            engine.step();
            worst = std::max(worst, testing::deepest_overlap(engine));
        }
        CHECK(worst < 0.01);
    }
}

TEST_CASE("random scenes that broke a promise once: no body gets into another in any step, and energy never rises")
{
    // 100: what was paid for a push out of an overlap led back into it. 106, 434: bodies that an impact had thrown
    // further than was reckoned with came where others, of other groups, were already. 165: the same, through a wall,
    // in the last try. 1021: through a wall for good. 134, 190: a clipped point lay above the corner that overlapped.
    // 214: islands that met unforeseen met others when they had gone back once. 1002: what slides along a wall gained
    // energy that only its friction could be asked for. 1142: a blow threw bodies where no pairs were listed. 1695:
    // impacts that a solve couldn't end gave a heap of masses 1:1e6 energy. 1798, 2157, 2212: hops on a turning side
    // sank behind it. 1795, 2077, 2132, 2331: corners slid past each other, and the sides that crossed were not seen.
    // 103, 214: of two blows in a step each was hidden by the cut that showed the other.
    // 2487: a blow to and fro between light and heavy bodies went on for minutes.
    // 1193: a pebble under a heavy body was pressed into the floor. 2169: a tip slid between a box and the floor.
    // 192, 1149: bodies that had met unforeseen went back to before the blow that threw one at the other. 1069, 1414: a
    // corner of a body with notches came lower than the points that were known of it. 3925: of two tips that met on the
    // floor, rounding put one deep into the other. 76: what lay beside two others was pushed out over both. 4512: a
    // push out of a jam took a box into a disc that it had no point with, and both stayed there.
    //
    // A change of one bit makes other runs of them. One that fails then has shown a fault of the method each time that
    // it was looked into
    for (const std::uint64_t seed : testing::tried<std::uint64_t>(
             {76,   100,  103,  106,  134,  165,  190,  192,  214,  434,  1002, 1021, 1069, 1142, 1149,
              1193, 1414, 1695, 1795, 1798, 2077, 2132, 2157, 2169, 2212, 2331, 2487, 3925, 4512})) {
        const stress::RestScene scene = stress::make_rest_scene(seed);
        const stress::RestFindings findings = stress::run_rest_scene(scene, 1, stress::Integrator::automatic);
        CAPTURE(seed);
        CAPTURE(scene.label);
        CHECK(findings.finite);
        CHECK(findings.lost == 0);
        CHECK(findings.rise <= stress::k_rise_allowed);
        CHECK(findings.overlap <= stress::k_overlap_allowed);
    }
}

TEST_CASE("a few bodies that lean gain no energy by rounding where their step is made in hundreds of parts")
{
    // With the allowance of a heap in each part, these gained 9e-14, 8e-14 and 2e-13 of the scene's energy; with a
    // jam for a solution, where there was another without, the last gained 1e-12, in hundreds of times the time
    for (const std::uint64_t seed : {2285, 4694, 8394, 8812}) {
        CAPTURE(seed);
        const stress::RestScene scene = stress::make_rest_scene(seed);
        CHECK(stress::run_rest_scene(scene, 1, stress::Integrator::automatic).rise <= 5e-14);
    }
}
