#include "response/impacts_at_once.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <vector>

#include "response/push_together.hpp"
#include "response/tied_pairs.hpp"

namespace flying {
namespace {

/// Lets two bodies strike each other. Whether any point was pushed.
bool strike(std::span<ImpactBody> bodies, const ImpactPair& pair, std::span<const ImpactPoint> points)
{
    ImpactBody& a = bodies[pair.a];
    ImpactBody& b = bodies[pair.b];
    const ImpactResult after =
        resolve_impact(a, b, points.subspan(pair.first, pair.end - pair.first), pair.material, pair.rests);
    if (!after.any_push) return false;
    if (moves(a)) a = {after.velocity_a, after.spin_a, a.inertia};
    if (moves(b)) b = {after.velocity_b, after.spin_b, b.inertia};
    return true;
}

/// A pair as the body of it that moves feels it, where only one does: as if that one were B.
[[nodiscard]] ImpactPair seen_by_mover(const ImpactPair& pair, bool is_a)
{
    return is_a ? ImpactPair{pair.b, pair.a, pair.first, pair.end, pair.material, pair.rests} : pair;
}
[[nodiscard]] ImpactPoint seen_by_mover(const ImpactPoint& point, bool is_a)
{
    return is_a ? ImpactPoint{point.r_b, point.r_a, -point.normal} : point;
}

/// Which pairs each body that moves belongs to.
class PairsOfBodies
{
public:
    PairsOfBodies(std::span<const ImpactBody> bodies, std::span<const ImpactPair> pairs) : begins_(bodies.size() + 1)
    {
        const auto each = [&](auto&& act) {
            for (std::size_t k = 0; k < pairs.size(); ++k) {
                for (const int body : {pairs[k].a, pairs[k].b}) {
                    if (moves(bodies[body])) act(body, static_cast<int>(k));
                }
            }
        };
        each([&](int body, int) { ++begins_[body + 1]; });
        std::partial_sum(begins_.begin(), begins_.end(), begins_.begin());
        pairs_.resize(begins_.back());
        std::vector<std::size_t> next = begins_;
        each([&](int body, int k) { pairs_[next[body]++] = k; });
    }
    /// Ascending; none where it doesn't move.
    [[nodiscard]] std::span<const int> of(int body) const
    {
        return std::span(pairs_).subspan(begins_[body], begins_[body + 1] - begins_[body]);
    }

private:
    std::vector<std::size_t> begins_; // by body, and one more
    std::vector<int> pairs_;
};

/// Pairs and their points, where immovable bodies that push one body along one normal are one: tiles that lie side by
/// side, or slabs that overlap and whose tops are level.
class JoinedPairs
{
public:
    JoinedPairs(std::span<const ImpactBody> bodies, std::span<const ImpactPair> pairs,
                std::span<const ImpactPoint> points, std::span<const double> slowest)
    {
        // Find, of each pair, the first one of the same floor: itself where there is none before, or where both move
        const int count = static_cast<int>(pairs.size());
        const PairsOfBodies pairs_of(bodies, pairs);
        const auto has_floor = [&](int k) { return moves(bodies[pairs[k].a]) != moves(bodies[pairs[k].b]); };
        const auto beside = [&](int k) { return pairs_of.of(moves(bodies[pairs[k].a]) ? pairs[k].a : pairs[k].b); };
        std::vector<int> first_of(count);
        for (int k = 0; k < count; ++k) {
            first_of[k] = k;
            if (!has_floor(k)) continue;
            for (const int other : beside(k)) {
                if (other == k) break;
                const bool is_first = has_floor(other) && first_of[other] == other;
                if (is_first && is_one_floor(bodies, pairs[other], pairs[k], points)) first_of[k] = other;
            }
        }

        // Make one pair of all those of a floor
        std::vector<int> floor;
        for (int first = 0; first < count; ++first) {
            if (first_of[first] != first) continue;
            floor.assign(1, first);
            if (has_floor(first)) {
                for (const int other : beside(first)) {
                    if (other > first && first_of[other] == first) floor.push_back(other);
                }
            }
            const bool is_joined = floor.size() > 1;
            const auto is_turned = [&](int k) { return is_joined && moves(bodies[pairs[k].a]); };
            ImpactPair& pair = pairs_.emplace_back(seen_by_mover(pairs[first], is_turned(first)));
            pair.first = points_.size();
            for (const int k : floor) {
                for (std::size_t i = pairs[k].first; i < pairs[k].end; ++i) {
                    ImpactPoint point = seen_by_mover(points[i], is_turned(k));
                    if (is_joined)
                        point.r_a = point.r_b; // of immovable bodies with centres of their own it is one place
                    if (is_joined && is_there(std::span(points_).subspan(pair.first), point)) continue;
                    points_.push_back(point);
                    slowest_.push_back(slowest[i]);
                }
            }
            pair.end = points_.size();
        }
    }

    [[nodiscard]] std::span<const ImpactPair> pairs() const { return pairs_; }
    [[nodiscard]] std::span<const ImpactPoint> points() const { return points_; }
    [[nodiscard]] std::span<const double> slowest() const { return slowest_; }

private:
    /// One body pushes at a point where another does.
    [[nodiscard]] static bool is_there(std::span<const ImpactPoint> points, const ImpactPoint& point)
    {
        return std::any_of(points.begin(), points.end(), [&](const ImpactPoint& other) {
            return (other.r_b - point.r_b).norm() <= tolerance::k_touch * point.r_b.norm();
        });
    }

    [[nodiscard]] static bool is_one_floor(std::span<const ImpactBody> bodies, const ImpactPair& one,
                                           const ImpactPair& two, std::span<const ImpactPoint> points)
    {
        if (one.material.friction != two.material.friction) return false;
        if (one.material.restitution != two.material.restitution) return false;
        const auto normal = [&](const ImpactPair& pair, std::size_t k) {
            return seen_by_mover(points[k], moves(bodies[pair.a])).normal;
        };
        const Vec2 common = normal(one, one.first);
        const auto all_along_it = [&](const ImpactPair& pair) {
            for (std::size_t k = pair.first; k < pair.end; ++k) {
                if (!((normal(pair, k) - common).norm() <= tolerance::k_same_normal)) return false;
            }
            return true;
        };
        return all_along_it(one) && all_along_it(two);
    }

    std::vector<ImpactPair> pairs_;
    std::vector<ImpactPoint> points_;
    std::vector<double> slowest_;
};

} // namespace

std::vector<int> number_anew(std::span<ImpactPair> pairs)
{
    std::vector<int> bodies;
    for (const ImpactPair& pair : pairs) bodies.insert(bodies.end(), {pair.a, pair.b});
    std::sort(bodies.begin(), bodies.end());
    bodies.erase(std::unique(bodies.begin(), bodies.end()), bodies.end());
    const auto place_of = [&](int body) {
        return static_cast<int>(std::lower_bound(bodies.begin(), bodies.end(), body) - bodies.begin());
    };
    for (ImpactPair& pair : pairs) {
        pair.a = place_of(pair.a);
        pair.b = place_of(pair.b);
    }
    return bodies;
}

int resolve_impacts(std::span<ImpactBody> bodies, std::span<const ImpactPair> all_pairs,
                    std::span<const ImpactPoint> all_points, std::span<const double> all_slowest, int most)
{
    const JoinedPairs joined(bodies, all_pairs, all_points, all_slowest);
    const std::span<const ImpactPair> pairs = joined.pairs();
    const std::span<const ImpactPoint> points = joined.points();
    const std::span<const double> slowest = joined.slowest();
    std::vector<PushLine> normals;
    normals.reserve(points.size());
    for (const ImpactPoint& point : points) normals.push_back(frame_at(point).normal);
    const auto approach = [&](const ImpactPair& pair) { // beyond what is none [m/s]
        const PairMotion motion = pair_motion(bodies, pair.a, pair.b);
        double fastest = 0.0;
        for (std::size_t k = pair.first; k < pair.end; ++k)
            fastest = std::max(fastest, -speed_along(normals[k], motion) - slowest[k]);
        return fastest;
    };
    const auto approach_of_all = [&](std::span<const int> group) {
        double fastest = 0.0;
        for (const int k : group) fastest = std::max(fastest, approach(pairs[k]));
        return fastest;
    };
    const auto tie = [&](int body) { return moves(bodies[body]) ? body : -1; };
    std::vector<PushTogether::Share> shares(bodies.size());
    BlockSystem system;
    std::vector<int> candidates(pairs.size()); // all at first; then those of the bodies that were struck
    std::iota(candidates.begin(), candidates.end(), 0);
    const PairsOfBodies pairs_of(bodies, pairs);
    std::vector<int> chosen;
    std::vector<std::array<int, 2>> ties; // of those chosen
    int impacts = 0;
    while (impacts < most) {
        // Find the pairs that approach, and those of them that share a body
        chosen.clear();
        ties.clear();
        for (const int k : candidates) {
            if (!(approach(pairs[k]) > 0.0)) continue;
            chosen.push_back(k);
            ties.push_back({tie(pairs[k].a), tie(pairs[k].b)});
        }
        if (chosen.empty()) break;

        // Strike
        candidates.clear();
        for (std::vector<int>& group : tied_pairs(ties)) {
            for (int& k : group) k = chosen[k];
            bool is_slowed = true;
            if (group.size() == 1) {
                if (!strike(bodies, pairs[group[0]], points)) continue;
            } else {
                const double before = approach_of_all(group);
                PushTogether together(bodies, shares, system);
                for (const int k : group) together.add(pairs[k], points);
                together.compress();
                together.give_back();
                is_slowed = approach_of_all(group) <= 0.5 * before;
            }
            impacts += static_cast<int>(group.size());
            if (!is_slowed) continue; // as it would be once more
            for (const int k : group) {
                for (const int body : {pairs[k].a, pairs[k].b}) {
                    const std::span<const int> others = pairs_of.of(body);
                    candidates.insert(candidates.end(), others.begin(), others.end());
                }
            }
        }
        std::sort(candidates.begin(), candidates.end());
        candidates.erase(std::unique(candidates.begin(), candidates.end()), candidates.end());
    }
    return impacts;
}

} // namespace flying
