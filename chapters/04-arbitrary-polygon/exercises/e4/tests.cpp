#include <cmath>
#include <random>

#include <doctest/doctest.h>

#include FLYING_ANSWER

namespace {

double area(const std::vector<Vec2>& ring)
{
    double twice = 0.0;
    for (std::size_t k = 0; k < ring.size(); ++k) {
        const Vec2& p = ring[k];
        const Vec2& q = ring[(k + 1) % ring.size()];
        twice += p.x() * q.y() - p.y() * q.x();
    }
    return 0.5 * twice;
}

const std::vector<Vec2> k_square = {Vec2(0, 0), Vec2(1, 0), Vec2(1, 1), Vec2(0, 1)};

} // namespace

TEST_CASE("a square, cut across, along a diagonal, and not at all")
{
    CHECK(area(cut(k_square, Vec2(1, 0), 0.25)) == doctest::Approx(0.25));
    const std::vector<Vec2> half = cut(k_square, Vec2(1, 1), 1.0);
    CHECK(half.size() == 3);
    CHECK(area(half) == doctest::Approx(0.5));
    CHECK(cut(k_square, Vec2(1, 0), 2.0).size() == 4);
    CHECK(cut(k_square, Vec2(1, 0), -1.0).empty());
    CHECK(cut(k_square, Vec2(1, 0), 0.0).empty()); // an edge has no area
}

TEST_CASE("the two sides of a cut weigh what the whole weighs")
{
    std::mt19937 random(5);
    std::uniform_real_distribution<double> any(-1.0, 1.0);
    for (int k = 0; k < 1000; ++k) {
        std::vector<Vec2> ring;
        for (int i = 0; i < 7; ++i) ring.push_back(Vec2(std::cos(0.9 * i), std::sin(0.9 * i)));
        const Vec2 n(any(random), any(random));
        const double c = any(random) * n.norm();
        const Vec2 other = -n;
        const double sum = area(cut(ring, n, c)) + area(cut(ring, other, -c));
        CHECK(sum == doctest::Approx(area(ring)).epsilon(1e-13));
    }
}
