#pragma once

/// A better value from two worse ones. fall(n) is the result of n steps, with an error that goes with 1/n.
template <typename Fall>
double extrapolated(const Fall& fall, int n)
{
    return fall(n); // your code here
}
