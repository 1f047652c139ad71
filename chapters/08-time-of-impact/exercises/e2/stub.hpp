#pragma once

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
    (void)f, (void)M, (void)until, (void)small;
    return std::numeric_limits<double>::infinity(); // your code here
}
