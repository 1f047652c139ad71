#include "play/watch.hpp"

#include <algorithm>
#include <cmath>

#include "collide/touching.hpp"
#include "motion/field.hpp"
#include "motion/kepler.hpp"
#include "play/run.hpp"
#include "play/seconds.hpp"

namespace flying {

namespace {

constexpr std::size_t k_trail_points = 24;
constexpr double k_trail_every = 0.03; ///< two frames: a point of a trail costs as much to draw as a body [s]
constexpr std::size_t k_all_trail_points = 12000;
constexpr std::size_t k_most_frames = 300;
constexpr double k_plan_every = 0.5;  ///< [s]
constexpr double k_touch = 1e-6;      ///< [sizes] gap of bodies that have just met
constexpr double k_unlike = 1e-9;     ///< [speeds] a change that is no rounding
constexpr double k_next_rest = 4.0;   ///< between two searches for next impacts, in times that the last one took
/// A search looks so far ahead at first, or a quarter as far as the last one did, then four times as far ... [s]
constexpr double k_next_first = 0x1p-10;
constexpr double k_next_within = 1.0; ///< ... as far as this [s]
constexpr double k_next_budget = 0.003; ///< a search that has found some and taken so long looks no farther [s]
constexpr std::size_t k_most_next = 24;

/// Where a body that was pushed touches: another, if it is one of two; else what stands around; else where it reaches
/// farthest against the push.
Vec2 touching_point(const World& world, const Inside& inside, int body, int other, const Vec2& push)
{
    const Pose pose = pose_of(world.state(body));
    const double size = bounding_radius(world.shape(body));
    std::vector<Touch> touches;
    const auto found = [&](const Shape& shape, const Pose& there) {
        find_touches(world.shape(body), pose, shape, there, k_touch * size, touches);
        return !touches.empty();
    };
    bool is_found = other >= 0 && found(world.shape(other), pose_of(world.state(other)));
    for (int k = 0; other < 0 && !is_found && k < world.body_count(); ++k) {
        if (!world.is_static(k)) continue;
        const double reach = size + bounding_radius(world.shape(k));
        if ((world.state(k).position - pose.position).norm() <= 1.001 * reach) is_found = found(world.shape(k), pose_of(world.state(k)));
    }
    for (std::size_t k = static_cast<std::size_t>(world.body_count()); other < 0 && !is_found && k < inside.shapes.size(); ++k) {
        const Shape& shape = inside.shapes[k].parts.front().shape;
        if (std::holds_alternative<HalfPlane>(shape)) is_found = found(shape, Pose());
    }
    if (!is_found) return pose.position - size / push.norm() * push;
    Vec2 sum = Vec2::Zero();
    for (const Touch& touch : touches) sum += pose.position + touch.r_a;
    return sum / static_cast<double>(touches.size());
}

void prepare(Watch& watch, const PlayRun& run)
{
    if (watch.inside_of == run.generation()) return;
    watch.inside = look_inside(run.world());
    watch.inside_of = run.generation();
}

} // namespace

void begin_watch(Watch& watch, const PlayRun& run)
{
    prepare(watch, run);
    watch.known_collisions = run.collisions();
    watch.flights.resize(static_cast<std::size_t>(run.world().body_count()));
    for (int k = 0; k < run.world().body_count(); ++k) {
        watch.flights[static_cast<std::size_t>(k)] = run.world().state(k);
        watch.flights[static_cast<std::size_t>(k)].time = run.world().time();
    }
}

void watch_event(Watch& watch, const PlayRun& run, double now)
{
    if (run.collisions() == watch.known_collisions) return;
    watch.known_collisions = run.collisions();

    // Who flies otherwise than it would have, was struck: one body, or two
    const World& world = run.world();
    int struck[2] = {-1, -1};
    Vec2 changes[2] = {Vec2::Zero(), Vec2::Zero()};
    int count = 0;
    for (int k = 0; k < world.body_count(); ++k) {
        BodyState& known = watch.flights[static_cast<std::size_t>(k)];
        if (world.mover(k) != World::Mover::events) continue;
        BodyState is = world.state(k);
        is.time = world.time();
        const BodyState was = flight(known, world.scene().world.field, is.time);
        known = is;
        const Vec2 change = is.velocity - was.velocity;
        if (!(change.norm() > k_unlike * (is.velocity.norm() + was.velocity.norm()))) continue;
        if (count < 2) {
            struck[count] = k;
            changes[count] = change;
        }
        ++count;
    }
    if (count < 1 || count > 2) return;
    SeenImpact seen;
    seen.seen = now;
    seen.push = changes[0] / run.inertia(struck[0]).inv_mass;
    seen.point = touching_point(world, watch.inside, struck[0], struck[1], seen.push);
    watch.impacts.push_back(seen);
    if (watch.impacts.size() > k_most_impacts) watch.impacts.pop_front();
}

void watch_present(Watch& watch, const PlayRun& run, const Look& look, double now)
{
    const bool wants_contacts = look.shows(Layer::contacts) || look.shows(Layer::normals) || look.shows(Layer::impulses) || look.shows(Layer::islands);
    if (wants_contacts || look.shows(Layer::cells) || look.shows(Layer::next)) prepare(watch, run);
    watch.contacts.clear();
    if (wants_contacts) watch.contacts = leaning_contacts(run.world(), watch.inside, run.options().step);
    if (!look.shows(Layer::next)) {
        watch.next.clear();
        watch.next_asked = -1.0;
        return;
    }
    if (watch.next_of != run.generation()) watch.next.clear();
    watch.next_of = run.generation();

    // However many bodies there are, the search takes a fifth of the time at most. The nearest future comes first: in a
    // crowd that is all that can be shown, and looking a second ahead would try most pairs
    if (watch.next_asked >= 0.0 && now <= watch.next_asked + k_next_rest * watch.next_took) return;
    const double started = seconds_now();
    const double first = std::clamp(0.25 * watch.next_within, k_next_first, k_next_within);
    for (double within = first; within <= k_next_within; within *= 4.0) {
        watch.next = next_impacts(run.world(), watch.inside, k_most_next, within);
        watch.next_within = within;
        watch.next_took = seconds_now() - started;
        if (watch.next.size() == k_most_next || (watch.next_took > k_next_budget && !watch.next.empty())) break;
    }
    watch.next_asked = now;
}

void FrameCosts::add(double cost)
{
    costs_.push_back(cost);
    if (costs_.size() > k_most_frames) costs_.pop_front();
}

double FrameCosts::quantile(double share) const
{
    if (costs_.empty()) return 0.0;
    std::vector<double> sorted(costs_.begin(), costs_.end());
    const auto place = static_cast<std::ptrdiff_t>(share * static_cast<double>(sorted.size() - 1));
    std::nth_element(sorted.begin(), sorted.begin() + place, sorted.end());
    return sorted[static_cast<std::size_t>(place)];
}

Sample sample_of(const PlayRun& run)
{
    const World& world = run.world();
    const Field& field = world.scene().world.field;
    Sample sample;
    sample.time = run.time();
    for (int k = 0; k < world.body_count(); ++k) {
        const Inertia& inertia = run.inertia(k);
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
    if (!watch.frames.empty()) watch.intervals.add(now - watch.frames.back());
    watch.frames.push_back(now);
    while (watch.frames.size() > 120) watch.frames.pop_front();
    while (!watch.impacts.empty() && watch.impacts.front().seen < now - 2.0 * k_impact_fades) watch.impacts.pop_front();

    const World& world = run.world();
    const std::size_t count = static_cast<std::size_t>(world.body_count());
    if (!look.shows(Layer::trails)) {
        watch.trails.clear();
    } else if (now >= watch.trails_grew + k_trail_every) {
        watch.trails_grew = now;
        if (watch.trails.size() != count) watch.trails.assign(count, {});
        const std::size_t most = std::clamp<std::size_t>(k_all_trail_points / std::max<std::size_t>(count, 1), 8, k_trail_points);
        for (std::size_t k = 0; k < count; ++k) {
            if (world.is_static(static_cast<int>(k))) continue;
            watch.trails[k].push_back(world.state(static_cast<int>(k)).position);
            while (watch.trails[k].size() > most) watch.trails[k].pop_front();
        }
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

} // namespace flying
