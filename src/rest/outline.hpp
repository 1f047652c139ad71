#pragma once

#include <span>
#include <vector>

#include "collide/separation.hpp"
#include "geometry/shape.hpp"
#include "math/vec2.hpp"

namespace flying {

/// The boundary of a body, each side and corner with the convex part that has it. Cuts between parts are none of it.
class Outline
{
public:
    /// A straight stretch of the boundary: an edge of a part. The inside lies to the left.
    struct Side
    {
        int edge = 0; ///< of the part
        Vec2 start = Vec2::Zero();
        Vec2 finish = Vec2::Zero();
        Vec2 tangent = Vec2::Zero(); ///< unit vector
        Vec2 normal = Vec2::Zero();  ///< unit vector, outwards
        double length = 0.0;         ///< [m]
        bool rises_before = false;   ///< the boundary turns towards the outside where the side starts
        bool rises_after = false;    ///< the same where it ends
        Vec2 before = Vec2::Zero();  ///< outward normal of the side that ends where this one starts
        Vec2 after = Vec2::Zero();   ///< and of the one that starts where it ends

        [[nodiscard]] double distance_to(const Vec2& point) const; ///< [m]
    };
    /// A corner that sticks out; or a whole disc, which is one with a radius.
    struct Corner
    {
        int vertex = 0; ///< of the part
        Vec2 place = Vec2::Zero();
        double radius = 0.0;        ///< [m]
        Vec2 before = Vec2::Zero(); ///< outward normal of the side that ends there
        Vec2 after = Vec2::Zero();  ///< and of that which starts there
    };

    /// parts  of the shape
    Outline(const Shape& shape, const CollisionShape& parts);

    [[nodiscard]] std::span<const Side> sides() const { return sides_; }
    [[nodiscard]] std::span<const Corner> corners() const { return corners_; }
    [[nodiscard]] std::span<const Side> sides_of(int part) const
    {
        return std::span(sides_).subspan(first_side_[part], first_side_[part + 1] - first_side_[part]);
    }
    /// Of several parts that share a corner, one has it: that with the side that starts there.
    [[nodiscard]] std::span<const Corner> corners_of(int part) const
    {
        return std::span(corners_).subspan(first_corner_[part], first_corner_[part + 1] - first_corner_[part]);
    }
    /// Of a part; infinite where it has none, as a disc.  [m]
    [[nodiscard]] double longest_side(int part) const { return longest_side_[part]; }
    /// Whether a point lies inside of the boundary, and not on it.
    /// touch  what is no further from a side than this lies on it [m]
    [[nodiscard]] bool holds(const Vec2& point, double touch) const;

private:
    std::vector<Side> sides_; // part after part
    std::vector<Corner> corners_;
    std::vector<int> first_side_; // of each part, and the number of all at the end
    std::vector<int> first_corner_;
    std::vector<double> longest_side_; // of each part [m]
};

} // namespace flying
