#include <algorithm>
#include <cmath>
#include <doctest/doctest.h>

#include "draw/layout.hpp"
#include "math/number_text.hpp"
#include "math/random.hpp"
#include "runs.hpp"
#include "support/receipts.hpp"
#include "world/checks.hpp"
#include "world/hand_over.hpp"

using namespace flying;

namespace {

/// One body by itself.
Scene alone(const ShapeDef& shape, const Vec2& velocity, double spin, const Vec2& gravity)
{
    Scene scene;
    scene.world.field = UniformField{gravity};
    BodyDef body;
    body.shape = shape;
    body.velocity = velocity;
    body.spin = spin;
    scene.bodies.push_back(body);
    return scene;
}


/// How far a point of a body is, halfway between two frames, from where a straight way
/// between them has it.  [m]
/// corner  from the body's centre, in its own frame
double off_halfway(const Scene& scene, const Vec2& corner, double start_time,
                   double frame)
{
    World world = start(scene);
    Vec2 at[3];
    for (int k = 0; k < 3; ++k) {
        go(world, start_time + 0.5 * k * frame);
        const BodyState state = world.state(0);
        at[k] = state.position + Rotation::of(state.angle) * corner;
    }
    return (at[1] - 0.5 * (at[0] + at[2])).norm();
}


} // namespace


TEST_CASE(
    "halfway between two frames a flight is g T^2 / 8 off the straight way, and a corner "
    "that turns misses it by its bow")
{
    Random random(1301);
    for (int k = 0; k < 200; ++k) {
        const double g = random.uniform(1.0, 20.0);
        const double T = random.uniform(0.01, 0.5);
        const Vec2 v(random.uniform(-3.0, 3.0), random.uniform(-3.0, 3.0));
        const Scene scene = alone(DiscDef{0.5}, v, 0.0, Vec2(0.0, -g));
        const double b = off_halfway(scene, Vec2::Zero(), random.uniform(0.0, 0.5), T);

        // Places of some metres have roundings of 1e-15 m, and the least bow is 1e-5 m
        CHECK_EQUATION("simulator.bow", b, g * T * T / 8.0, 1e-9, {"g", g}, {"T", T});
        CHECK_TWIN("simulator.bow", b, g * T * T / 2.0, 1e-9);

        const double omega = random.uniform(0.5, 30.0);
        const Scene turning = alone(SquareDef{1.0}, v, omega, Vec2::Zero());
        const double r = std::sqrt(0.5);
        const double d = off_halfway(turning, Vec2(0.5, 0.5), 0.0, T);
        const double bow = r * (1.0 - std::cos(0.5 * omega * T));
        CHECK_EQUATION("simulator.turn", d, bow, 1e-8, {"r", r}, {"\\omega", omega},
                       {"T", T});
        CHECK_TWIN("simulator.turn", d, r * (1.0 - std::cos(omega * T)), 1e-8);
    }
}



TEST_CASE("a body at rest that is struck head-on flies off at less than twice the speed "
          "of what "
          "strikes it")
{
    Random random(1302);
    for (int k = 0; k < 200; ++k) {
        const double M = std::pow(10.0, random.uniform(-2.0, 4.0));
        const double m = 1.0;
        const double V = random.uniform(0.1, 9.0);
        Scene scene = alone(DiscDef{0.5}, Vec2(V, 0.0), 0.0, Vec2::Zero());
        scene.bodies[0].mass = M;
        scene.bodies.push_back(scene.bodies[0]);
        scene.bodies[1].mass = m;
        scene.bodies[1].position = Vec2(2.0, 0.0);
        scene.bodies[1].velocity = Vec2::Zero();
        World world = start(scene);
        go(world, 2.0 / V);
        const double w = world.state(1).velocity.x();
        CHECK_EQUATION("simulator.blow", w, 2.0 * M * V / (M + m), 1e-14, {"M", M},
                       {"m", m}, {"V", V});
        CHECK_TWIN("simulator.blow", w, M * V / (M + m), 1e-14);
        CHECK(w < 2.0 * V);
    }
}



TEST_CASE("the step is halved until no body goes further than half its size")
{
    for (const double v : {4.0, 6.0, 7.0, 8.0, 14.0, 20.0, 40.0}) {
        // A disc that rolls on the floor of its box
        const double R = 0.5;
        Scene scene = alone(DiscDef{R}, Vec2(v, 0.0), -v / R, Vec2(0.0, -9.81));
        scene.world.friction = 0.5;
        scene.world.restitution = 0.0;
        scene.world.box = BoxDef{{-10.0, 0.0}, {100.0, 10.0}};
        scene.bodies[0].position = Vec2(0.0, R);
        World world = start(scene);
        go(world, 1.0);
        const Report report = world.report();
        const auto is_move = [](const StageCost& stage) { return stage.name == "move"; };
        const auto move =
            std::find_if(report.stages.begin(), report.stages.end(), is_move);
        REQUIRE(move != report.stages.end());
        const double d = 1.0 / 60.0;
        const double q = v / R + v / R;
        const double measured = static_cast<double>(move->count) * d;
        const double halvings = std::ceil(std::log2(2.0 * q * d));
        CHECK_EQUATION("simulator.halvings", std::log2(measured), halvings, 1e-12,
                       {"q", q}, {"d", d});
        CHECK_TWIN("simulator.halvings", std::log2(measured),
                   std::ceil(std::log2(4.0 * q * d)), 1e-12);
    }
}



TEST_CASE(
    "what the energy has changed is what impacts, steps and hand-overs have changed")
{
    double worst = 0.0;
    for (std::uint64_t seed = 1; seed <= 8; ++seed) {
        World world = start(rain(12, seed));
        const double scale = world.report().energy.total();
        for (int k = 1; k <= 8; ++k) {
            go(world, 0.5 * k);
            const Report report = world.report();
            const EnergyLedger& ledger = report.ledger;
            const double E = report.energy.total();
            const double E_0 = report.initial_total;
            const double I = ledger.impacts;
            const double S = ledger.steps;
            const double H = ledger.handovers;
            CHECK_EQUATION_SCALED("simulator.ledger", E, E_0 + I + S + H, scale, 1e-12,
                                  {"E_0", E_0}, {"A_i", I}, {"A_s", S}, {"A_h", H});
            if (S != 0.0)
                CHECK_TWIN_SCALED("simulator.ledger", E, E_0 + I + H, scale, 1e-12);
            worst = std::max(worst, std::abs(E - E_0 - I - S - H) / scale);
        }
    }
    RECORD_VALUE("simulator.ledger", worst);
}



TEST_CASE("no double needs more than seventeen digits, and some need them all")
{
    Random random(1303);
    std::size_t most = 0;
    for (int k = 0; k < 20'000; ++k) {
        const double x = random.uniform(0.0, 1.0) * std::pow(10.0, random.below(20) - 10);
        std::string text = number_text(x);
        CHECK(std::strtod(text.c_str(), nullptr) == x);
        text = text.substr(0, text.find('e'));
        std::erase(text, '.');
        text.erase(0, text.find_first_not_of('0'));
        most = std::max(most, text.size());
    }
    const double digits = std::ceil(1.0 + 53.0 * std::log(2.0) / std::log(10.0));
    CHECK_EQUATION("simulator.digits", static_cast<double>(most), digits, 0.0, {"p", 53});
    CHECK_TWIN("simulator.digits", static_cast<double>(most), digits - 1.0, 0.0);
}



TEST_CASE("a picture fits the view into its panel with one scale, and y points up")
{
    Random random(1304);
    for (int k = 0; k < 100; ++k) {
        Picture picture;
        picture.box = Aabb{Vec2(0.0, 0.0),
                           Vec2(random.uniform(1.0, 9.0), random.uniform(1.0, 9.0))};
        picture.view = *picture.box;
        const Layout layout = layout_of(picture, {900, 600});
        const Vec2 low = layout.map(picture.view.min);
        const Vec2 high = layout.map(picture.view.max);
        const double w = picture.view.max.x();
        const double h = picture.view.max.y();
        const double W = layout.panel.width();
        const double H = layout.panel.height();
        CHECK_EQUATION("simulator.map", (low.y() - high.y()) / h, std::min(W / w, H / h),
                       1e-13, {"W", W}, {"w", w}, {"H", H}, {"h", h});
        CHECK_TWIN("simulator.map", (low.y() - high.y()) / h, std::max(W / w, H / h),
                   1e-13);
        CHECK((layout.map.world_at(low) - picture.view.min).norm() < 1e-12);
    }
}



TEST_CASE("whatever might be struck is near as far as its reach, and no further")
{
    Random random(1305);
    for (int k = 0; k < 100; ++k) {
        const double v = random.uniform(0.0, 4.0);
        const double g = random.uniform(1.0, 20.0);
        const double d = random.uniform(0.004, 0.1);
        Leaning one;
        one.radius = 0.5;
        one.speed = v;
        one.pull = g;
        one.way = {Vec2(-1.0, -1.0), Vec2(1.0, 1.0)};
        HandOver rules;
        rules.begin({one});
        rules.reach(d);

        // Halve the range in which it ends
        double near = 0.0;
        double far = 10.0;
        for (int i = 0; i < 60; ++i) {
            const Vec2 there(0.5 * (near + far), 0.0);
            (rules.is_near({there, there}) ? near : far) = there.x();
        }
        const double l = near - (1.0 + 0x1p-10) * one.radius; // room for rounding
        CHECK_EQUATION("simulator.reach", l, 2.0 * v * d + g * d * d, 1e-10, {"v", v},
                       {"d", d}, {"g", g});
        CHECK_TWIN("simulator.reach", l, v * d + g * d * d, 1e-10);
    }
}

