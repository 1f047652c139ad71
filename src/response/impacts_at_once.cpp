#include "response/impacts_at_once.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

#include "response/push_line.hpp"
#include "response/tied_pairs.hpp"

namespace flying {
namespace {

/// Sweeps of compression, after which what was found is given back, if it isn't all.
constexpr int k_sweeps = 1000;

[[nodiscard]] bool moves(const ImpactBody& body)
{
    return body.inertia.inv_mass > 0.0 || body.inertia.inv_moment_of_inertia > 0.0;
}

[[nodiscard]] PairMotion pair_motion(std::span<const ImpactBody> bodies, int a, int b)
{
    return {bodies[a].velocity, bodies[b].velocity, bodies[a].spin, bodies[b].spin};
}

/// What pushes do to one body of a group.
struct Share
{
    ImpactBody before;
    Vec2 impulse = Vec2::Zero(); ///< not given yet [N s]
    double moment = 0.0;         ///< likewise [N m s]
    int lines = 0;               ///< along which it is pushed; 0 of a body that isn't in the group
};

/// A point of a group, with its impulses of compression.
struct GroupPoint
{
    int a = 0;
    int b = 0;
    PointFrame frame;
    Material material;
    double response_n = 0.0; ///< of the shares of both bodies that the push along the normal meets [1/kg]
    double response_t = 0.0; ///< likewise along the tangent
    double normal = 0.0;     ///< >= 0 [N s]
    double tangent = 0.0;    ///< at most mu times as much
};

/// Pairs that push together.
class Group
{
public:
    /// shares  of all bodies, with no lines; so they are again when the group is gone
    Group(std::span<ImpactBody> bodies, std::vector<Share>& shares) : bodies_(bodies), shares_(shares) {}
    ~Group()
    {
        for (const int body : movers_) shares_[body] = {};
    }
    Group(const Group&) = delete;
    Group& operator=(const Group&) = delete;

    /// Add the points of a pair.
    void add(const ImpactPair& pair, std::span<const ImpactPoint> points)
    {
        for (std::size_t k = pair.first; k < pair.end; ++k) {
            points_.push_back({pair.a, pair.b, frame_at(points[k]), pair.material});
            const GroupPoint& point = points_.back();
            const double v_n = speed_along(point.frame.normal, motion_of(point));
            const double v_t = speed_along(point.frame.tangent, motion_of(point));
            top_speed_ = std::max({top_speed_, std::abs(v_n), std::abs(v_t), bodies_[pair.a].velocity.norm(),
                                   bodies_[pair.b].velocity.norm()});
        }
        rests_ = std::max(rests_, pair.rests);
    }

    // [response.at_once.compress]
    /// Find the impulses that end the approach of all points at once, as far as the sweeps come.
    void compress()
    {
        const auto parts = [&](const GroupPoint& p) {
            return speed_along(p.frame.normal, motion_of(p)) > std::max(tolerance::k_approach * top_speed_, rests_);
        };
        std::erase_if(points_, parts);
        split_masses();
        const double enough = 4.0 * tolerance::k_epsilon * top_speed_;
        for (int sweep = 0; sweep < k_sweeps; ++sweep) {
            double change = 0.0;
            for (GroupPoint& p : points_) {
                const PairMotion motion = motion_of(p);
                const double mu = p.material.friction;
                const double j = std::max(0.0, p.normal - speed_along(p.frame.normal, motion) / p.response_n);
                change = std::max(change, std::abs(j - p.normal) * p.response_n);
                push(p, p.frame.normal, j - p.normal);
                p.normal = j;
                if (mu == 0.0) continue;
                const double wanted = p.tangent - speed_along(p.frame.tangent, motion) / p.response_t;
                const double q = std::clamp(wanted, -mu * j, mu * j);
                change = std::max(change, std::abs(q - p.tangent) * p.response_t);
                push(p, p.frame.tangent, q - p.tangent);
                p.tangent = q;
            }
            give(1.0);
            if (change <= enough) break; // both are zero where all is too slow for numbers
        }
        end_together();
        take_back();
    }
    // [response.at_once.compress]

    // [response.at_once.give_back]
    /// Push with (1 + e) times what was found, and of the friction with the part at which most energy is lost; with all
    /// of it scaled down where it would add energy.
    void give_back()
    {
        const auto along_normal = [](const GroupPoint& p) { return (1.0 + p.material.restitution) * p.normal; };
        const auto along_tangent = [](const GroupPoint& p) { return (1.0 + p.material.restitution) * p.tangent; };
        static_cast<void>(push_all(&PointFrame::normal, along_normal));
        give(1.0);
        const double slip = push_all(&PointFrame::tangent, along_tangent);
        const double part = slip < 0.0 ? std::min(1.0, -slip / taken_up()) : 0.0;
        take_back();

        double work = push_all(&PointFrame::normal, along_normal);
        work += push_all(&PointFrame::tangent, [&](const GroupPoint& p) { return part * along_tangent(p); });
        give(work < 0.0 ? std::min(1.0, -2.0 * work / taken_up()) : 0.0);
    }
    // [response.at_once.give_back]

private:
    [[nodiscard]] PairMotion motion_of(const GroupPoint& p) const { return pair_motion(bodies_, p.a, p.b); }

    /// Each line along which a body is pushed meets as much of its mass as any other.
    void split_masses()
    {
        for (const GroupPoint& p : points_) {
            for (const int body : {p.a, p.b}) {
                if (!moves(bodies_[body])) continue;
                Share& share = shares_[body];
                if (share.lines == 0) movers_.push_back(body);
                share.before = bodies_[body];
                share.lines += p.material.friction > 0.0 ? 2 : 1;
            }
        }
        const auto inertia_of = [&](int body) -> Inertia {
            const Inertia& whole = bodies_[body].inertia;
            return {shares_[body].lines * whole.inv_mass, shares_[body].lines * whole.inv_moment_of_inertia};
        };
        for (GroupPoint& p : points_) {
            const PairInertia inertia{inertia_of(p.a), inertia_of(p.b)};
            p.response_n = inverse_mass(p.frame.normal, inertia);
            p.response_t = inverse_mass(p.frame.tangent, inertia);
        }
    }

    void push(const GroupPoint& p, const PushLine& line, double j)
    {
        shares_[p.a].impulse -= j * line.direction;
        shares_[p.a].moment -= j * line.arm_a;
        shares_[p.b].impulse += j * line.direction;
        shares_[p.b].moment += j * line.arm_b;
    }

    /// Where the sweeps were not enough: as much of all that was found as ends the approach on the whole.
    void end_together()
    {
        const double left = push_all(&PointFrame::normal, [](const GroupPoint& p) { return p.normal; });
        const double taken = taken_up();
        const double part = taken > 0.0 ? 1.0 - left / taken : 1.0; // both may be too small for their squares
        for (GroupPoint& p : points_) p.normal *= part;
    }

    /// Twice the energy that bodies at rest would take up from what they were pushed with since the last time.  [J]
    [[nodiscard]] double taken_up() const
    {
        double sum = 0.0;
        for (const int body : movers_) {
            const Share& share = shares_[body];
            const Inertia& inertia = bodies_[body].inertia;
            sum += inertia.inv_mass * share.impulse.squaredNorm() +
                   inertia.inv_moment_of_inertia * (share.moment * share.moment);
        }
        return sum;
    }

    /// Give all bodies a part of what they were pushed with since the last time.
    void give(double part)
    {
        for (const int body : movers_) {
            ImpactBody& one = bodies_[body];
            Share& share = shares_[body];
            one.velocity += part * (one.inertia.inv_mass * share.impulse);
            one.spin += part * (one.inertia.inv_moment_of_inertia * share.moment);
            share.impulse = Vec2::Zero();
            share.moment = 0.0;
        }
    }

    /// Push at all points.
    /// Returns the work of it at the speeds that they have.  [J]
    template <typename Impulse>
    [[nodiscard]] double push_all(PushLine PointFrame::*line, const Impulse& impulse_of)
    {
        double work = 0.0;
        for (const GroupPoint& p : points_) {
            work += impulse_of(p) * speed_along(p.frame.*line, motion_of(p));
            push(p, p.frame.*line, impulse_of(p));
        }
        return work;
    }

    /// All bodies move as before, and nothing pushes them yet.
    void take_back()
    {
        give(0.0);
        for (const int body : movers_) bodies_[body] = shares_[body].before;
    }

    std::span<ImpactBody> bodies_;
    std::vector<Share>& shares_;
    std::vector<GroupPoint> points_;
    std::vector<int> movers_;
    double top_speed_ = 0.0; // [m/s]
    double rests_ = 0.0;     // what parts no faster rests [m/s]
};

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
    const auto approaches = [&](const ImpactPair& pair) {
        const PairMotion motion = pair_motion(bodies, pair.a, pair.b);
        for (std::size_t k = pair.first; k < pair.end; ++k) {
            if (speed_along(frame_at(points[k]).normal, motion) < -slowest[k]) return true;
        }
        return false;
    };
    const auto tie = [&](int body) { return moves(bodies[body]) ? body : -1; };
    std::vector<Share> shares(bodies.size());
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
            if (!approaches(pairs[k])) continue;
            chosen.push_back(k);
            ties.push_back({tie(pairs[k].a), tie(pairs[k].b)});
        }
        if (chosen.empty()) break;

        // Strike
        candidates.clear();
        for (std::vector<int>& group : tied_pairs(ties)) {
            for (int& k : group) k = chosen[k];
            if (group.size() == 1) {
                if (!strike(bodies, pairs[group[0]], points)) continue;
            } else {
                Group together(bodies, shares);
                for (const int k : group) together.add(pairs[k], points);
                together.compress();
                together.give_back();
            }
            impacts += static_cast<int>(group.size());
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
