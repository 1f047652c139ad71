// In a heap without friction a body that is pinched turns within a step by more than its contacts tell. A step of more
// than 64 bodies was made whole whatever came out; what overlapped went on to, since nothing paid for lifting it: by
// half a radius in a heap of 600. And of what was pushed apart nothing was pushed where one body would have had to go
// far.

#include "math/random.hpp"
#include "support/worlds.hpp"

using namespace flying;
using namespace flying::testing;

namespace {

constexpr double k_largest = 0.3; // bounding radius [m]

/// Discs and polygons that fall into a bin.
Scene heap(int count, double width, double restitution, double friction, std::uint64_t seed)
{
    Random random(seed);
    Scene scene;
    scene.world.field = UniformField{{0.0, -9.81}};
    scene.world.restitution = restitution;
    scene.world.friction = friction;
    scene.world.box = BoxDef{{0.0, 0.0}, {width, 60.0}};
    const int row = static_cast<int>(width / 0.63);
    for (int k = 0; k < count; ++k) {
        const double radius = random.uniform(0.5 * k_largest, k_largest);
        const Vec2 place(((k % row) + 0.5) * width / row, 0.5 + 0.63 * (k / row));
        BodyDef body = disc(radius, place);
        const int sides = 2 + random.below(6);
        if (sides > 2) body.shape = RegularDef{sides, radius};
        body.angle = random.uniform(0.0, 6.0);
        body.velocity = Vec2(random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0));
        body.spin = random.uniform(-3.0, 3.0);
        scene.bodies.push_back(body);
    }
    return scene;
}

} // namespace

TEST_CASE("heaps keep apart by a hundredth of the largest one's size at every step, with friction and without")
{
    struct Case
    {
        int count;
        double width; // [m]
        double restitution;
        double friction;
        std::uint64_t seed;
        double until; // [s]
    };
    for (const Case& each :
         {Case{100, 4.0, 0.4, 0.0, 7, 6.0}, Case{100, 4.0, 0.0, 0.0, 3, 6.0}, Case{300, 8.0, 0.4, 0.0, 2, 4.0},
          Case{40, 3.0, 0.3, 0.0, 5, 5.0}, Case{100, 4.0, 0.3, 0.5, 1, 5.0}, Case{40, 4.0, 0.0, 0.5, 4, 4.0}}) {
        CAPTURE(each.count);
        CAPTURE(each.friction);
        CAPTURE(each.restitution);
        World world = world_of(heap(each.count, each.width, each.restitution, each.friction, each.seed));
        REQUIRE_FALSE(world.advance(each.until).has_value());
        // The report doesn't say which two it were
        CHECK(world.report().max_overlap < 0.01 * k_largest);
    }
}
