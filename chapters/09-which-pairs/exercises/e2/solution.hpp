#pragma once

#include <algorithm>
#include <cstddef>
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
    std::vector<double> starts;
    std::vector<double> ends;
    for (const Interval& span : spans) {
        starts.push_back(span.low);
        ends.push_back(span.high);
    }
    std::sort(starts.begin(), starts.end());
    std::sort(ends.begin(), ends.end());

    // Take away the pairs of which one ends before the other starts
    const long n = static_cast<long>(spans.size());
    long pairs = n * (n - 1) / 2;
    std::size_t ended = 0;
    for (const double start : starts) {
        while (ended < ends.size() && ends[ended] < start) ++ended;
        pairs -= static_cast<long>(ended);
    }
    return pairs;
}
