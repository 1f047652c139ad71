// Two cards that lean on each other, tip to tip, are each other's mirror. The push between the tips went along the
// normal of one card's side, as if the other card's corner lay on it: it needed friction at the tips that cards on a
// table don't, so that they fell where they stand; and they fell to one side.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "math/random.hpp"
#include "support/bodies.hpp"
#include "support/worlds.hpp"

using namespace flying;
using namespace flying::testing;

namespace {

struct Cards
{
    double width = 0.0;
    double height = 0.0;
    double lean = 0.0; ///< of each, from upright
    double place = 0.0;
    bool right_first = true;
    bool is_notched = false; ///< in the middle of both sides, so that it is cut into parts

    /// Friction with which they stand. Each bears its weight at its foot, under its inner side, and half of it less a
    /// little pushes it over: moments about the foot give the push between the tips, which is level.
    [[nodiscard]] double least_friction() const { return 0.5 * (std::tan(lean) - width / height); }

    [[nodiscard]] PolygonDef notched() const
    {
        const double x = 0.5 * width;
        const double y = 0.5 * height;
        PolygonDef polygon;
        polygon.vertices = {{-x, -y}, {x, -y}, {x, -0.1 * y}, {0.5 * x, 0.0},  {x, 0.1 * y},
                            {x, y},   {-x, y}, {-x, 0.1 * y}, {-0.5 * x, 0.0}, {-x, -0.1 * y}};
        return polygon;
    }

    [[nodiscard]] Scene scene(double friction, double restitution) const
    {
        Scene scene;
        scene.world.field = UniformField{{0.0, -9.81}};
        scene.world.restitution = restitution;
        scene.world.friction = friction;
        scene.bodies = {still(rectangle(40.0, 1.0, Vec2(place, -0.5)))};
        const double aside = 0.5 * (width * std::cos(lean) + height * std::sin(lean));
        const double up = 0.5 * (height * std::cos(lean) + width * std::sin(lean));
        for (const double side : {right_first ? 1.0 : -1.0, right_first ? -1.0 : 1.0}) {
            BodyDef card = rectangle(width, height, Vec2(place + side * aside, up));
            if (is_notched) card.shape = notched();
            card.angle = side * lean;
            scene.bodies.push_back(card);
        }
        return scene;
    }
};

[[nodiscard]] Cards some_cards(Random& random)
{
    Cards cards;
    do {
        cards.height = random.uniform(0.3, 2.0);
        cards.width = cards.height * random.uniform(0.02, 0.3);
        cards.lean = random.uniform(0.1, 0.7);
    } while (cards.least_friction() < 0.02);
    cards.place = random.uniform(-2.0, 2.0);
    cards.right_first = random.uniform(0.0, 1.0) < 0.5;
    cards.is_notched = random.uniform(0.0, 1.0) < 0.5;
    return cards;
}

} // namespace

TEST_CASE("two cards stand with the friction that statics asks for and fall with less")
{
    Random random(61);
    for (int k = 0; k < 40; ++k) {
        const Cards cards = some_cards(random);
        CAPTURE(cards.width / cards.height);
        CAPTURE(cards.lean);
        CAPTURE(cards.is_notched);
        for (const double share : {0.98, 1.02}) {
            World world = world_of(cards.scene(share * cards.least_friction(), 0.0));
            REQUIRE_FALSE(world.advance(2.0).has_value());
            const double moved = std::abs(std::abs(world.state(1).angle) - cards.lean);
            if (share > 1.0) CHECK(moved < 1e-9);
            else CHECK(moved > 1e-2);
        }
    }
}

TEST_CASE("two cards that fall stay each other's mirror")
{
    Random random(62);
    for (int k = 0; k < 40; ++k) {
        const Cards cards = some_cards(random);
        CAPTURE(cards.width / cards.height);
        CAPTURE(cards.lean);
        CAPTURE(cards.is_notched);
        const double friction = random.uniform(0.0, 0.8) * cards.least_friction();
        World world = world_of(cards.scene(friction, k % 2 == 0 ? 0.0 : 0.3));
        double worst = 0.0;
        // Until they are about to lie flat
        for (int step = 1; step <= 90 && std::abs(world.state(1).angle) < 1.5; ++step) {
            REQUIRE_FALSE(world.advance(step / 60.0).has_value());
            const BodyState one = world.state(1);
            const BodyState two = world.state(2);
            worst = std::max({worst, std::abs(one.position.x() + two.position.x() - 2.0 * cards.place) / cards.height,
                              std::abs(one.position.y() - two.position.y()) / cards.height,
                              std::abs(one.angle + two.angle)});
        }
        CHECK(worst < 1e-9);
    }
}

TEST_CASE("polygons that meet tip to tip at rest go back the way they came")
{
    for (const int sides : {6, 8, 10, 12}) {
        for (const double restitution : {0.0, 0.5, 1.0}) {
            Scene scene;
            scene.world.restitution = restitution;
            scene.world.friction = restitution < 1.0 ? 0.3 : 0.0;
            PolygonDef polygon;
            for (int k = 0; k < sides; ++k) {
                const double turn = 2.0 * std::numbers::pi * k / sides;
                polygon.vertices.push_back({std::cos(turn), std::sin(turn)});
            }
            for (const double side : {-1.0, 1.0}) {
                BodyDef body = rectangle(1.0, 1.0, Vec2(1.3 * side, 0.0), Vec2(-side, 0.0));
                body.shape = polygon;
                scene.bodies.push_back(body);
            }
            World world = world_of(scene, EngineChoice::rest);
            run(world, 1.0);
            CAPTURE(sides);
            CAPTURE(restitution);
            for (const int body : {0, 1}) {
                const BodyState state = world.state(body);
                const double back = body == 0 ? -restitution : restitution;
                CHECK((state.velocity - Vec2(back, 0.0)).norm() < 1e-9);
                CHECK(std::abs(state.spin) < 1e-9);
            }
        }
    }
}
