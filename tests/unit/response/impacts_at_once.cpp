// Bodies that strike each other at one moment, several at once.

#include "response/impacts_at_once.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "math/random.hpp"
#include "response/tied_pairs.hpp"

using namespace flying;

namespace {

/// Discs of radius 1 that touch, and what they do.
struct Cluster
{
    std::vector<ImpactBody> bodies;
    std::vector<ImpactPair> pairs;
    std::vector<ImpactPoint> points;

    int add(double mass, const Vec2& velocity, double spin = 0.0)
    {
        bodies.push_back({velocity, spin, {mass > 0.0 ? 1.0 / mass : 0.0, mass > 0.0 ? 2.0 / mass : 0.0}});
        return static_cast<int>(bodies.size()) - 1;
    }
    void touch(int a, int b, const Vec2& normal, const Material& material)
    {
        pairs.push_back({a, b, points.size(), points.size() + 1, material});
        points.push_back({normal, -normal, normal});
    }
    int strike(int most = 1000)
    {
        const std::vector<double> slowest(points.size(), 1e-12);
        return resolve_impacts(bodies, pairs, points, slowest, most);
    }
    [[nodiscard]] double energy() const
    {
        double sum = 0.0;
        for (const ImpactBody& body : bodies) {
            if (body.inertia.inv_mass == 0.0) continue;
            sum += 0.5 * body.velocity.squaredNorm() / body.inertia.inv_mass +
                   0.5 * body.spin * body.spin / body.inertia.inv_moment_of_inertia;
        }
        return sum;
    }
    [[nodiscard]] Vec2 momentum() const
    {
        Vec2 sum = Vec2::Zero();
        for (const ImpactBody& body : bodies) {
            if (body.inertia.inv_mass > 0.0) sum += body.velocity / body.inertia.inv_mass;
        }
        return sum;
    }
};

Vec2 towards(double degrees)
{
    const double angle = degrees * std::acos(-1.0) / 180.0;
    return {std::cos(angle), std::sin(angle)};
}

} // namespace

TEST_CASE("a disc that meets two at once leaves along its own line, at the speed that the closed form says")
{
    // Compression: p = c (u - 2 p c / M) m for two of mass m at +-angle, c its cosine, and a striker of mass M
    for (const double angle : {10.0, 30.0, 45.0, 70.0}) {
        for (const double mass : {0.1, 1.0, 30.0}) {
            for (const double e : {1.0, 0.6, 0.0}) {
                Cluster cluster;
                const int striker = cluster.add(mass, {3.0, 0.0});
                cluster.add(1.0, Vec2::Zero());
                cluster.add(1.0, Vec2::Zero());
                cluster.touch(striker, 1, towards(angle), {e, 0.0});
                cluster.touch(striker, 2, towards(-angle), {e, 0.0});
                CHECK(cluster.strike() == 2);
                const double c = towards(angle).x();
                const double push = (1.0 + e) * 3.0 * c / (1.0 + 2.0 * c * c / mass);
                CHECK((cluster.bodies[0].velocity - Vec2(3.0 - 2.0 * push * c / mass, 0.0)).norm() < 1e-12);
                CHECK((cluster.bodies[1].velocity - push * towards(angle)).norm() < 1e-12);
                CHECK((cluster.bodies[2].velocity - push * towards(-angle)).norm() < 1e-12);
            }
        }
    }
}

TEST_CASE("a disc that strikes two walls at once comes straight back, and at e = 0 stands in the corner")
{
    for (const double e : {1.0, 0.5, 0.0}) {
        Cluster cluster;
        const int wall = cluster.add(0.0, Vec2::Zero());
        const int other = cluster.add(0.0, Vec2::Zero());
        const int disc = cluster.add(2.0, {-1.0, -3.0});
        cluster.touch(wall, disc, towards(50.0), {e, 0.0});
        cluster.touch(other, disc, towards(120.0), {e, 0.0});
        CHECK(cluster.strike() == 2);
        CHECK((cluster.bodies[disc].velocity - e * Vec2(1.0, 3.0)).norm() < 1e-12);
    }
}

TEST_CASE("speeds whose squares are too small to be written down do no harm")
{
    for (const double speed : {1e-100, 1e-160, 1e-200, 1e-300}) {
        Cluster cluster;
        const int middle = cluster.add(1.0, {speed, 0.0});
        cluster.add(1.0, Vec2::Zero());
        cluster.add(1.0, Vec2::Zero());
        cluster.touch(middle, 1, towards(30.0), {0.5, 0.0});
        cluster.touch(middle, 2, towards(-30.0), {0.5, 0.0});
        const std::vector<double> slowest(2, 0.0);
        (void)resolve_impacts(cluster.bodies, cluster.pairs, cluster.points, slowest, 10);
        for (const ImpactBody& body : cluster.bodies) {
            CHECK(std::isfinite(body.velocity.x()));
            CHECK(body.velocity.norm() <= speed);
        }
    }
}

TEST_CASE("a row of balls that touch hands a blow on, and two blows at once from both sides")
{
    for (const bool two : {false, true}) {
        Cluster cluster;
        for (int k = 0; k < 7; ++k) cluster.add(1.0, Vec2::Zero());
        cluster.bodies[0].velocity = {1.0, 0.0};
        if (two) cluster.bodies[6].velocity = {-1.0, 0.0};
        for (int k = 0; k < 6; ++k) cluster.touch(k, k + 1, {1.0, 0.0}, {1.0, 0.0});
        cluster.strike();
        for (int k = 0; k < 7; ++k) {
            const double end = k == 6 ? 1.0 : (k == 0 && two ? -1.0 : 0.0);
            CHECK(std::abs(cluster.bodies[k].velocity.x() - end) < 1e-12);
        }
    }
}

TEST_CASE("over random clusters energy never rises, momentum is kept, and numbering alters rounding alone")
{
    Random random(5);
    for (int k = 0; k < 300; ++k) {
        CAPTURE(k);
        const int count = 3 + static_cast<int>(random.below(6));
        const bool is_smooth = k % 2 == 0;
        const bool is_alike = k % 4 < 2; // one restitution for all
        Cluster cluster;
        for (int body = 0; body < count; ++body) {
            cluster.add(std::pow(10.0, random.uniform(-1.0, 1.0)),
                        {random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0)}, random.uniform(-1.0, 1.0));
        }
        const double e = random.uniform(0.0, 1.0);
        for (int body = 1; body < count; ++body) {
            const Material material{is_alike ? e : random.uniform(0.0, 1.0),
                                    is_smooth ? 0.0 : random.uniform(0.0, 1.5)};
            cluster.touch(static_cast<int>(random.below(body)), body, towards(random.uniform(0.0, 360.0)), material);
        }

        // The same with other numbers
        Cluster other = cluster;
        std::reverse(other.bodies.begin(), other.bodies.end());
        std::reverse(other.pairs.begin(), other.pairs.end());
        for (ImpactPair& pair : other.pairs) {
            pair.a = count - 1 - pair.a;
            pair.b = count - 1 - pair.b;
        }

        const double before = cluster.energy();
        const Vec2 momentum = cluster.momentum();
        cluster.strike(count); // a round or two: what comes after may grow what rounding left
        other.strike(count);
        CHECK(cluster.energy() <= before * (1.0 + 1e-14));
        CHECK((cluster.momentum() - momentum).norm() < 1e-13 * (1.0 + momentum.norm()) * 10.0);
        for (int body = 0; body < count; ++body)
            CHECK((cluster.bodies[body].velocity - other.bodies[count - 1 - body].velocity).norm() < 1e-9);
    }
}

TEST_CASE("without friction, and with one restitution, a push together is Newton's law at every point that is pushed")
{
    Random random(6);
    for (int k = 0; k < 200; ++k) {
        CAPTURE(k);
        const int count = 3 + static_cast<int>(random.below(5));
        const double e = random.uniform(0.0, 1.0);
        Cluster cluster;
        const int middle = cluster.add(1.0, {0.0, 0.0});
        for (int body = 1; body < count; ++body) {
            const Vec2 normal = towards(360.0 * body / count + random.uniform(-20.0, 20.0));
            cluster.add(random.uniform(0.3, 3.0), -normal * random.uniform(0.5, 2.0));
            cluster.touch(middle, body, normal, {e, 0.0});
        }
        const auto speed = [&](const ImpactPair& pair) {
            return (cluster.bodies[pair.b].velocity - cluster.bodies[pair.a].velocity)
                .dot(cluster.points[pair.first].normal);
        };
        std::vector<double> before;
        for (const ImpactPair& pair : cluster.pairs) before.push_back(speed(pair));
        cluster.strike(1);
        for (std::size_t i = 0; i < before.size(); ++i) CHECK(speed(cluster.pairs[i]) >= -e * before[i] - 1e-9);
    }
}

TEST_CASE("pairs are tied by bodies that move, through others too, and by no others")
{
    using Pairs = std::vector<std::array<int, 2>>;
    using Groups = std::vector<std::vector<int>>;
    CHECK(tied_pairs(Pairs{}).empty());
    CHECK(tied_pairs(Pairs{{0, 1}, {2, 3}, {4, 5}}) == Groups{{0}, {1}, {2}});
    CHECK(tied_pairs(Pairs{{0, 1}, {2, 3}, {3, 4}, {4, 0}}) == Groups{{0, 1, 2, 3}});
    CHECK(tied_pairs(Pairs{{5, -1}, {6, -1}, {5, 7}}) == Groups{{0, 2}, {1}});
}
