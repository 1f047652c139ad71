// Boxes of masses over nine powers of ten: heavy ones that closed in on a light one shot it out within a step, into a
// third one, by up to its whole size. The cut that should have shown that came before the blow, again and again: it was
// reckoned back from where the light one ended, as if it had flown there as fast as it went in the end.

#include <cmath>

#include "math/random.hpp"
#include "support/heaps.hpp"
#include "support/overlap.hpp"
#include "support/worlds.hpp"

using namespace flying;
using namespace flying::testing;

namespace {

Scene boxes_of_unequal_masses(int count, std::uint64_t seed)
{
    Random random(seed);
    Scene scene = rough_pit({4.0, 9.0});
    for (int k = 0; k < count; ++k) {
        BodyDef body;
        const double width = random.uniform(0.3, 0.6);
        body.shape = RectangleDef{width, random.uniform(0.3, 0.6)};
        body.position = {0.6 + 0.9 * (k % 4), 0.5 + 0.9 * (k / 4)};
        body.angle = random.uniform(0.0, 3.0);
        body.mass = std::pow(10.0, random.uniform(0.0, 9.0));
        scene.bodies.push_back(body);
    }
    return scene;
}

} // namespace

TEST_CASE("boxes of masses over 1 : 1e9 that are let fall keep apart, whatever is squeezed out among them")
{
    for (const std::uint64_t seed : {101U, 155U, 165U, 239U}) {
        CAPTURE(seed);
        World world = world_of(boxes_of_unequal_masses(24, seed));
        for (int k = 1; k <= 180; ++k) {
            run(world, k / 60.0);
            CHECK(deepest_overlap(world) <= 0.01);
        }
    }
}
