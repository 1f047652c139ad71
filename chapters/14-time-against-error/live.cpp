#include <algorithm>
#include <array>
#include <cmath>

#include "live/pieces.hpp"
#include "motion/kepler.hpp"
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
Answer box_race(std::span<const double> of)
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

/// The same round a centre, from its farthest point once round: method (0 in one flight), steps, how often, speed
/// there.
Answer orbit_race(std::span<const double> of)
{
    constexpr double k_mu = 40.0; // [m^3/s^2], and the farthest point is 1 m away
    const int method = static_cast<int>(std::clamp(of[0], 0.0, 3.0));
    const long n = static_cast<long>(std::clamp(of[1], 1.0, 1e6));
    const long times = static_cast<long>(std::clamp(of[2], 1.0, method == 0 ? 1e6 : 2e7 / static_cast<double>(n)));
    const double speed = std::clamp(of[3], 0.1, 6.0);
    const double a = 1.0 / (2.0 - speed * speed / k_mu);
    const double period = steps::Orbit{k_mu, a, 0.0}.period();
    const steps::Moving start{Vec2(1.0, 0.0), Vec2(0.0, speed)};
    const auto pull = [](const Vec2& x) {
        const double r = x.norm();
        return Vec2((-k_mu / (r * r * r)) * x);
    };
    const auto once = [&]() -> Vec2 {
        const double h = period / static_cast<double>(n);
        switch (method) {
        case 0:
            return KeplerFlight({start.x, start.v}, k_mu).after(period).position;
        case 1:
            return steps::run(steps::k_euler, start, pull, h, n).x;
        case 2:
            return steps::run(steps::k_symplectic, start, pull, h, n).x;
        default:
            return steps::run(steps::k_verlet, start, pull, h, n).x;
        }
    };
    Vec2 sum(0.0, 0.0);
    double error = 0.0;
    for (long k = 0; k < times; ++k) {
        const Vec2 end = once();
        error = (end - start.x).norm();
        sum += end;
    }
    return {{error, sum.x(), sum.y()}, {}};
}

constexpr std::array k_pieces{Piece{"box_race", 4, box_race}, Piece{"orbit_race", 4, orbit_race}};

} // namespace

std::span<const Piece> pieces_of_work()
{
    return k_pieces;
}

} // namespace flying::live
