#include <cmath>
#include <map>
#include <numbers>

#include <doctest/doctest.h>

#include "column.hpp"
#include "lying.hpp"
#include "math/random.hpp"
#include "support/receipts.hpp"
#include "wrong_rest.hpp"

using namespace flying;
using namespace flying::test;

namespace {

const double k_rocking = 1e-7; // of second order and better; measured: 1e-8 at 240 steps a second
const double k_leaves = 1e-4;  // it may leave a step late, and is slower sideways then by the square of that

} // namespace

// [rest.tests.zeno]
TEST_CASE("a ball lies still when the sum of its hops says so")
{
    const double step = 1.0 / 1920.0;
    for (const double e : {0.1, 0.3, 0.5, 0.7}) {
        for (const double h : {0.25, 1.0}) {
            RestEngine ball = zeno_ball(h, e, step);
            const double time = time_to_rest(ball);
            // Hops shorter than a step are not taken: 2/(1 - e) steps of them last
            const double bound = 2.0 * step / (1.0 - 0.7) / end_of_hops(0.25, 0.7);
            const double paper = end_of_hops(h, e);
            CHECK_EQUATION("rest.zeno", time, paper, bound, {"e", e}, {"h", h},
                           {"g", k_gravity});
            CHECK_TWIN("rest.zeno", time, paper / (1.0 + e), bound);
        }
    }
}
// [rest.tests.zeno]


TEST_CASE("under constant forces a place is exact, whatever the step")
{
    Random random(1101);
    for (int i = 0; i < 40; ++i) {
        const Slope slope{random.uniform(0.3, 0.6)};
        const double mu = random.uniform(0.0, 0.2);
        RestOptions options;
        options.step = i % 2 == 0 ? 1.0 / 60.0 : 0.125;
        RestEngine engine =
            on_slope(slope, box(1.0, 0.5, Vec2::Zero(), 3.0, {0.0, mu}), 0.25, options);
        const double t = 1.0;
        engine.advance(t);
        const double way =
            -(engine.state(1).position - 0.25 * slope.normal()).dot(slope.up());
        const double pull =
            k_gravity * (std::sin(slope.angle) - mu * std::cos(slope.angle));
        CHECK_EQUATION("rest.slide", way, 0.5 * pull * t * t, 1e-11, {"g", k_gravity},
                       {"\\theta", slope.angle}, {"\\mu", mu}, {"t", t});
        CHECK_TWIN("rest.slide", way, pull * t * t, 1e-11);
    }
}



TEST_CASE("a block sticks and stands up to the limits on paper")
{
    for (const double tangent : {0.25, 0.5}) {
        const double mu = limit_of(1.0, 0.01, 30, [&](double friction) {
            return left_on_slope(tangent, friction) == Fate::lies;
        });
        CHECK_EQUATION("rest.stick", mu, tangent, 1e-8, {"\\theta", std::atan(tangent)});
        CHECK_TWIN("rest.stick", mu, std::sin(std::atan(tangent)), 1e-8);
    }
    for (const double width : {0.4, 0.7}) {
        const double steep = limit_of(0.1, 1.5, 30, [&](double tangent) {
            return left_on_slope(tangent, 5.0, width) == Fate::lies;
        });
        CHECK_EQUATION("rest.tip", steep, width / 1.0, 1e-8, {"w", width}, {"h", 1.0});
        CHECK_TWIN("rest.tip", steep, width / 2.0, 1e-8);
    }
}


// [rest.tests.weights]
TEST_CASE("every box bears the weights above it")
{
    const int n = 10;
    RestEngine engine(stack(n));
    engine.advance(10.0);
    std::map<int, double> force;
    for (const RestContact& contact : engine.contacts())
        force[contact.b] += contact.normal_force;
    for (int k = 1; k <= n; ++k) {
        const double above = (n - k + 1) * k_gravity;
        CHECK_EQUATION("rest.weights", force[k], above, 1e-12, {"n", n}, {"k", k},
                       {"m", 1.0}, {"g", k_gravity});
        CHECK_TWIN("rest.weights", force[k], above - k_gravity, 1e-12);
    }
}
// [rest.tests.weights]


TEST_CASE("of two equal bodies, each sweep leaves half of what was missing")
{
    const double fall = 0.1635;
    ColumnSweeps column({1.0, 1.0}, fall);
    for (int k = 1; k <= 40; ++k) {
        column.sweep_once();
        const double j = column.impulse(1);
        CHECK_EQUATION("rest.halves", j, fall * (1.0 - std::pow(0.5, k)), 1e-14,
                       {"m", 1.0}, {"g", 9.81}, {"d", fall / 9.81}, {"k", k});
        if (k > 30) continue; // the twin forgets a sweep, which has no more to give
        CHECK_TWIN("rest.halves", j, fall * (1.0 - std::pow(0.5, k + 1)), 1e-14);
    }
}

TEST_CASE("of a stack, each sweep leaves the square of a cosine")
{
    for (const int n : {2, 3, 5, 10, 20, 40}) {
        const double rate = rate_of_sweeps(std::vector<double>(n, 1.0), 3 * n * n);
        const double paper = std::pow(std::cos(std::numbers::pi / (2 * n)), 2);
        CHECK_EQUATION("rest.rate", rate, paper, 1e-4, {"n", n});
        const double c = std::cos(std::numbers::pi / (2 * n));
        CHECK_TWIN("rest.rate", rate, c * c * c, 1e-4);
    }
}

TEST_CASE("of a heavy body on a light one, each sweep leaves nearly everything")
{
    for (const double ratio : {1.0, 10.0, 100.0, 1000.0}) {
        const double rate = rate_of_sweeps({1.0, ratio}, 10);
        CHECK_EQUATION("rest.ratio", rate, ratio / (1.0 + ratio), 1e-9, {"M", ratio},
                       {"m", 1.0});
        CHECK_TWIN("rest.ratio", rate, ratio / (2.0 + ratio), 1e-9);
    }
}



TEST_CASE("the direct solve has all forces at once, whatever the height or the masses")
{
    for (const int n : {2, 20, 200}) {
        // What rounding leaves grows with the way that the load goes
        CHECK(solve_at_once(std::vector<double>(n, 1.0)).error < 1e-15 * n * n * n);
    }
    double worst = 0.0;
    for (const double ratio : {1e2, 1e4, 1e6})
        worst = std::max(worst, solve_at_once({1.0, ratio}).error / ratio);
    CHECK(worst < 1e-14);
    RECORD_VALUE("rest.direct.error", solve_at_once(std::vector<double>(100, 1.0)).error);
}



TEST_CASE("planks lie a millionth within the harmonic series, and fall a millionth beyond")
{
    for (int n = 1; n <= 5; ++n) {
        CHECK(planks_stand(n, 1.0 - 1e-6));
        CHECK(!planks_stand(n, 1.0 + 1e-6));
        // Where they end, by the places at which they were laid
        const std::vector<RestBody> bodies = planks(n, 1.0);
        const double reach = bodies[n].state.position.x() + 1.0;
        double paper = 0.0;
        for (int k = 1; k <= n; ++k) paper += 1.0 / k;
        CHECK_EQUATION("rest.overhang", reach, paper, 1e-15, {"L", 2.0}, {"n", n});
        CHECK_TWIN("rest.overhang", reach, paper + 0.5, 1e-15);
    }
}



TEST_CASE("a disc that was thrown rolls at two thirds of its speed")
{
    for (const double v : {1.0, 2.0, 3.0}) {
        for (const double mu : {0.2, 0.4}) {
            RestEngine engine = thrown_disc(v, mu);
            engine.advance(3.0);
            const double rolls = engine.state(1).velocity.x();
            CHECK_EQUATION("rest.roll", rolls, 2.0 / 3.0 * v, 1e-9, {"v", v});
            CHECK_TWIN("rest.roll", rolls, 0.5 * v, 1e-9);
        }
    }
}


// [rest.tests.rocking]
TEST_CASE("a block that rocks keeps what the angle of its diagonal says")
{
    for (const double width : {0.3, 0.5}) {
        const double kept = kept_by_stroke(width, 1.5, 1.0 / 240.0);
        const double angle = std::atan(width / 1.5);
        const double sine = std::sin(angle);
        CHECK_EQUATION("rest.rocking", kept, 1.0 - 1.5 * sine * sine, k_rocking,
                       {"\\alpha", angle});
        CHECK_TWIN("rest.rocking", kept, 1.0 - sine * sine, k_rocking);
    }
}
// [rest.tests.rocking]

// [rest.tests.leaves]
TEST_CASE("a disc flies off a smooth cylinder at two thirds of the cosine")
{
    for (const double start : {0.1, 0.3, 0.5}) {
        const SlideOff off = slide_off(start, 1.0 / 60.0);
        const double paper = 2.0 / 3.0 * std::cos(start);
        CHECK_EQUATION("rest.leaves", off.cosine, paper, k_leaves,
                       {"\\varphi_0", start});
        CHECK_TWIN("rest.leaves", off.cosine, 0.5 * std::cos(start), k_leaves);
        CHECK(std::abs(off.energy_change) < 2e-6);
    }
}

TEST_CASE("half the step leaves an eighth of the energy that the disc loses")
{
    const double whole = std::abs(slide_off(0.1, 1.0 / 60.0).energy_change);
    const double half = std::abs(slide_off(0.1, 1.0 / 120.0).energy_change);
    const double quarter = std::abs(slide_off(0.1, 1.0 / 240.0).energy_change);
    CHECK(std::abs(whole / half - 8.0) < 0.5);
    CHECK(std::abs(half / quarter - 8.0) < 0.5);
    RECORD_VALUE("rest.leaves.energy", whole);
    RECORD_VALUE("rest.leaves.energy.half", half);
    RECORD_VALUE("rest.leaves.energy.quarter", quarter);
}
// [rest.tests.leaves]

// [rest.tests.wrong_bounce]
TEST_CASE("bounced after the move, a body at rest sinks for ever")
{
    const double dt = 1.0 / 60.0;
    for (const double e : {0.125, 0.25, 0.5}) {
        Lying body;
        for (int k = 0; k < 600; ++k) move_then_bounce(body, k_gravity, dt, e);
        const double before = body.x;
        move_then_bounce(body, k_gravity, dt, e);
        const double speed = (before - body.x) / dt;
        CHECK_EQUATION("rest.sinks", speed, k_gravity * dt / (1.0 + e), 1e-9,
                       {"g", k_gravity}, {"d", dt}, {"e", e});
        CHECK_TWIN("rest.sinks", speed, k_gravity * dt, 1e-9);
    }
}
// [rest.tests.wrong_bounce]


TEST_CASE("pushed out by its overlap a body never lies still: the engine's does, to the bit")
{
    const double dt = 1.0 / 60.0;
    Lying body;
    double fastest = 0.0;
    RestOptions options;
    options.sleeps = false;
    RestEngine engine(stack(1), options);
    const std::uint64_t start = engine.hash();
    for (int k = 0; k < 36000; ++k) {
        push_by_overlap(body, k_gravity, dt);
        engine.step();
        if (k >= 35990) fastest = std::max(fastest, std::abs(body.v));
        REQUIRE(engine.hash() == start);
    }
    CHECK(fastest > k_gravity * dt);
    RECORD_VALUE("rest.push.fastest", fastest);
}

