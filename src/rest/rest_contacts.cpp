#include <algorithm>
#include <cmath>
#include <limits>

#include "response/push_line.hpp"
#include "rest/near_points.hpp"
#include "rest/rest_engine.hpp"
#include "rest/rest_tolerance.hpp"

namespace flying {
namespace {


/// [sizes] A pair that overlaps by more is put right first, before anyone looks ahead.
constexpr double k_deep = 0x1p-10;
/// Looks at a pair that closes, each at the moment that the last one foresaw.
constexpr int k_looks = 5;
/// [sizes] A gap that turning has opened between two that lean on each other is less than this.
constexpr double k_barely = 0x1p-36;
/// [speeds that the field gives in a step] What bears, and comes nearer no faster than this, goes on to bear.
constexpr double k_slow = 0x1p-24;
/// [distances, ways] By which separations that are compared may be off: far more than their rounding.
constexpr double k_doubt = 0x1p-44;
/// [steps] What closes later is left to the next step.
constexpr double k_last_moment = 1.0 - 0x1p-30;



/// Time until a gap closes that changes at speed u and acceleration a; more than `within` where it doesn't by then. [s]
[[nodiscard]] double time_to_close(double gap, double u, double a, double within)
{
    if (gap + within * (u + 0.5 * a * within) > 0.0) return 2.0 * within;
    const double square = u * u - 2.0 * a * gap;
    const double root = std::sqrt(std::max(square, 0.0));
    return root > u ? 2.0 * gap / (root - u) : 2.0 * within;
}



/// The point of the last look that a point continues: the nearest at the same place, whatever the names of the features,
/// which change with rounding where corners lie on corners; or else that of the same features. -1 where there is none.
[[nodiscard]] int known_point(const PairLoads& pair, std::uint32_t feature, const Vec2& place, double near)
{
    int best = -1;
    bool best_near = false;
    for (int i = 0; i < pair.count; ++i) {
        const bool is_near = (pair.place[i] - place).squaredNorm() < near * near;
        if (pair.feature[i] == feature && is_near) return i;
        if ((pair.feature[i] == feature && !best_near) || is_near) { best = i; best_near = is_near; }
    }
    return best;
}

/// A point that bore a load when the step before ended.
[[nodiscard]] bool bore(const RestPair& pair, std::uint32_t feature)
{
    for (int i = 0; i < pair.count; ++i) {
        if (pair.feature[i] == feature) return pair.normal[i] > 0.0;
    }
    return false;
}


} // namespace


void RestEngine::collide()
{
    found_.clear();
    const std::span<const RestPair> pairs = pairs_.pairs();
    is_near_.assign(pairs.size(), 0);
    for (int k = 0; k < static_cast<int>(pairs.size()); ++k) {
        if (wakes_[pairs[k].a] || wakes_[pairs[k].b]) is_near_[k] = collide_pair(k) ? 1 : 0;
    }
}

/// True where the two parts are near enough to touch within the step.
bool RestEngine::collide_pair(int index)
{
    RestPair& pair = pairs_.pairs()[index];

    // Leave out those too far from each other for this step
    const ConvexPart& part_a = shapes_[pair.a].parts[pair.part_a];
    const ConvexPart& part_b = shapes_[pair.b].parts[pair.part_b];
    const double size = std::min(radius_[pair.a], radius_[pair.b]);
    const double margin = reach_[pair.a] + reach_[pair.b] + rest_tolerance::k_watch * size;
    const Pose& pose_a = poses_[pair.a];
    const Pose& pose_b = poses_[pair.b];
    const double clear = part_a.radius + part_b.radius + margin;
    const Vec2 way =
        (pose_b.position - pose_a.position) + (pose_b.rotation * part_b.centre - pose_a.rotation * part_a.centre);
    if (way.squaredNorm() > clear * clear) {
        pair.count = 0;
        return false;
    }
    Manifold manifold = look_again(pair, margin);
    if (manifold.count == 0) {
        pair.count = 0;
        return true;
    }

    // A gap that would close within the step is looked at when it does; bodies turn, so that one look may not do
    Closing closing{{0, 0}, 0, touch_gap(pair.a, pose_a.position, pair.b, pose_b.position), 0.0};
    Manifold ahead = manifold;
    double moment = 0.0;
    double closes_at = std::numeric_limits<double>::infinity();
    bool overlaps = false;
    for (int k = 0; k < manifold.count; ++k) overlaps = overlaps || manifold.contacts[k].separation < -k_deep * size;
    for (int k = 0; k <= k_looks && !overlaps; ++k) {
        const double wait = next_closing(pair, ahead, moment, closing);
        if (wait == 0.0) closes_at = moment;
        if (wait == 0.0 || !(moment + wait <= k_last_moment * span_)) break;
        moment += wait;
        ++counts_.manifolds;
        ahead = look(pair, pose_at(pair.a, moment), pose_at(pair.b, moment), margin);
        closing.closed = rest_tolerance::k_closed * size;
    }
    add_points(index, manifold, closes_at, closing.speed);
    return true;
}

/// Where a body's centre will be at a moment of the step, if it goes on as it did.
Vec2 RestEngine::place_at(int body, double moment) const
{
    if (moment == 0.0) return poses_[body].position;
    const BodyState& s = bodies_[body].state;
    if (bodies_[body].is_static) return s.position;
    return s.position + moment * (s.velocity + (0.5 * moment) * pull_[body]);
}

/// Where a body will be at a moment of the step, if it goes on as it did.
Pose RestEngine::pose_at(int body, double moment) const
{
    if (bodies_[body].is_static) return poses_[body];
    const BodyState& s = bodies_[body].state;
    return {place_at(body, moment),
            Rotation::of(s.angle + moment * (s.spin + (0.5 * moment) * turn_pull_[body]))};
}

/// Time from a moment until the first gap closes; 0 where one that was open has closed by then, infinite where none
/// does.
double RestEngine::next_closing(const RestPair& pair, const Manifold& manifold, double moment, Closing& closing) const
{
    const double left = span_ - moment;
    // What bore a load goes on to bear, whatever gap turning or rounding or, in a crowd, a push out of an overlap has
    // left; but what would be thrown back is thrown back
    const bool in_crowd = in_crowd_[pair.a] || in_crowd_[pair.b];
    const double near = k_barely * std::min(radius_[pair.a], radius_[pair.b]);
    double wait = std::numeric_limits<double>::infinity();
    for (int k = 0; k < manifold.count; ++k) {
        const Contact& contact = manifold.contacts[k];
        const bool was_open =
            std::find(closing.open, closing.open + closing.count, contact.feature) != closing.open + closing.count;
        if (contact.separation <= closing.closed && !was_open) continue;
        const double field = span_ * std::max(field_size_[pair.a], field_size_[pair.b]);
        const auto velocity = [&](int index) {
            const BodyState& s = bodies_[index].state;
            const Vec2 r = contact.point - place_at(index, moment);
            return Vec2(s.velocity + moment * pull_[index] + cross(s.spin + moment * turn_pull_[index], r));
        };
        const double u = (velocity(pair.b) - velocity(pair.a)).dot(contact.normal);
        if (contact.separation <= closing.closed) {
            closing.speed = std::max(closing.speed, -u);
            return 0.0;
        }
        const double slow = in_crowd ? field : 2.0 * contact.separation / left + k_slow * field;
        const bool is_near = contact.separation <= near && -2.0 * pair.restitution * u <= field;
        if ((in_crowd || is_near) && -u <= slow && bore(pair, contact.feature)) continue;
        if (moment == 0.0) closing.open[closing.count++] = contact.feature;
        const double fall = fall_at(pair, contact, moment);
        const double time = time_to_close(contact.separation, u, fall, left);
        if (time > left || (u > 0.0 && moment == 0.0 && stays_open(pair, closing.closed))) continue;
        wait = std::min(wait, time);
    }
    return wait;
}

/// Where the step ends there is a gap still, though it would close by how fast it opens and that changes now: round ones
/// that go round each other turn out of each other's way.
bool RestEngine::stays_open(const RestPair& pair, double touch) const
{
    return look(pair, pose_at(pair.a, span_), pose_at(pair.b, span_), touch).count == 0;
}

/// Normal acceleration of B relative to A at a contact, if they go on as they did.
double RestEngine::fall_at(const RestPair& pair, const Contact& contact, double moment) const
{
    const auto pull = [&](int index) {
        const Vec2 r = contact.point - place_at(index, moment);
        return Vec2(pull_[index] + cross(turn_pull_[index], r));
    };
    return (pull(pair.b) - pull(pair.a)).dot(contact.normal);
}

/// The same of a point whose arms are known.
double RestEngine::fall_of(const ContactPoint& c) const
{
    const Vec2 shift = pull_[c.b] - pull_[c.a];
    return (c.n_x * shift.x() + c.n_y * shift.y()) +
           (turn_pull_[c.b] * c.normal_arm_b - turn_pull_[c.a] * c.normal_arm_a);
}

/// The same if nothing but the field acts on them.
double RestEngine::weight_of(const ContactPoint& c) const
{
    const Vec2 shift = field_[c.b] - field_[c.a];
    return c.n_x * shift.x() + c.n_y * shift.y();
}



void RestEngine::add_points(int index, const Manifold& manifold, double closes_at, double closing_speed)
{
    RestPair& pair = pairs_.pairs()[index];
    const int own = is_moved(pair.a) ? pair.a : pair.b;
    const double size = std::min(radius_[pair.a], radius_[pair.b]);
    const Rotation own_from_world = inverse(poses_[own].rotation);
    PairLoads now;
    now.count = manifold.count;
    for (int k = 0; k < manifold.count; ++k) {
        const Contact& contact = manifold.contacts[k];
        const Vec2 r_a = contact.point - poses_[pair.a].position;
        const Vec2 r_b = contact.point - poses_[pair.b].position;
        const Vec2 place = own_from_world * (own == pair.a ? r_a : r_b);
        const int known = known_point(pair, contact.feature, place, rest_tolerance::k_same_place * size);
        now.feature[k] = contact.feature;
        now.place[k] = place;
        now.normal[k] = known >= 0 ? pair.normal[known] : 0.0;
        now.tangent[k] = known >= 0 ? pair.tangent[known] : 0.0;
        found_.push_back({.a = pair.a,
                          .b = pair.b,
                          .pair = index,
                          .feature = contact.feature,
                          .friction = pair.friction,
                          .restitution = pair.restitution,
                          .gap = contact.separation,
                          .normal = now.normal[k],
                          .tangent = now.tangent[k],
                          .closes_at = closes_at,
                          .closing_speed = closing_speed});
        set_arms(found_.back(), contact.normal, r_a, r_b);
        max_overlap_ = std::max(max_overlap_, -contact.separation);
    }
    static_cast<PairLoads&>(pair) = now;
}

void RestEngine::set_arms(ContactPoint& c, const Vec2& n, const Vec2& r_a, const Vec2& r_b) const
{
    const Mover& a = movers_[c.a];
    const Mover& b = movers_[c.b];
    c.n_x = n.x();
    c.n_y = n.y();
    c.normal_arm_a = normal_arm(r_a, n);
    c.normal_arm_b = normal_arm(r_b, n);
    c.tangent_arm_a = r_a.dot(n);
    c.tangent_arm_b = r_b.dot(n);
    const double shift = a.inv_mass + b.inv_mass;
    c.normal_mass =
        1.0 /
        (shift + (a.inv_moment * (c.normal_arm_a * c.normal_arm_a) + b.inv_moment * (c.normal_arm_b * c.normal_arm_b)));
    c.tangent_mass = 1.0 / (shift + (a.inv_moment * (c.tangent_arm_a * c.tangent_arm_a) +
                                     b.inv_moment * (c.tangent_arm_b * c.tangent_arm_b)));
}



void RestEngine::set_pose(int body, const Pose& pose)
{
    // How far, at most, it has moved and any point at distance 1 from its centre has turned, in all
    const Pose& old = poses_[body];
    travel_[body].shift += (pose.position - old.position).cwiseAbs().sum();
    travel_[body].turn += std::abs(pose.rotation.cosine - old.rotation.cosine) + std::abs(pose.rotation.sine - old.rotation.sine);
    poses_[body] = pose;
}

/// Where a body is when a step or a part of one begins: what the last such look has found may answer.
Manifold RestEngine::look_again(RestPair& pair, double margin)
{
    NearMemory& memory = pair.memory;
    const double shift = travel_[pair.a].shift + travel_[pair.b].shift;
    const double turn = travel_[pair.a].turn + travel_[pair.b].turn;
    if (memory.knows_separation) {
        // No separation along an edge can have changed by more
        const double arm = (poses_[pair.b].position - poses_[pair.a].position).cwiseAbs().sum() + (shift - pair.shift) +
                           (radius_[pair.a] + radius_[pair.b]);
        const double change = (shift - pair.shift) + (turn - pair.turn) * arm + k_doubt * (arm + shift);
        if (memory.separation - change > margin) return {};
        memory.edges.lead -= 2.0 * change;
        memory.knows_edges = memory.edges.lead > 0.0;
    }
    pair.shift = shift;
    pair.turn = turn;
    ++counts_.manifolds;
    const NearSide a{shapes_[pair.a].parts[pair.part_a].shape, poses_[pair.a], real_edges_[pair.a][pair.part_a]};
    const NearSide b{shapes_[pair.b].parts[pair.part_b].shape, poses_[pair.b], real_edges_[pair.b][pair.part_b]};
    Manifold manifold = near_points(a, b, margin, memory);
    if (manifold.count > 0) mend(pair, poses_[pair.a], poses_[pair.b], margin, manifold);
    return manifold;
}



Manifold RestEngine::look(const RestPair& pair, const Pose& pose_a, const Pose& pose_b, double margin) const
{
    const NearSide a{shapes_[pair.a].parts[pair.part_a].shape, pose_a, real_edges_[pair.a][pair.part_a]};
    const NearSide b{shapes_[pair.b].parts[pair.part_b].shape, pose_b, real_edges_[pair.b][pair.part_b]};
    Manifold manifold = near_points(a, b, margin);
    if (manifold.count > 0) mend(pair, pose_a, pose_b, margin, manifold);
    return manifold;
}



bool RestEngine::wake_touched()
{
    if (none_sleeps_) return false;
    bool any = false;
    for (const ContactPoint& point : found_) {
        for (const int body : {point.a, point.b}) {
            if (!asleep_[body]) continue;
            const int group = sleep_group_[body];
            for (std::size_t k = 0; k < bodies_.size(); ++k) {
                if (sleep_group_[k] != group) continue;
                asleep_[k] = 0;
                sleep_group_[k] = -1;
            }
            any = true;
        }
    }
    if (any) {
        list_awake();
        measure_reach(awake_);
    }
    return any;
}


} // namespace flying
