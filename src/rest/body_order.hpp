#pragma once

#include <span>
#include <vector>

#include "rest/rest_body.hpp"

namespace flying {

/// The order in which to keep bodies in memory. As they come, where no more than `few` of them move; else along a curve
/// that goes through the plane neighbourhood by neighbourhood, so that bodies that meet lie near each other in memory
/// too, behind the half-planes, which are everywhere. Returns, for each place in memory, the number of the body there.
///
/// The curve: G. M. Morton, A computer oriented geodetic data base and a new technique in file sequencing, 1966.
[[nodiscard]] std::vector<int> order_in_memory(std::span<const RestBody> bodies, int few);

} // namespace flying
