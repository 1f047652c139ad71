#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include <doctest/doctest.h>

/// Lists of numbers, and of pairs of numbers, as a reader wants to see them where a check fails: [(0, 1), (3, 4)].
namespace doctest {

template <typename A, typename B>
struct StringMaker<std::pair<A, B>>
{
    static String convert(const std::pair<A, B>& pair)
    {
        return String("(") + toString(pair.first) + ", " + toString(pair.second) + ")";
    }
};

template <typename T>
struct StringMaker<std::vector<T>>
{
    static String convert(const std::vector<T>& list)
    {
        constexpr std::size_t k_most = 12;
        String text = "[";
        for (std::size_t k = 0; k < list.size() && k < k_most; ++k)
            text += (k > 0 ? String(", ") : String()) + toString(list[k]);
        return text + (list.size() > k_most ? ", ...]" : "]");
    }
};

} // namespace doctest
