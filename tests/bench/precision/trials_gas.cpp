// Gases: discs against an oracle in long doubles, polygons against this engine's own run of the same gas elsewhere.

#include <cmath>
#include <memory>

#include "engine.hpp"
#include "reference_discs.hpp"
#include "scenes.hpp"
#include "trial.hpp"

namespace flying::bench {
namespace {

constexpr double k_until = 1.0; // [s]

/// The scene somewhere else: the same motion, with other roundings.
Scene moved(Scene scene, const Vec2& offset)
{
    scene.world.box->min += offset;
    scene.world.box->max += offset;
    for (BodyDef& body : scene.bodies) body.position += offset;
    return scene;
}

Trial gas_trial(const std::string& name, const std::string& shape, double packing, int count)
{
    Trial trial;
    trial.name = name;
    trial.title = std::to_string(count) + " elastic " + shape + "s, packing " + std::to_string(packing).substr(0, 3);
    trial.scene = scene_of("gas", gas(count, packing, shape));
    trial.until = k_until;
    trial.patience = count >= 300 && shape != "disc" ? 10.0 : 3.0;
    trial.looks = {0.0, k_until};
    trial.why = "collisions make a small error grow without end; after one second it is still smaller than a body in a "
                "good engine";
    std::vector<BodyState> truth;
    if (has_reference(trial.scene)) {
        trial.truth = "impact by impact in long doubles, by a program of its own";
        truth = reference_discs(trial.scene, k_until);
    } else {
        trial.truth = "this engine's own run of the same gas, moved by (0.1, 0.7) m: what rounding alone does";
        trial.is_own = true;
        const Vec2 offset(0.1, 0.7);
        Run run = own_engine(false).start(moved(trial.scene, offset), {});
        run.advance(k_until);
        truth = run.states();
        for (BodyState& state : truth) state.position -= offset;
    }
    const Scene scene = trial.scene;
    trial.measures = {median_distance(scene,
                                      [truth, scene](int k, double t) {
                                          return Place{t > 0.0 ? truth[k].position : scene.bodies[k].position, {}};
                                      }),
                      energy_drift(scene), deepest_overlap(scene)};
    return trial;
}

TrialMaker maker(const std::string& name, const std::string& shape, double packing, int full, int quick)
{
    return {name, [=](Coarseness coarseness) {
                return gas_trial(name, shape, packing, coarseness == Coarseness::full ? full : quick);
            }};
}

} // namespace

std::vector<TrialMaker> gas_trials()
{
    return {maker("discs-0.1", "disc", 0.1, 1000, 300), maker("discs-0.5", "disc", 0.5, 1000, 300),
            maker("polygons-0.1", "polygon", 0.1, 500, 100), maker("polygons-0.4", "polygon", 0.4, 500, 100),
            maker("dumbbells-0.2", "dumbbell", 0.2, 300, 60)};
}

} // namespace flying::bench
