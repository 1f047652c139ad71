#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "simulators.hpp"

namespace flying::bench {
namespace {

World world_of(const Scene& scene)
{
    Expected<World> made = World::make(scene);
    if (made) return std::move(made).value();
    const Fault& fault = made.faults().front();
    std::fprintf(stderr, "the scene '%s' is not valid: %s: %s; expected %s\n", scene.title.c_str(), fault.place.c_str(),
                 fault.found.c_str(), fault.expected.c_str());
    std::exit(1);
}

} // namespace

Exact::Exact(const Scene& scene) : world_(world_of(scene)) {}

void Exact::advance(double time)
{
    if (failure_) return;
    if (const auto failure = world_.advance(time)) failure_ = failure->message;
}

std::vector<BodyState> Exact::states() const
{
    std::vector<BodyState> states;
    for (int k = 0; k < world_.body_count(); ++k) states.push_back(world_.state(k));
    return states;
}

std::string name_of(EngineChoice::Kind kind)
{
    switch (kind) {
    case EngineChoice::Kind::exact:
        return "flying";
    case EngineChoice::Kind::chipmunk:
        return "Chipmunk";
    case EngineChoice::Kind::box2d:
        return "Box2D";
    }
    return {};
}

Simulator make_simulator(const EngineChoice& choice, const Scene& scene)
{
    switch (choice.kind) {
    case EngineChoice::Kind::chipmunk:
        return Chipmunk(scene, choice.hertz);
    case EngineChoice::Kind::box2d:
        return Box2d(scene, choice.hertz);
    case EngineChoice::Kind::exact:
        break;
    }
    return Exact(scene);
}

void advance(Simulator& simulator, double time)
{
    std::visit([&](auto& engine) { engine.advance(time); }, simulator);
}

std::vector<BodyState> states_of(const Simulator& simulator)
{
    return std::visit([](const auto& engine) { return engine.states(); }, simulator);
}

long collisions_of(const Simulator& simulator)
{
    return std::visit([](const auto& engine) { return engine.collisions(); }, simulator);
}

std::optional<std::string> failure_of(const Simulator& simulator)
{
    return std::visit([](const auto& engine) { return engine.failure(); }, simulator);
}

long steps_until(double time, double hertz)
{
    return std::lround(time * hertz);
}

} // namespace flying::bench
