#include "rest/outline_points.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>

#include "collide/manifold.hpp"
#include "rest/corner_ways.hpp"
#include "rest/rest_tolerance.hpp"

namespace flying {
namespace {

using Side = Outline::Side;
using Corner = Outline::Corner;

/// The corner of a body looks at a side of another: along one of its own sides, or with its tip. (Two that pass by each
/// other's sides, each with its tip along the other, would leave a thin wall by its far side.)
///
/// corner, normal  in one frame
[[nodiscard]] bool faces(const Corner& corner, const Vec2& normal)
{
    if (corner.radius > 0.0) return true;
    const double before = corner.before.dot(normal);
    const double after = corner.after.dot(normal);
    return before + after < -rest_tolerance::k_same_normal || std::min(before, after) < -rest_tolerance::k_one_face;
}

[[nodiscard]] Corner seen_from(const Pose& here_from_there, const Corner& corner)
{
    return {corner.vertex, here_from_there * corner.place, corner.radius, here_from_there.rotation * corner.before,
            here_from_there.rotation * corner.after};
}

/// The corner lies inside of the body, and leaves it by the shortest way over this side. (What is in front of the line
/// of another, in an arm beside it, can't leave over that, however near its end is.)
[[nodiscard]] bool leaves_over(const Outline& outline, const Side& side, const Corner& corner, double touch)
{
    const double depth = side.distance_to(corner.place);
    const auto is_nearer = [&](const Side& other) {
        const double height = other.normal.dot(corner.place - other.start); // the side is no nearer than its line
        return height < 0.0 && -height < depth && faces(corner, other.normal) &&
               other.distance_to(corner.place) < depth - touch;
    };
    return std::none_of(outline.sides().begin(), outline.sides().end(), is_nearer) &&
           outline.holds(corner.place, touch);
}

/// How two corners part that lie in each other.
struct Parting
{
    Vec2 normal = Vec2::Zero(); ///< from A to B
    double separation = -std::numeric_limits<double>::infinity();
    bool is_known = false;
};

/// The nearest of their four sides over which the other can leave: neither side of its own leads behind that, or the
/// two would cross and not part. Not known where one of them isn't behind both sides of the other.
///
/// a, b       corners, in the frame of A; that of B lies in A
/// outline_b  in its own frame
[[nodiscard]] Parting part_corners(const Corner& a, const Outline& outline_b, const Corner& b, const Pose& b_from_a,
                                   double touch)
{
    const Vec2 way = b.place - a.place;
    const double to_a = std::max(a.before.dot(way), a.after.dot(way));
    const double to_b = std::max(b.before.dot(-way), b.after.dot(-way));
    if (!(std::max(to_a, to_b) < -touch) || !outline_b.holds(b_from_a * a.place, touch)) return {};
    Parting best;
    const auto offer = [&](const Vec2& normal, const Corner& corner, double height, double sense) {
        const bool crosses = cross(corner.before, normal) > 0.0 || cross(corner.after, normal) < 0.0;
        if (!crosses && height > best.separation) best = {sense * normal, height, true};
    };
    offer(a.before, b, a.before.dot(way), 1.0);
    offer(a.after, b, a.after.dot(way), 1.0);
    offer(b.before, a, b.before.dot(-way), -1.0);
    offer(b.after, a, b.after.dot(-way), -1.0);
    return best;
}

/// Where an end of the side lies in the body of the corner: how these two part. Not known where that is over this side,
/// or one that looks the same way.
///
/// corners_from_sides  where the body with the side lies, as that with the corner sees it
[[nodiscard]] Parting part_otherwise(const Outline& with_sides, const Side& side, const Outline& with_corners,
                                     const Corner& corner, const Pose& corners_from_sides, double touch)
{
    for (const Corner& end : with_sides.corners()) {
        if (end.place != side.start && end.place != side.finish) continue;
        const Parting parting = part_corners(end, with_corners, corner, corners_from_sides, touch);
        if (parting.is_known && !(parting.normal.dot(side.normal) > rest_tolerance::k_one_face)) return parting;
    }
    return {};
}

/// Points of one pair of parts, in one frame; the best two of them.
class BestPoints
{
public:
    void add(const Contact& contact)
    {
        if (count_ < k_most) {
            all_[count_++] = contact;
            return;
        }
        Contact* highest = std::max_element(all_, all_ + count_, is_lower);
        if (is_lower(contact, *highest)) *highest = contact;
    }

    /// The lowest, and the one beside it that is the next lowest along the same normal.
    /// near  points this near to each other are one [m]
    [[nodiscard]] Manifold fetch(double near, double margin) const
    {
        Manifold manifold;
        if (count_ == 0) return manifold;
        const Contact* lowest = std::min_element(all_, all_ + count_, is_lower);
        manifold.contacts[manifold.count++] = *lowest;
        Contact next;
        next.separation = std::numeric_limits<double>::infinity();
        for (const Contact* other = all_; other != all_ + count_; ++other) {
            const double cosine = other->normal.dot(lowest->normal);
            if (!(cosine > rest_tolerance::k_one_face)) continue;
            const Vec2 way = other->point - lowest->point;
            if (!(std::abs(cross(lowest->normal, way)) > near)) continue;
            const double separation = other->separation / cosine;
            if (!(separation < next.separation)) continue;
            next = *other;
            next.separation = separation;
            next.normal = lowest->normal;
        }
        if (next.separation <= margin) manifold.contacts[manifold.count++] = next;
        return manifold;
    }

private:
    [[nodiscard]] static bool is_lower(const Contact& x, const Contact& y) { return x.separation < y.separation; }

    static constexpr int k_most = 16;
    Contact all_[k_most];
    int count_ = 0;
};

/// Corners of one body over sides of the other.
///
/// sides_from_corners  where the body with the corners lies, as the one with the sides sees it
/// corners_from_sides  the other way round
/// owner               of the corners
/// add                 takes a contact in the frame of the sides, with the normal out of these
template <class Add>
void add_corners_over_sides(const OutlineSide& with_sides, const OutlineSide& with_corners,
                            const Pose& sides_from_corners, const Pose& corners_from_sides, Owner owner, double margin,
                            double touch, const Add& add)
{
    for (const Corner& there : with_corners.outline.corners_of(with_corners.part)) {
        const Corner corner = seen_from(sides_from_corners, there);
        for (const Side& side : with_sides.outline.sides_of(with_sides.part)) {
            const Vec2 from_start = corner.place - side.start;
            const double height = side.normal.dot(from_start);
            const double separation = height - corner.radius;
            if (separation > margin || !faces(corner, side.normal)) continue;
            const double along = side.tangent.dot(from_start);
            const bool is_sunk = height < -touch;
            // In a notch a corner stays in front of the lines of both flanks, whichever of them it is over
            const double beyond = is_sunk ? std::numeric_limits<double>::infinity() : std::max(margin, touch);
            if (along < -(side.rises_before ? beyond : touch)) continue;
            if (along > side.length + (side.rises_after ? beyond : touch)) continue;
            if (is_sunk && !leaves_over(with_sides.outline, side, corner, touch)) continue;
            // What is behind the other flank, and not in the body, is beyond the arm whose flank that is
            const Vec2 from_finish = corner.place - side.finish;
            const bool is_behind = (along < -touch && side.before.dot(from_start) < -touch) ||
                                   (along > side.length + touch && side.after.dot(from_finish) < -touch);
            if (is_behind && !with_sides.outline.holds(corner.place, touch)) continue;
            Parting parting{side.normal, separation};
            if (is_sunk) {
                const Parting other =
                    part_otherwise(with_sides.outline, side, with_corners.outline, corner, corners_from_sides, touch);
                if (other.is_known) parting = other;
            }
            add(Contact{corner.place - (corner.radius + 0.5 * parting.separation) * parting.normal, parting.normal,
                        parting.separation, feature_number({owner, corner.vertex, side.edge})});
        }
    }
}

/// A way out of a corner leads between the normals of its two sides, beyond the ends of both.
[[nodiscard]] bool is_between(const Corner& corner, const Vec2& way, double touch)
{
    return corner.radius > 0.0 || (cross(way, corner.before) < -touch && cross(way, corner.after) > touch);
}

[[nodiscard]] std::uint32_t corner_feature(const Corner& a, const Corner& b)
{
    return 0x80000000u | static_cast<std::uint32_t>(a.vertex) << 16 | static_cast<std::uint32_t>(b.vertex) << 1;
}

/// Corners over corners, along the line between them.
void add_corners_over_corners(const OutlineSide& a, const OutlineSide& b, const Pose& a_from_b, double margin,
                              double touch, BestPoints& points)
{
    for (const Corner& there : b.outline.corners_of(b.part)) {
        const Corner corner_b = seen_from(a_from_b, there);
        for (const Corner& corner_a : a.outline.corners_of(a.part)) {
            const Vec2 way = corner_b.place - corner_a.place;
            const double reach = margin + corner_a.radius + corner_b.radius;
            const double square = way.squaredNorm();
            if (square > reach * reach || !(square > 0.0)) continue;
            if (!is_between(corner_a, way, touch) || !is_between(corner_b, -way, touch)) continue;
            const double length = std::sqrt(square);
            const Vec2 normal = way / length;
            const double separation = length - corner_a.radius - corner_b.radius;
            points.add({corner_a.place + (corner_a.radius + 0.5 * separation) * normal, normal, separation,
                        corner_feature(corner_a, corner_b)});
        }
    }
}

/// Where the lowest point is that of two corners which lie on each other, it goes along the middle of their ways. Where
/// another part has one of them, and this one no more than a side that leads there, it is that part's.
///
/// near   points no further from each other are one [m]
/// touch  lengths up to this are none [m]
void take_middle_way(const OutlineSide& a, const OutlineSide& b, const Pose& a_from_b, double near, double touch,
                     Manifold& manifold)
{
    Contact& lowest = manifold.contacts[0];
    const auto is_here = [&](const Corner& corner) {
        return (corner.place - lowest.point).norm() <= near;
    };
    const auto has = [](const OutlineSide& side, const Corner& corner) {
        const std::span<const Corner> own = side.outline.corners_of(side.part);
        return std::any_of(own.begin(), own.end(), [&](const Corner& other) { return &other == &corner; });
    };
    for (const Corner& there : b.outline.corners()) {
        const Corner corner_b = seen_from(a_from_b, there);
        if (!is_here(corner_b)) continue;
        for (const Corner& corner_a : a.outline.corners()) {
            if (!is_here(corner_a)) continue;
            const Vec2 way = corner_b.place - corner_a.place;
            const std::optional<Vec2> normal =
                middle_way({corner_a.before, corner_a.after}, {corner_b.before, corner_b.after}, way, touch);
            if (!normal) continue;
            if (has(a, corner_a) && has(b, there)) {
                const double separation = normal->dot(way);
                lowest = {corner_b.place - (0.5 * separation) * *normal, *normal, separation,
                          corner_feature(corner_a, corner_b)};
            } else {
                lowest = manifold.contacts[1];
                --manifold.count;
            }
            return;
        }
    }
}

[[nodiscard]] Manifold seen_in_world(Manifold manifold, const Pose& world_from_here)
{
    for (int k = 0; k < manifold.count; ++k) {
        Contact& contact = manifold.contacts[k];
        contact.point = world_from_here * contact.point;
        contact.normal = world_from_here.rotation * contact.normal;
    }
    return manifold;
}

} // namespace

Manifold outline_points(const OutlineSide& a, const OutlineSide& b, double margin, double touch)
{
    const Pose a_from_b = relative_pose(a.pose, b.pose);
    const Pose b_from_a = relative_pose(b.pose, a.pose);
    BestPoints points;
    add_corners_over_sides(a, b, a_from_b, b_from_a, Owner::b, margin, touch,
                           [&](const Contact& contact) { points.add(contact); });
    add_corners_over_sides(b, a, b_from_a, a_from_b, Owner::a, margin, touch, [&](const Contact& contact) {
        points.add(
            {a_from_b * contact.point, -(a_from_b.rotation * contact.normal), contact.separation, contact.feature});
    });
    add_corners_over_corners(a, b, a_from_b, margin, touch, points);
    const double size = std::min(a.outline.longest_side(a.part), b.outline.longest_side(b.part));
    Manifold manifold = points.fetch(rest_tolerance::k_watch * size, margin);
    if (manifold.count > 0)
        take_middle_way(a, b, a_from_b, rest_tolerance::k_watch * size,
                        std::max(touch, rest_tolerance::k_landed * size), manifold);
    return seen_in_world(manifold, a.pose);
}

Manifold outline_points(const HalfPlane& wall, const OutlineSide& b, double margin)
{
    BestPoints points;
    const double offset = wall.offset - wall.normal.dot(b.pose.position);
    for (const Corner& corner : b.outline.corners_of(b.part)) {
        const Vec2 place = b.pose.rotation * corner.place;
        const double separation = wall.normal.dot(place) - offset - corner.radius;
        if (separation > margin) continue;
        points.add({b.pose.position + (place - (corner.radius + 0.5 * separation) * wall.normal), wall.normal,
                    separation, feature_number({Owner::b, corner.vertex, 0})});
    }
    return points.fetch(rest_tolerance::k_watch * b.outline.longest_side(b.part), margin);
}

} // namespace flying
