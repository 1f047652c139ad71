#include "collide/separating_axis.hpp"

#include <algorithm>
#include <limits>

namespace flying {

Pose relative_pose(const Pose& world_from_a, const Pose& world_from_b)
{
    const Rotation a_from_world = inverse(world_from_a.rotation);
    const Vec2 offset = world_from_b.position - world_from_a.position;
    return {a_from_world * offset, a_from_world * world_from_b.rotation};
}

namespace {

/// The pose that leads back.
Pose inverse(const Pose& a_from_b)
{
    const Rotation b_from_a = flying::inverse(a_from_b.rotation);
    return {b_from_a * Vec2(-a_from_b.position), b_from_a};
}

/// Separation of one vertex of the other polygon from the line of the owner's edge.  [m]
double separation_of(const Polygon& owner, const Edge& edge, const Vec2& vertex, const Pose& owner_from_other)
{
    const Vec2 from_edge = owner_from_other * vertex - owner.vertices()[edge.from];
    return edge.normal.dot(from_edge);
}

/// Normal of the owner's edge in the other's frame.
Vec2 normal_in_other(const Edge& edge, const Pose& owner_from_other)
{
    return flying::inverse(owner_from_other.rotation) * edge.normal;
}

/// The vertex furthest against a direction.
int lowest_vertex(const Polygon& polygon, const Vec2& direction)
{
    int lowest = 0;
    double least = direction.dot(polygon.vertices()[0]);
    for (int v = 1; v < static_cast<int>(polygon.vertices().size()); ++v) {
        const double height = direction.dot(polygon.vertices()[v]);
        if (height < least) {
            least = height;
            lowest = v;
        }
    }
    return lowest;
}

/// The axis of greatest separation among the owner's edges, in one round of both polygons; and the next greatest.
Axis greatest_of_owner(const Polygon& owner, const Polygon& other, const Pose& owner_from_other, double& next)
{
    Axis best = axis_of_edge(owner, 0, other, owner_from_other);
    next = -std::numeric_limits<double>::infinity();
    int vertex = best.vertex;
    int steps_left = 2 * static_cast<int>(other.vertices().size());
    for (int k = 1; k < static_cast<int>(owner.edges().size()); ++k) {
        const Edge& edge = owner.edges()[k];
        const Vec2 normal = normal_in_other(edge, owner_from_other);
        while (normal.dot(other.edges()[vertex].tangent) < 0.0 && steps_left > 0) {
            vertex = other.edges()[vertex].to;
            --steps_left;
        }
        const double separation = separation_of(owner, edge, other.vertices()[vertex], owner_from_other);
        next = std::max(next, std::min(separation, best.separation));
        if (separation > best.separation) best = {Owner::a, k, vertex, separation};
    }
    return best;
}

} // namespace

Axis axis_of_edge(const Polygon& owner, int edge, const Polygon& other, const Pose& owner_from_other)
{
    const Edge& side = owner.edges()[edge];
    const int vertex = lowest_vertex(other, normal_in_other(side, owner_from_other));
    return {Owner::a, edge, vertex, separation_of(owner, side, other.vertices()[vertex], owner_from_other)};
}

Axis greatest_separation(const Polygon& a, const Polygon& b, const Pose& a_from_b)
{
    double next = 0.0;
    const Axis of_a = greatest_of_owner(a, b, a_from_b, next);
    Axis of_b = greatest_of_owner(b, a, inverse(a_from_b), next);
    of_b.owner = Owner::b;
    return of_b.separation > of_a.separation ? of_b : of_a;
}

BestEdges best_edges(const Polygon& a, const Polygon& b, const Pose& a_from_b)
{
    double next_of_a = 0.0;
    double next_of_b = 0.0;
    const Axis of_a = greatest_of_owner(a, b, a_from_b, next_of_a);
    const Axis of_b = greatest_of_owner(b, a, inverse(a_from_b), next_of_b);
    return {of_a.edge, of_b.edge, std::min(of_a.separation - next_of_a, of_b.separation - next_of_b)};
}

Axis greater_of(const BestEdges& edges, const Polygon& a, const Polygon& b, const Pose& a_from_b)
{
    const Axis of_a = axis_of_edge(a, edges.of_a, b, a_from_b);
    Axis of_b = axis_of_edge(b, edges.of_b, a, inverse(a_from_b));
    of_b.owner = Owner::b;
    return of_b.separation > of_a.separation ? of_b : of_a;
}

std::optional<Axis> overlapping_axis(const Polygon& a, const Polygon& b, const Pose& a_from_b, const BestEdges& guess,
                                     double depth)
{
    if (!(greater_of(guess, a, b, a_from_b).separation < -0.5 * depth)) return std::nullopt;
    const Axis axis = greatest_separation(a, b, a_from_b);
    return axis.separation < -depth ? std::optional(axis) : std::nullopt;
}

} // namespace flying
