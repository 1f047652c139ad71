#pragma once

#include <chrono>

namespace flying {

/// A clock that only goes forward, from some start.  [s]
[[nodiscard]] inline double seconds_now()
{
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

} // namespace flying
