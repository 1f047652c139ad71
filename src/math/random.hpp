#pragma once

#include <cstdint>

#include "math/hash.hpp"

namespace flying {

/// A stream of random numbers that a seed fixes, on every machine: SplitMix64 (Steele, Lea, Flood 2014), period 2^64.
class Random
{
public:
    explicit Random(std::uint64_t seed) : state_(seed) {}

    /// 64 random bits.
    [[nodiscard]] std::uint64_t bits() { return Hash::mix(state_ += 0x9e3779b97f4a7c15ull); }

    /// Uniform in [0, 1), a multiple of 2^-53.
    [[nodiscard]] double uniform() { return static_cast<double>(bits() >> 11) * 0x1p-53; }

    /// Uniform in [low, high); `low` where the two are equal.
    [[nodiscard]] double uniform(double low, double high) { return low + (high - low) * uniform(); }

    /// Uniform in 0 ... count - 1; count >= 1. The bias is below count / 2^53.
    [[nodiscard]] int below(int count) { return static_cast<int>(uniform() * count); }

private:
    std::uint64_t state_;
};

} // namespace flying
