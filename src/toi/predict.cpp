#include "toi/predict.hpp"

#include <cmath>
#include <optional>
#include <utility>

#include "math/tolerance.hpp"
#include "toi/discs.hpp"
#include "toi/predict_central.hpp"
#include "toi/turning_features.hpp"
#include "toi/window.hpp"

namespace flying {
namespace {

/// Longest time in which nothing moves farther than `travel`: at speed `speed` now, gaining
/// `acceleration`.  [s]
[[nodiscard]] double time_to_travel(double travel, double speed, double acceleration)
{
    const double denominator = speed + std::sqrt(speed * speed + 2.0 * acceleration * travel);
    return denominator > 0.0 ? 2.0 * travel / denominator : k_never;
}

/// The two bodies of a search, the parts of it that don't change.
struct Search
{
    const Flyer& flyer_a;
    const Flyer& flyer_b;
    RelativeFlight relative;
    double radius_a = 0.0;    ///< of the bounding circle [m]
    double radius_b = 0.0;    ///< infinite for a wall [m]
    double acceleration = 0.0; ///< relative [m/s^2]
    double tip_speed = 0.0;   ///< of the fastest points about their centres [m/s]
    bool skips_far_vertices = true;
    std::span<const Seam> seams_a = {};
    std::span<const Seam> seams_b = {};
};

[[nodiscard]] Search make_search(const Flyer& a, double radius_a, const Flyer& b, double radius_b, double tip_speed)
{
    Search search{a, b, relative_flight(a, b, common_start(a, b)), radius_a, radius_b, 0.0, tip_speed, true, {}, {}};
    search.acceleration = search.relative.acceleration.norm();
    return search;
}

/// The next window of turning features, no longer than to `latest`.
[[nodiscard]] Window next_window(const Search& search, double time, double latest)
{
    const double smaller = std::min(search.radius_a, search.radius_b);
    const double speed = search.relative.rate_at(time).norm();
    const double length = time_to_travel(k_window_travel * smaller, speed + search.tip_speed, search.acceleration);

    Window window;
    window.from = time;
    window.skips_far_vertices = search.skips_far_vertices;
    window.seams_a = search.seams_a;
    window.seams_b = search.seams_b;
    window.until = std::min(latest, std::max(time + length, next_after(time)));
    window.speed = speed;
    if (search.acceleration > 0.0) window.speed += search.acceleration * (window.until - time);

    // Take rounding from the coordinates and speeds in this window
    const Vec2 position = flight(search.flyer_a.state, search.flyer_a.acceleration, time).position;
    const bool b_is_wall = search.radius_b == k_never;
    const double other_reach = b_is_wall ? 0.0 : flight(search.flyer_b.state, search.flyer_b.acceleration, time).position.norm();
    const double larger = b_is_wall ? search.radius_a : std::max(search.radius_a, search.radius_b);
    const double reach = std::max(position.norm(), other_reach) + window.speed * (window.until - time);
    const double top_speed = window.speed + search.tip_speed;
    window.tolerance = gap_tolerance(smaller, larger, reach, top_speed, window.until);

    return window;
}

[[nodiscard]] Prediction impact(const Strike& strike) { return {Prediction::Kind::impact, strike.time, strike.feature}; }
[[nodiscard]] Prediction not_before(double time) { return {Prediction::Kind::not_before, time, {}}; }
[[nodiscard]] Prediction put_off(double time)
{
    return {Prediction::Kind::put_off, time, {}};
}

/// Look through one window. Returns an answer, or nothing where the search goes on after it.
template <typename Look>
[[nodiscard]] std::optional<Prediction> look_through(const Look& look, const Window& window)
{
    const Strike strike = look(window);
    if (strike.kind == MarchEnd::Kind::strike) return impact(strike);
    if (strike.kind == MarchEnd::Kind::tired) return not_before(strike.time);
    return std::nullopt;
}

/// Window after window from `from` to `until`.
/// horizon  of the first window; infinite but where it is the first of all [s]
template <typename Look>
[[nodiscard]] std::optional<Prediction> look_from(const Search& search, const Look& look, double from, double until,
                                                  int& windows, double horizon = k_never)
{
    double time = from;
    while (time < until) {
        if (windows-- <= 0) return not_before(time);
        Window window = next_window(search, time, until);
        if (window.until == k_never && window.speed + search.tip_speed == 0.0) return Prediction{};
        window.horizon = horizon;
        if (const auto answer = look_through(look, window)) return answer;
        if (horizon < window.until) return put_off(horizon);
        horizon = k_never;
        time = window.until;
    }
    return std::nullopt;
}

/// Two bodies under one acceleration: their circles overlap in one interval, which a quadratic gives.
template <typename Look>
[[nodiscard]] Prediction search_straight(const Search& search, const Look& look, double from,
                                         const PredictOptions& options)
{
    const double radius = bounding_reach(search.radius_a + search.radius_b);
    const Passage passage = passage_through_circle(search.relative.offset, search.relative.rate, radius);
    const double start = search.relative.start;
    const double enter = std::max(start, start + passage.enter);
    // What overlaps already is looked at now: a look that is due at once needn't be queued
    int windows = enter <= from ? std::max(options.windows, 1) : options.windows;

    // With the skip off, see for ourselves that nothing happens before the circles meet
    if (!options.skips_far_features && from < enter) {
        const double end = passage.enter == k_never ? from : enter;
        if (const auto answer = look_from(search, look, from, end, windows)) return *answer;
    }
    if (passage.enter == k_never) return {};
    const double horizon = from <= enter ? options.horizon : k_never;
    const double end = start + passage.leave;
    if (const auto answer = look_from(search, look, std::max(from, enter), end, windows, horizon)) return *answer;
    return {};
}

/// One of the two falls and the other doesn't: safe steps until the circles meet, then windows.
template <typename Look>
[[nodiscard]] Prediction search_curved(const Search& search, const Look& look, double from,
                                       const PredictOptions& options)
{
    constexpr double k_close = 1e-6; // [radii] circles this close count as met: steps shrink with the gap
    const double radius = (search.radius_a + search.radius_b) * (1.0 + k_close);
    int windows = std::max(options.windows, 1); // the first step needs no features
    double time = from;
    for (;;) {
        const Vec2 offset = search.relative.offset_at(time);
        const double distance = offset.norm();
        if (distance > radius) {
            const double rate = offset.dot(search.relative.rate_at(time)) / distance;
            const double clear = time + safe_step(distance - radius * (1.0 - 0.5 * k_close), rate, search.acceleration);
            if (clear == k_never) return {};
            if (windows-- <= 0) return not_before(time);
            if (!options.skips_far_features) {
                int more = options.windows;
                const auto answer = look_from(search, look, time, clear, more);
                if (answer && answer->kind == Prediction::Kind::impact) return *answer;
            }
            time = clear;
            continue;
        }
        if (windows-- <= 0) return not_before(time);
        const Window window = next_window(search, time, k_never);
        if (const auto answer = look_through(look, window)) return *answer;
        time = window.until;
    }
}

template <typename Look>
[[nodiscard]] Prediction search_pair(const Search& search, const Look& look, double from, const PredictOptions& options)
{
    return search.acceleration == 0.0 ? search_straight(search, look, from, options)
                                      : search_curved(search, look, from, options);
}

[[nodiscard]] Prediction search(const Disc& a, const Flyer& flyer_a, const Disc& b, const Flyer& flyer_b, double from,
                                const PredictOptions& options)
{
    // Turning discs look the same from every side: no tips
    const Search pair = make_search(flyer_a, a.radius, flyer_b, b.radius, 0.0);
    if (pair.acceleration == 0.0) {
        const double wait = time_to_meet(pair.relative.offset, pair.relative.rate, a.radius + b.radius);
        return wait == k_never ? Prediction{} : impact({MarchEnd::Kind::strike, pair.relative.start + wait, {}});
    }

    const auto look = [&](const Window& window) { return first_strike(a, b, pair.relative, window); };
    return search_curved(pair, look, from, options);
}

[[nodiscard]] Prediction search(const Disc& a, const Flyer& flyer_a, const Polygon& b, const Flyer& flyer_b, double from,
                                const PredictOptions& options)
{
    Search pair = make_search(flyer_a, a.radius, flyer_b, b.radius(), tip_speed(b, flyer_b));
    pair.skips_far_vertices = options.skips_far_features; // of the polygon's edges and corners, those that stay clear
    pair.seams_b = options.seams_b;
    const Turning turning_b(flyer_b.state);
    const auto look = [&](const Window& window) { return first_strike(a, b, turning_b, pair.relative, window); };
    return search_pair(pair, look, from, options);
}

[[nodiscard]] Prediction search(const Polygon& a, const Flyer& flyer_a, const Polygon& b, const Flyer& flyer_b,
                                double from, const PredictOptions& options)
{
    const double tips = tip_speed(a, flyer_a) + tip_speed(b, flyer_b);
    Search pair = make_search(flyer_a, a.radius(), flyer_b, b.radius(), tips);
    pair.skips_far_vertices = options.skips_far_vertices;
    pair.seams_a = options.seams_a;
    pair.seams_b = options.seams_b;
    const Turning turning_a(flyer_a.state);
    const Turning turning_b(flyer_b.state);
    const auto look = [&](const Window& window) {
        return first_strike(a, turning_a, b, turning_b, pair.relative, window);
    };
    return search_pair(pair, look, from, options);
}

[[nodiscard]] Prediction search(const Disc& a, const Flyer& flyer_a, const HalfPlane& b, const Flyer&, double,
                                const PredictOptions&)
{
    const BodyState& state = flyer_a.state;
    const double height = b.normal.dot(state.position) - b.offset - a.radius;
    const double wait = time_to_fall(height, b.normal.dot(state.velocity), b.normal.dot(flyer_a.acceleration));
    return wait == k_never ? Prediction{} : impact({MarchEnd::Kind::strike, state.time + wait, {}});
}

[[nodiscard]] Prediction search(const Polygon& a, const Flyer& flyer_a, const HalfPlane& b, const Flyer&, double from,
                                const PredictOptions& options)
{
    // Along the wall nothing matters: keep the motion along its normal
    const Flyer ground;
    Search pair = make_search(flyer_a, a.radius(), ground, k_never, tip_speed(a, flyer_a));
    pair.relative.rate = b.normal.dot(pair.relative.rate) * b.normal;
    pair.relative.acceleration = b.normal.dot(pair.relative.acceleration) * b.normal;
    pair.acceleration = pair.relative.acceleration.norm();
    const Turning turning_a(flyer_a.state);
    const double bend = b.normal.dot(flyer_a.acceleration);
    const double radius = bounding_reach(a.radius());
    const auto look = [&](const Window& window) { return first_strike(a, turning_a, b, pair.relative, window); };

    int windows = options.windows;
    double time = from;
    for (;;) {
        // Wait until the bounding circle comes down to the wall; it may rise and fall once more
        const double height = b.normal.dot(pair.relative.offset_at(time)) - b.offset - radius;
        const double rate = b.normal.dot(pair.relative.rate_at(time));
        if (height > 0.0) {
            const double fall = falling_root(height, rate, bend);
            if (!options.skips_far_features) {
                int more = options.windows;
                const auto answer = look_from(pair, look, time, fall == k_never ? time : time + fall, more);
                if (answer && answer->kind == Prediction::Kind::impact) return *answer;
            }
            if (fall == k_never) return {};
            const double later = time + fall;
            time = later > time ? later : next_after(time);
        }

        if (height <= 0.0 && time == from) windows = std::max(windows, 1); // a look that is due at once
        if (windows-- <= 0) return not_before(time);

        // Within reach, or leaving: windows as short as the body's own motion asks
        const Window window = next_window(pair, time, k_never);
        if (window.until == k_never) return {};
        if (const auto answer = look_through(look, window)) return *answer;
        time = window.until;
    }
}

template <typename A, typename B>
concept Ordered = requires(const A& a, const B& b, const Flyer& flyer) { search(a, flyer, b, flyer, 0.0, PredictOptions{}); };

} // namespace

Prediction predict(const Shape& a, const Flyer& flyer_a, const Shape& b, const Flyer& flyer_b, double from,
                   const PredictOptions& options)
{
    if (flyer_a.central || flyer_b.central) return predict_central(a, flyer_a, b, flyer_b, from, options);
    const auto visit = [&](const auto& shape_a, const auto& shape_b) -> Prediction {
        using A = std::decay_t<decltype(shape_a)>;
        using B = std::decay_t<decltype(shape_b)>;
        if constexpr (Ordered<A, B>) return search(shape_a, flyer_a, shape_b, flyer_b, from, options);
        else if constexpr (Ordered<B, A>) {
            PredictOptions other_way = options;
            std::swap(other_way.seams_a, other_way.seams_b);
            return swapped(search(shape_b, flyer_b, shape_a, flyer_a, from, other_way));
        } else return {};
    };
    return std::visit(visit, a, b);
}

} // namespace flying
