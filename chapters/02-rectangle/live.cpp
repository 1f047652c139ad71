#include <array>

#include "door.hpp"
#include "live/pieces.hpp"
#include "rectangle.hpp"

// What this chapter's page computes.

namespace flying::live {

namespace {

/// width, mass, force, distance of the push from the hinge, time -> moment of inertia about the hinge, mass felt, angle.
Answer door(std::span<const double> of)
{
    constexpr double k_thickness = 0.06;
    const MassProperties leaf = rectangle_mass(of[0], k_thickness, of[1] / (of[0] * k_thickness));
    const double hinged = about_parallel_axis(leaf, 0.5 * of[0]);
    return {{hinged, mass_felt(hinged, of[3]), angle_turned(hinged, of[2] * of[3], of[4])}, {}};
}

constexpr std::array k_pieces{Piece{"door", 5, door}};

} // namespace

std::span<const Piece> pieces_of_doors() { return k_pieces; }

} // namespace flying::live
