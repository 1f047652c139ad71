#pragma once

#include <cmath>

#include "math/sine_cosine.hpp"

namespace wrong {

/// E by putting it into its own equation again and again, until a round changes it by no more than `small`.
struct ByTurns
{
    double E;   ///< [rad]
    int rounds; ///< that it took
};
[[nodiscard]] inline ByTurns anomaly_by_turns(double M, double ecc, double small)
{
    double E = M;
    for (int rounds = 1;; ++rounds) {
        const double next = M + ecc * flying::sine_cosine(E).sine;
        const double change = std::abs(next - E);
        E = next;
        if (change <= small) return {E, rounds};
    }
}

} // namespace wrong
