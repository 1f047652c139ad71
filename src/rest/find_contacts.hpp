#pragma once

#include <vector>

#include "rest/rest_data.hpp"

namespace flying {

/// Adds the points at which a pair touches, or might touch before the step ends, and foresees when one that is open
/// closes. What the pair bore at such a point before, the point begins with.
/// pair   its number in the list
/// found  where to add them
/// True where the two parts are near enough to touch within the step.
bool find_contacts(RestData& data, int pair, std::vector<ContactPoint>& found);

} // namespace flying
