#include "rest/outline.hpp"

#include <algorithm>
#include <limits>

#include "geometry/straight_vertices.hpp"
#include "rest/rest_tolerance.hpp"

namespace flying {

Outline::Outline(const Shape& shape, const CollisionShape& parts)
{
    first_side_.assign(1, 0);
    first_corner_.assign(1, 0);
    if (const auto* disc = std::get_if<Disc>(&shape)) corners_.push_back({.radius = disc->radius});
    const auto* whole = std::get_if<Polygon>(&shape);

    // Gather the sides: all edges of the only part, and of several parts those that are no cuts
    for (const ConvexPart& part : parts.parts) {
        if (whole) {
            const Polygon& polygon = std::get<Polygon>(part.shape);
            for (int k = 0; k < static_cast<int>(polygon.edges().size()); ++k) {
                const Edge& edge = polygon.edges()[k];
                const Vec2& start = polygon.vertices()[edge.from];
                const Vec2& finish = polygon.vertices()[edge.to];
                if (parts.parts.size() > 1 && !has_straight_side(*whole, start, finish)) continue;
                sides_.push_back({k, start, finish, edge.tangent, edge.normal, edge.length});
            }
        }
        double longest = 0.0;
        for (std::size_t k = first_side_.back(); k < sides_.size(); ++k) longest = std::max(longest, sides_[k].length);
        longest_side_.push_back(longest > 0.0 ? longest : std::numeric_limits<double>::infinity());
        first_side_.push_back(static_cast<int>(sides_.size()));
    }

    // See how the boundary turns where one side ends and the next starts
    for (int part = 0; part < static_cast<int>(parts.parts.size()); ++part) {
        for (int k = first_side_[part]; k < first_side_[part + 1]; ++k) {
            Side& after = sides_[k];
            const auto before = std::find_if(sides_.begin(), sides_.end(),
                                             [&](const Side& side) { return side.finish == after.start; });
            if (before == sides_.end()) continue;
            const double turn = cross(before->tangent, after.tangent);
            before->after = after.normal;
            after.before = before->normal;
            if (turn < 0.0) after.rises_before = before->rises_after = true;
            else if (turn > rest_tolerance::k_straight)
                corners_.push_back({after.edge, after.start, 0.0, before->normal, after.normal});
        }
        first_corner_.push_back(static_cast<int>(corners_.size()));
    }
}

double Outline::Side::distance_to(const Vec2& point) const
{
    const double along = std::clamp(tangent.dot(point - start), 0.0, length);
    return (point - (start + along * tangent)).norm();
}

bool Outline::holds(const Vec2& point, double touch) const
{
    // Count the sides that a line crosses which leaves the point towards greater x
    bool is_inside = false;
    for (const Side& side : sides_) {
        if ((side.start.y() > point.y()) == (side.finish.y() > point.y())) continue;
        const bool is_left_of_it = side.normal.dot(point - side.start) < 0.0;
        if (is_left_of_it == (side.finish.y() > side.start.y())) is_inside = !is_inside;
    }
    const auto is_on = [&](const Side& side) { return side.distance_to(point) <= touch; };
    return is_inside && std::none_of(sides_.begin(), sides_.end(), is_on);
}

} // namespace flying
