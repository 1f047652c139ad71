#include <algorithm>
#include <array>
#include <cmath>

#include "live/pieces.hpp"
#include "plain_engine.hpp"

// What this chapter's page computes.

namespace flying::live {

namespace {

/// seed, seconds -> for each moment, 60 a second: x, y, angle of each of nine hexagons with the spoilt bound, then with
/// the right one.
Answer hexagons_by_bound(std::span<const double> of)
{
    const auto seed = static_cast<std::uint64_t>(std::clamp(of[0], 0.0, 1e9));
    const int frames = static_cast<int>(std::clamp(60.0 * of[1], 1.0, 1200.0));
    Answer answer;
    PlainEngine now[] = {PlainEngine(hexagons(seed), Bound::spoilt), PlainEngine(hexagons(seed), Bound::right)};
    PlainEngine next[] = {now[0], now[1]};
    for (PlainEngine& engine : next) engine.step();
    for (int frame = 0; frame <= frames; ++frame) {
        const double time = frame / 60.0;
        for (int which = 0; which < 2; ++which) {
            while (next[which].time() <= time) {
                now[which] = next[which];
                next[which].step();
            }
            for (int body = 0; body < 9; ++body) {
                const BodyState state = now[which].state(body, time);
                answer.engine.insert(answer.engine.end(), {state.position.x(), state.position.y(), state.angle});
            }
        }
    }
    return answer;
}

constexpr std::array k_pieces{Piece{"hexagons", 2, hexagons_by_bound}};

} // namespace

std::span<const Piece> pieces_of_skips() { return k_pieces; }

} // namespace flying::live
