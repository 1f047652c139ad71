#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace flying::live {

using Numbers = std::vector<double>;

/// What a piece of the engine answers. The first list is made of the engine's own arithmetic, whose bits are the same
/// everywhere; the second of closed forms, which may ask the C library for a sine.
struct Answer
{
    Numbers engine;
    Numbers paper;

    [[nodiscard]] std::uint64_t hash() const; ///< of the first list
};

/// A function of a chapter that its page calls with the numbers of its controls. What the numbers mean is said where the
/// function stands, in the chapter's live.cpp.
struct Piece
{
    std::string_view name;
    std::size_t least = 0; ///< how many numbers it needs
    Answer (*function)(std::span<const double>) = nullptr;
};

/// The answer of a piece; nothing where no piece has that name, where numbers are missing, or where one is not finite.
[[nodiscard]] std::optional<Answer> answer_of(std::string_view name, std::span<const double> numbers);

} // namespace flying::live
