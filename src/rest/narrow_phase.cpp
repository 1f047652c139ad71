#include "rest/narrow_phase.hpp"

#include <algorithm>
#include <utility>

#include "broadphase/box_cells.hpp"
#include "rest/near_points.hpp"
#include "rest/rest_tolerance.hpp"

namespace flying {
namespace {

[[nodiscard]] NearSide side_of(const RestBodies& bodies, int body, int part, const Pose& pose)
{
    return {bodies.shapes[body].parts[part].shape, pose, bodies.real_edges[body][part]};
}

// Where surfaces of neighbours act as one (collide/seams.hpp): who neighbours whom.

/// Adds the seams of a part with a part of another body, or of its own.
void find_seams_with(const RestBodies& bodies, int body, int part, int neighbour, int neighbours_part,
                     std::vector<Seam>& seams)
{
    const auto& polygon = std::get<Polygon>(bodies.shapes[body].parts[part].shape);
    const double size = std::min(bodies.radius[body], bodies.radius[neighbour]);
    // Parts of one body lie as they do wherever it is
    const bool is_own = body == neighbour;
    const double reach = is_own ? 0.0
                                : bodies.poses[body].position.cwiseAbs().maxCoeff() +
                                      bodies.poses[neighbour].position.cwiseAbs().maxCoeff();
    SeamTolerance tolerance = seam_tolerance(size, reach);
    // Bricks that move lie as level as the solve leaves them
    if (!is_own && (!bodies.list[body].is_static || !bodies.list[neighbour].is_static))
        tolerance.step = tolerance.crack;
    const bool is_wall = std::holds_alternative<HalfPlane>(bodies.shapes[neighbour].parts[neighbours_part].shape);
    const Pose there = is_wall ? Pose{} : bodies.poses[neighbour];
    find_seams(polygon, is_own ? Pose{} : relative_pose(bodies.poses[body], there),
               bodies.shapes[neighbour].parts[neighbours_part].shape, bodies.real_edges[neighbour][neighbours_part],
               tolerance, seams);
}

/// Adds those at the bottoms of a body's notches, where cuts between its parts begin. A part that has one flank of a
/// notch goes on up the other flank, whichever part has that one.
void find_notches(const RestBodies& bodies, int body, std::vector<std::vector<Seam>>& seams)
{
    const auto* outline = std::get_if<Polygon>(&bodies.list[body].shape);
    if (!outline) return;
    const double crack = seam_tolerance(bodies.radius[body], 0.0).crack;
    for (std::size_t p = 0; p < bodies.shapes[body].parts.size(); ++p) {
        const auto& part = std::get<Polygon>(bodies.shapes[body].parts[p].shape);
        const std::vector<char>& real = bodies.real_edges[body][p];
        for (int bottom = 0; bottom < static_cast<int>(outline->vertices().size()); ++bottom) {
            if (!outline->is_reflex(bottom)) continue;
            for (int v = 0; v < static_cast<int>(part.vertices().size()); ++v) {
                if ((part.vertices()[v] - outline->vertices()[bottom]).norm() > crack) continue;
                const int before = part.previous(v);
                Seam seam{v, before, v, Vec2::Zero(), Vec2::Zero(), crack, Seam::Bend::buried, false};
                if (real[before] || real[v]) {
                    seam.bend = Seam::Bend::hollow;
                    if (real[before]) std::swap(seam.hidden, seam.open);
                    const Edge& flank = outline->edges()[real[before] ? bottom : outline->previous(bottom)];
                    seam.onwards = real[before] ? flank.tangent : Vec2(-flank.tangent);
                    seam.outwards = flank.normal;
                }
                seams[p].push_back(seam);
            }
        }
    }
}

/// Adds those of one body of a pair with others that go with it, beside it, while the other body of the pair passes a
/// corner of its.
void find_moving_seams(const RestBodies& bodies, const PairList& list, const RestPair& pair, Owner owner,
                       const Pose& pose, const Manifold& manifold, std::vector<Seam>& seams)
{
    const int body = owner == Owner::a ? pair.a : pair.b;
    const int part = owner == Owner::a ? pair.part_a : pair.part_b;
    const int toucher = owner == Owner::a ? pair.b : pair.a;
    const auto& polygon = std::get<Polygon>(bodies.shapes[body].parts[part].shape);
    const double sign = owner == Owner::a ? 0.5 : -0.5;
    const double near = rest_tolerance::k_same_place * std::min(bodies.radius[pair.a], bodies.radius[pair.b]);
    for (int k = 0; k < manifold.count; ++k) {
        const Contact& contact = manifold.contacts[k];
        const Vec2 point = contact.point - (sign * contact.separation) * contact.normal;
        const double pass = (bodies.velocity_of(body, point) - bodies.velocity_of(toucher, point)).norm();
        if (pass == 0.0) continue;
        const Vec2 local = inverse(pose.rotation) * Vec2(point - pose.position);
        const auto is_here = [&](const Vec2& vertex) { return (vertex - local).squaredNorm() <= near * near; };
        if (std::none_of(polygon.vertices().begin(), polygon.vertices().end(), is_here)) continue;

        // Look at those whose circles come here
        const auto look_at = [&](const RestPair& next) {
            const bool is_first = next.a == body;
            const int other = is_first ? next.b : next.a;
            if (other == toucher || (is_first ? next.part_a : next.part_b) != part) return;
            const int others_part = is_first ? next.part_b : next.part_a;
            const ConvexPart& neighbour = bodies.shapes[other].parts[others_part];
            const Vec2 way = point - bodies.poses[other] * neighbour.centre;
            const double reach = neighbour.radius + 2.0 * near;
            if (way.squaredNorm() > reach * reach) return;
            if ((bodies.velocity_of(body, point) - bodies.velocity_of(other, point)).norm() >
                rest_tolerance::k_together * pass)
                return;
            find_seams_with(bodies, body, part, other, others_part, seams);
        };
        list.for_each_of(body, look_at);
        break;
    }
    for (Seam& seam : seams) seam.is_loose = true;
}

} // namespace

/// Those that last: of parts of one body, and of what never moves.
NarrowPhase::NarrowPhase(const RestBodies& bodies)
{
    seams_.resize(bodies.list.size());
    std::vector<BoxCells::Entry> boxes;
    std::vector<int> walls;
    const auto add = [&](int one, int two) {
        for (int p = 0; p < static_cast<int>(bodies.shapes[one].parts.size()); ++p) {
            if (!std::holds_alternative<Polygon>(bodies.shapes[one].parts[p].shape)) continue;
            for (int q = 0; q < static_cast<int>(bodies.shapes[two].parts.size()); ++q) {
                if (one != two || p != q) find_seams_with(bodies, one, p, two, q, seams_[one][p]);
            }
        }
    };
    for (int k = 0; k < static_cast<int>(bodies.list.size()); ++k) {
        seams_[k].resize(bodies.shapes[k].parts.size());
        if (bodies.shapes[k].parts.size() > 1) {
            find_notches(bodies, k, seams_[k]);
            add(k, k);
        }
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
    const double near = rest_tolerance::k_same_place * std::min(bodies.radius[pair.a], bodies.radius[pair.b]);
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
        find_moving_seams(bodies, pairs, pair, owner, pose, manifold, moving);
        if (!moving.empty()) mend_at_seams(*polygon, pose, moving, owner, other, other_pose, near, margin, manifold);
    }
}

Manifold NarrowPhase::look(const RestBodies& bodies, const PairList& pairs, const RestPair& pair, const Pose& pose_a,
                           const Pose& pose_b, double margin) const
{
    Manifold manifold =
        near_points(side_of(bodies, pair.a, pair.part_a, pose_a), side_of(bodies, pair.b, pair.part_b, pose_b), margin);
    if (manifold.count > 0) mend(bodies, pairs, pair, pose_a, pose_b, margin, manifold);
    return manifold;
}

Manifold NarrowPhase::find_cached(const RestBodies& bodies, const PairList& pairs, RestPair& pair, double margin) const
{
    const Pose& pose_a = bodies.poses[pair.a];
    const Pose& pose_b = bodies.poses[pair.b];
    Manifold manifold = near_points(side_of(bodies, pair.a, pair.part_a, pose_a),
                                    side_of(bodies, pair.b, pair.part_b, pose_b), margin, pair.memory);
    if (manifold.count > 0) mend(bodies, pairs, pair, pose_a, pose_b, margin, manifold);
    return manifold;
}

} // namespace flying
