#include "play/watch.hpp"

#include <algorithm>
#include <cmath>

#include "collide/touching.hpp"
#include "motion/field.hpp"
#include "motion/kepler.hpp"
#include "play/run.hpp"
#include "world/hybrid.hpp"

namespace flying {

namespace {

constexpr std::size_t k_trail_points = 48;
constexpr std::size_t k_all_trail_points = 12000;
constexpr double k_plan_every = 0.5;  ///< [s]
constexpr double k_touch = 1e-6;      ///< [sizes] gap of bodies that have just met

bool flies(const World& world, int body)
{
    return body < world.body_count() && world.mover(body) == World::Mover::events;
}

/// Where two bodies touch: the middle of all points, as they lie now.
Vec2 touching_point(const EventEngine& engine, int a, int b, const Pose& pose_a, const Pose& pose_b)
{
    const double size_a = bounding_radius(engine.shape(a));
    const double size_b = bounding_radius(engine.shape(b));
    const double size = std::isfinite(size_a) ? (std::isfinite(size_b) ? std::min(size_a, size_b) : size_a) : size_b;
    std::vector<Touch> touches;
    find_touches(engine.shape(a), pose_a, engine.shape(b), pose_b, k_touch * size, touches);
    const bool from_a = std::isfinite(size_a);
    if (touches.empty()) return from_a ? pose_a.position : pose_b.position;
    Vec2 sum = Vec2::Zero();
    for (const Touch& touch : touches) sum += from_a ? Vec2(pose_a.position + touch.r_a) : Vec2(pose_b.position + touch.r_b);
    return sum / static_cast<double>(touches.size());
}

} // namespace

void begin_watch(Watch& watch, const PlayRun& run)
{
    const World& world = run.world();
    const EventEngine& engine = world.integrators().flying();
    const std::size_t count = static_cast<std::size_t>(engine.body_count());
    if (watch.generation != run.generation() || watch.flights.size() != count) {
        watch.generation = run.generation();
        watch.known_impacts = engine.counts().impacts;
        watch.flights.resize(count);
        watch.inv_mass.resize(count);
        for (std::size_t k = 0; k < count; ++k) watch.inv_mass[k] = engine.inertia(static_cast<int>(k)).inv_mass;
    }
    for (std::size_t k = 0; k < count; ++k) watch.flights[k] = engine.flyer(static_cast<int>(k)).state;
}

void watch_event(Watch& watch, const PlayRun& run, double now)
{
    const World& world = run.world();
    const EventEngine& engine = world.integrators().flying();
    if (engine.counts().impacts == watch.known_impacts) return;
    watch.known_impacts = engine.counts().impacts;
    const Event& impact = engine.last_impact();
    if (impact.a < 0 || impact.b < 0) return;

    // The push on either body tells that on the other; one of them flies
    const int body = flies(world, impact.b) ? impact.b : impact.a;
    if (!flies(world, body)) return;
    const std::size_t place = static_cast<std::size_t>(body);
    const BodyState after = engine.flyer(body).state;
    if (watch.flights[place].time > after.time) return;
    const BodyState before = flight(watch.flights[place], world.scene().world.field, after.time);
    const double sign = body == impact.b ? 1.0 : -1.0;
    SeenImpact seen;
    seen.seen = now;
    seen.push = sign / watch.inv_mass[place] * (after.velocity - before.velocity);
    seen.change = (after.velocity - before.velocity).norm();
    seen.point = touching_point(engine, impact.a, impact.b, pose_of(engine.flyer(impact.a).state), pose_of(engine.flyer(impact.b).state));
    watch.impacts.push_back(seen);
    if (watch.impacts.size() > k_most_impacts) watch.impacts.pop_front();
    for (const int k : {impact.a, impact.b}) watch.flights[static_cast<std::size_t>(k)] = engine.flyer(k).state;
}

Sample sample_of(const PlayRun& run)
{
    const World& world = run.world();
    const Field& field = world.scene().world.field;
    Sample sample;
    sample.time = run.time();
    for (int k = 0; k < world.body_count(); ++k) {
        const Inertia& inertia = world.inertia(k);
        if (inertia.inv_mass == 0.0) continue;
        const BodyState s = world.state(k);
        const double mass = 1.0 / inertia.inv_mass;
        sample.kinetic += 0.5 * mass * s.velocity.squaredNorm();
        if (inertia.inv_moment_of_inertia > 0.0) sample.kinetic += 0.5 / inertia.inv_moment_of_inertia * s.spin * s.spin;
        sample.potential += mass * potential_at(field, s.position);
        sample.momentum += mass * s.velocity;
    }
    return sample;
}

void watch_frame(Watch& watch, PlayRun& run, const Look& look, double now)
{
    watch.frames.push_back(now);
    while (watch.frames.size() > 120) watch.frames.pop_front();
    while (!watch.impacts.empty() && watch.impacts.front().seen < now - 2.0 * k_impact_fades) watch.impacts.pop_front();

    const World& world = run.world();
    const std::size_t count = static_cast<std::size_t>(world.body_count());
    if (look.shows(Layer::trails)) {
        if (watch.trails.size() != count) watch.trails.assign(count, {});
        const std::size_t most = std::clamp<std::size_t>(k_all_trail_points / std::max<std::size_t>(count, 1), 8, k_trail_points);
        for (std::size_t k = 0; k < count; ++k) {
            if (world.is_static(static_cast<int>(k))) continue;
            watch.trails[k].push_back(world.state(static_cast<int>(k)).position);
            while (watch.trails[k].size() > most) watch.trails[k].pop_front();
        }
    } else {
        watch.trails.clear();
    }

    if (look.shows(Layer::strips)) {
        const Sample sample = sample_of(run);
        if (!watch.samples.empty() && sample.time < watch.samples.back().time) watch.samples.clear();
        if (watch.samples.empty() || sample.time > watch.samples.back().time) watch.samples.push_back(sample);
        while (watch.samples.front().time < sample.time - k_strip_length || watch.samples.size() > 4000) watch.samples.pop_front();
    } else {
        watch.samples.clear();
    }

    if (look.shows(Layer::plan) && (watch.plan_asked < 0.0 || now > watch.plan_asked + k_plan_every)) {
        watch.plan = run.world().report().plan;
        watch.plan_asked = now;
    }
}

void forget(Watch& watch)
{
    watch.impacts.clear();
    watch.trails.clear();
    watch.samples.clear();
    watch.plan_asked = -1.0;
    watch.generation = -1;
}

} // namespace flying
