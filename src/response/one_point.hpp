#pragma once

#include "response/newton.hpp"
#include "response/push_line.hpp"

namespace flying {

/// How a point gives way: changes of normal and tangential speed per unit of impulse.
///
///     d v_n = w_n d j + w_nt d q          j normal, q tangential impulse          [N s]
///     d v_t = w_nt d j + w_t d q
struct PointResponse
{
    double w_n = 0.0;         ///< > 0 [1/kg]
    double w_t = 0.0;         ///< > 0 [1/kg]
    double w_nt = 0.0;        ///< couples friction into the normal [1/kg]
    double determinant = 0.0; ///< w_n w_t - w_nt^2 > 0, without the cancellation [1/kg^2]
};

/// Impulses at one point.
struct PointImpulse
{
    double normal = 0.0;  ///< >= 0 [N s]
    double tangent = 0.0; ///< at most mu times the normal one in size [N s]
};

/// The response of two bodies at a point.
[[nodiscard]] PointResponse response_at(const PointFrame& frame, const PairInertia& inertia);

/// Impulses of a planar impact with Coulomb's friction at one point, in closed form.
///
/// v_n, v_t  normal and tangential speed of B relative to A before         [m/s]
///
/// The course of the impact is followed over the growing normal impulse (Keller 1986; Stronge, Impact Mechanics, 2000):
/// slip; where slip ends, stick or slip back; restitution ends when it has given back e^2 of the work of compression.
/// Nothing happens where the point is not approaching. The work of both impulses together is never positive.
[[nodiscard]] PointImpulse one_point_impulse(const PointResponse& response, double v_n, double v_t,
                                             const Material& material);

} // namespace flying
