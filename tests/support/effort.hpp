#pragma once

namespace flying::testing {

/// How many of so many random cases a build tries: all; with the sanitizers, which take ten to twenty times as long for
/// each, an eighth, one at least.
[[nodiscard]] constexpr int tried(int many)
{
#ifdef __SANITIZE_ADDRESS__
    return many < 8 ? 1 : many / 8;
#else
    return many;
#endif
}

} // namespace flying::testing
