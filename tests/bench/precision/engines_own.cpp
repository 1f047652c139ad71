#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <memory>

#include "01-flying-balls/steppers.hpp"
#include "engine.hpp"
#include "resting.hpp"
#include "world/world.hpp"

namespace flying::bench {
namespace {

bool always(const Trial&)
{
    return true;
}
std::string nothing(const Trial&)
{
    return {};
}

Run start_world(const Scene& scene, double step, const std::vector<std::string>& without = {})
{
    WorldOptions options;
    options.step = step;
    options.without = without;
    Expected<World> made = World::make(scene, options);
    if (!made) {
        const Fault& fault = made.faults().front();
        std::fprintf(stderr, "the scene '%s' is not valid: %s: %s; expected %s\n", scene.title.c_str(),
                     fault.place.c_str(), fault.found.c_str(), fault.expected.c_str());
        std::exit(1);
    }
    const auto world = std::make_shared<World>(std::move(made).value());
    const auto failure = std::make_shared<std::optional<std::string>>();
    Run run;
    run.advance = [=](double time) {
        if (*failure) return;
        if (const auto failed = world->advance(time)) *failure = failed->message;
    };
    run.states = [=] {
        std::vector<BodyState> states;
        for (int k = 0; k < world->body_count(); ++k) states.push_back(world->state(k));
        return states;
    };
    run.failure = [=] { return *failure; };
    return run;
}

Run start_resting(const Scene& scene, const Setting& setting)
{
    const auto engine = std::make_shared<Resting>(scene, setting.hertz, true);
    const auto steps = std::make_shared<long>(0);
    const int bodies = static_cast<int>(scene.bodies.size());
    Run run;
    run.advance = [=](double time) {
        for (const long until = std::lround(time * setting.hertz); *steps < until; ++*steps) engine->step();
    };
    run.states = [=] { return engine->states(); };
    run.loads = [=] {
        std::vector<Load> loads;
        for (const RestContact& contact : engine->engine().contacts()) {
            const int a = contact.a < bodies ? contact.a : -1;
            const int b = contact.b < bodies ? contact.b : -1;
            loads.push_back({std::min(a, b), std::max(a, b), contact.normal_force});
        }
        return loads;
    };
    return run;
}

/// What moves by a stepper: discs that never meet each other.
struct Stepped
{
    std::vector<BodyState> bodies;
    std::vector<double> radii;
    Scene scene;
    long steps = 0;
};

/// A wall that finds a ball in it, on its way further in, turns it round.
void reflect(BodyState& body, const Vec2& normal, double gap, double e)
{
    const double v = body.velocity.dot(normal);
    if (gap < 0.0 && v < 0.0) body.velocity -= (1.0 + e) * v * normal;
}

template <typename Step>
Run start_stepper(const Scene& scene, const Setting& setting, const Step& step)
{
    const auto all = std::make_shared<Stepped>();
    all->scene = scene;
    for (const WeighedBody& body : weigh(scene)) {
        all->bodies.push_back(body.start);
        all->radii.push_back(body.radius);
    }
    Run run;
    run.advance = [=](double time) {
        const double h = 1.0 / setting.hertz;
        const auto pull = [&](const Vec2& x) { return acceleration_at(all->scene.world.field, x); };
        const double e = all->scene.world.restitution;
        for (const long until = std::lround(time * setting.hertz); all->steps < until; ++all->steps) {
            for (std::size_t k = 0; k < all->bodies.size(); ++k) {
                BodyState& body = all->bodies[k];
                const steps::Moving next = step(steps::Moving{body.position, body.velocity}, pull, h);
                body.position = next.x;
                body.velocity = next.v;
                if (!all->scene.world.box) continue;
                const BoxDef& box = *all->scene.world.box;
                const double R = all->radii[k];
                reflect(body, Vec2(1.0, 0.0), body.position.x() - R - box.min.x(), e);
                reflect(body, Vec2(-1.0, 0.0), box.max.x() - R - body.position.x(), e);
                reflect(body, Vec2(0.0, 1.0), body.position.y() - R - box.min.y(), e);
                reflect(body, Vec2(0.0, -1.0), box.max.y() - R - body.position.y(), e);
            }
        }
    };
    run.states = [=] { return all->bodies; };
    return run;
}

/// A ball between walls or round a centre, and no two that could meet.
bool is_flight(const Trial& trial)
{
    return trial.name.starts_with("bounce") || trial.name == "billiard" || trial.name == "kepler";
}

template <typename Step>
Engine stepper(const std::string& name, const Step& step)
{
    return {name, is_flight, nothing, always,
            [step](const Scene& scene, const Setting& setting) { return start_stepper(scene, setting, step); }};
}

} // namespace

Engine own_engine(bool has_step)
{
    return {"flying", always, nothing, [=](const Trial& trial) { return has_step && trial.rests; },
            [=](const Scene& scene, const Setting& setting) {
                return start_world(scene, has_step && setting.hertz > 0.0 ? 1.0 / setting.hertz : 1.0 / 60.0);
            }};
}

Engine own_awake()
{
    return {"flying, kept awake", [](const Trial& trial) { return trial.rests; }, nothing, always,
            [](const Scene& scene, const Setting& setting) {
                return start_world(scene, 1.0 / setting.hertz, {"sleeping"});
            }};
}

Engine own_steps()
{
    const auto why_not = [](const Trial& trial) -> std::string {
        if (std::holds_alternative<CentralField>(trial.scene.world.field))
            return "round a centre it moves only what leans on something";
        return {};
    };
    return {"flying, steps only", always, why_not, always, start_resting};
}

std::vector<Engine> steppers()
{
    return {stepper("Euler", steps::k_euler), stepper("symplectic Euler", steps::k_symplectic),
            stepper("Verlet", steps::k_verlet)};
}

} // namespace flying::bench
