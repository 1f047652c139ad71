#pragma once

#include <cmath>
#include <limits>

/// What `f(t)` returns.
struct Reading
{
    double value;
    double rate;
};

/// When `f` is first down to `small`; infinite where that is not before `until`.
template <typename Function>
double first_zero(const Function& f, double M, double until, double small)
{
    double t = 0.0;
    while (t < until) {
        const Reading now = f(t);
        if (now.value <= small) return t;

        // The root of the parabola below; of its two forms the one that adds
        const double root = std::sqrt(now.rate * now.rate + 2.0 * M * now.value);
        const double step = now.rate > 0.0 ? (now.rate + root) / M : 2.0 * now.value / (root - now.rate);
        t += step;
    }
    return std::numeric_limits<double>::infinity();
}
