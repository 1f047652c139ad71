#include <doctest/doctest.h>

#include "response/one_point.hpp"
#include "support/impacts.hpp"

using namespace impacts;
using flying::PointImpulse;
using flying::PointResponse;

namespace {

// Work of both impulses, per unit of what they moved: impulse times the mean of the speeds before and after
real work(const PointResponse& w, real v_n, real v_t, const PointImpulse& p)
{
    const real after_n = v_n + w.w_n * static_cast<real>(p.normal) + w.w_nt * static_cast<real>(p.tangent);
    const real after_t = v_t + w.w_nt * static_cast<real>(p.normal) + w.w_t * static_cast<real>(p.tangent);
    return 0.5L * (p.normal * (v_n + after_n) + p.tangent * (v_t + after_t));
}

// What the speeds hold before, as far as impulses at the point can take it
real store(const PointResponse& w, real v_n, real v_t)
{
    return 0.5L * (w.w_t * v_n * v_n - 2.0L * w.w_nt * v_n * v_t + w.w_n * v_t * v_t) / w.determinant;
}

PointResponse response(double w_n, double w_t, double w_nt)
{
    return {w_n, w_t, w_nt, w_n * w_t - w_nt * w_nt};
}

// The impact in many small steps of the normal impulse: slip against the speed, stick when it would turn round
PointImpulse by_steps(const PointResponse& w, real v_n, real v_t, const Material& material, int steps)
{
    const real mu = material.friction;
    const real step = -v_n / w.w_n / steps;
    real j = 0.0L;
    real q = 0.0L;
    real work_n = 0.0L;
    real least = 0.0L;
    real n = v_n;
    real t = v_t;
    for (bool compressed = false;;) {
        // Find what friction does in this step: what would stop the slip, within the cone
        real dq = -(t + w.w_nt * step) / w.w_t;
        dq = std::clamp(dq, -mu * step, mu * step);
        const real n_next = n + w.w_n * step + w.w_nt * dq;
        const real dwork = 0.5L * (n + n_next) * step;
        if (!compressed && n_next >= 0.0L) {
            compressed = true;
            least = work_n;
        }
        if (compressed &&
            work_n + dwork >= (1.0L - static_cast<real>(material.restitution) * material.restitution) * least)
            return {static_cast<double>(j), static_cast<double>(q)};
        work_n += dwork;
        j += step;
        q += dq;
        t += w.w_nt * step + w.w_t * dq;
        n = n_next;
    }
}

// A rod's end on the floor, inclined by `angle` to it: unit length, unit mass, I = 1/12
PointResponse rod(double angle)
{
    const double x = 0.5 * std::cos(angle);
    const double y = 0.5 * std::sin(angle);
    return {1.0 + 12.0 * x * x, 1.0 + 12.0 * y * y, 12.0 * x * y, 1.0 + 12.0 * (x * x + y * y)};
}

// Two rods of unit mass and length, hinged on each other and on a pivot, at angles to the vertical; the tip is struck
// from below. Speed of the tip = G (theta_1', theta_2'); w = G M^-1 G^T
PointResponse double_pendulum(double theta_1, double theta_2)
{
    const double m11 = 4.0 / 3.0;
    const double m12 = 0.5 * std::cos(theta_1 - theta_2);
    const double m22 = 1.0 / 3.0;
    const double det = m11 * m22 - m12 * m12;
    const double t1 = std::cos(theta_1);
    const double t2 = std::cos(theta_2);
    const double n1 = std::sin(theta_1);
    const double n2 = std::sin(theta_2);
    const auto weigh = [&](double x1, double x2, double y1, double y2) {
        return (m22 * x1 * y1 - m12 * (x1 * y2 + x2 * y1) + m11 * x2 * y2) / det;
    };
    return {weigh(n1, n2, n1, n2), weigh(t1, t2, t1, t2), weigh(n1, n2, t1, t2),
            (n1 * t2 - n2 * t1) * (n1 * t2 - n2 * t1) / det};
}

} // namespace

TEST_CASE("without friction the answer is Newton's, bit for bit")
{
    flying::Random random(711);
    for (int i = 0; i < 100'000; ++i) {
        const double w_nt = random.uniform(-0.9, 0.9);
        const PointResponse w = response(1.0, random.uniform(0.9, 3.0), w_nt);
        const double v_n = random.uniform(-1.0, 1.0);
        const double e = random.uniform();
        const PointImpulse p = flying::one_point_impulse(w, v_n, random.uniform(-1.0, 1.0), {e, 0.0});
        CHECK(same_bits(p.normal, v_n < 0.0 ? -(1.0 + e) * v_n / w.w_n : 0.0));
        CHECK(p.tangent == 0.0);
    }
}

TEST_CASE("a disc on a wall sticks iff |ut| <= 3 mu (1+e) |un|, else it keeps what the cone leaves it")
{
    flying::Random random(712);
    int stuck = 0;
    for (int i = 0; i < 200'000; ++i) {
        const double radius = spread(random, 0.1, 10.0);
        const double m = spread(random, 0.1, 10.0);
        const Material material{random.uniform(), random.uniform(0.0, 1.0)};
        const double u_n = random.uniform(-2.0, -0.1);
        const double limit = 3.0 * material.friction * (1.0 + material.restitution) * -u_n;

        // Near the threshold, on either side of it
        const double side = random.below(2) == 0 ? 1.0 - 1e-13 : 1.0 + 1e-13;
        const double u_t = (random.below(2) == 0 ? side : random.uniform(0.0, 3.0)) * limit;
        const double sign = random.below(2) == 0 ? 1.0 : -1.0;
        const double spin = random.uniform(-1.0, 1.0);
        const ImpactPoint point{{0.0, 0.0}, {0.0, -radius}, {0.0, 1.0}};
        const ImpactBody disc = body(m, 0.5 * m * radius * radius, {sign * u_t - spin * radius, u_n}, spin);
        const ImpactResult after = flying::resolve_impact(k_wall, disc, {&point, 1}, material);

        const double slip = after.velocity_b.x() + after.spin_b * radius;
        const double rounding = 8.0 * k_epsilon * (std::abs(u_t) + std::abs(spin) * radius + std::abs(u_n));
        CHECK(std::abs(after.velocity_b.y() + material.restitution * u_n) <= 8.0 * k_epsilon * std::abs(u_n));
        CHECK(std::abs(slip - sign * std::max(0.0, u_t - limit)) <= rounding);
        stuck += u_t <= limit;
    }
    CHECK(stuck > 50'000);
    CHECK(stuck < 150'000);
}

TEST_CASE("a sticking disc on a wall is stopped where it touches exactly, where the numbers are round")
{
    const ImpactPoint point{{0.0, 0.0}, {0.0, -1.0}, {0.0, 1.0}};
    const ImpactBody disc = body(1.0, 0.5, {3.0, -1.0}, 0.0);
    const ImpactResult at = flying::resolve_impact(k_wall, disc, {&point, 1}, {1.0, 0.5}); // 3 = 3 * 0.5 * 2 * 1
    CHECK(tangent_speed(at, point) == 0.0);
    CHECK(at.velocity_b == Vec2(2.0, 1.0));
    const ImpactResult below = flying::resolve_impact(k_wall, disc, {&point, 1}, {1.0, 0.5 - 0x1p-30});
    CHECK(tangent_speed(below, point) != 0.0);
}

TEST_CASE("no impact with friction gains energy, in a million random cases")
{
    flying::Random random(713);
    int jams = 0;
    int reversals = 0;
    double worst_gain = 0.0;
    for (int i = 0; i < 1'000'000; ++i) {
        // Coupling up to nearly singular; slip up to ten times the approach; friction up to 10
        const double w_t = spread(random, 0.05, 20.0);
        const double share = i % 2 == 0 ? random.uniform(-1.0, 1.0) : 1.0 - spread(random, 1e-9, 1.0);
        const PointResponse w = response(1.0, w_t, share * std::sqrt(w_t));
        if (!(w.determinant > 0.0)) continue;
        const double v_n = -1.0;
        const double v_t = random.below(8) == 0 ? 0.0 : random.uniform(-10.0, 10.0);
        const Material material{random.below(4) == 0 ? 1.0 : random.uniform(), spread(random, 1e-3, 10.0)};
        const PointImpulse p = flying::one_point_impulse(w, v_n, v_t, material);

        CHECK_UNARY(p.normal > 0.0);
        CHECK_UNARY(std::abs(p.tangent) <= material.friction * p.normal * (1.0 + 4.0 * k_epsilon));
        // Rounding of the response's entries weighs more the nearer it is to singular
        const real condition = w.w_n * w.w_t / w.determinant;
        const double gain = static_cast<double>(work(w, v_n, v_t, p) / (store(w, v_n, v_t) * condition));
        worst_gain = std::max(worst_gain, gain);
        const double after_t = v_t + w.w_nt * p.normal + w.w_t * p.tangent;
        jams += w.w_n - std::copysign(material.friction, v_t) * w.w_nt < 0.0 && v_t != 0.0;
        reversals += after_t * v_t < 0.0 && std::abs(after_t) > 1e-9;
    }
    CHECK(worst_gain < 16.0 * k_epsilon);
    CHECK(jams > 1'000);
    CHECK(reversals > 1'000);
}

TEST_CASE("Kane's double pendulum, which gains energy under Newton's law with friction, doesn't here")
{
    // Newton's ratio of normal speeds together with Coulomb's friction gains energy in some of these cases; count them,
    // so that the test is known to bite
    flying::Random random(714);
    int newton_gains = 0;
    double worst_gain = 0.0;
    for (int i = 0; i < 100'000; ++i) {
        const double theta_1 = random.below(4) == 0 ? 0.349065850398866 : random.uniform(0.05, 1.5); // 20 degrees
        const double theta_2 = random.below(4) == 0 ? 0.523598775598299 : random.uniform(0.05, 1.5); // 30 degrees
        const PointResponse w = double_pendulum(theta_1, theta_2);
        if (!(w.determinant > 1e-6 * w.w_n * w.w_t)) continue;
        const double v_n = -1.0;
        const double v_t = random.uniform(-3.0, 3.0);
        const double e = random.uniform(0.5, 1.0);
        const double mu = random.uniform(0.1, 1.0);
        const PointImpulse p = flying::one_point_impulse(w, v_n, v_t, {e, mu});
        worst_gain = std::max(worst_gain, static_cast<double>(work(w, v_n, v_t, p) / store(w, v_n, v_t)));

        // Newton and Coulomb: v_n_after = -e v_n, slip to the end in the direction of the slip after it
        for (const double s : {-1.0, 1.0}) {
            const double j = -(1.0 + e) * v_n / (w.w_n - s * mu * w.w_nt);
            const PointImpulse newton{j, -s * mu * j};
            const bool slips = s * (v_t + w.w_nt * j + w.w_t * newton.tangent) > 0.0;
            newton_gains += j > 0.0 && slips && work(w, v_n, v_t, newton) > 1e-9L;
        }
    }
    CHECK(newton_gains > 100);
    CHECK(worst_gain < 16.0 * k_epsilon);
}

TEST_CASE("the closed form is the limit of the impact taken in small steps of the normal impulse")
{
    // The steps' error is of the order of one step, the width of a phase's end
    flying::Random random(715);
    const int steps = 4000;
    double worst = 0.0;
    for (int i = 0; i < 2'000; ++i) {
        const double w_t = spread(random, 0.2, 5.0);
        const PointResponse w = response(1.0, w_t, random.uniform(-0.9, 0.9) * std::sqrt(w_t));
        const double v_t = random.below(6) == 0 ? 0.0 : random.uniform(-2.0, 2.0);
        const Material material{random.uniform(), random.uniform(0.01, 1.5)};
        const PointImpulse exact = flying::one_point_impulse(w, -1.0, v_t, material);
        const PointImpulse stepped = by_steps(w, -1.0, v_t, material, steps);
        const double off = std::abs(exact.normal - stepped.normal) + std::abs(exact.tangent - stepped.tangent);
        worst = std::max(worst, off / (1.0 + exact.normal) * steps);
    }
    CHECK(worst < 20.0);
}

TEST_CASE("a rod that jams is stopped, sticks and is thrown back with e^2 of the work of compression")
{
    // Slip towards the lean with mu beyond w_n / w_nt makes the normal speed grow at first
    const PointResponse w = rod(1.1);
    const double mu = 2.0 * w.w_n / w.w_nt;
    const double v_t = 0.5;
    REQUIRE(w.w_n - mu * w.w_nt < 0.0);
    for (const double e : {0.0, 0.5, 1.0}) {
        const PointImpulse p = flying::one_point_impulse(w, -1.0, v_t, {e, mu});
        const double after_n = -1.0 + w.w_n * p.normal + w.w_nt * p.tangent;
        const double after_t = v_t + w.w_nt * p.normal + w.w_t * p.tangent;
        CHECK(std::abs(after_t) < 8.0 * k_epsilon);

        // By hand: slip ends at j_s with normal speed v_s, sticking brings it back at rate det / w_t
        const double j_s = v_t / (mu * w.w_t - w.w_nt);
        const double v_s = -1.0 + (w.w_n - mu * w.w_nt) * j_s;
        const double k = w.determinant / w.w_t;
        const double work_of_compression = 0.5 * (v_s - 1.0) * j_s - 0.5 * v_s * v_s / k;
        CHECK(v_s < -1.0);
        CHECK(std::abs(after_n - e * std::sqrt(-2.0 * k * work_of_compression)) < 32.0 * k_epsilon);
        CHECK(std::abs(after_n) <= 8.0 * k_epsilon + (e > 0.0 ? 10.0 : 0.0));
    }
}

TEST_CASE("where friction doesn't reach the normal, the energetic law is Newton's, at the limit too")
{
    // The coupled formula at a coupling of 1e-9 differs from the uncoupled branch by no more than that
    flying::Random random(716);
    for (int i = 0; i < 20'000; ++i) {
        const double v_t = random.uniform(-2.0, 2.0);
        const Material material{random.uniform(), random.uniform(0.01, 1.0)};
        const PointImpulse none = flying::one_point_impulse(response(1.0, 3.0, 0.0), -1.0, v_t, material);
        const PointImpulse little = flying::one_point_impulse(response(1.0, 3.0, 1e-9), -1.0, v_t, material);
        CHECK(std::abs(none.normal - little.normal) < 1e-8);
        CHECK(std::abs(none.tangent - little.tangent) < 1e-8);
    }
}

TEST_CASE("a body on a pivot, struck in line with it, neither gains nor produces nonsense")
{
    // One free dimension: the response is singular
    flying::Random random(717);
    for (int i = 0; i < 20'000; ++i) {
        const double angle = random.uniform(0.1, 1.47);
        const double n = std::cos(angle);
        const double t = std::sin(angle);
        const double turn = random.uniform(-1.0, 1.0);
        const Material material{random.uniform(), spread(random, 0.01, 10.0)};
        const PointResponse w{n * n, t * t, n * t, 0.0};
        const PointImpulse p = flying::one_point_impulse(w, n * turn, t * turn, material);
        CHECK(std::isfinite(p.normal));
        CHECK(std::isfinite(p.tangent));
        CHECK(p.normal >= 0.0);
        const double turn_after = turn + n * p.normal + t * p.tangent;
        CHECK(std::abs(turn_after) <= std::abs(turn) * (1.0 + 1e-12) + 1e-15);
    }
}
