#include <algorithm>
#include <array>

#include "collide/manifold.hpp"
#include "head_on.hpp"
#include "live/pieces.hpp"

// What this chapter's page computes.

namespace flying::live {

namespace {

/// sides of A, sides of B (four: a rectangle, else regular), place x, y and angle of A, of B -> greatest separation;
/// 0 where the axis is A's, 1 where B's; its edge, and the other's vertex; the normal from A to B, x, y; the number of
/// contacts; of each its point x, y and its separation. Then the separation along each edge of A, along each of B.
Answer axes(std::span<const double> of)
{
    const auto polygon = [](double sides) {
        const int count = static_cast<int>(std::clamp(sides, 3.0, 12.0));
        return count == 4 ? box_of(2.0, 1.2) : regular(count, 1.0);
    };
    const Polygon a = polygon(of[0]);
    const Polygon b = polygon(of[1]);
    const Pose world_from_a = placed(of[2], of[3], of[4]);
    const Pose world_from_b = placed(of[5], of[6], of[7]);
    const Pose a_from_b = relative_pose(world_from_a, world_from_b);
    const Axis axis = greatest_separation(a, b, a_from_b);
    const bool is_of_a = axis.owner == Owner::a;
    const Vec2 normal = is_of_a ? Vec2(world_from_a.rotation * a.edges()[axis.edge].normal)
                                : Vec2(world_from_b.rotation * -b.edges()[axis.edge].normal);
    const Manifold manifold = make_manifold(a, world_from_a, b, world_from_b, 0.0);

    Answer answer{{axis.separation, is_of_a ? 0.0 : 1.0, static_cast<double>(axis.edge),
                   static_cast<double>(axis.vertex), normal.x(), normal.y(), static_cast<double>(manifold.count)},
                  {}};
    for (int k = 0; k < manifold.count; ++k) {
        const Contact& contact = manifold.contacts[k];
        answer.engine.insert(answer.engine.end(), {contact.point.x(), contact.point.y(), contact.separation});
    }
    const Pose b_from_a = relative_pose(world_from_b, world_from_a);
    for (std::size_t k = 0; k < a.edges().size(); ++k)
        answer.engine.push_back(axis_of_edge(a, static_cast<int>(k), b, a_from_b).separation);
    for (std::size_t k = 0; k < b.edges().size(); ++k)
        answer.engine.push_back(axis_of_edge(b, static_cast<int>(k), a, b_from_a).separation);
    return answer;
}

/// speed, steps a second, seconds -> for each step: places along x of both squares by the right rule, then x, y of both by
/// the wrong one.
Answer head_on(std::span<const double> of)
{
    const double dt = 1.0 / std::clamp(of[1], 1.0, 1e4);
    const int count = static_cast<int>(std::clamp(of[2] / dt, 1.0, 1e4));
    HeadOn right;
    right.v_a *= of[0];
    right.v_b *= of[0];
    HeadOn wrong = right;
    Answer answer;
    for (int k = 0; k <= count; ++k) {
        for (const HeadOn* pair : {&right, &wrong})
            for (const Pose* pose : {&pair->pose_a, &pair->pose_b})
                answer.engine.insert(answer.engine.end(), {pose->position.x(), pose->position.y()});
        right.step(Rule::greatest_separation, dt);
        wrong.step(Rule::nearest_edge, dt);
    }
    return answer;
}

constexpr std::array k_pieces{Piece{"axes", 8, axes}, Piece{"head-on", 3, head_on}};

} // namespace

std::span<const Piece> pieces_of_axes() { return k_pieces; }

} // namespace flying::live
