#include <array>
#include <cmath>
#include <numbers>

#include <doctest/doctest.h>

#include "response/impacts_at_once.hpp"
#include "response/one_point.hpp"
#include "response/several_points.hpp"
#include "strikes.hpp"
#include "support/receipts.hpp"
#include "support/impacts.hpp"
#include "wrong_impulse.hpp"

using namespace impacts;
using flying::PairInertia;
using flying::PairMotion;
using flying::PointFrame;
using flying::PointImpulse;
using flying::PointResponse;

namespace {

// A pair that has met at a point, with all that the formulas ask for
struct Meeting
{
    Pair pair;
    ImpactPoint point;
    PointFrame frame;
    PairMotion motion;
    PairInertia inertia;
};

Meeting random_meeting(flying::Random& random)
{
    Meeting m;
    m.pair = random_pair(random, 30.0);
    m.pair.a.inertia = {spread(random, 0.1, 10.0), spread(random, 0.1, 10.0)};
    const Vec2 r_a = in_square(random, 1.0);
    const Vec2 r_b = in_square(random, 1.0);
    m.point = {r_a, r_b, unit(random.uniform(0.0, 6.28))};
    m.frame = flying::frame_at(m.point);
    m.motion = {m.pair.a.velocity, m.pair.b.velocity, m.pair.a.spin, m.pair.b.spin};
    m.inertia = {m.pair.a.inertia, m.pair.b.inertia};
    return m;
}

} // namespace


TEST_CASE("the normal speed is that of one point seen from the other")
{
    flying::Random random(722);
    for (int i = 0; i < 1000; ++i) {
        const Meeting m = random_meeting(random);
        const double engine = flying::speed_along(m.frame.normal, m.motion);

        // The oracle subtracts the velocities of the two points, and knows no arms
        const double direct = normal_speed(m.pair.a, m.pair.b, m.point);
        CHECK_EQUATION_SCALED("impulse.speed", engine, direct, 8.0, 1e-15, {"v_{ax}", m.motion.velocity_a.x()},
                              {"v_{ay}", m.motion.velocity_a.y()}, {"v_{bx}", m.motion.velocity_b.x()},
                              {"v_{by}", m.motion.velocity_b.y()}, {"\\omega_a", m.motion.spin_a},
                              {"\\omega_b", m.motion.spin_b}, {"n_x", m.point.normal.x()}, {"n_y", m.point.normal.y()},
                              {"c_a", flying::cross(m.point.r_a, m.point.normal)},
                              {"c_b", flying::cross(m.point.r_b, m.point.normal)});
        if (m.motion.velocity_a == Vec2(0.0, 0.0)) continue; // a wall: the twin forgets what is not there
        CHECK_TWIN_SCALED("impulse.speed", engine, direct + m.motion.velocity_a.dot(m.point.normal), 8.0, 1e-15);
    }
}


TEST_CASE("a push of one newton-second changes the normal speed by the inverse mass")
{
    flying::Random random(723);
    for (int i = 0; i < 1000; ++i) {
        const Meeting m = random_meeting(random);
        const double m_a = 1.0 / m.inertia.a.inv_mass;
        const double m_b = 1.0 / m.inertia.b.inv_mass;
        const double i_a = 1.0 / m.inertia.a.inv_moment_of_inertia;
        const double i_b = 1.0 / m.inertia.b.inv_moment_of_inertia;
        // [impulse.tests.mass]
        const double c_a = flying::cross(m.point.r_a, m.point.normal);
        const double c_b = flying::cross(m.point.r_b, m.point.normal);
        const double w_n = flying::inverse_mass(m.frame.normal, m.inertia);
        const double sum = 1 / m_a + 1 / m_b + c_a * c_a / i_a + c_b * c_b / i_b;
        CHECK_EQUATION("impulse.inverse_mass", w_n, sum, 3e-15, {"m_a", m_a}, {"m_b", m_b},
                       {"I_a", i_a}, {"I_b", i_b}, {"c_a", c_a}, {"c_b", c_b});
        CHECK_TWIN("impulse.inverse_mass", w_n,
                   1 / m_a + 1 / m_b + c_a * c_a / m_a + c_b * c_b / i_b, 3e-15);

        // The same from motion: push and look
        flying::PairPush push;
        push.add(m.frame.normal, 1.0);
        const PairMotion after = flying::pushed(m.motion, push, m.inertia);
        const double gain = flying::speed_along(m.frame.normal, after) -
                            flying::speed_along(m.frame.normal, m.motion);
        CHECK(std::abs(gain - w_n) <= 16.0 * k_epsilon * (8.0 + w_n));
        // [impulse.tests.mass]
        const double before = m.motion.spin_b;
        const double spin = before + c_b / i_b;
        CHECK_EQUATION_SCALED("impulse.spin_b", after.spin_b, spin,
                              1.0 + std::abs(c_b / i_b), 2e-15, {"\\omega_b", before},
                              {"c_b", c_b}, {"j", 1.0}, {"I_b", i_b});
        CHECK_TWIN_SCALED("impulse.spin_b", after.spin_b, before - c_b / i_b,
                          1.0 + std::abs(c_b / i_b), 2e-15);
        const double v = m.motion.velocity_b.x();
        const double n_x = m.point.normal.x();
        const double size = 1.0 + 1.0 / m_b;
        CHECK_EQUATION_SCALED("impulse.velocity_b", after.velocity_b.x(), v + n_x / m_b,
                              size, 2e-15, {"v_{bx}", v}, {"n_x", n_x}, {"j", 1.0},
                              {"m_b", m_b});
        CHECK_TWIN_SCALED("impulse.velocity_b", after.velocity_b.x(), v - n_x / m_b, size,
                          2e-15);
    }
}

TEST_CASE(
    "the impulse turns the approach round, e times as fast, and loses what that costs")
{
    flying::Random random(724);
    int struck = 0;
    for (int i = 0; i < 2000; ++i) {
        const Meeting m = random_meeting(random);
        const double v_n = flying::speed_along(m.frame.normal, m.motion);
        if (v_n > -0.01) continue;
        ++struck;
        const double e = random.uniform();
        const double w_n = flying::inverse_mass(m.frame.normal, m.inertia);
        // [impulse.tests.newton]
        const ImpactResult after =
            flying::resolve_impact(m.pair.a, m.pair.b, {&m.point, 1}, {e, 0.0});
        const Vec2 gained = after.velocity_b - m.pair.b.velocity;
        const double j = gained.dot(m.point.normal) / m.pair.b.inertia.inv_mass;

        // Rounding has its share of all speeds at hand
        const double speeds = speed_scale(m.pair.a, m.pair.b, after, m.point);
        const double momenta = speeds / m.pair.b.inertia.inv_mass;
        CHECK_EQUATION_SCALED("impulse.normal", j, (1 + e) * -v_n / w_n, momenta, 4e-15,
                              {"e", e}, {"v_n", v_n}, {"w_n", w_n});
        CHECK_TWIN_SCALED("impulse.normal", j, (1 + e * e) * -v_n / w_n, momenta, 4e-15);
        CHECK(std::abs(normal_speed(after, m.point) + e * v_n) <= 4e-15 * speeds);
        // [impulse.tests.newton]

        const real before = energy(m.pair.a, m.pair.b);
        const double change =
            static_cast<double>(energy(m.pair.a, m.pair.b, after) - before);
        const double all = static_cast<double>(before) + j * j * w_n;
        CHECK_EQUATION_SCALED("impulse.energy", change, v_n * j + w_n * j * j / 2, all,
                              4e-15, {"v_n", v_n}, {"j", j}, {"w_n", w_n});
        CHECK_TWIN_SCALED("impulse.energy", change, v_n * j + w_n * j * j, all, 4e-15);
        const double lost = -(1 - e * e) * v_n * v_n / (2 * w_n);
        CHECK_EQUATION_SCALED("impulse.lost", change, lost, all, 4e-15, {"e", e},
                              {"v_n", v_n}, {"w_n", w_n});
        CHECK_TWIN_SCALED("impulse.lost", change, -(1 - e) * v_n * v_n / (2 * w_n), all,
                          4e-15);
    }
    CHECK(struck > 500);
}

// [impulse.tests.disc]
TEST_CASE("a disc on the floor loses the slip that the cone can take")
{
    flying::Random random(725);
    for (int i = 0; i < 1000; ++i) {
        const double slip = random.uniform(0.0, 8.0);
        const Material rough{random.uniform(), random.uniform(0.05, 1.0)};
        const double e = rough.restitution;
        const double mu = rough.friction;
        const ImpactResult after = flying::strike_floor(slip, rough);
        const double left = after.velocity_b.x() + after.spin_b;
        const double closed = std::max(0.0, slip - 3 * mu * (1 + e));
        CHECK_EQUATION_SCALED("impulse.disc", left, closed, 8.0, 1e-15, {"v_t", slip},
                              {"\\mu", mu}, {"e", e}, {"v_n", -1.0});
        if (closed == 0.0) continue;
        CHECK_TWIN_SCALED("impulse.disc", left, std::max(0.0, slip - 2 * mu * (1 + e)), 8.0,
                          1e-15);
    }
    RECORD_VALUE("impulse.disc.threshold", 3 * 0.5 * (1 + 1.0) * 1.0);
}
// [impulse.tests.disc]


TEST_CASE("where the slip outlasts the impact, the impulse has one rate")
{
    flying::Random random(726);
    int slipping = 0;
    for (int i = 0; i < 4000; ++i) {
        const Meeting m = random_meeting(random);
        const PointResponse w = flying::response_at(m.frame, m.inertia);
        const double direct = w.w_n * w.w_t - w.w_nt * w.w_nt;
        CHECK(std::abs(w.determinant - direct) <= 8.0 * k_epsilon * w.w_n * w.w_t);

        // Push along both lines and look at both speeds
        const double n = flying::speed_along(m.frame.normal, m.motion);
        const double t = flying::speed_along(m.frame.tangent, m.motion);
        flying::PairPush push;
        push.add(m.frame.normal, 0.7);
        push.add(m.frame.tangent, -0.3);
        const PairMotion moved = flying::pushed(m.motion, push, m.inertia);
        const double size = 8.0 + w.w_n + w.w_t;
        const double n_after = flying::speed_along(m.frame.normal, moved);
        const double t_after = flying::speed_along(m.frame.tangent, moved);
        CHECK_EQUATION_SCALED("impulse.coupled_n", n_after, n + w.w_n * 0.7 - w.w_nt * 0.3, size, 2e-15, {"v_n", n},
                              {"w_n", w.w_n}, {"j", 0.7}, {"w_{nt}", w.w_nt}, {"q", -0.3});
        CHECK_TWIN_SCALED("impulse.coupled_n", n_after, n + w.w_n * 0.7 + w.w_nt * 0.3, size, 2e-15);
        CHECK_EQUATION_SCALED("impulse.coupled_t", t_after, t + w.w_nt * 0.7 - w.w_t * 0.3, size, 2e-15, {"v_t", t},
                              {"w_t", w.w_t}, {"j", 0.7}, {"w_{nt}", w.w_nt}, {"q", -0.3});
        CHECK_TWIN_SCALED("impulse.coupled_t", t_after, t - w.w_nt * 0.7 - w.w_t * 0.3, size, 2e-15);

        const double v_t = random.uniform(-9.0, 9.0);
        const double s = v_t > 0.0 ? 1.0 : -1.0;
        const double e = random.uniform();
        const double mu = random.uniform(0.05, 0.5);
        const double k = w.w_n - s * mu * w.w_nt;
        const double j = (1 + e) / k;
        const bool goes_on = k > 0.01 * w.w_n && s * (v_t + (w.w_nt - s * mu * w.w_t) * j) > 0.01;
        if (!goes_on) continue;
        ++slipping;
        const PointImpulse p = flying::one_point_impulse(w, -1.0, v_t, {e, mu});
        CHECK_EQUATION("impulse.slipping", p.normal, j, 1e-14, {"e", e}, {"v_n", -1.0}, {"w_n", w.w_n}, {"s", s},
                       {"\\mu", mu}, {"w_{nt}", w.w_nt});
        CHECK_TWIN("impulse.slipping", p.normal, (1 + e) / (k + 2 * s * mu * w.w_nt), 1e-14);
        CHECK(std::abs(p.tangent + s * mu * j) <= 1e-14 * mu * j);
    }
    CHECK(slipping > 500);
}



TEST_CASE("where the slip ends during compression, e squared of the work comes back")
{
    flying::Random random(727);
    int cases = 0;
    for (int i = 0; i < 20'000; ++i) {
        const Meeting m = random_meeting(random);
        const PointResponse w = flying::response_at(m.frame, m.inertia);
        const double v_t = random.uniform(0.1, 1.0);
        const double e = random.uniform();
        const double mu = random.uniform(0.3, 2.0);
        const double brake = mu * w.w_t - w.w_nt;
        const bool sticks = std::abs(w.w_nt) < mu * w.w_t;
        if (!sticks || brake < 0.01 * w.w_t || w.determinant < 0.01 * w.w_n * w.w_t) continue;
        const double j_s = v_t / brake;
        const double v_s = -1.0 + (w.w_n - mu * w.w_nt) * j_s;
        if (v_s > -0.1) continue;
        ++cases;

        // Triangle and trapezium under the line of the normal speed, each half base times height
        const double kappa = w.determinant / w.w_t;
        const double work = v_s * v_s / (2 * kappa) - (v_s - 1.0) * j_s / 2;
        const double out = e * std::sqrt(2 * kappa * work);
        const double j = j_s + (out - v_s) / kappa;
        const PointImpulse p = flying::one_point_impulse(w, -1.0, v_t, {e, mu});
        CHECK_EQUATION("impulse.stronge", p.normal, j, 1e-12, {"j_s", j_s}, {"v_s", v_s}, {"e", e}, {"v_n", -1.0},
                       {"\\kappa", kappa});
        CHECK_TWIN("impulse.stronge", p.normal, j_s + (e - v_s) / kappa, 1e-12);
        CHECK_EQUATION("impulse.slip_end", (p.normal - (out - v_s) / kappa) * brake, v_t, 1e-10, {"\\mu", mu},
                       {"w_t", w.w_t}, {"s", 1.0}, {"w_{nt}", w.w_nt}, {"j_s", j_s}, {"v_t", v_t});
        CHECK_TWIN("impulse.slip_end", (p.normal - (out - v_s) / kappa) * (mu * w.w_t + w.w_nt), v_t, 1e-10);
    }
    CHECK(cases > 500);
}



TEST_CASE("five balls in a row: both laws keep the momentum, and at e = 1 the energy")
{
    const flying::Row start{1.0, 0.0, 0.0, 0.0, 0.0};
    for (int i = 0; i <= 30; ++i) {
        const double e = 0.7 + 0.01 * i;
        const flying::Row turn = flying::struck_in_turn(start, e);
        const flying::Row once = flying::struck_at_once(start, e);
        CHECK_EQUATION("impulse.row_turn", turn[4], std::pow((1 + e) / 2, 4), 4e-15, {"v_1", 1.0}, {"e", e});
        if (i < 30) CHECK_TWIN("impulse.row_turn", turn[4], std::pow((1 + e) / 2, 5), 4e-15);
        CHECK_EQUATION("impulse.row_once", once[4], (1 + e) / 5, 4e-15, {"v_1", 1.0}, {"e", e});
        CHECK_TWIN("impulse.row_once", once[4], (1 + e) / 4, 4e-15);
        for (const flying::Row& row : {turn, once}) {
            double momentum = 0.0;
            double energy = 0.0;
            for (const double v : row) momentum += v, energy += v * v;
            CHECK(std::abs(momentum - 1.0) < 16.0 * k_epsilon);
            CHECK(energy < 1.0 + 16.0 * k_epsilon);
            if (i == 30) CHECK(energy > 1.0 - 16.0 * k_epsilon);
        }
    }
}



TEST_CASE("a ball that meets two at once pushes both alike")
{
    for (int i = 0; i <= 40; ++i) {
        const double e = 0.025 * i;
        const double alpha = 0.2 + 0.03 * i;
        const double m = 0.2 + 0.1 * i;
        const double u = 3.0;
        const Vec2 up(std::cos(alpha), std::sin(alpha));
        const Vec2 down(up.x(), -up.y());
        std::vector<flying::ImpactBody> bodies = {
            {Vec2(u, 0.0), 0.0, {1.0, 2.0}}, {Vec2::Zero(), 0.0, {1.0 / m, 2.0 / m}}, {Vec2::Zero(), 0.0, {1.0 / m, 2.0 / m}}};
        const std::vector<flying::ImpactPoint> points = {{up, -up, up}, {down, -down, down}};
        const std::vector<flying::ImpactPair> pairs = {{0, 1, 0, 1, {e, 0.0}}, {0, 2, 1, 2, {e, 0.0}}};
        const std::vector<double> slowest(2, 1e-12);
        flying::resolve_impacts(bodies, pairs, points, slowest, 2);
        const double cosine = std::cos(alpha);
        const double p = (1.0 + e) * m * u * cosine / (1.0 + 2.0 * m * cosine * cosine);
        CHECK_EQUATION("impulse.two_at_once", m * bodies[1].velocity.norm(), p, 1e-13, {"M", 1.0}, {"m", m}, {"u", u}, {"e", e}, {"\\alpha", alpha});
        CHECK_TWIN("impulse.two_at_once", m * bodies[1].velocity.norm(), (1.0 + e) * m * u * cosine / (1.0 + m), 1e-13);
        CHECK(std::abs(bodies[1].velocity.y() + bodies[2].velocity.y()) < 1e-14);
        CHECK(std::abs(bodies[0].velocity.y()) < 1e-14);
    }
}

TEST_CASE("a block that rocks from one corner to the other keeps what the angle of its diagonal leaves")
{
    for (int i = 1; i <= 50; ++i) {
        const double a = 0.01 * i;
        const double w = std::sin(a);
        const double h = std::cos(a);
        const double spin = -0.8;

        // It turned about the left corner, which rests; the right one comes down
        const std::array<ImpactPoint, 2> corners{{{{-w, 0.0}, {-w, -h}, {0.0, 1.0}}, {{w, 0.0}, {w, -h}, {0.0, 1.0}}}};
        const ImpactBody block = body(1.0, 1.0 / 3.0, -flying::cross(spin, corners[0].r_b), spin);
        const ImpactResult after = flying::resolve_impact(k_wall, block, corners, {0.0, 10.0});
        CHECK_EQUATION("impulse.rocking", after.spin_b / spin, 1 - 1.5 * w * w, 32.0 * k_epsilon, {"\\alpha", a});
        CHECK_TWIN("impulse.rocking", after.spin_b / spin, 1 - 2 * w * w, 32.0 * k_epsilon);
    }
}


// [impulse.tests.wrong_two_e]
TEST_CASE("2 e in place of 1 + e is right at e = 1 alone: at e = 0 the ball goes through "
          "the wall")
{
    CHECK(flying::impulse_two_e(-1.0, 1.0, 1.0) == flying::newton_impulse(-1.0, 1.0, 1.0));
    CHECK(-1.0 + flying::impulse_two_e(-1.0, 1.0, 0.0) == -1.0);
    flying::Random random(728);
    for (int i = 0; i < 1000; ++i) {
        const double e = random.uniform(0.0, 0.99);
        const double w_n = spread(random, 0.1, 10.0);
        const double rebound = -1.0 + w_n * flying::newton_impulse(-1.0, w_n, e);
        const double wrong = -1.0 + w_n * flying::impulse_two_e(-1.0, w_n, e);
        CHECK(std::abs(rebound - e) <= 4.0 * k_epsilon);
        CHECK(std::abs(wrong - e) > 0.005); // off by 1 - e
    }
}
// [impulse.tests.wrong_two_e]

// [impulse.tests.wrong_no_test]
TEST_CASE("without a test of approach a body that leaves is thrown back, and its energy is "
          "none the wiser")
{
    const double v = 50.0;
    const double wrong = v + flying::impulse_without_test(v, 1.0, 1.0);
    CHECK(wrong == -50.0);
    CHECK(0.5 * wrong * wrong == 0.5 * v * v); // energy is kept, to the bit
    // Contact pulls: this finds it
    CHECK_FALSE(flying::impulse_without_test(v, 1.0, 1.0) >= 0.0);
    CHECK(flying::newton_impulse(v, 1.0, 1.0) == 0.0);
}
// [impulse.tests.wrong_no_test]

// [impulse.tests.wrong_one_body]
TEST_CASE("the velocity of one body alone makes the impulse depend on the observer")
{
    for (const double train : {0.0, 1.0, 3.0, 5.0}) {
        const double v_a = 3.0 - train;
        const double v_b = 0.0 - train;
        CHECK(flying::newton_impulse(v_b - v_a, 2.0, 1.0) == 3.0);
    }
    CHECK(flying::impulse_of_one_body(-1.0, 2.0, 1.0) !=
          flying::impulse_of_one_body(-5.0, 2.0, 1.0));
}
// [impulse.tests.wrong_one_body]
