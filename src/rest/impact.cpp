#include "rest/impact.hpp"

#include <algorithm>
#include <vector>

#include "response/impact.hpp"
#include "rest/rest_tolerance.hpp"

namespace flying {
namespace {

/// A contact as the law of two bodies wants it: its place from both centres, from the arms of its pushes.
[[nodiscard]] ImpactPoint impact_point(const ContactPoint& c)
{
    const Vec2 n(c.n_x, c.n_y);
    const Vec2 t(-c.n_y, c.n_x);
    return {c.tangent_arm_a * n - c.normal_arm_a * t, c.tangent_arm_b * n - c.normal_arm_b * t, n};
}

[[nodiscard]] ImpactBody impact_body(const Mover& body)
{
    return {Vec2(body.v_x, body.v_y), body.spin, {body.inv_mass, body.inv_moment}};
}

void set_velocity(Mover& body, const Vec2& velocity, double spin)
{
    body.v_x = velocity.x();
    body.v_y = velocity.y();
    body.spin = spin;
}

/// The points of two bodies, among all that an impact may strike.
struct PairOfBodies
{
    int a = 0;
    int b = 0;
    std::size_t first = 0;
    std::size_t end = 0;
};

[[nodiscard]] std::vector<PairOfBodies> pairs_of(std::span<const ContactPoint> points)
{
    std::vector<PairOfBodies> pairs;
    for (std::size_t k = 0; k < points.size(); ++k) {
        const ContactPoint& c = points[k];
        if (pairs.empty() || pairs.back().a != c.a || pairs.back().b != c.b) pairs.push_back({c.a, c.b, k, k});
        pairs.back().end = k + 1;
    }
    return pairs;
}

/// Strikes a pair, if one of its points arrives fast enough. Whether it did.
/// places  the points, as the law of two bodies wants them
bool strike(const PairOfBodies& pair, std::span<Mover> velocities, std::span<const ContactPoint> points,
            std::span<const ImpactPoint> places, std::span<const double> slowest)
{
    Mover& a = velocities[pair.a];
    Mover& b = velocities[pair.b];
    bool arrives = false;
    for (std::size_t k = pair.first; k < pair.end && !arrives; ++k)
        arrives = normal_speed(points[k], a, b) < -slowest[k];
    if (!arrives) return false;
    const std::span<const ImpactPoint> of_pair = places.subspan(pair.first, pair.end - pair.first);
    const ContactPoint& one = points[pair.first];
    const ImpactResult after = resolve_impact(impact_body(a), impact_body(b), of_pair, {one.restitution, one.friction});
    if (!after.any_push) return false;
    if (a.inv_mass > 0.0) set_velocity(a, after.velocity_a, after.spin_a);
    if (b.inv_mass > 0.0) set_velocity(b, after.velocity_b, after.spin_b);
    return true;
}

/// The first pair up to one that shares a body with it that moves.
[[nodiscard]] std::size_t first_with(std::span<const PairOfBodies> pairs, std::size_t last,
                                     std::span<const Mover> velocities)
{
    const auto has = [&](const PairOfBodies& pair, int body) {
        return velocities[body].inv_mass > 0.0 && (pair.a == body || pair.b == body);
    };
    std::size_t first = 0;
    while (first < last && !has(pairs[first], pairs[last].a) && !has(pairs[first], pairs[last].b)) ++first;
    return first;
}

} // namespace

int throw_back(std::span<Mover> velocities, std::span<const ContactPoint> points, std::span<const double> slowest)
{
    // One after the other, always the first pair that arrives: the order in which events come at one moment
    const std::vector<PairOfBodies> pairs = pairs_of(points);
    std::vector<ImpactPoint> places;
    for (const ContactPoint& c : points) places.push_back(impact_point(c));
    const int most = rest_tolerance::k_patience * static_cast<int>(pairs.size());
    int impacts = 0;
    for (std::size_t k = 0; k < pairs.size() && impacts < most;) {
        if (strike(pairs[k], velocities, points, places, slowest)) {
            ++impacts;
            k = first_with(pairs, k, velocities);
        } else ++k;
    }
    return impacts;
}

} // namespace flying
