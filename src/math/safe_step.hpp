#pragma once

#include <cmath>

#include "math/roots.hpp"

namespace flying {

/// A step that can't pass a root: for every function with f(0) = f, f'(0) = f_rate and
/// |f''| <= bend on the way, f stays positive on (0, step).  [unit of time]
///
/// f       value now, >= 0
/// f_rate  rate now, any sign
/// bend    bound on |f''|, >= 0
///
/// The parabola f + f_rate t - bend t^2 / 2 lies below all such functions; the step is its
/// positive root, in the form that does not cancel. Infinite where the parabola has none.
[[nodiscard]] inline double safe_step(double f, double f_rate, double bend)
{
    const double root = std::sqrt(f_rate * f_rate + 2.0 * bend * f);
    if (f_rate <= 0.0) {
        const double denominator = root - f_rate;
        return denominator > 0.0 ? 2.0 * f / denominator : k_never;
    }
    return bend > 0.0 ? (f_rate + root) / bend : k_never;
}

} // namespace flying
