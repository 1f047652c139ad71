// flying_instructions SCENE: runs one small fixed scene, for callgrind to count what `measured_run` takes.
// flying_instructions: prints the names of the scenes.

#include <cstdio>
#include <string>
#include <utility>
#include <vector>

#include "scene/generate.hpp"
#include "world/world.hpp"

namespace {

using flying::Bounds;
using flying::EngineChoice;
using flying::GenerateOptions;
using flying::Scene;
using flying::Vec2;
using flying::World;

struct SmallScene
{
    const char* name;
    const char* kind;
    GenerateOptions options;
    double until; ///< [s]
    EngineChoice engine = EngineChoice::automatic;
};

GenerateOptions gas(int count, double packing, const char* shape)
{
    GenerateOptions options;
    options.seed = 7;
    options.count = count;
    options.packing = packing;
    options.rms_speed = 5.0;
    options.shape = shape;
    return options;
}

std::vector<SmallScene> small_scenes()
{
    // Discs of all sizes that fall and rub
    GenerateOptions rubbing;
    rubbing.seed = 7;
    rubbing.count = 100;
    rubbing.gravity = Vec2(0.0, -9.81);
    rubbing.friction = 0.3;

    GenerateOptions billiard;
    billiard.billiard = "pi";
    billiard.exponent = 4;

    // Boxes that land on each other, too many to be solved whole; and some that stand, which are
    GenerateOptions pile;
    pile.seed = 7;
    pile.count = 450;
    pile.restitution = 0.0;
    GenerateOptions pyramid;
    pyramid.count = 12;
    pyramid.restitution = 0.0;

    return {{"discs-thin", "gas", gas(1000, 0.1, "disc"), 2.0},
            {"discs-dense", "gas", gas(400, 0.5, "disc"), 1.0},
            {"discs-rubbing", "balls", rubbing, 2.0},
            {"polygons-thin", "gas", gas(300, 0.1, "polygon"), 2.0},
            {"polygons-dense", "gas", gas(100, 0.4, "polygon"), 0.5},
            {"dumbbells", "gas", gas(60, 0.15, "dumbbell"), 0.5},
            {"billiard", "billiard", billiard, 1e6},
            {"pile", "pile", pile, 1.5, EngineChoice::rest},
            {"pyramid", "pyramid", pyramid, 0.5, EngineChoice::rest}};
}

} // namespace

// What is counted: no inlining, so that it has a name to begin and end at. Reads nothing, prints nothing.
extern "C" __attribute__((noinline)) bool measured_run(World& world, double until)
{
    return !world.advance(until).has_value();
}

int main(int argc, char** argv)
{
    for (const SmallScene& small : small_scenes()) {
        if (argc < 2) {
            std::printf("%s\n", small.name);
            continue;
        }
        if (std::string(argv[1]) != small.name) continue;
        const auto scene = flying::generate(small.kind, small.options);
        if (!scene) {
            std::fprintf(stderr, "%s: %s\n", scene.faults().front().place.c_str(),
                         scene.faults().front().found.c_str());
            return 1;
        }
        flying::WorldOptions options;
        options.engine = small.engine;
        auto world = World::make(scene.value(), options);
        if (!world) return 1;
        const bool went = measured_run(world.value(), small.until);
        std::printf("%ld collisions\n", world.value().collisions());
        return went ? 0 : 1;
    }
    return argc < 2 ? 0 : 2;
}
