#include <algorithm>

#include "broadphase/box_cells.hpp"
#include "rest/rest_engine.hpp"
#include "rest/rest_tolerance.hpp"

namespace flying {
namespace {


/// [speeds] Two that part no faster than this, beside one that passes both, go together.
constexpr double k_together = 0x1p-6;


} // namespace


// Where surfaces of neighbours act as one (collide/seams.hpp): who neighbours whom.

/// Adds the seams of a part with a part of another body, or of its own.
void RestEngine::find_seams_with(int body, int part, int neighbour, int neighbours_part, std::vector<Seam>& seams) const
{
    const auto& polygon = std::get<Polygon>(shapes_[body].parts[part].shape);
    const double size = std::min(radius_[body], radius_[neighbour]);
    // Parts of one body lie as they do wherever it is
    const bool is_own = body == neighbour;
    const double reach =
        is_own ? 0.0 : poses_[body].position.cwiseAbs().maxCoeff() + poses_[neighbour].position.cwiseAbs().maxCoeff();
    SeamTolerance tolerance = seam_tolerance(size, reach);
    // Bricks that move lie as level as the solve leaves them
    if (!is_own && (is_moved(body) || is_moved(neighbour))) tolerance.step = tolerance.crack;
    const bool is_wall = std::holds_alternative<HalfPlane>(shapes_[neighbour].parts[neighbours_part].shape);
    const Pose there = is_wall ? Pose{} : poses_[neighbour];
    find_seams(polygon, is_own ? Pose{} : relative_pose(poses_[body], there), shapes_[neighbour].parts[neighbours_part].shape,
               real_edges_[neighbour][neighbours_part], tolerance, seams);
}

/// Those that last: of parts of one body, and of what never moves.
void RestEngine::find_fixed_seams()
{
    seams_.resize(bodies_.size());
    std::vector<BoxCells::Entry> boxes;
    std::vector<int> walls;
    const auto add = [&](int one, int two) {
        for (int p = 0; p < static_cast<int>(shapes_[one].parts.size()); ++p) {
            if (!std::holds_alternative<Polygon>(shapes_[one].parts[p].shape)) continue;
            for (int q = 0; q < static_cast<int>(shapes_[two].parts.size()); ++q) {
                if (one != two || p != q) find_seams_with(one, p, two, q, seams_[one][p]);
            }
        }
    };
    for (int k = 0; k < static_cast<int>(bodies_.size()); ++k) {
        seams_[k].resize(shapes_[k].parts.size());
        if (shapes_[k].parts.size() > 1) add(k, k);
        if (!bodies_[k].is_static) continue;
        if (std::holds_alternative<HalfPlane>(bodies_[k].shape)) {
            walls.push_back(k);
            continue;
        }
        const Aabb box = bounding_box(bodies_[k].shape, poses_[k]);
        const Vec2 room = Vec2::Constant(rest_tolerance::k_watch * radius_[k]);
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



/// Adds those of one body of a pair with others that go with it, beside it, while the other body of the pair passes a
/// corner of its.
void RestEngine::find_moving_seams(const RestPair& pair, Owner owner, const Pose& pose, const Manifold& manifold,
                                   std::vector<Seam>& seams) const
{
    const int body = owner == Owner::a ? pair.a : pair.b;
    const int part = owner == Owner::a ? pair.part_a : pair.part_b;
    const int toucher = owner == Owner::a ? pair.b : pair.a;
    const auto& polygon = std::get<Polygon>(shapes_[body].parts[part].shape);
    const double sign = owner == Owner::a ? 0.5 : -0.5;
    const double near = rest_tolerance::k_same_place * std::min(radius_[pair.a], radius_[pair.b]);
    for (int k = 0; k < manifold.count; ++k) {
        const Contact& contact = manifold.contacts[k];
        const Vec2 point = contact.point - (sign * contact.separation) * contact.normal;
        const double pass = (velocity_of(body, point) - velocity_of(toucher, point)).norm();
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
            const ConvexPart& neighbour = shapes_[other].parts[others_part];
            const Vec2 way = point - poses_[other] * neighbour.centre;
            const double reach = neighbour.radius + 2.0 * near;
            if (way.squaredNorm() > reach * reach) return;
            if ((velocity_of(body, point) - velocity_of(other, point)).norm() > k_together * pass) return;
            find_seams_with(body, part, other, others_part, seams);
        };
        const std::span<const RestPair> pairs = pairs_.pairs();
        for (int next = pairs_.starts()[body]; next < pairs_.starts()[body + 1]; ++next) look_at(pairs[next]);
        for (const int next : pairs_.pairs_of_second(body)) look_at(pairs[next]);
        break;
    }
    for (Seam& seam : seams) seam.is_loose = true;
}

/// Velocity of a body's point, as the step or a part of one begins.
Vec2 RestEngine::velocity_of(int body, const Vec2& point) const
{
    const BodyState& s = bodies_[body].state;
    return bodies_[body].is_static ? Vec2(Vec2::Zero()) : velocity_at(s, point - poses_[body].position);
}



/// Puts right what the two of a pair would touch of sides that neighbours hide.
void RestEngine::mend(const RestPair& pair, const Pose& pose_a, const Pose& pose_b, double margin, Manifold& manifold) const
{
    const double near = rest_tolerance::k_same_place * std::min(radius_[pair.a], radius_[pair.b]);
    std::vector<Seam> moving;
    for (const Owner owner : {Owner::a, Owner::b}) {
        const bool of_a = owner == Owner::a;
        const int body = of_a ? pair.a : pair.b;
        const int part = of_a ? pair.part_a : pair.part_b;
        const Shape& other = of_a ? shapes_[pair.b].parts[pair.part_b].shape : shapes_[pair.a].parts[pair.part_a].shape;
        const auto* polygon = std::get_if<Polygon>(&shapes_[body].parts[part].shape);
        if (!polygon || std::holds_alternative<HalfPlane>(other)) continue;
        const Pose& pose = of_a ? pose_a : pose_b;
        const Pose& other_pose = of_a ? pose_b : pose_a;
        const std::vector<Seam>& fixed = seams_[body][part];
        if (!fixed.empty()) mend_at_seams(*polygon, pose, fixed, owner, other, other_pose, near, margin, manifold);
        moving.clear();
        find_moving_seams(pair, owner, pose, manifold, moving);
        if (!moving.empty()) mend_at_seams(*polygon, pose, moving, owner, other, other_pose, near, margin, manifold);
    }
}


} // namespace flying
