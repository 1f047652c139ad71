#include <algorithm>
#include <array>
#include <cmath>

#include "live/pieces.hpp"
#include "race.hpp"

// What this chapter's page computes. The page holds the watch.

namespace flying::live {

namespace {

/// The end of a race, by one of the methods; `steps` doesn't count from wall to wall.
BodyState race_once(const work::Race& race, int method, long n)
{
    const auto by = [&](const auto& step) {
        return work::by_steps(step, race.start(), race.walls(), race.gravity(), race.until / static_cast<double>(n), n);
    };
    switch (method) {
    case 0:
        return work::by_walls(race.start(), race.walls(), race.gravity(), race.until).ball;
    case 1:
        return by(steps::k_euler);
    case 2:
        return by(steps::k_symplectic);
    default:
        return by(steps::k_verlet);
    }
}

/// method (0 from wall to wall, 1 Euler, 2 symplectic Euler, 3 Verlet), steps, how often it is run, speed to the right
/// -> the error in metres, and the sum of the last places, so that no run can be left out.
Answer race(std::span<const double> of)
{
    const int method = static_cast<int>(std::clamp(of[0], 0.0, 3.0));
    const long n = static_cast<long>(std::clamp(of[1], 1.0, 1e6));
    const long times = static_cast<long>(std::clamp(of[2], 1.0, method == 0 ? 1e6 : 2e7 / static_cast<double>(n)));
    work::Race race;
    race.speed = std::clamp(of[3], -10.0, 10.0);
    Vec2 sum(0.0, 0.0);
    double error = 0.0;
    for (long k = 0; k < times; ++k) {
        const BodyState end = race_once(race, method, n);
        error = race.error(end);
        sum += end.position;
    }
    return {{error, sum.x(), sum.y()}, {}};
}

constexpr std::array k_pieces{Piece{"race", 4, race}};

} // namespace

std::span<const Piece> pieces_of_work()
{
    return k_pieces;
}

} // namespace flying::live
