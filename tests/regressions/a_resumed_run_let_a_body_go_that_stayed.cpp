#include "support/worlds.hpp"

using namespace flying;
using namespace flying::testing;

// A run that was stopped and resumed let a body fly that the whole run kept, and ended with other bits: whether nothing
// touches a body for two steps was asked of the pairs on the list of neighbours alone. Where the step was halved, the
// list didn't reach that far; one made long ago held the pair by chance, a fresh one did not. Found by the fuzzer.

TEST_CASE("a run that is stopped while a halved step leads its bodies goes on with the same bits")
{
    Scene scene;
    scene.world.field = UniformField{{-4.773937590600443, -12.896620126649882}};
    scene.world.restitution = 0.0;
    scene.world.friction = 10.0;
    scene.world.box = BoxDef{{-5.0, -5.0}, {5.0, 5.0}};
    scene.until = 0.5;
    BodyDef large = disc(2.125, {-1.290295262073701, -1.9428931105516138}, {-25.43221179522392, -10.417334248874653});
    large.angle = 0.8816662851911197;
    large.spin = -10.47531853208209;
    large.density = 0.001953125;
    BodyDef plate = rectangle(0.09033203125, 0.16203440946691178, {-0.4764705882352942, -4.918982795266544},
                              {-1.0588235294117645, -1.0588235294117645});
    plate.spin = 7.1764705882352935;
    plate.density = 0.03125;
    plate.restitution = 0.5;
    BodyDef small = disc(0.11181640625, {-4.5, -4.5});
    small.density = 0.00048828125;
    scene.bodies = {large, plate, small};

    World whole = world_of(scene);
    run(whole, scene.until);
    for (const double part : {0.1, 0.2, 0.3, 0.37, 0.5, 0.8}) {
        CAPTURE(part);
        World first = world_of(scene);
        run(first, part * scene.until);
        Expected<World> second = World::resume(scene, first.snapshot());
        REQUIRE(second);
        run(second.value(), scene.until);
        CHECK(second.value().report().hash == whole.report().hash);
    }
}
