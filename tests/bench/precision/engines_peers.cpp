#include <memory>

#include "engine.hpp"
#include "simulators.hpp"

namespace flying::bench {
namespace {

/// A peer that can do everything that its class says, by steps.
/// effort  its iterations as a multiple of those that it comes with
template <typename Peer>
Engine peer(const std::string& name, int effort)
{
    const auto applies = [effort](const Trial& trial) { return effort == 1 || trial.rests; };
    const auto start = [effort](const Scene& scene, const Setting& setting) {
        const auto engine = std::make_shared<Peer>(scene, setting.hertz, effort);
        Run run;
        run.advance = [=](double time) { engine->advance(time); };
        run.states = [=] { return engine->states(); };
        run.loads = [=] { return engine->loads(); };
        return run;
    };
    return {name, applies, [](const Trial&) { return std::string(); }, [](const Trial&) { return true; }, start};
}

} // namespace

std::vector<Engine> peers()
{
    return {peer<Chipmunk>("Chipmunk", 1), peer<Chipmunk>("Chipmunk, 40 iterations", 4), peer<Box2d>("Box2D", 1),
            peer<Box2d>("Box2D, 32/12 iterations", 4)};
}

} // namespace flying::bench
