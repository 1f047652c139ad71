#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "collide/touching.hpp"
#include "events/event_engine.hpp"
#include "math/hash.hpp"
#include "math/random.hpp"
#include "math/roots.hpp"
#include "toi/predict.hpp"

// An event engine on one page: every pair anew after every impact, with one skip that can
// be spoilt.
namespace flying {


/// How a pair is looked at before its corners are.
enum class Bound
{
    none,   ///< corners at once
    right,  ///< corners while the bounding circles overlap
    spoilt, ///< corners while circles overlap that are a hundredth too small
};



class PlainEngine
{
public:
    PlainEngine(std::vector<EventBody> bodies, Bound bound)
        : bodies_(std::move(bodies)), bound_(bound)
    {
    }

    bool step();
    [[nodiscard]] std::uint64_t hash() const { return log_.value(); }
    [[nodiscard]] double time() const { return time_; }
    [[nodiscard]] double deepest() const { return deepest_; }
    [[nodiscard]] double energy() const;
    [[nodiscard]] BodyState state(int body, double time) const
    {
        return state_at(bodies_[body].flyer, time);
    }

private:
    [[nodiscard]] double foresee(int a, int b) const;
    [[nodiscard]] std::optional<double> spoilt_start(int a, int b) const;
    void strike(int a, int b, double time);

    std::vector<EventBody> bodies_;
    Bound bound_;
    Hash log_;
    double time_ = 0.0;
    double deepest_ = 0.0;
};



/// When a pair's circles, a hundredth too small, begin to overlap; nothing where they never
/// do.
inline std::optional<double> PlainEngine::spoilt_start(int a, int b) const
{
    constexpr double k_spoilt = 0.99;
    const Flyer& flyer_a = bodies_[a].flyer;
    const Flyer& flyer_b = bodies_[b].flyer;
    const double start = common_start(flyer_a, flyer_b);
    const BodyState at_a = state_at(flyer_a, start);
    const BodyState at_b = state_at(flyer_b, start);
    const double reach_a = k_spoilt * bounding_radius(bodies_[a].shape);
    if (const auto* wall = std::get_if<HalfPlane>(&bodies_[b].shape)) {
        const double height = wall->normal.dot(at_a.position) - wall->offset - reach_a;
        const double rate = wall->normal.dot(at_a.velocity);
        if (rate >= 0.0) return std::nullopt;
        return start + std::max(0.0, -height / rate);
    }
    const double reach = reach_a + k_spoilt * bounding_radius(bodies_[b].shape);
    const Passage passage = passage_through_circle(at_a.position - at_b.position,
                                                   at_a.velocity - at_b.velocity, reach);
    if (!(passage.leave > 0.0)) return std::nullopt;
    return start + std::max(0.0, passage.enter);
}



/// When two bodies meet as they fly now.  [s]
inline double PlainEngine::foresee(int a, int b) const
{
    const Flyer& flyer_a = bodies_[a].flyer;
    const Flyer& flyer_b = bodies_[b].flyer;
    PredictOptions options;
    options.skips_far_features = bound_ != Bound::none;
    const auto look_from = [&](double from) {
        for (;;) {
            const Prediction p = predict(bodies_[a].shape, flyer_a, bodies_[b].shape,
                                         flyer_b, from, options);
            if (p.kind != Prediction::Kind::not_before) return p.time;
            from = p.time;
        }
    };
    const double time = look_from(common_start(flyer_a, flyer_b));
    if (bound_ != Bound::spoilt) return time;

    // What lies before the spoilt start is overlooked until then; what lies after it keeps
    // its bits
    const std::optional<double> start = spoilt_start(a, b);
    if (!start || time == k_never) return k_never;
    return time >= *start ? time : look_from(*start);
}



/// Bring two bodies to their impact, and push them apart.
inline void PlainEngine::strike(int a, int b, double time)
{
    EventBody& body_a = bodies_[a];
    EventBody& body_b = bodies_[b];
    body_a.flyer.state = state_at(body_a.flyer, time);
    if (!body_b.is_static) body_b.flyer.state = state_at(body_b.flyer, time);

    std::vector<Touch> touches;
    for (double slack = 1e-11; touches.empty() && slack < 1.0; slack *= 16.0) {
        find_touches(body_a.shape, pose_of(body_a.flyer.state), body_b.shape,
                     pose_of(body_b.flyer.state), slack, touches);
    }
    std::vector<ImpactPoint> points;
    for (const Touch& touch : touches) {
        points.push_back({touch.r_a, touch.r_b, touch.normal});
        deepest_ = std::max(deepest_, -touch.separation);
    }
    const auto moving = [](const EventBody& body) {
        return ImpactBody{body.flyer.state.velocity, body.flyer.state.spin, body.inertia};
    };
    const ImpactResult after =
        resolve_impact(moving(body_a), moving(body_b), points, body_a.material);
    body_a.flyer.state.velocity = after.velocity_a;
    body_a.flyer.state.spin = after.spin_a;
    if (body_b.is_static) return;
    body_b.flyer.state.velocity = after.velocity_b;
    body_b.flyer.state.spin = after.spin_b;
}



/// The next impact of all. False where there is none.
inline bool PlainEngine::step()
{
    double first = k_never;
    int first_a = -1;
    int first_b = -1;
    const int count = static_cast<int>(bodies_.size());
    for (int a = 0; a < count; ++a) {
        for (int b = a + 1; b < count && !bodies_[a].is_static; ++b) {
            const double time = foresee(a, b);
            if (time < first) first = time, first_a = a, first_b = b;
        }
    }
    if (first == k_never) return false;
    time_ = std::max(time_, first);
    strike(first_a, first_b, first);
    // [skipping-work.plain.log]
    for (const int body : {first_a, first_b}) {
        const BodyState& s = bodies_[body].flyer.state;
        log_.add(std::array{first, s.position.x(), s.position.y(), s.velocity.x(),
                            s.velocity.y(), s.angle, s.spin});
    }
    // [skipping-work.plain.log]
    return true;
}



/// Energy of motion.  [J]
inline double PlainEngine::energy() const
{
    double sum = 0.0;
    for (const EventBody& body : bodies_) {
        if (body.is_static) continue;
        const BodyState& s = body.flyer.state;
        sum += 0.5 * s.velocity.squaredNorm() / body.inertia.inv_mass;
        sum += 0.5 * s.spin * s.spin / body.inertia.inv_moment_of_inertia;
    }
    return sum;
}



/// Nine hexagons of radius 0.5 m that turn as they fly, in a box of 6 m.
inline std::vector<EventBody> hexagons(std::uint64_t seed)
{
    Random random(seed);
    std::vector<Vec2> ring;
    for (int k = 0; k < 6; ++k)
        ring.push_back(Rotation::of(k * 1.0471975512) * Vec2(0.5, 0.0));
    std::vector<EventBody> bodies;
    for (int k = 0; k < 9; ++k) {
        EventBody body{Polygon({ring}), {}, {1.0, 9.6}, {1.0, 0.0}, false};
        body.flyer.state.position = Vec2(1.0 + 2.0 * (k % 3), 1.0 + 2.0 * (k / 3));
        body.flyer.state.velocity =
            Vec2{random.uniform(-2.0, 2.0), random.uniform(-2.0, 2.0)};
        body.flyer.state.spin = random.uniform(-3.0, 3.0);
        bodies.push_back(body);
    }
    const auto wall = [&](const Vec2& normal, double offset) {
        bodies.push_back({HalfPlane{normal, offset}, {}, {}, {1.0, 0.0}, true});
    };
    wall({1.0, 0.0}, 0.0);
    wall({-1.0, 0.0}, -6.0);
    wall({0.0, 1.0}, 0.0);
    wall({0.0, -1.0}, -6.0);
    return bodies;
}


} // namespace flying
