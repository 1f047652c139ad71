#include "stress/random_pairs.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "stress/random_draws.hpp"
#include "toi/predict.hpp"

namespace flying::stress {
namespace {

/// Any way, and a length between two. (Draws are statements of their own here: in one expression compilers choose their
/// order, and a seed would mean another pair to each.)
Vec2 random_vector(Random& random, double least, double greatest)
{
    const Vec2 way = direction(random.uniform(0.0, 6.3));
    return log_uniform(random, least, greatest) * way;
}

std::vector<Vec2> star_ring(Random& random, int corners, double least, double greatest)
{
    // No gap of half a turn between neighbours, or the origin would lie outside and the ring might turn the wrong way
    const double play = corners == 3 ? 0.45 : 0.8;
    std::vector<Vec2> ring;
    for (int k = 0; k < corners; ++k) {
        const double radius = random.uniform(least, greatest);
        ring.push_back(radius * direction(2.0 * k_pi * (k + random.uniform(0.0, play)) / corners));
    }
    return ring;
}

using Rings = std::vector<std::vector<Vec2>>;

/// Rings about the origin, within a circle of radius 1; none for a disc.
Rings random_rings(Random& random)
{
    const int kind = random.below(10);
    if (kind < 2) return {};
    if (kind < 4) {
        const double w = random.uniform(0.2, 0.9);
        const double h = kind == 2 ? random.uniform(0.1, 0.4) : log_uniform(random, 1e-3, 0.1);
        return {{{-w, -h}, {w, -h}, {w, h}, {-w, h}}};
    }
    if (kind < 6) {
        const int sides = 3 + random.below(6);
        std::vector<Vec2> ring;
        for (int k = 0; k < sides; ++k) ring.push_back(direction(2.0 * k_pi * k / sides));
        return {ring};
    }
    const int corners = 3 + random.below(6);
    return {star_ring(random, corners, 0.3, 1.0)};
}

Outline outline_of(const Rings& rings, double size)
{
    if (rings.empty()) return disc_outline(size);
    Rings scaled = rings;
    for (auto& ring : scaled) {
        for (Vec2& vertex : ring) vertex *= size;
    }
    return rings_outline(scaled);
}

Shape shape_of(const Rings& rings, double size)
{
    if (rings.empty()) return Disc{size};
    Rings scaled = rings;
    for (auto& ring : scaled) {
        for (Vec2& vertex : ring) vertex *= size;
    }
    return Polygon(scaled);
}

double random_spin(Random& random, double unit)
{
    // In radians in the time the pair takes to pass by
    const int kind = random.below(20);
    const double sign = random.below(2) == 0 ? 1.0 : -1.0;
    if (kind < 4) return 0.0;
    if (kind == 4) return sign * unit * log_uniform(random, 10.0, 1000.0);
    if (kind == 5) return sign * unit * log_uniform(random, 1e-9, 1e-2);
    return unit * random.uniform(-6.0, 6.0);
}

double bounding(const Outline& outline)
{
    return outline.radius;
}

/// Move A along the line of the pair's least gap, so that the path grazes: passes by with a gap of `graze`, or strikes that
/// deep where it is negative. False where it doesn't come to that.
bool make_graze(FlyingPair& pair, double start, double horizon, double graze)
{
    for (int k = 0; k < 12; ++k) {
        double when = 0.0;
        const double gap = least_gap(pair, start, horizon, when);
        const bool is_within = when > start && when < horizon;
        if (!std::isfinite(gap) || !is_within || gap > 0.5 * pair.a.radius) return false;

        // Which way the gap grows, by differences
        const double h = std::min(1e-6 * pair.a.radius, 0.5 * gap);
        Vec2 slope;
        for (int axis = 0; axis < 2; ++axis) {
            FlyingPair moved = pair;
            moved.flyer_a.state.position[axis] += h;
            const double up = gap_at(moved, when);
            moved.flyer_a.state.position[axis] -= 2.0 * h;
            slope[axis] = (up - gap_at(moved, when)) / (2.0 * h);
        }
        const double steepness = slope.squaredNorm();
        if (!(steepness > 0.01)) return false;
        const double off = gap - std::abs(graze);
        const bool is_near = std::abs(off) <= 0.2 * std::abs(graze);
        if (is_near && graze > 0.0) return true;

        // Never farther than nearly the gap, for the least gap may soon be elsewhere; the last step goes through
        const double way = is_near ? 2.0 * std::abs(graze) : std::min(off, 0.9 * gap);
        pair.flyer_a.state.position -= way / steepness * slope;
        if (is_near) return true;
    }
    return false;
}

double smaller_of(const FlyingPair& pair)
{
    return pair.b.kind == Outline::Kind::wall ? pair.a.radius : std::min(pair.a.radius, pair.b.radius);
}

} // namespace

RandomPair random_pair(std::uint64_t seed)
{
    Random random(Hash::mix(seed));
    RandomPair pair;
    for (;;) {
        const Rings rings_a = random_rings(random);
        Rings rings_b = random_rings(random);
        const double size_a = random.uniform(0.3, 1.0);
        double size_b = random.uniform(0.3, 1.0);
        if (random.below(5) == 0) size_b = size_a * log_uniform(random, 0.01, 100.0);
        const int kind = random.below(40);
        const bool is_wall = kind < 4;
        const bool is_within = kind == 4 || kind == 5;
        const bool is_central = kind == 6;
        const bool falls = kind >= 7 && kind < 14;
        if (is_within) {
            std::vector<Vec2> hole = star_ring(random, 4 + random.below(4), 0.5, 0.8);
            std::vector<Vec2> rim;
            for (int k = 0; k < 12; ++k) rim.push_back(0.9 * direction(2.0 * k_pi * k / 12));
            for (Vec2& corner : hole) corner *= 0.95;
            std::reverse(hole.begin(), hole.end());
            rings_b = {rim, hole};
            size_b = size_a * random.uniform(4.0, 10.0);
        }

        FlyingPair& flying = pair.flying;
        flying = {};
        flying.a = outline_of(rings_a, size_a);
        pair.shape_a = shape_of(rings_a, size_a);
        const Vec2 home = random.below(10) == 0 ? random_vector(random, 1.0, 1e6) : Vec2(Vec2::Zero());
        const double start_b = random.below(2) == 0 ? 0.0 : random.uniform(0.0, 0.1);
        flying.flyer_a.state.time = random.below(2) == 0 ? 0.0 : random.uniform(0.0, 0.1);
        flying.flyer_b.state.time = start_b;
        pair.start = common_start(flying.flyer_a, flying.flyer_b);

        const double speed = log_uniform(random, 0.1, 10.0);
        double reach = bounding(flying.a);
        if (is_wall) {
            const double turn = random.uniform(0.0, 6.3);
            const Vec2 normal = random.below(2) == 0 ? Vec2(0.0, 1.0) : direction(turn);
            const double offset = normal.dot(home);
            flying.b = wall_outline(normal, offset);
            pair.shape_b = HalfPlane{normal, offset};
            const double height = bounding(flying.a) * random.uniform(0.3, 3.0);
            const double way = random.uniform(0.0, 6.3);
            flying.flyer_a.state.position = home + height * normal;
            flying.flyer_a.state.velocity = speed * direction(way);
            flying.flyer_b.state.time = 0.0;
            pair.start = flying.flyer_a.state.time;
            if (random.below(2) == 0) flying.flyer_a.acceleration = Vec2(0.0, -1.0) * speed * speed / reach;
        } else {
            flying.b = outline_of(rings_b, size_b);
            pair.shape_b = shape_of(rings_b, size_b);
            reach += bounding(flying.b);
            const double away = random.uniform(0.0, 6.3);
            const double distance = is_within ? 0.2 * size_b * random.uniform() : reach * random.uniform(0.2, 2.0);
            const double miss = random.uniform(-1.1, 1.1);
            const double ahead = random.uniform(0.0, 6.3);
            flying.flyer_b.state.position = home;
            flying.flyer_a.state.position = home + distance * direction(away);

            // Towards each other, past each other's middle by up to more than both reach
            const double turn = distance > reach ? away + k_pi + std::asin(std::clamp(miss * reach / distance, -1.0, 1.0)) : ahead;
            Vec2 relative = speed * direction(turn);
            if (is_central) {
                const double pull = speed * speed * reach * log_uniform(random, 0.3, 3.0);
                const Vec2 to_centre = direction(random.uniform(0.0, 6.3));
                const Vec2 centre = home + reach * random.uniform(1.5, 4.0) * to_centre;
                pair.field = std::make_unique<CentralField>(CentralField{centre, pull, 0.0});
                flying.flyer_a.central = pair.field.get();
                flying.flyer_a.state.velocity = relative;
                if (random.below(2) == 0) {
                    flying.flyer_b.central = pair.field.get();
                    flying.flyer_b.state.velocity = speed * direction(random.uniform(0.0, 6.3));
                }
            } else if (falls) {
                const Vec2 down = direction(random.uniform(0.0, 6.3));
                const Vec2 g = speed * speed / reach * log_uniform(random, 0.1, 3.0) * down;
                flying.flyer_a.acceleration = g;
                flying.flyer_a.state.velocity = relative;
            } else {
                const Vec2 way = direction(random.uniform(0.0, 6.3));
                const Vec2 common = speed * random.uniform(0.0, 2.0) * way;
                flying.flyer_a.state.velocity = relative + common;
                flying.flyer_b.state.velocity = common;
                if (random.below(4) == 0) {
                    // Under one acceleration both: as if there were none
                    const Vec2 g = speed * speed / reach * direction(random.uniform(0.0, 6.3));
                    flying.flyer_a.acceleration = flying.flyer_b.acceleration = g;
                }
            }
        }
        const double unit = speed / reach;
        flying.flyer_a.state.angle = random.uniform(-3.0, 3.0);
        flying.flyer_a.state.spin = random_spin(random, unit);
        if (!is_wall) {
            flying.flyer_b.state.angle = random.uniform(-3.0, 3.0);
            const bool stands = falls || (is_central && flying.flyer_b.central == nullptr);
            if (!stands) flying.flyer_b.state.spin = random_spin(random, unit);
        }
        pair.horizon = pair.start + random.uniform(2.0, 8.0) * reach / speed;
        pair.is_grazing = !is_central && random.below(10) == 0;

        // Apart by more than rounding to begin with
        if (!(gap_at(flying, pair.start) > 1e-6 * smaller_of(flying)) || overlap_at(flying, pair.start)) continue;
        if (pair.is_grazing) {
            const double depth = log_uniform(random, 1e-11, 1e-3) * smaller_of(flying);
            const double graze = random.below(2) == 0 ? depth : -depth;
            const FlyingPair before = flying;
            pair.is_grazing = make_graze(flying, pair.start, pair.horizon, graze);
            if (!pair.is_grazing || !(gap_at(flying, pair.start) > 1e-6 * smaller_of(flying))) flying = before;
        }
        return pair;
    }
}

Prediction foresee(const RandomPair& pair)
{
    constexpr int k_most = 1'000'000;
    const FlyingPair& flying = pair.flying;
    Prediction answer = predict(pair.shape_a, flying.flyer_a, pair.shape_b, flying.flyer_b, pair.start);
    for (int k = 0; k < k_most && answer.kind == Prediction::Kind::not_before && answer.time < pair.horizon; ++k)
        answer = predict(pair.shape_a, flying.flyer_a, pair.shape_b, flying.flyer_b, answer.time);
    return answer;
}

Verdict judge(const RandomPair& pair, const Prediction& answer)
{
    constexpr double k_contract = 1e-12; // [sizes] gap at an impact
    const FlyingPair& flying = pair.flying;
    const double size = smaller_of(flying);
    Verdict verdict;
    verdict.impact = answer.kind == Prediction::Kind::impact && answer.time < pair.horizon;
    const double until = verdict.impact ? answer.time : pair.horizon;
    char text[200];

    // At the impact the surfaces meet
    if (verdict.impact) {
        const double gap = gap_at(flying, answer.time);
        verdict.gap = gap / size;
        const double allowed = k_contract * size + rounding_at(flying, answer.time);
        if (!(std::abs(gap) <= allowed) || answer.time < pair.start) {
            std::snprintf(text, sizeof text, "gap of %.3g sizes at the impact foreseen for %.17g", verdict.gap, answer.time);
            verdict.why = text;
            return verdict;
        }
    }
    if (!verdict.impact && answer.kind == Prediction::Kind::not_before && answer.time < pair.horizon) {
        verdict.why = "the engine found no end";
        return verdict;
    }

    // Before it, they don't
    const DenseAnswer dense = search_densely(flying, pair.start, until);
    verdict.samples = dense.samples;
    if (dense.gave_up) {
        verdict.why = "the dense search took too many samples";
        verdict.undecided = true;
        return verdict;
    }
    if (dense.overlaps) {
        std::snprintf(text, sizeof text, "overlap of %.3g sizes at %.17g, %s %.17g", -dense.least / size, dense.time,
                      verdict.impact ? "impact foreseen for" : "none foreseen until", until);
        verdict.why = text;
        return verdict;
    }
    verdict.right = true;
    return verdict;
}

double shifted_root_error(RandomPair pair, double shift)
{
    const Prediction plain = foresee(pair);
    const bool plain_hits = plain.kind == Prediction::Kind::impact && plain.time < pair.horizon;
    RandomPair later = std::move(pair);
    FlyingPair& flying = later.flying;
    flying.flyer_a.state.time += shift;
    flying.flyer_b.state.time += shift;
    const double moved = std::max(flying.flyer_a.state.time, flying.flyer_b.state.time);
    later.start = moved;
    later.horizon += shift;
    const Prediction answer = foresee(later);
    const bool hits = answer.kind == Prediction::Kind::impact && answer.time < later.horizon;

    // Rounded times move each body by its speed times the rounding
    const double rounding = rounding_at(flying, later.horizon) + 1e-12 * smaller_of(flying);
    if (!plain_hits && !hits) return 0.0;
    if (plain_hits != hits) {
        // Only a graze that shallow may come or go
        const Prediction& found = hits ? answer : plain;
        const double offset = hits ? 0.0 : shift;
        if (found.time + offset > later.horizon * (1.0 - 1e-12)) return -1.0;
        const DenseAnswer dense = search_densely(flying, found.time + offset - 1e-9 * (later.horizon - later.start),
                                                 later.horizon, {1e-9, rounding / smaller_of(flying)});
        return dense.overlaps ? std::numeric_limits<double>::infinity() : -1.0;
    }

    // The root's gap, seen by the other's flight, over the rounding allowed
    return std::abs(gap_at(flying, plain.time + shift)) / rounding;
}

} // namespace flying::stress
