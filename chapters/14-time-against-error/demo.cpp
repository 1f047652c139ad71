// A ball in a box by steps and from wall to wall: error against work, counted in steps and flights instead of seconds,
// so that every machine prints the same.

#include <cstdio>

#include "race.hpp"

using namespace flying;
using namespace flying::work;

namespace {

struct Row
{
    std::vector<double> work;
    std::vector<double> errors;
};

// [time-against-error.demo.sweep]
/// The same with ever smaller steps. `error` is a function of the number of steps.
template <typename Error>
Row sweep(const char* name, const Error& error)
{
    Row row;
    std::printf("%-28s", name);
    for (long n = 480; n <= 122880; n *= 4) {
        row.work.push_back(static_cast<double>(n));
        row.errors.push_back(error(n));
        std::printf("  %.1e", row.errors.back());
    }
    std::printf("\n");
    return row;
}
// [time-against-error.demo.sweep]

} // namespace

int main()
{
    const Race race;
    std::printf("A ball in a box, 8 s: error in metres after so many steps\n%-28s", "");
    for (long n = 480; n <= 122880; n *= 4) std::printf("  %7ld", n);
    std::printf("\n");
    const Row euler = sweep("Euler", [&](long n) { return error_by_steps(race, steps::k_euler, n); });
    sweep("symplectic Euler", [&](long n) { return error_by_steps(race, steps::k_symplectic, n); });
    const Row verlet = sweep("Verlet", [&](long n) { return error_by_steps(race, steps::k_verlet, n); });
    const Flown flown = by_walls(race.start(), race.walls(), race.gravity(), race.until);
    std::printf("from wall to wall, %ld flights  %.1e\n\n", flown.flights, race.error(flown.ball));

    std::printf("One turn of an ellipse, no walls\n");
    const Row euler_orbit = sweep("Euler", [](long n) { return error_of_orbit(steps::k_euler, n); });
    const Row verlet_orbit = sweep("Verlet", [](long n) { return error_of_orbit(steps::k_verlet, n); });

    std::printf("\nSlopes of error against work\n");
    std::printf("Verlet, ellipse = %.2f\n", *slope(verlet_orbit.work, verlet_orbit.errors));
    std::printf("Euler, ellipse = %.2f\n", *slope(euler_orbit.work, euler_orbit.errors));
    std::printf("Verlet, box = %.2f\n", *slope(verlet.work, verlet.errors));
    std::printf("Euler, box = %.2f\n", *slope(euler.work, euler.errors));
    std::printf("\nflights from wall to wall = %ld\n", flown.flights);
    std::printf("Verlet error at most steps = %.1e m\n", verlet.errors.back());
    std::printf("error from wall to wall = %.1e m\n", race.error(flown.ball));
    return 0;
}
