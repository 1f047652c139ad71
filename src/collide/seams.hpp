#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "collide/contact.hpp"
#include "collide/separating_axis.hpp"
#include "geometry/shape.hpp"
#include "math/rotation.hpp"

namespace flying {

/// A corner of a polygon at which its surface goes on over a neighbour: the next tile of a floor, the next facet of a
/// bowl, the part beyond a cut. All in the polygon's frame.
struct Seam
{
    int corner = 0;               ///< vertex of the polygon
    int hidden = 0;               ///< its edge there that faces the neighbour, and that nothing can reach
    int open = 0;                 ///< its other edge there
    Vec2 onwards = Vec2::Zero();  ///< unit vector along the neighbour's surface, away from the corner
    Vec2 outwards = Vec2::Zero(); ///< unit normal of the neighbour's surface
    double crack = 0.0;           ///< nothing tells two points apart that are no further from each other [m]
    enum class Bend
    {
        ridge,  ///< the surface turns down: the corner is one still, with fewer normals
        none,   ///< it goes straight on: there is no corner
        hollow, ///< it turns up: nothing but a corner of another body gets there
        buried  ///< neighbours hide both edges: what gets there touches them, and not this polygon
    };
    Bend bend = Bend::none;
    bool is_loose = false; ///< the two may part: what touches the very corner touches both
};

/// Part of an edge that can be struck: beyond its ends there may be a crack that is none, and a neighbour may hide an
/// end.
struct OpenPart
{
    double from = 0.0;   ///< [m]
    double length = 0.0; ///< [m]
};
[[nodiscard]] inline OpenPart open_part(const Edge& edge, std::span<const Seam> seams)
{
    OpenPart part{0.0, edge.length};
    for (const Seam& seam : seams) {
        const bool is_hidden = seam.hidden == edge.from;
        if (!is_hidden && (seam.open != edge.from || seam.bend == Seam::Bend::ridge)) continue;
        const double longer = is_hidden ? -seam.crack : seam.crack;
        if (seam.corner == edge.from) part.from -= longer;
        part.length += longer;
    }
    return part;
}

/// A corner that is none of the surface which it belongs to.
[[nodiscard]] inline bool is_no_corner(int vertex, std::span<const Seam> seams)
{
    return std::any_of(seams.begin(), seams.end(),
                       [&](const Seam& seam) { return seam.corner == vertex && seam.bend != Seam::Bend::ridge; });
}

/// How well two surfaces must meet to act as one.
struct SeamTolerance
{
    double step = 0.0;  ///< greatest height of one surface over the other: the rounding of their coordinates [m]
    double crack = 0.0; ///< greatest gap between their ends [m]
};
/// size   of the smaller of the two bodies [m]
/// reach  how far from the world's origin they lie [m]
[[nodiscard]] SeamTolerance seam_tolerance(double size, double reach);

/// Adds the seams of a polygon with one neighbour: corners that lie on the line of an edge of the neighbour, to within
/// the tolerance, and over it, while the polygon's own edge there runs down behind that line. A corner at the foot of
/// an edge that rises from the neighbour's surface (a wall on a floor) is none.
///
/// part             polygon; reflex vertices have no seams
/// part_from_other  where the neighbour lies as the polygon sees it
/// other            polygon or half-plane; discs make no seams
/// real             of each edge of the neighbour, whether it is a side and no cut; empty where all are
void find_seams(const Polygon& part, const Pose& part_from_other, const Shape& other, std::span<const char> real,
                const SeamTolerance& tolerance, std::vector<Seam>& seams);

/// Whether a normal at a seam's corner is one of the joint surface's. One that leans over the neighbour is not, unless
/// it is that of the polygon's open edge: it belongs to the side that the neighbour hides.
///
/// normal  unit vector out of the polygon, in the polygon's frame
[[nodiscard]] bool is_of_surface(const Polygon& part, const Seam& seam, const Vec2& normal);

/// A normal at a corner is one of the surface's, whatever seams are there. normal  out of the polygon, in its frame
[[nodiscard]] inline bool is_open(const Polygon& polygon, int vertex, std::span<const Seam> seams, const Vec2& normal)
{
    return std::none_of(seams.begin(), seams.end(), [&](const Seam& seam) {
        return seam.corner == vertex && !is_of_surface(polygon, seam, normal);
    });
}

/// The normal of the joint surface that takes the place of one that isn't.
[[nodiscard]] const Vec2& surface_normal(const Polygon& part, const Seam& seam);

/// The rule in contacts: what a body touches at a seam, it touches as it would touch the joint surface. A contact along
/// a normal that is none of that surface's, or on a corner that is none of it, becomes one of the body's nearest point
/// along the surface's normal; but it goes where another contact bears what it would: the nearest point of the body is
/// over the neighbour, or, where the surface goes straight on and the pair has another point, anywhere else than at the
/// seam. Neighbours that are loose lend no normal to what lies on them along an edge of its own.
///
/// seams        of the polygon
/// owner        which of the manifold's two bodies the polygon is
/// other        the body that touches it, a convex polygon or a disc
/// near         contacts further than this from a seam's corner stay [m]
/// margin       contacts that are further apart go [m]
void mend_at_seams(const Polygon& part, const Pose& world_from_part, std::span<const Seam> seams, Owner owner,
                   const Shape& other, const Pose& world_from_other, double near, double margin, Manifold& manifold);

} // namespace flying
