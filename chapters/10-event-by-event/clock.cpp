#include <array>
#include <cstdio>
#include <cstdlib>
#include <initializer_list>
#include <numbers>
#include <span>

#include "three.hpp"
#include "world/world.hpp"

using namespace flying;

namespace {

/// A ball at e = 1/2, let fall for a second, whose first hop lasts a second too: with the
/// events alone, and left to itself.
void fall_and_hop()
{
    Scene scene;
    scene.world.restitution = 0.5;
    scene.world.field = UniformField{{0.0, -9.8}};
    scene.world.box = BoxDef{{-1.0, 0.0}, {1.0, 10.0}};
    BodyDef ball;
    ball.name = "ball";
    ball.shape = DiscDef{0.1};
    ball.position = {0.0, 5.0};
    scene.bodies = {ball};
    for (const EngineChoice engine : {EngineChoice::events, EngineChoice::automatic}) {
        WorldOptions options;
        options.engine = engine;
        Expected<World> world = World::make(scene, options);
        if (!world) return;
        if (const auto failure = world.value().advance(10.0)) {
            std::printf("stopped: %s\n", failure->message.c_str());
            continue;
        }
        const Report report = world.value().report();
        for (const Handover& handover : report.handovers) {
            std::printf("handed over after %.3f s, at a price of %.0f J\n", handover.time,
                        handover.energy_change);
        }
        std::printf("after %.0f s the ball lies at %.3f m\n", report.time,
                    world.value().state(0).position.y());
    }
}

/// Three balls in a row: how often they meet, and what the angle says.
void meet_in_a_row(std::span<const double> restitutions)
{
    std::printf("\n     e   pi / phi   impacts   gaps in the end\n");
    for (const double e : restitutions) {
        EventEngine engine = three_in_a_row(e);
        if (engine.advance(100.0, -1)) continue;
        const auto gap = [&](int k) {
            const double left = state_at(engine.flyer(k), 100.0).position.x();
            return state_at(engine.flyer(k + 1), 100.0).position.x() - left - 1.0;
        };
        const double phi = row_angle(e);
        std::printf("%6.3f", e);
        if (phi > 0.0) std::printf("%11.2f", std::numbers::pi / phi);
        else std::printf("%11s", "-");
        std::printf(" %9ld %10.0e m, %.0e m\n", engine.counts().impacts, gap(0), gap(1));
    }
}

} // namespace

/// e  restitution of three balls in a row; a table if none is given
int main(int argc, char** argv)
{
    constexpr std::array k_table{1.0, 0.5, 0.2, 0.1, 0.08, 0.076, 0.074, 0.07, 0.05};
    fall_and_hop();
    if (argc > 1) {
        const double e = std::atof(argv[1]);
        meet_in_a_row({&e, 1});
    } else {
        meet_in_a_row(k_table);
    }
}
