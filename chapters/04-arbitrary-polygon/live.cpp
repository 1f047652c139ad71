#include <array>
#include <vector>

#include "geometry/make_polygon.hpp"
#include "live/pieces.hpp"
#include "mass/polygon.hpp"

// What this chapter's page computes.

namespace flying::live {

namespace {

/// x, y of a point, then x, y of each vertex -> 1 where the ring is a polygon (0 where it is none, and nothing else),
/// area, centroid x, y, moment of inertia at 1 kg/m^2, then the signed area of the triangle from the point to each edge.
Answer outline(std::span<const double> of)
{
    const Vec2 from(of[0], of[1]);
    std::vector<Vec2> ring;
    for (std::size_t k = 2; k + 1 < of.size(); k += 2) ring.emplace_back(of[k], of[k + 1]);
    const Expected<CentredPolygon> made = make_polygon(ring);
    if (!made) return {{0.0}, {}};
    const MassProperties mass = polygon_mass(made.value().polygon, 1.0);
    const Vec2 centroid = made.value().centroid;
    Answer answer{{1.0, mass.mass, centroid.x(), centroid.y(), mass.moment_of_inertia}, {}};
    for (std::size_t k = 0; k < ring.size(); ++k)
        answer.engine.push_back(0.5 * cross(ring[k] - from, ring[(k + 1) % ring.size()] - from));
    return answer;
}

constexpr std::array k_pieces{Piece{"outline", 8, outline}};

} // namespace

std::span<const Piece> pieces_of_outlines() { return k_pieces; }

} // namespace flying::live
