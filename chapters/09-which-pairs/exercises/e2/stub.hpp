#pragma once

#include <vector>

/// From low to high, both included; low <= high.
struct Interval
{
    double low = 0.0;
    double high = 0.0;
};

/// How many pairs of intervals share a place.
inline long count_side_by_side(const std::vector<Interval>& spans)
{
    return static_cast<long>(spans.size()) * 0; // your code here
}
