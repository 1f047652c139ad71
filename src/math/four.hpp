#pragma once

namespace flying {

/// Four numbers side by side, for what is done to four things alike. Each operation does to every number what it does
/// to one, so that the bits are the same, whether the processor takes four at once or not. (A vector of the compilers'
/// own: g++, clang.)
using Four [[gnu::vector_size(32)]] = double;

/// Rows into columns: first number of each row, second, third, fourth.
inline void transpose(const Four (&row)[4], Four& first, Four& second, Four& third, Four& fourth)
{
    const Four odd_low = __builtin_shufflevector(row[0], row[1], 0, 4, 2, 6);
    const Four even_low = __builtin_shufflevector(row[0], row[1], 1, 5, 3, 7);
    const Four odd_high = __builtin_shufflevector(row[2], row[3], 0, 4, 2, 6);
    const Four even_high = __builtin_shufflevector(row[2], row[3], 1, 5, 3, 7);
    first = __builtin_shufflevector(odd_low, odd_high, 0, 1, 4, 5);
    second = __builtin_shufflevector(even_low, even_high, 0, 1, 4, 5);
    third = __builtin_shufflevector(odd_low, odd_high, 2, 3, 6, 7);
    fourth = __builtin_shufflevector(even_low, even_high, 2, 3, 6, 7);
}

} // namespace flying
