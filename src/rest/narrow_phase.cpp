#include "rest/narrow_phase.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <utility>

#include "broadphase/box_cells.hpp"
#include "rest/near_points.hpp"
#include "rest/outline_points.hpp"
#include "rest/rest_tolerance.hpp"

namespace flying {
namespace {

/// Where two parts cross so that neither has a corner in the other's body, as corners that slide past each other do:
/// the points along the shortest way that parts them, if that is over a side.
///
/// touch  gaps below this, of either sign, are contact [m]
/// known  overlap up to this is no news [m]
[[nodiscard]] Manifold points_of_crossing(const RestBodies& bodies, const RestPair& pair, const Pose& pose_a,
                                          const Pose& pose_b, double touch, double known)
{
    const auto* a = std::get_if<Polygon>(&bodies.shapes[pair.a].parts[pair.part_a].shape);
    const auto* b = std::get_if<Polygon>(&bodies.shapes[pair.b].parts[pair.part_b].shape);
    if (!a || !b) return {};
    const Pose a_from_b = relative_pose(pose_a, pose_b);
    const std::optional<Axis> axis = overlapping_axis(*a, *b, a_from_b, pair.memory.edges, known);
    if (!axis) return {};
    const bool of_a = axis->owner == Owner::a;
    const std::vector<char>& real = bodies.real_edges[of_a ? pair.a : pair.b][of_a ? pair.part_a : pair.part_b];
    if (!real.empty() && !real[axis->edge]) return {};
    // The corner that is deepest under the side stands beyond its ends, or else it is a point of the outlines
    const Vec2 corner = of_a ? Vec2(a_from_b * b->vertices()[axis->vertex])
                             : Vec2(relative_pose(pose_b, pose_a) * a->vertices()[axis->vertex]);
    if (bodies.outlines[of_a ? pair.a : pair.b].holds(corner, touch)) return {};
    return make_manifold(*a, pose_a, *b, pose_b, a_from_b, *axis, 0.0);
}

/// The points of a pair as their outlines have them, where a body is cut into parts or edges don't tell.
[[nodiscard]] Manifold points_of_outlines(const RestBodies& bodies, const RestPair& pair, const Pose& pose_a,
                                          const Pose& pose_b, double margin)
{
    const OutlineSide a{bodies.outlines[pair.a], pair.part_a, pose_a};
    const OutlineSide b{bodies.outlines[pair.b], pair.part_b, pose_b};
    if (const auto* wall = std::get_if<HalfPlane>(&bodies.list[pair.a].shape)) return outline_points(*wall, b, margin);
    if (const auto* wall = std::get_if<HalfPlane>(&bodies.list[pair.b].shape)) {
        Manifold manifold = outline_points(*wall, a, margin);
        for (int k = 0; k < manifold.count; ++k) manifold.contacts[k].normal = -manifold.contacts[k].normal;
        return manifold;
    }
    const double touch = bodies.touch_gap(pair.a, pose_a.position, pair.b, pose_b.position);
    const Manifold manifold = outline_points(a, b, margin, touch);
    const double lowest = manifold.count > 0 ? manifold.contacts[0].separation : 0.0; // it stands first
    const Manifold crossing = points_of_crossing(bodies, pair, pose_a, pose_b, touch, std::max(touch, -lowest));
    return crossing.count > 0 ? crossing : manifold;
}

// Where surfaces of neighbours act as one (collide/seams.hpp): what neighbours what.

/// Adds the seams of a part with a part of another body.
void find_seams_with(const RestBodies& bodies, int body, int part, int neighbour, int neighbours_part,
                     std::vector<Seam>& seams)
{
    const auto& polygon = std::get<Polygon>(bodies.shapes[body].parts[part].shape);
    const double size = bodies.size_of(body, neighbour);
    const double reach =
        bodies.poses[body].position.cwiseAbs().maxCoeff() + bodies.poses[neighbour].position.cwiseAbs().maxCoeff();
    SeamTolerance tolerance = seam_tolerance(size, reach);
    // Bricks that move lie as level as the solve leaves them, and tiles as the centres that their maker has summed up
    tolerance.step = tolerance.crack;
    const bool is_wall = std::holds_alternative<HalfPlane>(bodies.shapes[neighbour].parts[neighbours_part].shape);
    const Pose there = is_wall ? Pose{} : bodies.poses[neighbour];
    find_seams(polygon, relative_pose(bodies.poses[body], there), bodies.shapes[neighbour].parts[neighbours_part].shape,
               bodies.real_edges[neighbour][neighbours_part], tolerance, seams);
}

/// Adds those of one body of a pair with others that go with it, beside it, while the other body of the pair passes a
/// corner of its.
///
/// near  a corner that is no further from a contact is passed [m]
void find_moving_seams(const RestBodies& bodies, const PairList& list, const RestPair& pair, Owner owner,
                       const Pose& pose, const Manifold& manifold, double near, std::vector<Seam>& seams)
{
    const int body = owner == Owner::a ? pair.a : pair.b;
    const int part = owner == Owner::a ? pair.part_a : pair.part_b;
    const int toucher = owner == Owner::a ? pair.b : pair.a;
    const auto& polygon = std::get<Polygon>(bodies.shapes[body].parts[part].shape);
    const double sign = owner == Owner::a ? 0.5 : -0.5;
    for (int k = 0; k < manifold.count; ++k) {
        const Contact& contact = manifold.contacts[k];
        const Vec2 point = contact.point - (sign * contact.separation) * contact.normal;
        const Vec2 velocity = bodies.velocity_of(body, point);
        const double pass = (velocity - bodies.velocity_of(toucher, point)).squaredNorm();
        if (pass == 0.0) continue;
        const Vec2 local = inverse(pose.rotation) * Vec2(point - pose.position);
        const auto is_here = [&](const Vec2& vertex) { return (vertex - local).squaredNorm() <= near * near; };
        if (std::none_of(polygon.vertices().begin(), polygon.vertices().end(), is_here)) continue;

        // Together go two that part, while the third passes by its size, by no more than what is near
        const double slow = rest_tolerance::k_watch * rest_tolerance::k_watch * pass;
        const auto goes_with_it = [&](int other) {
            return other != toucher && !((velocity - bodies.velocity_of(other, point)).squaredNorm() > slow);
        };
        if (!list.any_beside(body, goes_with_it)) break;

        // Look at those that do, and of these at the parts whose circles come here
        const auto look_at = [&](std::span<const RestPair> pairs) {
            const bool is_first = pairs.front().a == body;
            const int other = is_first ? pairs.front().b : pairs.front().a;
            if (!goes_with_it(other)) return;
            for (const RestPair& next : pairs) {
                if ((is_first ? next.part_a : next.part_b) != part) continue;
                const int others_part = is_first ? next.part_b : next.part_a;
                const ConvexPart& neighbour = bodies.shapes[other].parts[others_part];
                const Vec2 way = point - bodies.poses[other] * neighbour.centre;
                const double reach = neighbour.radius + 2.0 * near;
                if (way.squaredNorm() > reach * reach) continue;
                find_seams_with(bodies, body, part, other, others_part, seams);
            }
        };
        list.for_each_of(body, look_at);
        break;
    }
    for (Seam& seam : seams) seam.is_loose = true;
}

} // namespace

double change_since_look(const RestBodies& bodies, const RestPair& pair, const Pose& pose_a, const Pose& pose_b)
{
    double shift = bodies.travel[pair.a].shift + bodies.travel[pair.b].shift;
    double turn = bodies.travel[pair.a].turn + bodies.travel[pair.b].turn;
    for (const auto& [there, body] : {std::pair(&pose_a, pair.a), std::pair(&pose_b, pair.b)}) {
        const Pose& here = bodies.poses[body];
        shift += (there->position - here.position).cwiseAbs().sum();
        turn += std::abs(there->rotation.cosine - here.rotation.cosine) +
                std::abs(there->rotation.sine - here.rotation.sine);
    }
    const double arm = (pose_b.position - pose_a.position).cwiseAbs().sum() + (shift - pair.shift) +
                       (bodies.radius[pair.a] + bodies.radius[pair.b]);
    return (shift - pair.shift) + (turn - pair.turn) * arm + rest_tolerance::k_rounding * (arm + shift);
}

/// Seams that last: of what never moves.
NarrowPhase::NarrowPhase(const RestBodies& bodies)
{
    for (const CollisionShape& shape : bodies.shapes) {
        std::vector<double>& widths = widths_.emplace_back();
        for (const ConvexPart& part : shape.parts) widths.push_back(least_width(part.shape));
    }
    seams_.resize(bodies.list.size());
    std::vector<BoxCells::Entry> boxes;
    std::vector<int> walls;
    const auto add = [&](int one, int two) {
        for (int p = 0; p < static_cast<int>(bodies.shapes[one].parts.size()); ++p) {
            if (!std::holds_alternative<Polygon>(bodies.shapes[one].parts[p].shape)) continue;
            for (int q = 0; q < static_cast<int>(bodies.shapes[two].parts.size()); ++q) {
                find_seams_with(bodies, one, p, two, q, seams_[one][p]);
            }
        }
    };
    for (int k = 0; k < static_cast<int>(bodies.list.size()); ++k) {
        seams_[k].resize(bodies.shapes[k].parts.size());
        if (!bodies.list[k].is_static) continue;
        if (std::holds_alternative<HalfPlane>(bodies.list[k].shape)) {
            walls.push_back(k);
            continue;
        }
        const Aabb box = bounding_box(bodies.list[k].shape, bodies.poses[k]);
        const Vec2 room = Vec2::Constant(rest_tolerance::k_watch * bodies.radius[k]);
        boxes.push_back({{box.min - room, box.max + room}, k});
    }
    for (const BoxCells::Entry& entry : boxes) {
        for (const int wall : walls) add(entry.body, wall);
    }
    BoxCells cells;
    cells.sort(std::move(boxes));
    cells.for_each_pair([&](const BoxCells::Entry& one, const BoxCells::Entry& two) {
        add(one.body, two.body);
        add(two.body, one.body);
    });
}

/// Puts right what the two of a pair would touch of sides that neighbours hide.
void NarrowPhase::mend(const RestBodies& bodies, const PairList& pairs, const RestPair& pair, const Pose& pose_a,
                       const Pose& pose_b, double margin, Manifold& manifold) const
{
    // What lies on a slim body is not what lies beside it
    const double size = std::min(
        {bodies.radius[pair.a], bodies.radius[pair.b], widths_[pair.a][pair.part_a], widths_[pair.b][pair.part_b]});
    const double near = rest_tolerance::k_watch * size;
    std::vector<Seam> moving;
    for (const Owner owner : {Owner::a, Owner::b}) {
        const bool of_a = owner == Owner::a;
        const int body = of_a ? pair.a : pair.b;
        const int part = of_a ? pair.part_a : pair.part_b;
        const Shape& other =
            of_a ? bodies.shapes[pair.b].parts[pair.part_b].shape : bodies.shapes[pair.a].parts[pair.part_a].shape;
        const auto* polygon = std::get_if<Polygon>(&bodies.shapes[body].parts[part].shape);
        if (!polygon || std::holds_alternative<HalfPlane>(other)) continue;
        const Pose& pose = of_a ? pose_a : pose_b;
        const Pose& other_pose = of_a ? pose_b : pose_a;
        const std::vector<Seam>& fixed = seams_[body][part];
        if (!fixed.empty()) mend_at_seams(*polygon, pose, fixed, owner, other, other_pose, near, margin, manifold);
        moving.clear();
        find_moving_seams(bodies, pairs, pair, owner, pose, manifold, near, moving);
        if (!moving.empty()) mend_at_seams(*polygon, pose, moving, owner, other, other_pose, near, margin, manifold);
    }
}

Manifold NarrowPhase::look(const RestBodies& bodies, const PairList& pairs, const RestPair& pair, const Pose& pose_a,
                           const Pose& pose_b, double margin) const
{
    std::optional<Manifold> manifold;
    if (!bodies.has_cuts(pair.a, pair.b)) {
        // Edges that led by more than two separations can have changed are the best here, too
        NearMemory memory;
        memory.knows_edges = pair.memory.knows_edges;
        if (memory.knows_edges) {
            memory.edges = pair.memory.edges;
            memory.edges.lead -= 2.0 * change_since_look(bodies, pair, pose_a, pose_b);
            memory.knows_edges = memory.edges.lead > 0.0;
        }
        manifold = near_points(bodies.shapes[pair.a].parts[0].shape, pose_a, bodies.shapes[pair.b].parts[0].shape,
                               pose_b, margin, memory);
    }
    if (!manifold) manifold = points_of_outlines(bodies, pair, pose_a, pose_b, margin);
    if (manifold->count > 0) mend(bodies, pairs, pair, pose_a, pose_b, margin, *manifold);
    return *manifold;
}

Manifold NarrowPhase::find_cached(const RestBodies& bodies, const PairList& pairs, RestPair& pair, double margin) const
{
    const Pose& pose_a = bodies.poses[pair.a];
    const Pose& pose_b = bodies.poses[pair.b];
    const Shape& part_a = bodies.shapes[pair.a].parts[pair.part_a].shape;
    const Shape& part_b = bodies.shapes[pair.b].parts[pair.part_b].shape;
    std::optional<Manifold> manifold;
    if (!bodies.has_cuts(pair.a, pair.b)) manifold = near_points(part_a, pose_a, part_b, pose_b, margin, pair.memory);
    else if (find_separation(part_a, pose_a, part_b, pose_b, pair.memory) > margin) return {};
    if (!manifold) manifold = points_of_outlines(bodies, pair, pose_a, pose_b, margin);
    if (manifold->count > 0) mend(bodies, pairs, pair, pose_a, pose_b, margin, *manifold);
    return *manifold;
}

} // namespace flying
