#pragma once

#include <cstdint>
#include <span>

#include "world/world.hpp"

namespace flying::fuzz {

/// A run to try: any bytes make one, and near bytes make near ones, so that a fuzzer can find its way. Not every scene
/// is valid: bodies may overlap, rings may cross themselves.
struct Trial
{
    Scene scene; ///< one to eight bodies within metres of the origin, metres a second fast
    WorldOptions options;
};

[[nodiscard]] Trial trial_from_bytes(std::span<const std::uint8_t> bytes);

} // namespace flying::fuzz
