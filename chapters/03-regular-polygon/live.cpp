#include <algorithm>
#include <array>
#include <cmath>

#include "../02-rectangle/door.hpp"
#include "beside_disc.hpp"
#include "live/pieces.hpp"

// What this chapter's page computes.

namespace flying::live {

namespace {

/// sides, torque, time -> for a polygon with the mass and area of a disc of 1 m and 1 kg/m^2: its inertia as a share of
/// the disc's, its angle, the disc's angle, the radius to its vertices.
Answer race(std::span<const double> of)
{
    const int sides = static_cast<int>(std::clamp(of[0], 3.0, 1000.0));
    const MassProperties disc = disc_mass(1.0, 1.0);
    const double share = beside_disc_of_same_area(sides);
    const double radius = std::sqrt(disc.mass / regular_polygon_mass(sides, 1.0, 1.0).mass);
    return {{share, angle_turned(share * disc.moment_of_inertia, of[1], of[2]),
             angle_turned(disc.moment_of_inertia, of[1], of[2]), radius},
            {}};
}

constexpr std::array k_pieces{Piece{"race", 3, race}};

} // namespace

std::span<const Piece> pieces_of_races() { return k_pieces; }

} // namespace flying::live
