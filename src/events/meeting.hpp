#pragma once

#include <vector>

#include "collide/touching.hpp"
#include "events/body_rows.hpp"
#include "events/static_surfaces.hpp"
#include "response/impact.hpp"

namespace flying {

/// Where two bodies touch at the moment of their impact. Made anew for each impact in the memory of the last.
struct MeetingPoints
{
    std::vector<Touch> touches;      ///< those that were looked at last
    std::vector<ImpactPoint> points; ///< all at which the impact acts
    double touch = 0.0;              ///< the tolerance of touching [m]
    double overlap = 0.0;            ///< the deepest of the points, 0 where none overlaps [m]
};

/// The gap, of either sign, at which two bodies touch, when they are about where they are now.  [m]
/// a, b  rows
/// time  [s]
[[nodiscard]] double touch_tolerance(const BodyRows& bodies, int a, int b, double time);

/// All points at which a pair touches; where rounding hides even the one that was foreseen, the search is widened until
/// it shows. Where nothing rebounds, those that are open by less than a millionth of the smaller one's radius are among
/// them; and where a static body's surface goes on over others, those at which they are touched.
///
/// a, b  rows, of the lower and the higher id, both at their places at `time` [s]
void find_meeting(const BodyRows& bodies, const StaticSurfaces& surfaces, int a, int b, double time,
                  MeetingPoints& meeting);

} // namespace flying
