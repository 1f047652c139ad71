#include <algorithm>
#include <cmath>
#include <limits>

#include <doctest/doctest.h>

#include FLYING_ANSWER

#include "math/random.hpp"
#include "toi/discs.hpp"

TEST_CASE("straight to the next image")
{
    CHECK(std::abs(meet_images(5, 0, 1, 0, 1, 10, 100) - 4.0) < 1e-14);
    CHECK(std::abs(meet_images(5, 0, -2, 0, 1, 10, 100) - 2.0) < 1e-14);
    CHECK(std::isinf(meet_images(5, 5, 1, 0, 1, 10, 1e3))); // between two rows for ever
    CHECK(std::isinf(meet_images(5, 0, 0, 0, 1, 10, 1e3)));
    CHECK(std::isinf(meet_images(5, 0, 1, 0, 1, 10, 3.0)));
}

TEST_CASE("the earliest of all images, as trying forty by forty of them says")
{
    flying::Random random(1051);
    for (int n = 0; n < 300; ++n) {
        const double x = random.uniform(-5.0, 5.0);
        const double y = random.uniform(-5.0, 5.0);
        const double reach = random.uniform(0.05, 4.9);
        if (std::hypot(x, y) <= reach) continue;
        const flying::Vec2 v(random.uniform(-3.0, 3.0), random.uniform(-3.0, 3.0));
        const double until = 150.0 / v.norm(); // so that it stays among the forty
        double expected = std::numeric_limits<double>::infinity();
        for (int i = -20; i <= 20; ++i) {
            for (int k = -20; k <= 20; ++k) {
                const flying::Vec2 offset(x - 10.0 * i, y - 10.0 * k);
                expected = std::min(expected, flying::time_to_meet(offset, v, reach));
            }
        }
        const double found = meet_images(x, y, v.x(), v.y(), reach, 10.0, until);
        CAPTURE(x);
        CAPTURE(y);
        CAPTURE(v.x());
        CAPTURE(v.y());
        CAPTURE(reach);
        CAPTURE(expected);
        if (expected < 0.99 * until)
            CHECK(std::abs(found - expected) < 1e-12 * (1.0 + until));
        else if (expected > 1.01 * until) CHECK(std::isinf(found));
    }
}

TEST_CASE("a small disc that passes ten thousand images meets the one after them")
{
    // One room up on ten thousand to the right: it comes down on an image, having passed
    // all the others
    const double t = meet_images(5.0, 0.5, 1.0, -0.5 / 100005.0, 1e-6, 10.0, 1e6);
    CHECK(std::abs(t - 100005.0) < 1.0);
}
