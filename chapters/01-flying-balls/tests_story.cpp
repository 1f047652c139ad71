#include <cmath>

#include "math/random.hpp"
#include "motion/body.hpp"
#include "motion/flight.hpp"
#include "steppers.hpp"
#include "support/receipts.hpp"
#include "walls.hpp"

using namespace flying;
using namespace flying::steps;
using namespace flying::walls;

namespace {

constexpr double k_ulp = 0x1p-52;

} // namespace

TEST_CASE("a point of a turning body is where the turn puts it, and moves as its spin says")
{
    Random random(31);
    for (int k = 0; k < 1000; ++k) {
        BodyState body;
        body.position = Vec2{random.uniform(-5.0, 5.0), random.uniform(-5.0, 5.0)};
        body.velocity = Vec2{random.uniform(-5.0, 5.0), random.uniform(-5.0, 5.0)};
        body.angle = random.uniform(-9.0, 9.0);
        body.spin = random.uniform(-9.0, 9.0);
        const Vec2 r{random.uniform(-2.0, 2.0), random.uniform(-2.0, 2.0)};

        // Four roundings of terms no larger than the scale
        const Vec2 place = pose_of(body) * r;
        const Vec2 c = body.position;
        const double phi = body.angle;
        const double x = c.x() + r.x() * std::cos(phi) - r.y() * std::sin(phi);
        const double y = c.y() + r.x() * std::sin(phi) + r.y() * std::cos(phi);
        CHECK_EQUATION_SCALED("motion.turn.x", place.x(), x, 10.0, 2.0 * k_ulp,
                              {"c_x", c.x()}, {"r_x", r.x()}, {"r_y", r.y()},
                              {"\\varphi", phi});
        CHECK_TWIN_SCALED("motion.turn.x", place.x(), x + 2.0 * r.y() * std::sin(phi), 10.0,
                          2.0 * k_ulp);
        CHECK_EQUATION_SCALED("motion.turn.y", place.y(), y, 10.0, 2.0 * k_ulp,
                              {"c_y", c.y()}, {"r_x", r.x()}, {"r_y", r.y()},
                              {"\\varphi", phi});
        CHECK_TWIN_SCALED("motion.turn.y", place.y(), y - 2.0 * r.x() * std::sin(phi), 10.0,
                          2.0 * k_ulp);

        const Vec2 u = velocity_at(body, r);
        const Vec2 v = body.velocity;
        const double omega = body.spin;
        const auto u_x =
            static_cast<double>(v.x() - static_cast<long double>(omega) * r.y());
        const auto u_y =
            static_cast<double>(v.y() + static_cast<long double>(omega) * r.x());
        CHECK_EQUATION_SCALED("motion.point_velocity.x", u.x(), u_x, 20.0, k_ulp,
                              {"v_x", v.x()}, {"\\omega", omega}, {"r_y", r.y()});
        CHECK_TWIN_SCALED("motion.point_velocity.x", u.x(), v.x() + omega * r.y(), 20.0,
                          k_ulp);
        CHECK_EQUATION_SCALED("motion.point_velocity.y", u.y(), u_y, 20.0, k_ulp,
                              {"v_y", v.y()}, {"\\omega", omega}, {"r_x", r.x()});
        CHECK_TWIN_SCALED("motion.point_velocity.y", u.y(), v.y() - omega * r.x(), 20.0,
                          k_ulp);
    }
}

TEST_CASE("flight follows the closed form, and energy does not change on the way")
{
    Random random(32);
    for (int k = 0; k < 1000; ++k) {
        BodyState ball;
        ball.position.y() = random.uniform(-10.0, 10.0);
        ball.velocity.y() = random.uniform(-10.0, 10.0);
        const double g = random.uniform(-10.0, 10.0);
        const double t = random.uniform(0.0, 100.0);
        const BodyState after = flight(ball, Vec2(0.0, g), t);


        // Compare with 64 bits; the engine's value passes five roundings of terms below the
        // scale
        const long double y_0 = ball.position.y();
        const long double v_0 = ball.velocity.y();
        const double y = static_cast<double>(y_0 + v_0 * t + 0.5L * g * t * t);
        const double v = static_cast<double>(v_0 + static_cast<long double>(g) * t);
        const double far = 10.0 + 10.0 * t + 5.0 * t * t;
        CHECK_EQUATION_SCALED("flight.position", after.position.y(), y, far, 2.0 * k_ulp,
                              {"y_0", y_0}, {"v_0", v_0}, {"g", g}, {"t", t});
        CHECK_TWIN_SCALED("flight.position", after.position.y(), y + 0.1 * g * t * t, far,
                          2.0 * k_ulp);
        CHECK_EQUATION_SCALED("flight.velocity", after.velocity.y(), v, 10.0 + 10.0 * t,
                              k_ulp, {"v_0", v_0}, {"g", g}, {"t", t});
        CHECK_TWIN_SCALED("flight.velocity", after.velocity.y(), v + 0.1 * g * t,
                          10.0 + 10.0 * t, k_ulp);
        const auto energy = [g](const BodyState& b) {
            return 0.5 * b.velocity.squaredNorm() - g * b.position.y();
        };
        const double most = 50.0 * (1.0 + t) * (1.0 + t) + 10.0 * far;
        CHECK_EQUATION_SCALED("flight.energy", energy(after), energy(ball), most,
                              4.0 * k_ulp, {"v_0", v_0}, {"y_0", y_0}, {"g", g});
        CHECK_TWIN_SCALED("flight.energy", energy(after), energy(ball) - g * y, most,
                          4.0 * k_ulp);

    }
}

// ---- Walls
// ----------------------------------------------------------------------------------

TEST_CASE(
    "the time to a wall solves its equation, and a ball let go bounces with the period "
    "of its height")
{
    Random random(33);
    for (int k = 0; k < 1000; ++k) {
        const double d = random.uniform(0.1, 10.0);
        const double u = random.uniform(-10.0, 10.0);
        const double c = random.uniform(0.1, 10.0);
        const double t = time_to_cover(d, u, c);

        // The closed form cancels where u is large, the engine's way doesn't: compare with
        // 64 bits
        const long double square = static_cast<long double>(u) * u + 2.0L * c * d;
        const double closed = static_cast<double>((std::sqrt(square) - u) / c);
        const double scale = (std::abs(u) + static_cast<double>(std::sqrt(square))) / c;
        CHECK_EQUATION_SCALED("walls.time", t, closed, scale, 4.0 * k_ulp, {"u", u},
                              {"c", c}, {"d", d});
        CHECK_TWIN_SCALED("walls.time", t, closed + 0.1 * d / scale, scale, 4.0 * k_ulp);

        const double period = 2.0 * std::sqrt(2.0 * d / c);
        CHECK_EQUATION("walls.period", 2.0 * time_to_cover(d, 0.0, c), period, 4.0 * k_ulp,
                       {"d", d}, {"c", c});
        CHECK_TWIN("walls.period", 2.0 * time_to_cover(d, 0.0, c), 2.0 * std::sqrt(d / c),
                   4.0 * k_ulp);
    }
}

TEST_CASE("a wall takes no wall away: never reached, or left for good")
{
    CHECK(std::isinf(time_to_cover(1.0, -1.0, 0.0)));
    CHECK(std::isinf(time_to_cover(1.0, 1.0, -1.0)));
    CHECK(time_to_cover(1.0, 2.0, 0.0) == 0.5);
    CHECK(time_to_cover(0.0, -2.0, 4.0) == 1.0); // thrown up from the floor, and back
}

TEST_CASE("a reflection turns the part along the normal round and leaves the speed")
{
    Random random(34);
    for (int k = 0; k < 1000; ++k) {
        const Vec2 v{random.uniform(-10.0, 10.0), random.uniform(-10.0, 10.0)};
        const double angle = random.uniform(-3.0, 3.0);
        const Vec2 n = Rotation::of(angle) * Vec2(1.0, 0.0);
        const Vec2 after = reflected(v, n);
        const long double along = static_cast<long double>(v.x()) * n.x() +
                                  static_cast<long double>(v.y()) * n.y();
        const auto x = static_cast<double>(v.x() - 2.0L * along * n.x());
        CHECK_EQUATION_SCALED("walls.reflect", after.x(), x, 30.0, 2.0 * k_ulp,
                              {"v_x", v.x()}, {"v_y", v.y()}, {"n_x", n.x()},
                              {"n_y", n.y()});
        CHECK_TWIN_SCALED("walls.reflect", after.x(),
                          v.x() - (v.x() * n.x() + v.y() * n.y()) * n.x(), 30.0,
                          2.0 * k_ulp);

        // n has unit length to two roundings
        CHECK(std::abs(after.norm() - v.norm()) <= 8.0 * k_ulp * v.norm());
        CHECK(std::abs(after.dot(n) + v.dot(n)) <= 8.0 * k_ulp * v.norm());
    }
}


TEST_CASE("a disc between two walls is where a straight line is that is folded at them")
{
    // The centre runs between 0 and L, and so does the straight flight once it is folded
    const double L = 3.0;
    const auto walls = box_walls(Vec2(-0.5, -100.0), Vec2(3.5, 100.0), 0.5);
    Random random(35);
    double worst = 0.0;
    for (int k = 0; k < 200; ++k) {
        BodyState disc;
        disc.position = Vec2(random.uniform(0.0, L), 0.0);
        disc.velocity = Vec2(random.uniform(-10.0, 10.0), 0.0);
        const double t = random.uniform(0.0, 1000.0);
        const double straight = disc.position.x() + disc.velocity.x() * t;
        const double folded = std::abs(std::remainder(straight, 2.0 * L));
        const BodyState after = fly_between(disc, walls, Vec2::Zero(), t);
        worst = std::max(worst, std::abs(after.position.x() - folded));

        // Up to 3333 bounces, each with a place rounded to an ulp of L, and a time to an
        // ulp of 1000 s
        REQUIRE(worst <= 3333.0 * (L + 10.0 * 1000.0) * k_ulp);
    }
    RECORD_VALUE("walls.fold.worst", worst);
}


TEST_CASE("a ball that is let go is back at its height after a thousand bounces")
{
    // Each bounce rounds the speed and the time; the latter counts from the start and grows
    // to 1000 periods
    const double h = 2.0;
    const double g = 9.81;
    const double period = 2.0 * std::sqrt(2.0 * h / g);
    BodyState ball;
    ball.position = Vec2(0.0, h);
    const auto walls = box_walls(Vec2(-9.0, -0.5), Vec2(9.0, 9.0), 0.5);
    const BodyState after = fly_between(ball, walls, Vec2(0.0, -g), 1000.0 * period);
    CHECK(std::abs(after.position.y() - h) <= 1e-9);
    const double energy = 0.5 * after.velocity.squaredNorm() + g * after.position.y();
    CHECK(std::abs(energy - g * h) <= 1000.0 * 8.0 * k_ulp * g * h);
}

// ---- Steps
// ----------------------------------------------------------------------------------

TEST_CASE("in a uniform field Euler stays behind, symplectic Euler runs ahead, and Verlet "
          "is exact")
{
    Random random(36);
    for (int k = 0; k < 300; ++k) {
        const int n = 1 + random.below(300);
        const double h = random.uniform(0.01, 0.1);
        const double g = random.uniform(-10.0, -1.0);
        const double v_0 = random.uniform(-10.0, 10.0);
        const double t = n * h;
        const auto pull = [g](const Vec2&) { return Vec2(0.0, g); };
        const Moving start{Vec2(0.0, 0.0), Vec2(0.0, v_0)};
        const double exact = v_0 * t + 0.5 * g * t * t;


        const auto gap = [&](const auto& step) {
            return run(step, start, pull, h, n).x.y() - exact;
        };
        const double size = std::abs(g * t * h / 2);
        const double bound =
            1e-9; // up to 300 steps, whose places are up to 6000 times the gap
        CHECK_EQUATION_SCALED("steps.behind", gap(k_euler), -g * t * h / 2, size, bound,
                              {"g", g}, {"t", t}, {"h", h});
        CHECK_TWIN_SCALED("steps.behind", gap(k_euler), g * t * h / 2, size, bound);
        CHECK_EQUATION_SCALED("steps.ahead", gap(k_symplectic), g * t * h / 2, size, bound,
                              {"g", g}, {"t", t}, {"h", h});
        CHECK_TWIN_SCALED("steps.ahead", gap(k_symplectic), -g * t * h / 2, size, bound);
        CHECK(std::abs(gap(k_verlet)) <= 2.0 * n * k_ulp * (10.0 * t + 5.0 * t * t));

    }
}
