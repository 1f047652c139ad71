#include <doctest/doctest.h>

#include <array>

#include "response/one_point.hpp"
#include "support/impacts.hpp"

using namespace impacts;

namespace {

ImpactResult strike(const Pair& pair, const ImpactPoint& point, const Material& material)
{
    return flying::resolve_impact(pair.a, pair.b, {&point, 1}, material);
}

// Two discs that touch along n
ImpactPoint disc_point(double radius_a, double radius_b, const Vec2& n)
{
    return {radius_a * n, -radius_b * n, n};
}

// A corner anywhere on either body
ImpactPoint random_point(flying::Random& random)
{
    const Vec2 r_a = in_square(random, 1.0);
    const Vec2 r_b = in_square(random, 1.0);
    return {r_a, r_b, unit(random.uniform(0.0, 6.28))};
}

} // namespace

// ---- Discs ----------------------------------------------------------------------------------------------------------

TEST_CASE("equal discs meeting head-on at e = 1 swap their velocities, to the bit")
{
    const Pair pair{body(2.0, 1.0, {3.0, 0.0}, 0.0), body(2.0, 1.0, {-5.0, 0.0}, 0.0)};
    const ImpactResult after = strike(pair, disc_point(1.0, 1.0, {1.0, 0.0}), {1.0, 0.0});
    CHECK(same_bits(after.velocity_a, Vec2(-5.0, 0.0)));
    CHECK(same_bits(after.velocity_b, Vec2(3.0, 0.0)));
}

TEST_CASE("discs of any masses, met at any angle with any restitution, part as momentum and Newton's law say")
{
    // Each velocity along n is (m_a u_a + m_b u_b + m_other e (u_other - u)) / (m_a + m_b); across n nothing changes
    flying::Random random(701);
    double worst = 0.0;
    for (int i = 0; i < 200'000; ++i) {
        const double m_a = spread(random, 1e-6, 1e6);
        const double m_b = spread(random, 1e-6, 1e6);
        const double e = random.uniform();
        const double radius_a = spread(random, 0.01, 100.0);
        const double radius_b = spread(random, 0.01, 100.0);
        const Vec2 n = unit(random.uniform(0.0, 6.28));
        ImpactBody a = body(m_a, 0.5 * m_a * radius_a * radius_a, in_square(random, 1.0), 0.0);
        ImpactBody b = body(m_b, 0.5 * m_b * radius_b * radius_b, in_square(random, 1.0), 0.0);
        a.spin = random.uniform(-1.0, 1.0) / radius_a;
        b.spin = random.uniform(-1.0, 1.0) / radius_b;
        const ImpactResult after = strike({a, b}, disc_point(radius_a, radius_b, n), {e, 0.0});
        CHECK(same_bits(after.spin_a, a.spin));
        CHECK(same_bits(after.spin_b, b.spin));

        const real closing = static_cast<real>(b.velocity.x() - a.velocity.x()) * n.x() +
                             static_cast<real>(b.velocity.y() - a.velocity.y()) * n.y();
        const real sum = static_cast<real>(m_a) + m_b;
        const real gain_a = closing < 0.0L ? (1.0L + e) * closing * m_b / sum : 0.0L;
        const real gain_b = closing < 0.0L ? -(1.0L + e) * closing * m_a / sum : 0.0L;
        const auto off = [&](const Vec2& got, const Vec2& before, real gain) {
            return static_cast<double>(std::abs(got.x() - (before.x() + gain * n.x())) +
                                       std::abs(got.y() - (before.y() + gain * n.y())));
        };
        worst = std::max({worst, off(after.velocity_a, a.velocity, gain_a), off(after.velocity_b, b.velocity, gain_b)});
    }
    CHECK(worst < 32.0 * k_epsilon); // a dozen roundings of numbers up to 4
}

TEST_CASE("a ball that drops under a heavier one throws it up at (3M - m)/(M + m)")
{
    // The lower ball M has bounced already and rises at 1; the upper one m still falls at 1
    for (const double ratio : {1.0, 2.0, 3.0, 10.0, 1e6}) {
        const Pair pair{body(ratio, 1.0, {0.0, 1.0}, 0.0), body(1.0, 1.0, {0.0, -1.0}, 0.0)};
        const ImpactResult after = strike(pair, disc_point(1.0, 1.0, {0.0, 1.0}), {1.0, 0.0});
        CHECK(std::abs(after.velocity_b.y() - (3.0 * ratio - 1.0) / (ratio + 1.0)) <= 4.0 * k_epsilon * 3.0);
    }
}

TEST_CASE("in a row of five equal balls struck one after another the last leaves with everything, to the bit")
{
    std::array<ImpactBody, 5> row;
    for (ImpactBody& ball : row) ball = body(0.3, 0.1, {0.0, 0.0}, 0.0);
    row[0].velocity = {0.7, 0.0};
    for (int i = 0; i + 1 < 5; ++i) {
        const ImpactResult after = strike({row[i], row[i + 1]}, disc_point(1.0, 1.0, {1.0, 0.0}), {1.0, 0.0});
        row[i].velocity = after.velocity_a;
        row[i + 1].velocity = after.velocity_b;
    }
    for (int i = 0; i < 4; ++i) CHECK(row[i].velocity.norm() == 0.0);
    CHECK(same_bits(row[4].velocity.x(), 0.7));
}

// ---- Corners --------------------------------------------------------------------------------------------------------

TEST_CASE("a corner on a wall takes j = -(1+e) un / (1/m + rt^2/I)")
{
    flying::Random random(702);
    double worst = 0.0;
    for (int i = 0; i < 200'000; ++i) {
        const double m = spread(random, 1e-3, 1e3);
        const double moment = m * spread(random, 0.01, 10.0);
        const double e = random.uniform();
        const double r_t = random.uniform(-2.0, 2.0);
        const double fall = random.uniform(0.01, 2.0);
        const Pair pair{k_wall, body(m, moment, {0.0, -fall}, 0.0)};
        const ImpactResult after = strike(pair, {{5.0, 0.0}, {r_t, -1.0}, {0.0, 1.0}}, {e, 0.0});

        const real inv_m = pair.b.inertia.inv_mass;
        const real inv_i = pair.b.inertia.inv_moment_of_inertia;
        const real j = (1.0L + e) * fall / (inv_m + static_cast<real>(r_t) * r_t * inv_i);
        const real spin = j * r_t * inv_i;
        if (after.spin_b != 0.0) worst = std::max(worst, std::abs(static_cast<double>(after.spin_b / spin - 1.0L)));
        CHECK(std::abs(static_cast<double>(after.velocity_b.y() - (j * inv_m - fall))) <= 4.0 * k_epsilon * 2.0);
        CHECK(after.velocity_b.x() == 0.0);
    }
    CHECK(worst < 1e-14);
}

TEST_CASE("a struck pair keeps momentum and angular momentum, and at e = 1 its energy, to rounding")
{
    flying::Random random(703);
    double worst_momentum = 0.0;
    double worst_angular = 0.0;
    double worst_energy = 0.0;
    for (int i = 0; i < 200'000; ++i) {
        Pair pair = random_pair(random, 1e3);
        pair.a.inertia = {spread(random, 1e-3, 1e3), spread(random, 1e-3, 1e3)};
        const double mu = random.below(2) == 0 ? 0.0 : random.uniform(0.0, 2.0);
        const ImpactPoint point = random_point(random);
        const ImpactResult after = strike(pair, point, {mu == 0.0 ? 1.0 : random.uniform(), mu});

        // All pushes act at the point: about it, m r x v + I omega of each is kept, with the bodies' centres at -r
        const real m_a = 1.0L / pair.a.inertia.inv_mass;
        const real m_b = 1.0L / pair.b.inertia.inv_mass;
        const real i_a = 1.0L / pair.a.inertia.inv_moment_of_inertia;
        const real i_b = 1.0L / pair.b.inertia.inv_moment_of_inertia;
        real scale = 0.0L;
        for (int k = 0; k < 2; ++k) {
            const real kick = m_a * (static_cast<real>(after.velocity_a[k]) - pair.a.velocity[k]) +
                              m_b * (static_cast<real>(after.velocity_b[k]) - pair.b.velocity[k]);
            const real size = m_a * (std::abs(after.velocity_a[k]) + std::abs(pair.a.velocity[k])) +
                              m_b * (std::abs(after.velocity_b[k]) + std::abs(pair.b.velocity[k]));
            worst_momentum = std::max(worst_momentum, static_cast<double>(std::abs(kick) / size));
            scale += size;
        }
        const auto turned = [](real m, real moment, const Vec2& r, const Vec2& dv, real dw) {
            return moment * dw - m * (static_cast<real>(r.x()) * dv.y() - static_cast<real>(r.y()) * dv.x());
        };
        const real twist = turned(m_a, i_a, point.r_a, after.velocity_a - pair.a.velocity,
                                  static_cast<real>(after.spin_a) - pair.a.spin) +
                           turned(m_b, i_b, point.r_b, after.velocity_b - pair.b.velocity,
                                  static_cast<real>(after.spin_b) - pair.b.spin);
        scale = 2.0L * scale + i_a * (std::abs(after.spin_a) + std::abs(pair.a.spin)) +
                i_b * (std::abs(after.spin_b) + std::abs(pair.b.spin));
        worst_angular = std::max(worst_angular, static_cast<double>(std::abs(twist) / scale));
        if (mu == 0.0) {
            const real before = energy(pair.a, pair.b);
            const real off = std::abs(energy(pair.a, pair.b, after) - before) / before;
            worst_energy = std::max(worst_energy, static_cast<double>(off));
        }
    }
    CHECK(worst_momentum < 2.0 * k_epsilon);
    CHECK(worst_angular < 4.0 * k_epsilon);
    CHECK(worst_energy < 16.0 * k_epsilon);
}

TEST_CASE("at e = 0 nothing is left of the approach but rounding, with friction and without")
{
    flying::Random random(704);
    double worst = 0.0;
    for (int i = 0; i < 200'000; ++i) {
        const Pair pair = random_pair(random, 1e6);
        const ImpactPoint point = random_point(random);
        const double mu = random.below(2) == 0 ? 0.0 : random.uniform(0.0, 3.0);
        const ImpactResult after = strike(pair, point, {0.0, mu});
        if (!after.any_push) continue;
        CHECK(after.ended);
        worst = std::max(worst, std::abs(normal_speed(after, point)) / speed_scale(pair.a, pair.b, after, point));
    }
    CHECK(worst < 32.0 * k_epsilon); // what counts as rounding: tolerance::k_approach
}

// ---- What must not happen -------------------------------------------------------------------------------------------

TEST_CASE("a pair that separates, or slides without approaching, is left alone to the bit")
{
    flying::Random random(705);
    int separating = 0;
    for (int i = 0; i < 100'000; ++i) {
        const Pair pair = random_pair(random, 1e3);
        const ImpactPoint point = random_point(random);
        if (normal_speed(pair.a, pair.b, point) < 1e-12) continue;
        ++separating;
        const ImpactResult after = strike(pair, point, {0.5, 0.5});
        CHECK(same_bits(after, {pair.a.velocity, pair.b.velocity, pair.a.spin, pair.b.spin, false, true}));
    }
    CHECK(separating > 40'000);

    const Pair sliding{k_wall, body(1.0, 0.5, {3.0, 0.0}, 0.0)};
    const ImpactResult after = strike(sliding, {{0.0, 0.0}, {0.0, -1.0}, {0.0, 1.0}}, {1.0, 0.5});
    CHECK(same_bits(after, {{0.0, 0.0}, {3.0, 0.0}, 0.0, 0.0, false, true}));
}

TEST_CASE("two walls that are said to approach are left alone")
{
    ImpactBody wall;
    wall.velocity = {0.0, -1.0};
    const ImpactResult after = strike({k_wall, wall}, {{0.0, 0.0}, {0.0, -1.0}, {0.0, 1.0}}, {1.0, 0.5});
    CHECK(same_bits(after.velocity_b, wall.velocity));
    CHECK_FALSE(after.any_push);
    CHECK_FALSE(after.ended);
}

TEST_CASE("a wall stays where it is, to the bit")
{
    const Pair pair{k_wall, body(1.0, 0.5, {3.0, -4.0}, 2.0)};
    const ImpactResult after = strike(pair, {{7.0, 9.0}, {0.3, -1.0}, {0.0, 1.0}}, {0.7, 0.5});
    CHECK(after.any_push);
    CHECK(same_bits(after.velocity_a, Vec2(0.0, 0.0)));
    CHECK(same_bits(after.spin_a, 0.0));
}

// ---- Symmetry and scale ---------------------------------------------------------------------------------------------

TEST_CASE("masses, lengths and times scaled by powers of two scale the answer bit for bit")
{
    flying::Random random(706);
    for (int i = 0; i < 20'000; ++i) {
        const Pair pair = random_pair(random, 1e3);
        const ImpactPoint point = random_point(random);
        const Material material{random.uniform(), random.below(3) == 0 ? 0.0 : random.uniform(0.0, 2.0)};
        const PowerScale scale = PowerScale::random(random);
        const ImpactResult plain = strike(pair, point, material);
        const ImpactResult large = strike({scale.of(pair.a), scale.of(pair.b)}, scale.of(point), material);
        CHECK(same_bits(large, scale.of(plain)));
    }
}

TEST_CASE("the mirror image and the quarter turn of an impact of discs are those of its result, bit for bit")
{
    flying::Random random(707);
    for (int i = 0; i < 20'000; ++i) {
        const Pair pair = random_pair(random, 1e3);
        const double radius_a = random.uniform(0.1, 2.0);
        const double radius_b = random.uniform(0.1, 2.0);
        const ImpactPoint point = disc_point(radius_a, radius_b, unit(random.uniform(0.0, 6.28)));
        const Material material{random.uniform(), random.below(3) == 0 ? 0.0 : random.uniform(0.0, 2.0)};
        const ImpactResult plain = strike(pair, point, material);

        const auto mirror = [](const Vec2& v) { return Vec2(-v.x(), v.y()); };
        const auto check = [&](auto&& image, double turning) {
            const auto moved = [&](const ImpactBody& from) {
                return ImpactBody{image(from.velocity), turning * from.spin, from.inertia};
            };
            const ImpactPoint at{image(point.r_a), image(point.r_b), image(point.normal)};
            const ImpactResult got = strike({moved(pair.a), moved(pair.b)}, at, material);
            CHECK(got.velocity_a == image(plain.velocity_a));
            CHECK(got.velocity_b == image(plain.velocity_b));
            CHECK(got.spin_a == turning * plain.spin_a);
            CHECK(got.spin_b == turning * plain.spin_b);
        };
        check(mirror, -1.0);
        check([](const Vec2& v) { return flying::perp(v); }, 1.0);
    }
}

TEST_CASE("a pair takes the larger restitution and the geometric mean of the frictions")
{
    const Material both = flying::combine({0.2, 0.25}, {0.9, 1.0});
    CHECK(both.restitution == 0.9);
    CHECK(both.friction == 0.5);
    CHECK(flying::combine({0.0, 0.0}, {0.0, 7.0}).friction == 0.0);
}
