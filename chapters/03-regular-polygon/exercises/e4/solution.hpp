#pragma once

/// The least n >= 3 with gap(n) <= share. gap  falls with n, towards 0; share  positive
template <typename Gap>
long first_within(const Gap& gap, double share)
{
    // Double until it is enough
    if (gap(3) <= share) return 3;
    long low = 3; // not enough
    long high = 6;
    while (gap(high) > share) {
        low = high;
        high *= 2;
    }

    // Halve what lies between
    while (high - low > 1) {
        const long middle = low + (high - low) / 2;
        (gap(middle) > share ? low : high) = middle;
    }
    return high;
}
