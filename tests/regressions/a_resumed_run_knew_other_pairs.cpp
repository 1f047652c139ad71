// Which pairs may touch is listed by boxes with room to spare, and the list lasts until a body may leave its box. A
// light box between heavy ones is thrown further than a step foresees; the parts of its step then asked for all that
// was listed, and that depended on when the list was made. A run that was saved and resumed makes it anew: of 24 boxes
// of 1 kg to 1e9 kg that fall into a bin, two in forty took another way.

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "chapters/support/lying_bodies.hpp"
#include "math/random.hpp"
#include "support/effort.hpp"

using namespace flying;
using namespace flying::test;

TEST_CASE("boxes of unequal masses fall alike whether a run is resumed before each step or goes on")
{
    constexpr int k_columns = 4;
    constexpr double k_place = 0.9; // [m]
    for (const std::uint64_t seed : testing::tried<std::uint64_t>({1, 5, 7})) {
        CAPTURE(seed);
        Random random(seed);
        const Material material{0.0, 0.5};
        std::vector<RestBody> bodies{wall({0.0, 1.0}, 0.0, material), wall({1.0, 0.0}, 0.0, material),
                                     wall({-1.0, 0.0}, -(k_columns + 0.5) * k_place, material)};
        for (int k = 0; k < 24; ++k) {
            const Vec2 place(0.6 + k_place * (k % k_columns) + random.uniform(-0.1, 0.1),
                             0.5 + k_place * (k / k_columns));
            const double mass = std::pow(10.0, random.uniform(0.0, 9.0));
            bodies.push_back(box(random.uniform(0.3, 0.6), random.uniform(0.3, 0.6), place, mass, material));
            bodies.back().state.angle = random.uniform(0.0, 2.0 * std::numbers::pi);
        }
        RestEngine resumed(bodies);
        RestEngine whole(bodies);
        bool same = true;
        for (int k = 0; k < 180; ++k) {
            resumed.go_on_from(resumed.memory());
            resumed.step();
            whole.step();
            same = same && resumed.hash() == whole.hash();
        }
        CHECK(same);
    }
}
