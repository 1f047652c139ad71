#include <cmath>
#include <random>

#include <doctest/doctest.h>

#include FLYING_ANSWER

namespace {

/// Where the object ball goes when the cue ball is pushed along `way`: a unit vector, zero where it is missed.
Vec2 played(const Vec2& cue, const Vec2& object, const Vec2& way, double radius)
{
    const Vec2 x = object - cue;
    const double along = way.dot(x);
    const double discriminant = along * along - x.squaredNorm() + 4.0 * radius * radius;
    if (!(along > 0.0) || discriminant < 0.0) return Vec2(0.0, 0.0);
    const Vec2 at = cue + (along - std::sqrt(discriminant)) * way;
    return (object - at).normalized();
}

} // namespace

TEST_CASE("straight shots")
{
    CHECK((aim(Vec2(0, 0), Vec2(1, 0), Vec2(3, 0), 0.03) - Vec2(1, 0)).norm() < 1e-15);
    CHECK(aim(Vec2(0, 0), Vec2(1, 0), Vec2(-1, 0.2), 0.03).norm() == 0.0);
}

TEST_CASE("shots at any angle go in")
{
    std::mt19937 random(8);
    std::uniform_real_distribution<double> any(-1.0, 1.0);
    int played_in = 0;
    for (int k = 0; k < 2000; ++k) {
        const Vec2 cue(any(random), any(random));
        const Vec2 object(any(random), any(random));
        const Vec2 pocket(any(random), any(random));
        if ((cue - object).norm() < 0.2 || (pocket - object).norm() < 0.2) continue;
        const Vec2 way = aim(cue, object, pocket, 0.03);
        const Vec2 n = (pocket - object).normalized();
        if (way == Vec2(0, 0)) {
            CHECK((object - 0.06 * n - cue).dot(n) <= 1e-9);
            continue;
        }
        CHECK(way.norm() == doctest::Approx(1.0));
        CHECK((played(cue, object, way, 0.03) - n).norm() < 1e-9);
        ++played_in;
    }
    CHECK(played_in > 300);
}
