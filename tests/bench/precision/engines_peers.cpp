#include <memory>

#include "engine.hpp"
#include "siconos.hpp"
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

#ifdef FLYING_SICONOS
Run start_siconos(const Scene& scene, const Setting& setting, Siconos::Solver solver)
{
    const auto engine = std::make_shared<Siconos>(scene, setting.hertz, solver);
    Run run;
    run.advance = [=](double time) { engine->advance(time); };
    run.states = [=] { return engine->states(); };
    run.loads = [=] { return engine->loads(); };
    run.failure = [=] { return engine->failure(); };
    return run;
}
constexpr const char* k_no_siconos = "";
#else
Run start_siconos(const Scene&, const Setting&, Siconos::Solver)
{
    return {};
}
constexpr const char* k_no_siconos = "not built in: libsiconos-kernel-dev is not installed";
#endif

/// A peer for contacts that last, where it is installed.
Engine siconos(const std::string& name, Siconos::Solver solver)
{
    return {name, [](const Trial& trial) { return trial.rests; },
            [](const Trial&) { return std::string(k_no_siconos); }, [](const Trial&) { return true; },
            [solver](const Scene& scene, const Setting& setting) { return start_siconos(scene, setting, solver); }};
}

} // namespace

std::vector<Engine> peers()
{
    return {peer<Chipmunk>("Chipmunk", 1),
            peer<Chipmunk>("Chipmunk, 40 iterations", 4),
            peer<Box2d>("Box2D", 1),
            peer<Box2d>("Box2D, 32/12 iterations", 4),
            siconos("Siconos, sweeps", Siconos::Solver::sweeps),
            siconos("Siconos, Lemke", Siconos::Solver::lemke)};
}

} // namespace flying::bench
