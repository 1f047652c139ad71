#include "live/pieces.hpp"

#include <algorithm>
#include <cmath>

#include "math/hash.hpp"

namespace flying::live {

// Each is defined in the live.cpp of its chapter
std::span<const Piece> pieces_of_falling();
std::span<const Piece> pieces_of_flight();
std::span<const Piece> pieces_of_two_balls();
std::span<const Piece> pieces_of_doors();
std::span<const Piece> pieces_of_races();
std::span<const Piece> pieces_of_outlines();
std::span<const Piece> pieces_of_axes();
std::span<const Piece> pieces_of_corners();
std::span<const Piece> pieces_of_strikes();
std::span<const Piece> pieces_of_bars();
std::span<const Piece> pieces_of_pairs();
std::span<const Piece> pieces_of_events();
std::span<const Piece> pieces_of_rest();
std::span<const Piece> pieces_of_skips();
std::span<const Piece> pieces_of_work();

std::uint64_t Answer::hash() const
{
    Hash hash;
    for (const double number : engine) hash.add(number);
    return hash.value();
}

std::optional<Answer> answer_of(std::string_view name, std::span<const double> numbers)
{
    if (!std::all_of(numbers.begin(), numbers.end(), [](double x) { return std::isfinite(x); })) return std::nullopt;
    for (const auto pieces :
         {pieces_of_falling, pieces_of_flight, pieces_of_two_balls, pieces_of_doors, pieces_of_races, pieces_of_outlines,
          pieces_of_axes, pieces_of_corners, pieces_of_strikes, pieces_of_bars, pieces_of_pairs, pieces_of_events,
          pieces_of_rest, pieces_of_skips, pieces_of_work}) {
        for (const Piece& piece : pieces())
            if (piece.name == name && numbers.size() >= piece.least) return piece.function(numbers);
    }
    return std::nullopt;
}

} // namespace flying::live
