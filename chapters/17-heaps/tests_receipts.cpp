#include <cmath>
#include <limits>

#include <doctest/doctest.h>

#include "heap.hpp"
#include "rest/island_solver.hpp"
#include "rest/rest_tolerance.hpp"
#include "rest/sweeps.hpp"
#include "support/receipts.hpp"
#include "wrong_heap.hpp"

using namespace flying;
using namespace flying::test;

namespace {

/// Of what gravity gives in a step: a heap is stopped that changes by no more.
constexpr double k_stopped = 1.0 / 256.0;

/// The worst error that is left of a load of a column, by turns and by as many sweeps.
struct LeftOfColumn
{
    double by_turns;
    double by_sweeps;
};

LeftOfColumn left_of_column(const std::vector<double>& masses)
{
    Column column = column_of(masses, 1.0);
    IslandSolver().solve_by_turns(column.movers, column.members, column.points, 0.0, rest_tolerance::k_more_sweeps);
    LeftOfColumn left{worst_error(column.points, weights_above(masses, 1.0)), 1.0};
    ColumnSweeps swept(masses);
    for (int k = 0; k < rest_tolerance::k_more_sweeps; ++k) left.by_sweeps = swept.sweep_once();
    return left;
}

} // namespace

TEST_CASE("a ring doubles its blocks, less three, when it is eliminated")
{
    for (int n = 5; n <= 60; ++n) {
        CHECK_EQUATION("heaps.ring", blocks_of(n, ring_of(n)), 2 * n - 3, 0.0, {"n", n});
        CHECK_TWIN("heaps.ring", blocks_of(n, ring_of(n)), 2 * n - 2, 0.0);
        CHECK(blocks_of(n, chain_of(n)) == n - 1);
    }
}

TEST_CASE("blocks are those that elimination on paper counts, but for ties in the order")
{
    for (const int n : {5, 20, 100}) {
        CHECK(blocks_by_hand(n, chain_of(n)).blocks == n - 1);
        CHECK(blocks_by_hand(n, ring_of(n)).blocks == 2 * n - 3);
    }
    for (const int base : {4, 10, 20}) {
        const int count = base * (base + 1) / 2;
        const int engine = blocks_of(count, pyramid_of(base));
        const int paper = blocks_by_hand(count, pyramid_of(base)).blocks;
        // Neither order is the best; each has its own ties
        CHECK(std::abs(engine - paper) < 0.2 * paper);
        CHECK(engine >= static_cast<int>(pyramid_of(base).size()));
    }
}

// [heaps.tests.row]
TEST_CASE("the last ball of a row leaves as if each pair met alone, on a floor too")
{
    const double v = 2.0;
    for (const int n : {2, 5, 12, 13, 40}) {
        for (const double e : {0.9, 0.95, 1.0}) {
            RestEngine engine = row_of_balls(n, v, e);
            engine.step();
            const double u = engine.state(n).velocity.x();
            CHECK_EQUATION("heaps.row", u, v * std::pow(0.5 * (1.0 + e), n - 1), 1e-12, {"n", n}, {"v", v}, {"e", e});
            if (e == 1.0) continue; // whatever the power, nothing is lost
            CHECK_TWIN("heaps.row", u, v * std::pow(0.5 * (1.0 + e), n), 1e-12);
        }
    }
}
// [heaps.tests.row]

TEST_CASE("the share of the impulses that acts is where no energy is gained")
{
    Random random(1711);
    for (int k = 0; k < 100; ++k) {
        const double v = random.uniform(-1.0, 1.0);
        const double f = random.uniform(-0.3, -0.05);
        const double c = random.uniform(0.5, 3.0);
        // With no impulses energy is lost, with ten times what is needed it is gained
        double low = 0.0;
        double high = 10.0;
        for (int i = 0; i < 60; ++i) {
            const double s = 0.5 * (low + high);
            const double end = v + f + s * c;
            (0.5 * end * end - 0.5 * v * v - f * end < 0.0 ? low : high) = s;
        }
        const double paper = (std::sqrt(v * v + f * f) - v) / c;
        CHECK_EQUATION("heaps.share", low, paper, 1e-10, {"v", v}, {"f", f}, {"c", c});
        CHECK_TWIN("heaps.share", low, (std::sqrt(v * v + f * f) + v) / c, 1e-10);
    }
}

TEST_CASE("two discs that overlap part by their masses")
{
    const double deep = 0.01;
    for (const double m_b : {0.5, 1.0, 4.0, 20.0}) {
        std::vector<RestBody> bodies = {disc(0.5, Vec2(0.0, 0.0), 1.0, {}), disc(0.5, Vec2(1.0 - deep, 0.0), m_b, {})};
        for (RestBody& body : bodies) body.acceleration = Vec2::Zero();
        RestEngine engine(bodies);
        engine.step();
        const double way = -engine.state(0).position.x();
        CHECK_EQUATION("heaps.apart", way, deep * m_b / (1.0 + m_b), 1e-9, {"\\delta", deep}, {"m_a", 1.0},
                       {"m_b", m_b});
        if (m_b != 1.0) CHECK_TWIN("heaps.apart", way, deep / (1.0 + m_b), 1e-9);
        CHECK(engine.state(0).velocity.isZero(0.0));
    }
}

TEST_CASE("the list of pairs is made anew when a box may be left, and no sooner")
{
    RestOptions options;
    for (const double r : {0.25, 1.0}) {
        for (const double v : {0.07, 0.3, 1.1, 5.0}) {
            RestBody flyer = disc(r, Vec2::Zero(), 1.0, {});
            flyer.acceleration = Vec2::Zero();
            flyer.state.velocity = Vec2(v, 0.0);
            RestEngine engine({flyer}, options);
            std::vector<int> searched; // steps that began with a search
            for (int k = 0; searched.size() < 4; ++k) {
                const auto before = engine.counts().looks;
                engine.step();
                if (engine.counts().looks > before) searched.push_back(k);
            }
            const double every = searched[3] - searched[2];
            const double room = r / (32.0 * v * options.step);
            CHECK_EQUATION("heaps.looks", every, 3.0 + std::floor(room), 0.0, {"r", r}, {"v", v}, {"d", options.step});
            CHECK_TWIN("heaps.looks", every, 2.0 + std::floor(room), 0.0);
        }
    }
}

TEST_CASE("a swept heap that would speed up by less than a share of gravity doesn't start")
{
    double low = 0.0;
    double high = 0.1;
    for (int k = 0; k < 30; ++k) {
        const double middle = 0.5 * (low + high);
        (stays_put(middle) ? low : high) = middle;
    }
    CHECK_EQUATION("heaps.calm", low * k_gravity, k_gravity / 256.0, 1e-8, {"g", k_gravity});
    CHECK_TWIN("heaps.calm", low * k_gravity, k_gravity / 128.0, 1e-8);
}

// [heaps.tests.weight]
TEST_CASE("what floor and walls bear of a heap at rest is its weight")
{
    double worst = 0.0;
    for (const int n : {80, 100, 120, 250}) {
        RestEngine engine(over_a_pit(n));
        time_to_sleep(engine, 30.0);
        const Weighed weighed = weigh(engine);
        const double mean = weighed.weight / (n * k_gravity);
        CHECK_EQUATION("heaps.weight", weighed.borne, weighed.weight, k_stopped, {"n", n}, {"m", mean},
                       {"g", k_gravity});
        // In a larger heap, the price of standing still would hide a missing disc
        const double missing = weighed.weight * (n - 1) / n;
        if (2.0 * k_stopped * n < 1.0) CHECK_TWIN("heaps.weight", weighed.borne, missing, k_stopped);
        worst = std::max(worst, std::abs(weighed.borne / weighed.weight - 1.0));
    }
    RECORD_VALUE("heaps.weight.off", worst);
}
// [heaps.tests.weight]

// [heaps.tests.settles]
TEST_CASE("a heap that is poured never gains energy, sleeps, and hasn't sunk")
{
    RestEngine engine(over_a_pit(200));
    double before = energy(engine);
    const double scale = before;
    double deepest = 0.0; // [radii of the smallest]
    while (engine.time() < 20.0) {
        engine.step();
        const double now = energy(engine);
        CHECK(now - before <= 1e-13 * scale);
        before = now;
    }
    for (const RestContact& c : engine.contacts()) deepest = std::max(deepest, -c.gap / 0.3);
    for (int k = 3; k < engine.body_count(); ++k) CHECK((engine.is_asleep(k) || rolls(engine, k)));
    CHECK(deepest < 0.01);
    RECORD_VALUE("heaps.deepest", deepest);
}
// [heaps.tests.settles]

TEST_CASE("with sleep and without, a heap has the same bits")
{
    RestOptions awake;
    awake.sleeps = false;
    RestEngine one(over_a_pit(120));
    RestEngine other(over_a_pit(120), awake);
    one.advance(8.0);
    other.advance(8.0);
    CHECK(one.hash() == other.hash());
    CHECK(one.counts().asleep > 0);
}

// [heaps.tests.wide]
TEST_CASE("wide sweeps have the bits of plain ones in the order of the batches")
{
    Random random(1721);
    for (const int base : {3, 9, 20}) {
        // Boxes of random masses, and contacts of any direction where a pyramid has some
        std::vector<Mover> movers = {{}};
        std::vector<int> members;
        std::vector<ContactPoint> points;
        for (int k = 0; k < base * (base + 1) / 2; ++k) {
            movers.push_back({random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0),
                              random.uniform(0.5, 2.0), random.uniform(0.5, 2.0)});
            members.push_back(k + 1);
        }
        Pairs pairs = pyramid_of(base);
        for (int k = 0; k < base; ++k) pairs.emplace_back(-1, k);
        for (const auto& [a, b] : pairs) {
            ContactPoint c;
            c.a = a + 1;
            c.b = b + 1;
            c.pair = static_cast<int>(points.size());
            c.n_x = 0.6;
            c.n_y = 0.8;
            c.normal_arm_a = c.tangent_arm_b = random.uniform(-0.5, 0.5);
            c.normal_arm_b = c.tangent_arm_a = random.uniform(-0.5, 0.5);
            c.normal_mass = c.tangent_mass = 0.25;
            c.friction = 0.5;
            points.push_back(c);
        }
        SweepBatches batches;
        batches.lay_out(points, movers, members);
        batches.sweep_ahead({1, 1, 0.0});
        std::vector<ContactPoint> plain;
        for (const int k : batches.order()) plain.push_back(points[k]);
        sweep(plain, movers);
        batches.get_impulses(points);
        int bearing = 0;
        for (std::size_t k = 0; k < plain.size(); ++k) {
            CHECK(points[batches.order()[k]].normal == plain[k].normal);
            CHECK(points[batches.order()[k]].tangent == plain[k].tangent);
            bearing += plain[k].normal > 0.0 ? 1 : 0;
        }
        CHECK(bearing > base);
    }
}
// [heaps.tests.wide]

TEST_CASE("sweeps that look back take about twice as many for twice the height")
{
    const int low = sweeps_looking_back(20, 0.01);
    const int high = sweeps_looking_back(80, 0.01);
    const double growth = std::sqrt(static_cast<double>(high) / low);
    CHECK(growth < 2.5);
    CHECK(sweeps_until(std::vector<double>(40, 1.0), 0.01) > 10 * sweeps_looking_back(40, 0.01));
    RECORD_VALUE("heaps.back.growth", growth);
}

TEST_CASE("all at once, a body on some points is pushed as often as it has points")
{
    const double fall = k_gravity / 60.0;
    for (int k = 1; k <= 5; ++k) {
        OnPoints body = on_points(k, fall);
        sweep_at_once(body.points, body.movers);
        double sum = 0.0;
        for (const ContactPoint& c : body.points) sum += c.normal;
        CHECK_EQUATION("heaps.at_once", sum, k * fall, 1e-15, {"k", k}, {"m", 1.0}, {"g", k_gravity},
                       {"d", fall / k_gravity});
        CHECK_TWIN("heaps.at_once", sum, (k + 1) * fall, 1e-15);
    }
}

TEST_CASE("a round by turns leaves so much of what impulses lack")
{
    const double kappa = rest_tolerance::k_soft_stiffness;
    const double alpha = rest_tolerance::k_over_relaxation;
    const double fall = k_gravity / 60.0;
    for (int k = 1; k <= 5; ++k) {
        for (const double lacks : {0.1, 0.5, 0.9}) {
            OnPoints body = on_points(k, fall);
            for (ContactPoint& c : body.points) c.normal = (1.0 - lacks) * fall / k;
            const std::vector<int> members = {1};
            IslandSolver().solve_by_turns(body.movers, members, body.points, 0.0, 1);
            double sum = 0.0;
            for (const ContactPoint& c : body.points) sum += c.normal;
            const double left = 1.0 - sum / fall;
            const double paper = lacks * (1.0 - alpha * k * kappa / (1.0 + k * kappa));
            CHECK_EQUATION("heaps.turn", left, paper, 4e-13, {"k", k}, {"\\varepsilon", lacks}, {"\\kappa", kappa},
                           {"\\alpha", alpha});
            CHECK_TWIN("heaps.turn", left, lacks * (1.0 - k * kappa / (1.0 + k * kappa)), 4e-13);
        }
    }
    RECORD_VALUE("heaps.turn.kappa", kappa);
}

TEST_CASE("by turns, a point that won't close bears nothing, and the others bear for it")
{
    const double fall = k_gravity / 60.0;
    OnPoints body = on_points(3, fall);
    body.points[1].bound = -std::numeric_limits<double>::infinity();
    for (ContactPoint& c : body.points) c.normal = fall / 3.0;
    const std::vector<int> members = {1};
    IslandSolver().solve_by_turns(body.movers, members, body.points, 0.0, rest_tolerance::k_more_sweeps);
    CHECK(body.points[1].normal == 0.0);
    CHECK(std::abs(body.points[0].normal + body.points[2].normal - fall) < 1e-14);
    CHECK(std::abs(body.movers[1].v_y) < 1e-14);
}

TEST_CASE("in a high column, and under heavy boxes, rounds by turns get much further than sweeps")
{
    const LeftOfColumn high = left_of_column(std::vector<double>(40, 1.0));
    CHECK(high.by_turns < 1e-3 * high.by_sweeps);
    std::vector<double> masses(5, 1.0);
    masses.resize(10, 100.0);
    const LeftOfColumn heavy = left_of_column(masses);
    CHECK(heavy.by_turns < 0.1 * heavy.by_sweeps);
    RECORD_VALUE("heaps.turn.rounds", rest_tolerance::k_more_sweeps);
    RECORD_VALUE("heaps.turn.high", high.by_turns);
    RECORD_VALUE("heaps.turn.high.swept", 100.0 * high.by_sweeps);
    RECORD_VALUE("heaps.turn.heavy", 100.0 * heavy.by_turns);
    RECORD_VALUE("heaps.turn.heavy.swept", 100.0 * heavy.by_sweeps);
}
