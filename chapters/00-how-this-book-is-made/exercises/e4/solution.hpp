#pragma once

/// A better value from two worse ones. fall(n) is the result of n steps, with an error that goes with 1/n.
template <typename Fall>
double extrapolated(const Fall& fall, int n)
{
    // Twice the steps have half the error: take the fine result, and once more what it gained over the coarse one
    const double coarse = fall(n);
    const double fine = fall(2 * n);
    return fine + (fine - coarse);
}
