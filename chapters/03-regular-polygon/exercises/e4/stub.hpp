#pragma once

/// The least n >= 3 with gap(n) <= share. gap  falls with n, towards 0; share  positive
template <typename Gap>
long first_within(const Gap& gap, double share)
{
    long n = 3;
    while (gap(n) > share && n < 1000) ++n;
    return n; // your code here
}
