#include "toi/predict_central.hpp"

#include <cmath>
#include <optional>

#include "math/tolerance.hpp"
#include "toi/central_flight.hpp"
#include "toi/turning_features.hpp"
#include "toi/window.hpp"

namespace flying {
namespace {

/// [radii] Circles this close count as met: steps shrink with the gap.
constexpr double k_close = 1e-6;

/// Two bodies of a search.
struct CentralSearch
{
    CentralPairFlight relative;
    Vec2 centre = Vec2::Zero(); ///< [m]
    double radius_a = 0.0;      ///< of the bounding circle [m]
    double radius_b = 0.0;      ///< 0 for a wall [m]
    double smaller = 0.0;       ///< of the two; A's for a wall [m]
    double tip_speed = 0.0;     ///< of the fastest points about their centres [m/s]
    double reach = 0.0;         ///< of the coordinates from which the paths are known [m]
    bool skips_far_vertices = true;
};

[[nodiscard]] double radius_of(const Disc& disc)
{
    return disc.radius;
}
[[nodiscard]] double radius_of(const Polygon& polygon)
{
    return polygon.radius();
}

template <typename A, typename B>
[[nodiscard]] CentralSearch make_search(const A& a, const Flyer& flyer_a, const B& b, const Flyer& flyer_b)
{
    const CentralField& field = flyer_a.central ? *flyer_a.central : *flyer_b.central;
    CentralSearch search{CentralPairFlight(flyer_a, flyer_b, field), field.centre};
    search.radius_a = radius_of(a);
    if constexpr (!std::is_same_v<B, HalfPlane>) search.radius_b = radius_of(b);
    search.smaller = search.radius_b > 0.0 ? std::min(search.radius_a, search.radius_b) : search.radius_a;
    search.tip_speed = tip_speed(a, flyer_a) + tip_speed(b, flyer_b);
    search.reach =
        field.centre.norm() + std::max(search.relative.a().start_distance(), search.relative.b().start_distance());
    return search;
}

/// Set the bound on the relative acceleration that holds from `time` on.
/// Returns until when.  [s]
double look_ahead(CentralSearch& search, double time)
{
    CentralPairFlight& relative = search.relative;
    const CentralPath::Outlook a = relative.a().outlook(relative.place_a(time), time);
    const CentralPath::Outlook b = relative.b().outlook(relative.place_b(time), time);
    relative.set_bound(a.acceleration + b.acceleration);
    return std::min(a.until, b.until);
}

/// The next window of features, no longer than to `latest`, up to which the bound that is set holds.
[[nodiscard]] Window next_window(const CentralSearch& search, double time, double latest)
{
    const double bound = search.relative.bound();
    const double travel = k_window_travel * search.smaller;
    const double speed = search.relative.rate_at(time).norm();
    const double fastest = speed + search.tip_speed;
    const double length = 2.0 * travel / (fastest + std::sqrt(fastest * fastest + 2.0 * bound * travel));

    Window window;
    window.from = time;
    window.skips_far_vertices = search.skips_far_vertices;
    window.until = std::max(std::min(latest, time + length), next_after(time));
    window.speed = speed + bound * (window.until - time);

    // Take rounding from the coordinates and speeds in this window
    const double place = std::max(search.relative.place_a(time).norm(), search.relative.place_b(time).norm());
    const double way = window.speed * (window.until - time);
    const double reach = std::max(search.reach, search.centre.norm() + place + way);
    const double larger = std::max(search.radius_a, search.radius_b);
    window.tolerance = gap_tolerance(search.smaller, larger, reach, window.speed + search.tip_speed, window.until);

    return window;
}

/// How far apart two bounding circles are, and how fast that changes.
struct Apart
{
    double gap = 0.0;  ///< [m]
    double rate = 0.0; ///< [m/s]
};

/// Two bodies that keep to rings round the centre that don't overlap never meet.
[[nodiscard]] bool never_meet(const CentralSearch& search)
{
    const CentralPath& a = search.relative.a();
    const CentralPath& b = search.relative.b();
    const double reach = bounding_reach(search.radius_a + search.radius_b);
    const double rounding = tolerance::k_bounding_margin * search.reach;
    return a.nearest() - b.farthest() > reach + rounding || b.nearest() - a.farthest() > reach + rounding;
}

[[nodiscard]] Apart circles_apart(const CentralSearch& search, double time)
{
    const Vec2 offset = search.relative.offset_at(time);
    const double distance = offset.norm();
    const double reach = (search.radius_a + search.radius_b) * (1.0 + 0.5 * k_close);
    return {distance - reach, offset.dot(search.relative.rate_at(time)) / distance};
}

/// A body that stays within a ring round the centre may never come down to a wall.
[[nodiscard]] bool never_meet(const CentralSearch& search, const HalfPlane& wall)
{
    const double height = wall.normal.dot(search.centre) - wall.offset;
    const double rounding = tolerance::k_bounding_margin * (search.reach + std::abs(wall.offset));
    return height - search.relative.a().farthest() > bounding_reach(search.radius_a) + rounding;
}

[[nodiscard]] Apart circles_apart(const CentralSearch& search, const HalfPlane& wall, double time)
{
    const double height = wall.normal.dot(search.relative.offset_at(time)) - wall.offset;
    return {height - search.radius_a * (1.0 + 0.5 * k_close), wall.normal.dot(search.relative.rate_at(time))};
}

/// Safe steps until the bounding circles meet, then windows; each no longer than its bound on the acceleration holds.
template <typename Gap, typename Look>
[[nodiscard]] Prediction search_central(CentralSearch& search, const Gap& apart, const Look& look, double from,
                                        const PredictOptions& options)
{
    int windows = std::max(options.windows, 1);
    double time = from;
    for (;;) {
        const double latest = look_ahead(search, time);
        const Apart now = apart(time);
        const bool is_far = now.gap > 0.5 * k_close * (search.radius_a + search.radius_b);
        if (windows-- <= 0) return {Prediction::Kind::not_before, time, {}};
        double until = latest;

        if (is_far) {
            const double clear = time + safe_step(now.gap, now.rate, search.relative.bound());
            until = std::max(std::min(latest, clear), next_after(time));
            if (until == k_never) return {};
        }

        // With the skip off, see for ourselves that nothing happens before the circles meet
        while (time < until && !(is_far && options.skips_far_features)) {
            const Window window = next_window(search, time, until);
            const Strike strike = look(window);
            if (strike.kind == MarchEnd::Kind::strike) return {Prediction::Kind::impact, strike.time, strike.feature};
            time = window.until;
            if (is_far) continue;
            if (strike.kind == MarchEnd::Kind::tired) return {Prediction::Kind::not_before, strike.time, {}};
            break;
        }

        if (is_far) time = until;
    }
}

/// A disc against a wall.
[[nodiscard]] Strike strike_on_wall(const Disc& disc, const CentralSearch& search, const HalfPlane& wall,
                                    const Window& window)
{
    const double bend = search.relative.bound() * (1.0 + tolerance::k_bend_margin);
    const MarchBounds bounds{bend, k_never, k_never, window.tolerance};
    const auto read = [&](double time) {
        const double height = wall.normal.dot(search.relative.offset_at(time)) - wall.offset - disc.radius;
        return EdgeReading{height, wall.normal.dot(search.relative.rate_at(time)), 0.0, 0.0};
    };
    const MarchEnd end = march(read(window.from), read, bounds, window.from, window.until);
    return {end.kind, end.time, {}};
}

template <typename A, typename B>
[[nodiscard]] Prediction search(const A& a, const Flyer& flyer_a, const B& b, const Flyer& flyer_b, double from,
                                const PredictOptions& options)
{
    CentralSearch pair = make_search(a, flyer_a, b, flyer_b);
    pair.skips_far_vertices = options.skips_far_vertices;
    const Turning turning_a(flyer_a.state);
    const Turning turning_b(flyer_b.state);

    const auto look = [&](const Window& window) {
        constexpr bool a_is_disc = std::is_same_v<A, Disc>;
        if constexpr (std::is_same_v<B, HalfPlane>) {
            if constexpr (a_is_disc) return strike_on_wall(a, pair, b, window);
            else return first_strike(a, turning_a, b, pair.relative, window);
        } else if constexpr (a_is_disc && std::is_same_v<B, Disc>) {
            return first_strike(a, b, pair.relative, window);
        } else if constexpr (a_is_disc) {
            return first_strike(a, b, turning_b, pair.relative, window);
        } else {
            return first_strike(a, turning_a, b, turning_b, pair.relative, window);
        }
    };

    if constexpr (std::is_same_v<B, HalfPlane>) {
        if (options.skips_apart_rings && never_meet(pair, b)) return {};
        const auto apart = [&](double time) { return circles_apart(pair, b, time); };
        return search_central(pair, apart, look, from, options);
    } else {
        if (options.skips_apart_rings && never_meet(pair)) return {};
        const auto apart = [&](double time) { return circles_apart(pair, time); };
        return search_central(pair, apart, look, from, options);
    }
}

/// Pairs as the searches take them: discs first, walls last.
template <typename A, typename B>
constexpr bool k_ordered = std::is_same_v<A, Disc> ? true : std::is_same_v<A, Polygon> && !std::is_same_v<B, Disc>;

} // namespace

Prediction predict_central(const Shape& a, const Flyer& flyer_a, const Shape& b, const Flyer& flyer_b, double from,
                           const PredictOptions& options)
{
    const auto visit = [&](const auto& shape_a, const auto& shape_b) -> Prediction {
        using A = std::decay_t<decltype(shape_a)>;
        using B = std::decay_t<decltype(shape_b)>;
        if constexpr (k_ordered<A, B>) return search(shape_a, flyer_a, shape_b, flyer_b, from, options);
        else if constexpr (k_ordered<B, A>) return swapped(search(shape_b, flyer_b, shape_a, flyer_a, from, options));
        else return {};
    };
    return std::visit(visit, a, b);
}

} // namespace flying
