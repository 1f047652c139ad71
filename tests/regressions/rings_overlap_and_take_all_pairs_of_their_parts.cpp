// Rings of twelve corners with a hole, poured into a box, got into each other by up to a quarter of their radius and
// stayed there: a corner that had sunk in a little was led out over whatever side its part had, that of the hole
// included, and one corner made points with all the parts that met there. And each pair of rings took 144 pairs of
// parts, again for each of its points.

#include <cmath>
#include <numbers>
#include <string>

#include "math/random.hpp"
#include "support/worlds.hpp"

using namespace flying;
using namespace flying::testing;

namespace {

constexpr double k_ring = 0.3; // [m]

[[nodiscard]] std::vector<Vec2> circle_of_corners(int corners, double radius)
{
    std::vector<Vec2> ring;
    for (int k = 0; k < corners; ++k) {
        const double angle = 2.0 * std::numbers::pi * k / corners;
        ring.push_back({radius * std::cos(angle), radius * std::sin(angle)});
    }
    return ring;
}

[[nodiscard]] Scene rings(int count, int corners, double thickness, double restitution, double friction,
                          std::uint64_t seed)
{
    Random random(seed);
    Scene scene;
    scene.world.field = UniformField{{0.0, -9.81}};
    scene.world.restitution = restitution;
    scene.world.friction = friction;
    scene.world.box = BoxDef{{0.0, 0.0}, {5.0, 60.0}};
    for (int k = 0; k < count; ++k) {
        BodyDef body;
        body.shape = PolygonDef{circle_of_corners(corners, k_ring),
                                {circle_of_corners(corners, (1.0 - thickness) * k_ring)}};
        body.position = {0.4 + 0.65 * (k % 7) + random.uniform(-0.02, 0.02), 0.5 + 0.65 * (k / 7)};
        body.angle = random.uniform(0.0, 6.0);
        scene.bodies.push_back(body);
    }
    return scene;
}

[[nodiscard]] double count_of(const Report& report, const std::string& stage)
{
    for (const StageCost& cost : report.stages) {
        if (cost.name == stage) return static_cast<double>(cost.count);
    }
    return 0.0;
}

} // namespace

TEST_CASE("rings keep apart by a hundredth of their radius at every step")
{
    struct Case
    {
        int count;
        int corners;
        double thickness;
        double restitution;
        double friction;
    };
    for (const Case& each :
         {Case{150, 12, 0.25, 0.0, 0.3}, Case{50, 12, 0.25, 0.2, 0.0}, Case{100, 6, 0.1, 0.0, 0.3}}) {
        CAPTURE(each.corners);
        CAPTURE(each.count);
        World world = world_of(rings(each.count, each.corners, each.thickness, each.restitution, each.friction, 1));
        REQUIRE_FALSE(world.advance(1.0).has_value());
        CHECK(world.report().max_overlap < 0.01 * k_ring);
    }
}

TEST_CASE("of two rings only the parts that are near each other are looked at")
{
    World world = world_of(rings(50, 12, 0.25, 0.2, 0.0, 1));
    REQUIRE_FALSE(world.advance(1.0).has_value());
    const Report report = world.report();

    // A ring has six neighbours at most, so there are three pairs a ring; four pairs of parts of each may be near, and
    // each is looked at once, and up to five times ahead
    const double most = 50.0 * 3.0 * 4.0 * (1.0 + 5.0);
    REQUIRE(count_of(report, "solve") > 0.0);
    CHECK(count_of(report, "collide") / count_of(report, "solve") < most);
}
