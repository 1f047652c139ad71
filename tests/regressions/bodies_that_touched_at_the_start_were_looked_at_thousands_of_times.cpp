// Two bodies that touch as a scene begins, and of which one turns: a corner that lay a rounding deep, didn't rise and
// was about to turn round was followed from each moment that the clock knows to the next. Shortly after zero moments
// lie so close together that thousands of looks, of two thousand readings each, passed before anything moved by a
// digit: the first step of a disc on a rod took up to three seconds.

#include <cmath>
#include <numbers>

#include "math/random.hpp"
#include "support/bodies.hpp"
#include "support/worlds.hpp"

using namespace flying;
using namespace flying::testing;

namespace {

/// A rod that flies and turns, and on it a disc, a block, or a square on its tip, which slides along.
Scene slid(Random& random, int kind)
{
    const double half_length = random.uniform(0.3, 4.0);
    const double half_height = random.uniform(0.05, 0.5);
    const double radius = random.uniform(0.1, 0.5);
    const double place = random.uniform(-half_length, half_length);
    const double rise = kind == 2 ? half_height + std::numbers::sqrt2 * radius : half_height + radius;
    const double angle = random.uniform(0.0, 6.0);
    const Rotation turned = Rotation::of(angle);
    const double flown_x = random.uniform(-2.0, 2.0);
    const double flown_y = random.uniform(-2.0, 2.0);
    const Vec2 flown(flown_x, flown_y);
    const double spin = random.uniform(-3.0, 3.0);
    const double slide = random.uniform(-2.0, 2.0);

    BodyDef rod = rectangle(2.0 * half_length, 2.0 * half_height, Vec2::Zero(), flown);
    const Vec2 start = turned * Vec2(place, rise);
    const Vec2 rate = flown + turned * Vec2(slide - spin * half_height, spin * place);
    BodyDef bead = kind == 0 ? disc(radius, start, rate) : rectangle(2.0 * radius, 2.0 * radius, start, rate);
    rod.spin = spin;
    rod.mass = std::exp(random.uniform(-2.0, 4.0));
    bead.mass = 1.0;
    bead.spin = kind == 1 ? spin : random.uniform(-3.0, 3.0);
    rod.angle = angle;
    bead.angle = angle + (kind == 2 ? 0.25 * std::numbers::pi : 0.0);

    Scene scene;
    scene.world.restitution = random.below(2) == 0 ? 0.0 : random.uniform(0.0, 0.5);
    scene.world.friction = random.below(2) == 0 ? 0.0 : random.uniform(0.0, 1.0);
    if (random.below(2) == 0) scene.world.field = UniformField{{0.0, random.uniform(-10.0, 3.0)}};
    scene.bodies = {rod, bead};
    return scene;
}

} // namespace

TEST_CASE("what slides along a turning body from the start on is looked at some times and not thousands of times")
{
    Random random(47);
    for (int k = 0; k < 120; ++k) {
        CAPTURE(k);
        World world = with_step(slid(random, k % 3), 1.0 / 60.0);
        run(world, 1.0 / 60.0);
        CHECK(world.report().events < 500);
    }
}
