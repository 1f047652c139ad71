#pragma once

#include <cstdint>

#include "scene/generate.hpp"

namespace flying::testing {

/// Boxes to be poured into a bin: without rebound, with friction 0.5. Half a diagonal of the smallest is 0.3 m.
///
/// count  >= 1
inline Scene poured_boxes(int count, std::uint64_t seed)
{
    GenerateOptions options;
    options.count = count;
    options.seed = seed;
    options.shape = "box";
    options.restitution = 0.0;
    options.friction = 0.5;
    return generate("pile", options).value();
}

} // namespace flying::testing
