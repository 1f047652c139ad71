#pragma once

#include <span>
#include <vector>

#include "rest/rest_data.hpp"

namespace flying {

/// Adds the points at which a pair touches, or might touch before the step ends, and foresees when one that is open
/// closes. What the pair bore at such a point before, the point begins with.
/// pair   its number in the list
/// found  where to add them
void find_contacts(RestData& data, int pair, std::vector<ContactPoint>& found);

/// How fast two bodies open the gap at a contact.  [m/s]
[[nodiscard]] double opening_speed(const Contact& contact, const BodyState& a, const BodyState& b);

/// Time until a gap > 0 closes that changes at speed u [m/s] and acceleration a [m/s^2]; more than `within` where it
/// doesn't by then.  [s]
[[nodiscard]] double time_to_close(double gap, double u, double a, double within);

/// The two parts of a pair may touch before the step ends, where the bodies get no further than so.
/// farthest  of each body [m]
[[nodiscard]] bool may_touch(const RestData& data, const RestPair& pair, std::span<const double> farthest);

} // namespace flying
