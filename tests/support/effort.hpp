#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <initializer_list>
#include <vector>

namespace flying::testing {

/// How many of random cases a test tries, where every run is to try so many: with the sanitizers, which take ten to
/// twenty times as long for each, an eighth, one at least. `./course stress tests` sets FLYING_TIMES, and multiplies
/// them.
[[nodiscard]] inline int tried(int many)
{
    const char* const times = std::getenv("FLYING_TIMES");
#ifdef FLYING_SANITIZED
    many = std::max(many / 8, 1);
#endif
    return times == nullptr ? many : many * std::max(std::atoi(times), 1);
}

/// For what is one long run, and not many.
[[nodiscard]] constexpr bool is_sanitized()
{
#ifdef FLYING_SANITIZED
    return true;
#else
    return false;
#endif
}

/// Of cases that a test lists, all; with the sanitizers every eighth, the first among them.
template <typename Case>
[[nodiscard]] std::vector<Case> tried(std::initializer_list<Case> cases)
{
    std::vector<Case> result;
    const std::size_t stride = is_sanitized() ? 8 : 1;
    for (std::size_t k = 0; k < cases.size(); k += stride) result.push_back(cases.begin()[k]);
    return result;
}

} // namespace flying::testing
