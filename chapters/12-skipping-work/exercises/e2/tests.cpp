#include <algorithm>
#include <cmath>

#include <doctest/doctest.h>

#include FLYING_ANSWER

#include "math/random.hpp"
#include "math/roots.hpp"

using namespace flying;

TEST_CASE("no pair that meets is left out, and of those that don't, nearly all are")
{
    Random random(1251);
    int apart = 0;
    int left_out = 0;
    for (int k = 0; k < 100'000; ++k) {
        const Vec2 offset{random.uniform(-9.0, 9.0), random.uniform(-9.0, 9.0)};
        const Vec2 velocity{random.uniform(-2.0, 2.0), random.uniform(-2.0, 2.0)};
        const double reach = random.uniform(0.1, 2.0);
        if (offset.norm() <= reach) continue;
        const Passage passage = passage_through_circle(offset, velocity, reach);
        const bool meets = passage.leave > 0.0;
        if (meets)
            CHECK_MESSAGE(can_meet(offset, velocity, reach), "they meet in " << std::max(0.0, passage.enter) << " s");
        apart += meets ? 0 : 1;
        left_out += can_meet(offset, velocity, reach) ? 0 : 1;
    }
    CHECK(left_out > 0.99 * apart);
}

TEST_CASE("a graze within rounding is not left out")
{
    Random random(1252);
    for (int k = 0; k < 1000; ++k) {
        const double reach = random.uniform(0.1, 2.0);
        CHECK(can_meet(Vec2(-5.0, reach), Vec2(random.uniform(0.1, 9.0), 0.0), reach));
    }

    // From any side: the nearest that it comes, in longer arithmetic, and one more digit for good measure
    for (int k = 0; k < 1000; ++k) {
        const Vec2 offset(random.uniform(-9.0, -5.0), random.uniform(0.1, 5.0));
        const Vec2 velocity(random.uniform(1.0, 2.0), random.uniform(-0.1, 0.1));
        const long double v_x = velocity.x();
        const long double v_y = velocity.y();
        const long double miss = std::abs(offset.x() * v_y - offset.y() * v_x) / std::sqrt(v_x * v_x + v_y * v_y);
        CHECK(can_meet(offset, velocity, std::nextafter(static_cast<double>(miss), 99.0)));
    }
}

TEST_CASE("two bodies that stand still never meet")
{
    CHECK_FALSE(can_meet(Vec2(3.0, 0.0), Vec2(0.0, 0.0), 1.0));
}
