// Bodies between the two integrators: who moves whom, from when on, and at what cost.

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "support/worlds.hpp"
#include "world/world.hpp"

using namespace flying;
using namespace flying::testing;

namespace {

constexpr double k_g = 9.81; // [m/s^2]

Scene box_in_gravity(double restitution, double friction)
{
    Scene scene;
    scene.world.field = UniformField{{0.0, -k_g}};
    scene.world.restitution = restitution;
    scene.world.friction = friction;
    scene.world.box = BoxDef{{-20.0, 0.0}, {20.0, 20.0}};
    return scene;
}

BodyDef body(const ShapeDef& shape, const Vec2& position, const Vec2& velocity = Vec2::Zero(), double spin = 0.0)
{
    BodyDef def;
    def.shape = shape;
    def.position = position;
    def.velocity = velocity;
    def.spin = spin;
    return def;
}

bool same_bits(const BodyState& p, const BodyState& q)
{
    return p.position == q.position && p.velocity == q.velocity && p.angle == q.angle && p.spin == q.spin;
}

/// A stack of three boxes about x = 0, and a ball that bounces for ever at x = 6, or one that never meets anything.
Scene ball_beside_stack(bool with_stack)
{
    Scene scene = box_in_gravity(0.0, 0.5);
    BodyDef ball = body(DiscDef{0.3}, {6.0, 4.0}, {0.37, 0.0}, 2.0);
    ball.restitution = 1.0;
    scene.bodies.push_back(ball);
    if (!with_stack) return scene;
    for (int k = 0; k < 3; ++k) scene.bodies.push_back(body(RectangleDef{1.0, 1.0}, {0.0, 0.5 + k}));
    return scene;
}

} // namespace

TEST_CASE("bounces end at sqrt(2 h/g) (1 + e)/(1 - e), to 1e-12, whatever e, sliding and spinning or not")
{
    for (const double e : {0.0, 0.1, 0.5, 0.9, 0.99, 0.999}) {
        for (const bool slides : {false, true}) {
            Scene scene = box_in_gravity(e, slides ? 0.3 : 0.0);
            const double h = 1.7;
            const double r = 0.25;
            scene.world.box->max.x() = 1e6;
            scene.bodies = {body(DiscDef{r}, {0.0, h + r}, {slides ? 1.5 : 0.0, 0.0}, slides ? 7.0 : 0.0)};
            World world = world_of(scene);
            const double end = std::sqrt(2.0 * h / k_g) * (1.0 + e) / (1.0 - e);
            run(world, end + 0.1);
            INFO("e " << e << " slides " << slides);
            REQUIRE(world.handovers().size() == 1);
            const Handover& handover = world.handovers()[0];
            CHECK(handover.ends_bounces);
            CHECK(handover.bodies == std::vector<int>{0});
            CHECK(handover.energy_change == 0.0);
            CHECK(std::abs(handover.time / end - 1.0) <= 1e-12);
            // The last hops that are told from contact are 16 tolerances of touching high; then velocities are rounding
            CHECK(std::abs(world.state(0).position.y() - r) <= 16.0 * 0x1p-40 * r);
            CHECK(std::abs(world.state(0).velocity.y()) <= 1e-13);
        }
    }
}

TEST_CASE("a ball that slides while its bounces die away has lost mu g t at their end, as if it had never bounced")
{
    // All normal impulses together bear the weight over the whole time, and the fall before; the disc slips throughout
    const double e = 0.6;
    const double mu = 0.01;
    const double h = 0.4;
    const double r = 0.25;
    // The last hops are 16 tolerances of touching high. A disc handed over as fast as these goes down and up in a step,
    // by a quarter of the way that it would go at that speed; friction has the arm of halfway.
    const double d = 1.0 / 60.0;
    const double hop = std::sqrt(2.0 * k_g * 16.0 * 0x1p-40 * r); // [m/s]
    const double arm = 0.25 * hop * d;                            // how far it may be off [m]
    for (const double v : {1.0, 1.5, 3.0, 5.0, 7.0, 20.0, 50.0}) {
        CAPTURE(v);
        Scene scene = box_in_gravity(e, mu);
        scene.world.box->max.x() = 1e3;
        scene.bodies = {body(DiscDef{r}, {-10.0, h + r}, {v, 0.0})};
        World world = world_of(scene);
        const double end = std::sqrt(2.0 * h / k_g) * (1.0 + e) / (1.0 - e);
        run(world, end + 0.5);
        const double lost = mu * k_g * (end + 0.5);
        CHECK(std::abs(world.state(0).velocity.x() - (v - lost)) <= 1e-12 * v);
        CHECK(std::abs(world.state(0).spin + 2.0 * lost / r) <= 2.0 * mu * k_g * d * arm / (r * r) + 1e-12 * v / r);
    }
}

TEST_CASE("a ball that bounces beside a stack has the bits that it has alone")
{
    World alone = world_of(ball_beside_stack(false));
    World beside = world_of(ball_beside_stack(true));
    for (int k = 1; k <= 200; ++k) {
        run(alone, 0.1 * k);
        run(beside, 0.1 * k);
        REQUIRE(same_bits(alone.state(0), beside.state(0)));
        CHECK(beside.mover(0) == World::Mover::events);
    }
    for (int k = 1; k <= 3; ++k) CHECK(beside.mover(k) == World::Mover::asleep);
    CHECK(alone.handovers().empty());
    CHECK(beside.handovers().size() >= 1);
}

TEST_CASE("a box that falls on a sleeping stack meets it when flight says, wakes it, and all comes to rest again")
{
    Scene scene = box_in_gravity(0.3, 0.5);
    scene.bodies = {body(SquareDef{0.5}, {0.1, 11.0})};
    for (int k = 0; k < 3; ++k) scene.bodies.push_back(body(RectangleDef{1.0, 1.0}, {0.0, 0.5 + k}));
    World world = world_of(scene);
    const double contact = std::sqrt(2.0 * (11.0 - 3.25) / k_g);

    run(world, contact * (1.0 - 1e-13));
    CHECK(world.mover(0) == World::Mover::events);
    for (int k = 1; k <= 3; ++k) CHECK(world.mover(k) == World::Mover::asleep);
    CHECK(std::abs(world.state(0).position.y() - 3.25) <= 1e-11);

    run(world, contact * (1.0 + 1e-13));
    CHECK(world.mover(3) == World::Mover::rest);
    CHECK(world.state(0).velocity.y() > 0.0);
    CHECK(world.report().max_overlap <= 1e-12);

    run(world, 20.0);
    const Report report = world.report();
    for (int k = 0; k < 4; ++k) CHECK(world.mover(k) == World::Mover::asleep);
    CHECK(report.max_overlap <= 0.01 * 0.25);
    CHECK(report.energy.kinetic == 0.0);
}

TEST_CASE(
    "three discs collapse where e is below 7 - 4 sqrt 3: nothing of their relative motion is left, and all fly on")
{
    // Impacts follow each other ever faster until the speeds agree to rounding; nothing presses the discs together then
    const double limit = 7.0 - 4.0 * std::sqrt(3.0);
    for (const double e : {0.5 * limit, 0.9 * limit, 1.1 * limit}) {
        Scene scene;
        scene.world.restitution = e;
        scene.bodies = {body(DiscDef{0.5}, {-3.0, 0.0}, {1.5, 0.0}), body(DiscDef{0.5}, {0.0, 0.0}, {0.5, 0.0}),
                        body(DiscDef{0.5}, {3.5, 0.0}, {-0.5, 0.0})};
        World world = world_of(scene);
        run(world, 60.0);
        INFO("e " << e);
        double momentum = 0.0;
        double spread = 0.0;
        for (int k = 0; k < 3; ++k) {
            CHECK(world.mover(k) == World::Mover::events);
            momentum += world.state(k).velocity.x();
            spread = std::max(spread, std::abs(world.state(k).velocity.x() - 0.5));
        }
        CHECK(std::abs(momentum - 1.5) <= 1e-13);
        CHECK((spread <= 1e-14) == (e < limit));
        CHECK(world.report().max_overlap <= 1e-12);
        for (const Handover& handover : world.handovers()) CHECK(handover.energy_change == 0.0);
    }
}

TEST_CASE("a block that is struck off its stack flies, and is the event engine's until it lands")
{
    Scene scene = box_in_gravity(0.2, 0.3);
    scene.bodies = {body(RectangleDef{2.0, 8.0}, {0.0, 4.0}), body(RectangleDef{1.0, 1.0}, {0.0, 8.5}),
                    body(SquareDef{0.6}, {-15.0, 11.0}, {20.0, 0.0})};
    scene.bodies[0].is_static = true;
    World world = world_of(scene);
    run(world, 0.5);
    CHECK(world.mover(1) == World::Mover::asleep);
    // At 20 m/s it falls by 2.5 m over the 14.2 m between them
    bool flew = false;
    for (int k = 31; k <= 1200; ++k) {
        run(world, k / 60.0);
        flew = flew || (world.mover(1) == World::Mover::events && world.state(1).position.y() < 7.0);
    }
    CHECK(flew);
    CHECK(world.mover(1) == World::Mover::asleep);
    CHECK(world.mover(2) == World::Mover::asleep);
    CHECK(world.state(1).position.y() == doctest::Approx(0.5).epsilon(1e-3));
}

TEST_CASE("a world says when the step under way ends, and nothing where no step is under way")
{
    constexpr double k_step = 1.0 / 60.0;
    World world = world_of(ball_beside_stack(true));
    CHECK_FALSE(world.step_end().has_value());
    for (const double share : {0.25, 0.75}) {
        REQUIRE_FALSE(world.advance(share * k_step));
        REQUIRE(world.step_end().has_value());
        CHECK(*world.step_end() == k_step);
    }
    REQUIRE_FALSE(world.advance(k_step));
    CHECK_FALSE(world.step_end().has_value());

    // The stack sleeps, and the ball flies on
    REQUIRE_FALSE(world.advance(600.5 * k_step));
    REQUIRE(world.mover(1) == World::Mover::asleep);
    CHECK_FALSE(world.step_end().has_value());

    World alone = world_of(ball_beside_stack(false));
    REQUIRE_FALSE(alone.advance(7.5 * k_step));
    CHECK_FALSE(alone.step_end().has_value());
}

TEST_CASE("bodies of a wall that is struck are let go where whole steps end, however often fast ones halve them")
{
    constexpr double k_step = 1.0 / 60.0;
    Scene scene = box_in_gravity(0.3, 0.5);
    for (int row = 0; row < 6; ++row) {
        for (int k = 0; k < 4; ++k) scene.bodies.push_back(body(RectangleDef{0.6, 0.3}, {0.6 * k, 0.15 + 0.3 * row}));
    }
    int let_go = 0;
    for (const double speed : {20.0, 25.0, 30.0, 40.0, 50.0, 60.0, 80.0}) {
        CAPTURE(speed);
        Scene struck = scene;
        struck.bodies.push_back(body(DiscDef{0.3}, {-8.0, 1.0}, {speed, 1.0}));
        World world = world_of(struck);
        run(world, 3.0);
        for (const Handover& each : world.handovers()) {
            if (each.to != Handover::To::events) continue;
            CHECK(each.time == std::round(each.time / k_step) * k_step);
            ++let_go;
        }
    }
    CHECK(let_go >= 10);
}
