#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace flying {

/// A running 64-bit fingerprint of numbers, the same on every machine: equal streams of bits give equal fingerprints,
/// and two different streams agree by accident once in about 2^64. The mixing step is the finaliser of SplitMix64
/// (Steele, Lea, Flood, "Fast splittable pseudorandom number generators", 2014).
class Hash
{
public:
    Hash() = default;
    /// Go on from the fingerprint of an earlier stream.
    explicit Hash(std::uint64_t value) : state_(value) {}

    void add(std::uint64_t word) { state_ = mix(state_ ^ mix(word + k_odd)); }

    /// Every bit of the number counts, but -0 counts as +0, for the two are equal in every sum.
    void add(double number) { add(std::bit_cast<std::uint64_t>(number + 0.0)); }

    /// Several numbers at once: each is scrambled by itself, with its place, before they come together.
    template <std::size_t N>
    void add(const std::array<double, N>& numbers)
    {
        std::uint64_t sum = 0;
        const auto add_up = [&]<std::size_t... k>(std::index_sequence<k...>) {
            ((sum += mix(std::bit_cast<std::uint64_t>(numbers[k] + 0.0) + (2 * k + 1) * k_odd)), ...);
        };
        add_up(std::make_index_sequence<N>{});
        add(sum);
    }

    [[nodiscard]] std::uint64_t value() const { return state_; }

    /// A one-to-one scrambling of 64 bits.
    [[nodiscard]] static std::uint64_t mix(std::uint64_t z)
    {
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ull;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebull;
        return z ^ (z >> 31);
    }

private:
    static constexpr std::uint64_t k_odd = 0x9e3779b97f4a7c15ull; // 2^64 over the golden ratio
    std::uint64_t state_ = 0;
};

} // namespace flying
