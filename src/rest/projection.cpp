#include "rest/projection.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "collide/separating_axis.hpp"
#include "rest/energy_limit.hpp"
#include "rest/rest_tolerance.hpp"

namespace flying {
namespace {

[[nodiscard]] bool may_overlap(const RestData& data, const ContactPoint& c)
{
    // A gap along a fixed normal is never more than the distance; turning may bring anything along it by its whole arc
    const double way = c.n_x * (data.motion.shift[c.b].x() - data.motion.shift[c.a].x()) +
                       c.n_y * (data.motion.shift[c.b].y() - data.motion.shift[c.a].y());
    return c.gap + way - (arc_of(data, c.a) + arc_of(data, c.b)) < -data.bodies.touch_gap(c.a, c.b);
}

/// Two that come nearer to each other by so much may come to overlap where they had no point.
[[nodiscard]] bool comes_nearer(const RestData& data, int a, int b)
{
    const double nearer = (data.motion.shift[b] - data.motion.shift[a]).norm() + arc_of(data, a) + arc_of(data, b);
    return nearer > rest_tolerance::k_fair_overlap * data.bodies.breadth_of(a, b);
}

/// A point's gap as the step ends, if its two went straight on.  [m]
[[nodiscard]] double gap_at_end(const RestData& data, const ContactPoint& c)
{
    const StepMotion& motion = data.motion;
    const Vec2 shift = motion.shift[c.b] - motion.shift[c.a];
    const double turns = motion.turn[c.b] * c.normal_arm_b - motion.turn[c.a] * c.normal_arm_a;
    return c.gap + (c.n_x * shift.x() + c.n_y * shift.y()) + turns;
}

/// It is known well enough where a pair ends: the two hardly come nearer, and no point is deeper than is fair.
///
/// points  all of the pair
[[nodiscard]] bool stays_fair(const RestData& data, std::span<const ContactPoint> points)
{
    if (points.empty() || comes_nearer(data, points[0].a, points[0].b)) return false;
    const double fair = rest_tolerance::k_fair_overlap * data.bodies.breadth_of(points[0].a, points[0].b);
    return std::all_of(points.begin(), points.end(),
                       [&](const ContactPoint& c) { return gap_at_end(data, c) >= -fair; });
}

/// How two polygons part by the shortest way where they overlap as the step ends; separation 0 where they don't.
[[nodiscard]] Contact overlap_at_end(const RestData& data, const RestPair& pair)
{
    Contact contact;
    const ConvexPart& part_a = data.bodies.shapes[pair.a].parts[pair.part_a];
    const ConvexPart& part_b = data.bodies.shapes[pair.b].parts[pair.part_b];
    const auto* a = std::get_if<Polygon>(&part_a.shape);
    const auto* b = std::get_if<Polygon>(&part_b.shape);
    if (!a || !b) return contact;
    const Pose& pose_a = data.motion.end_poses[pair.a];
    const Pose& pose_b = data.motion.end_poses[pair.b];
    const Pose a_from_b = relative_pose(pose_a, pose_b);
    const double clear = part_a.radius + part_b.radius;
    if ((a_from_b * part_b.centre - part_a.centre).squaredNorm() > clear * clear) return contact;
    const double touch = data.bodies.touch_gap(pair.a, pair.b);
    const std::optional<Axis> axis = overlapping_axis(*a, *b, a_from_b, pair.memory.edges, touch);
    if (!axis) return contact;
    const bool of_a = axis->owner == Owner::a;
    contact.separation = axis->separation;
    contact.normal = of_a ? Vec2(pose_a.rotation * a->edges()[axis->edge].normal)
                          : Vec2(-(pose_b.rotation * b->edges()[axis->edge].normal));
    contact.point = of_a ? pose_b * b->vertices()[axis->vertex] : pose_a * a->vertices()[axis->vertex];
    return contact;
}

} // namespace

double Projection::measure_overlap(RestData& data, const Island& island)
{
    points_.clear();
    const std::span<const ContactPoint> points = island.points;
    if (is_heap(island)) return measure_overlap_of_heap(data, island);
    const auto may_any = [&](const ContactPoint& c) { return may_overlap(data, c); };
    if (std::none_of(points.begin(), points.end(), may_any)) return 0.0;
    set_end_poses(data, island, 1.0);
    list_pairs_of(data, points);
    double worst = 0.0;
    for (const int pair : pairs_near_) worst = std::max(worst, find_overlap_of_pair(data, pair));
    return worst;
}

/// Lists what bodies of a heap that the step, or a push, takes further than they were thought to get may have come to
/// overlap: of the heap, or static, and without a point.
void Projection::find_unforeseen(RestData& data, const Island& island)
{
    unforeseen_.clear();
    std::vector<BodyPose> thrown;
    for (const int member : island.members) {
        if (farthest_way(data, member) > data.motion.reach[member])
            thrown.push_back({member, pose_along(data, member, 1.0)});
    }
    if (thrown.empty()) return;
    BodySet members(data.bodies.count());
    members.insert(island.members);
    const auto is_ours = [&](int body) { return members.has(body) || data.bodies.list[body].is_static; };
    const auto has_points = [&](const RestPair& pair) {
        const auto comes_before = [](const ContactPoint& c, const RestPair& two) {
            return c.a != two.a ? c.a < two.a : c.b < two.b;
        };
        const auto found = std::lower_bound(island.points.begin(), island.points.end(), pair, comes_before);
        return found != island.points.end() && found->a == pair.a && found->b == pair.b;
    };
    unforeseen_ = data.pairs.pairs_at(thrown, data.bodies);
    std::erase_if(unforeseen_,
                  [&](const RestPair& pair) { return !is_ours(pair.a) || !is_ours(pair.b) || has_points(pair); });
}

/// Only pairs that may overlap more than is fair are looked at: of the others it is known well enough where they end.
double Projection::measure_overlap_of_heap(RestData& data, const Island& island)
{
    find_unforeseen(data, island);
    list_pairs_of(data, island.points);
    for (std::size_t k = 0; k < unforeseen_.size(); ++k)
        pairs_near_.push_back(static_cast<int>(data.pairs.pairs().size() + k));
    // The points of each, which stand in the same order; those of parts that have none come with their bodies' others
    const auto for_each = [&](auto&& visit) {
        std::size_t first = 0;
        for (const int pair : pairs_near_) {
            std::size_t end = first;
            while (end < island.points.size() && island.points[end].pair == pair) ++end;
            visit(pair, island.points.subspan(first, end - first));
            first = end;
        }
    };
    bool is_fair = true;
    for_each([&](int, std::span<const ContactPoint> points) { is_fair = is_fair && stays_fair(data, points); });
    if (is_fair) return 0.0;

    set_end_poses(data, island, 1.0);
    double worst = 0.0;
    for_each([&](int pair, std::span<const ContactPoint> points) {
        if (!stays_fair(data, points)) {
            worst = std::max(worst, find_overlap_of_pair(data, pair));
            return;
        }
        for (const ContactPoint& c : points) {
            ContactPoint& point = points_.emplace_back(c);
            point.bound = -gap_at_end(data, c);
            point.normal = point.tangent = point.friction = 0.0;
        }
    });
    return worst > rest_tolerance::k_fair_overlap ? worst : 0.0;
}

/// The pairs that points belong to, in their order, and where the two come nearer to each other those of all their
/// parts.
void Projection::list_pairs_of(const RestData& data, std::span<const ContactPoint> points)
{
    pairs_near_.clear();
    const std::span<const RestPair> pairs = data.pairs.pairs();
    for (const ContactPoint& c : points) {
        if (!pairs_near_.empty() && pairs_near_.back() >= c.pair) continue;
        const bool all = data.bodies.has_cuts(c.a, c.b) && comes_nearer(data, c.a, c.b);
        // The pairs of all parts of the two stand together
        const auto is_theirs = [&](int pair) { return pairs[pair].a == c.a && pairs[pair].b == c.b; };
        int first = c.pair;
        int end = c.pair + 1;
        while (all && first > 0 && is_theirs(first - 1)) --first;
        while (all && end < static_cast<int>(pairs.size()) && is_theirs(end)) ++end;
        for (int pair = first; pair < end; ++pair) pairs_near_.push_back(pair);
    }
}

const RestPair& Projection::pair_at(const RestData& data, int index) const
{
    const std::span<const RestPair> pairs = data.pairs.pairs();
    return index < std::ssize(pairs) ? pairs[index] : unforeseen_[index - pairs.size()];
}

/// The points of a pair as the step ends, and how much it overlaps.  [breadths]
double Projection::find_overlap_of_pair(RestData& data, int index)
{
    const RestPair& pair = pair_at(data, index);
    const double breadth = data.bodies.breadth_of(pair.a, pair.b);
    const double margin = rest_tolerance::k_watch * data.bodies.size_of(pair.a, pair.b);
    const Pose& pose_a = data.motion.end_poses[pair.a];
    const Pose& pose_b = data.motion.end_poses[pair.b];
    if (!are_near(data, pair, pose_a, pose_b, margin)) return 0.0;
    const Manifold manifold = look(data, pair, pose_a, pose_b, margin);
    ++data.counts.manifolds;
    double worst = 0.0;
    const auto add = [&](const Contact& contact) {
        ContactPoint& c = points_.emplace_back();
        c.a = pair.a;
        c.b = pair.b;
        c.pair = index;
        data.motion.set_arms(c, contact.normal, contact.point - pose_a.position, contact.point - pose_b.position);
        c.bound = -contact.separation;
        const double depth = -contact.separation - data.bodies.touch_gap(pair.a, pair.b);
        worst = std::max(worst, depth / breadth);
    };
    for (int k = 0; k < manifold.count; ++k) add(manifold.contacts[k]);
    if (worst > 0.0 || data.bodies.has_cuts(pair.a, pair.b)) return worst; // of cuts its edge may be one

    // What sticks out beyond the ends of the edge that it lies deepest under is clipped there
    const Contact clipped = overlap_at_end(data, pair);
    if (clipped.separation < 0.0) add(clipped);
    return worst;
}

double Projection::put_apart(RestData& data, const Island& island, double overlap, HeapSweeps& sweeps)
{
    if (overlap <= 0.0) return 0.0;
    ++data.counts.projected;
    pushes_.resize(data.motion.now.size());
    shift_before_.resize(data.motion.now.size());
    turn_before_.resize(data.motion.now.size());
    const std::span<const int> members = island.members;
    for (int round = 0; round < rest_tolerance::k_few_rounds && overlap > 0.0; ++round) {
        double touch = data.bodies.touch_gap(points_[0].a, points_[0].b);
        for (const ContactPoint& c : points_) touch = std::min(touch, data.bodies.touch_gap(c.a, c.b));
        for (const int member : members) {
            pushes_[member] = data.motion.now[member];
            pushes_[member].v_x = pushes_[member].v_y = pushes_[member].spin = 0.0;
            shift_before_[member] = data.motion.shift[member];
            turn_before_[member] = data.motion.turn[member];
        }
        // [rest.projection.round]
        find_pushes(data, island, 0.125 * touch, sweeps);
        const bool is_free = is_heap(island) && overlap > rest_tolerance::k_most_overlap;
        double share = is_free ? 1.0 : share_that_is_paid(data, island);
        double after = overlap;
        // Pushes that turn bodies go along arcs, too: where all of them would do harm, half may help
        for (int k = 0; k < rest_tolerance::k_quick_rounds; ++k, share *= 0.5) {
            push_by(data, members, share);
            after = measure_overlap(data, island);
            if (!(after > overlap)) break;
        }
        if (!(after < overlap)) {
            for (const int member : members) {
                data.motion.shift[member] = shift_before_[member];
                data.motion.turn[member] = turn_before_[member];
            }
            break;
        }
        overlap = after;
        // [rest.projection.round]
    }
    return overlap;
}

/// The ways of the step, and so much of the pushes.
void Projection::push_by(RestData& data, std::span<const int> members, double share) const
{
    for (const int member : members) {
        const Mover& push = pushes_[member];
        data.motion.shift[member] = shift_before_[member] + share * Vec2(push.v_x, push.v_y);
        data.motion.turn[member] = turn_before_[member] + share * push.spin;
    }
}

/// A small island's motion pays for its pushes. (A heap would hang in the air if all its motion went to lift it.) What
/// is all but still has none, nor has what slides too slowly for so much of a lift: the limit of energy would take back
/// the step's own ways with the pushes, the same in every step.
///
/// lift  what the pushes cost [J]
bool Projection::may_pay(const RestData& data, const Island& island, double lift) const
{
    const std::span<const int> members = island.members;
    const std::span<const Mover> before = data.motion.before;
    const auto is_still = [&](int member) { return is_all_but_still(data, member, before[member]); };
    if (is_heap(island) || std::all_of(members.begin(), members.end(), is_still)) return false;
    const double energy = kinetic_energy(island, before);
    return energy >= lift || energy_to_spare(data, island, before) > rest_tolerance::k_rounding * energy;
}

/// How much of the pushes is paid for: all, or as much as the energy that the step has taken.
double Projection::share_that_is_paid(const RestData& data, const Island& island) const
{
    double lift = 0.0; // [J]
    for (const int member : island.members) {
        const Mover& push = pushes_[member];
        lift -= data.motion.field[member].dot(Vec2(push.v_x, push.v_y)) / data.motion.now[member].inv_mass;
    }
    if (!(lift > 0.0) || may_pay(data, island, lift)) return 1.0;
    return std::clamp(-gain_of(data, island).gained / lift, 0.0, 1.0);
}

/// Pushes that take off overlap. Where something static bears, they are those of bodies of the same mass: what is heavy
/// and has sunk onto light bodies would hardly be moved otherwise. Bodies that touch nothing static keep their common
/// centre of mass.
void Projection::find_pushes(RestData& data, const Island& island, double tolerance, HeapSweeps& sweeps)
{
    const std::span<const int> members = island.members;
    const auto is_static = [&](const ContactPoint& c) {
        return !data.motion.is_moved(c.a) || !data.motion.is_moved(c.b);
    };
    if (std::any_of(points_.begin(), points_.end(), is_static) ||
        std::any_of(island.points.begin(), island.points.end(), is_static)) {
        for (const int member : members) {
            pushes_[member].inv_moment /= pushes_[member].inv_mass;
            pushes_[member].inv_mass = 1.0;
        }
        for (ContactPoint& c : points_) {
            const Mover& a = pushes_[c.a];
            const Mover& b = pushes_[c.b];
            c.normal_mass = effective_mass(a.inv_mass + b.inv_mass, a, b, c.normal_arm_a, c.normal_arm_b);
        }
    }
    if (is_heap(island)) sweeps.sweep_places(data, island, pushes_, points_, tolerance);
    else data.solver.solve(pushes_, members, points_, tolerance);
}

} // namespace flying
