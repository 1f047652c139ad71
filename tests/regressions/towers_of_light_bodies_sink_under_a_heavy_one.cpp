// A body of 1e9 kg on 14 or 20 boxes of 1 kg sank into them, and all reported speeds of up to a decimetre a second: the
// springs between light boxes yielded to it in every round of corrections. With 1e12 kg what might be rounding was
// accepted as soon as it was met, up to a centimetre a second, though another round would have taken it off; the bodies
// moved by it, and some runs didn't end.

#include <cmath>
#include <vector>

#include "support/worlds.hpp"

using namespace flying;
using namespace flying::testing;

namespace {

/// Light boxes of 1 kg in a tower on a floor, and a heavy body among them or on top.
struct Tower
{
    int count;     ///< bodies that move
    int heavy;     ///< which of them is heavy, from below
    double mass;   ///< of that one [kg]
    double width;  ///< of each [m]
    double height; ///< of each [m]
    double shift;  ///< of every second box, to the side [m]
    double drop;   ///< of the heavy one, from above the others [m]
};

Scene scene_of(const Tower& tower)
{
    Scene scene = on_a_floor(1.0, 0.5);
    for (int k = 0; k < tower.count; ++k) {
        const double lift = k >= tower.heavy ? tower.drop : 0.0;
        BodyDef body =
            rectangle(tower.width, tower.height, {k % 2 == 0 ? 0.0 : tower.shift, (k + 0.5) * tower.height + lift});
        body.mass = k == tower.heavy ? tower.mass : 1.0;
        scene.bodies.push_back(body);
    }
    return scene;
}

} // namespace

TEST_CASE("a tower of light boxes stands still under a body a billion times as heavy")
{
    for (const Tower& tower : {Tower{14, 13, 1e9, 0.45, 0.225, 0.0, 0.0}, Tower{20, 19, 1e9, 0.3, 0.3, 0.0, 0.0},
                               Tower{18, 12, 3e8, 0.4, 0.25, 0.02, 0.0}, Tower{9, 8, 1e12, 0.4, 0.3, 0.0, 0.0},
                               Tower{12, 6, 1e12, 0.4, 0.4, 0.0, 0.0}}) {
        CAPTURE(tower.count);
        CAPTURE(tower.mass);
        const Scene scene = scene_of(tower);
        World world = world_of(scene);
        run(world, 2.0);
        for (int k = 1; k <= tower.count; ++k) {
            const BodyState state = world.state(k);
            CHECK(state.velocity.isZero(0.0));
            CHECK(state.spin == 0.0);
            CHECK((state.position - scene.bodies[static_cast<std::size_t>(k)].position).norm() < 1e-6 * tower.height);
        }
        CHECK(world.report().rest.value().unsolved == 0);
    }
}

TEST_CASE("what lands on a tower of light boxes and is a billion times as heavy comes to rest on it")
{
    const Tower tower{15, 14, 1e9, 0.4, 0.4, 0.0, 0.01};
    const Scene scene = scene_of(tower);
    World world = world_of(scene);
    run(world, 2.0);
    for (int k = 1; k <= tower.count; ++k) {
        const BodyState state = world.state(k);
        CHECK(state.velocity.isZero(0.0));
        const double height = (k - 0.5) * tower.height;
        CHECK(std::abs(state.position.y() - height) < 0.01 * tower.height);
    }
}
