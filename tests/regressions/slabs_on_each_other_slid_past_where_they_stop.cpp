#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "support/worlds.hpp"

// Of four slabs on each other the lowest stopped for the rest of a step where its slip along the floor ended, though
// the others went on to drag it the other way: what ended within a step was only found for up to a dozen points.

using namespace flying;
using namespace flying::testing;

namespace {

struct Slab
{
    double mass;     ///< [kg]
    double friction; ///< with what lies under it
    double speed;    ///< [m/s]
};

constexpr double k_slab_gravity = 9.81;
constexpr double k_slab_height = 0.5; ///< [m]

/// Slabs that slide on each other, from the lowest up: velocities change evenly until some slip ends, and a slip that
/// has ended begins anew where friction can't hold it.
///
/// Returns how far each has got by then.  [m]
[[nodiscard]] std::vector<double> slab_ways(const std::vector<Slab>& slabs, double until)
{
    const int count = static_cast<int>(slabs.size());
    std::vector<double> most(count); // friction under each [N]
    double above = 0.0;
    for (int k = count - 1; k >= 0; --k) {
        above += slabs[k].mass;
        most[k] = slabs[k].friction * above * k_slab_gravity;
    }
    std::vector<double> way(count, 0.0);
    std::vector<double> speed(count);
    for (int k = 0; k < count; ++k) speed[k] = slabs[k].speed;
    std::vector<double> pushes(count + 1, 0.0); // on each, from below; none on the last from above [N]
    const auto slip = [&](const std::vector<double>& v, int k) { return v[k] - (k > 0 ? v[k - 1] : 0.0); };
    for (double time = 0.0; time < until;) {
        // Where nothing slips, find what holds by sweeps: none may push more than it can
        for (int round = 0; round < 4000; ++round) {
            for (int k = 0; k < count; ++k) {
                const double now = slip(speed, k);
                if (std::abs(now) > 1e-12) {
                    pushes[k] = now > 0.0 ? -most[k] : most[k];
                    continue;
                }
                // What holds this slab to the one under it, if all other pushes stay
                const double inverse = 1.0 / slabs[k].mass + (k > 0 ? 1.0 / slabs[k - 1].mass : 0.0);
                const double own = (pushes[k] - pushes[k + 1]) / slabs[k].mass;
                const double under = k > 0 ? (pushes[k - 1] - pushes[k]) / slabs[k - 1].mass : 0.0;
                pushes[k] = std::clamp(pushes[k] - (own - under) / inverse, -most[k], most[k]);
            }
        }
        std::vector<double> gain(count);
        for (int k = 0; k < count; ++k) gain[k] = (pushes[k] - pushes[k + 1]) / slabs[k].mass;
        double span = until - time;
        for (int k = 0; k < count; ++k) {
            const double now = slip(speed, k);
            const double change = slip(gain, k);
            if (std::abs(now) > 1e-12 && now * change < 0.0) span = std::min(span, -now / change);
        }
        for (int k = 0; k < count; ++k) {
            way[k] += span * (speed[k] + 0.5 * span * gain[k]);
            speed[k] += span * gain[k];
        }
        time += span;
    }
    return way;
}

} // namespace

TEST_CASE("slabs that slide on each other stop and turn back when friction says, however many")
{
    const std::vector<Slab> all{{3.0, 0.2, 0.8},  {1.0, 0.5, -2.5}, {2.0, 0.3, 3.0}, {0.5, 0.7, -1.0},
                                {4.0, 0.15, 2.0}, {1.5, 0.4, -3.5}, {0.8, 0.25, 1.2}};
    for (const int count : {3, 4, 5, 7}) {
        for (const double faster : {1.0, 0.6, -0.9}) {
            std::vector<Slab> slabs(all.begin(), all.begin() + count);
            Scene scene = on_a_floor(0.0, 1.0);
            for (int k = 0; k < count; ++k) {
                slabs[k].speed *= faster;
                scene.bodies.push_back(
                    rectangle(60.0, k_slab_height, {0.0, (k + 0.5) * k_slab_height}, {slabs[k].speed, 0.0}));
                scene.bodies.back().mass = slabs[k].mass;
            }
            // Friction of a pair is the geometric mean of both
            double under = 1.0;
            for (int k = 0; k < count; ++k) {
                under = slabs[k].friction * slabs[k].friction / under;
                scene.bodies[k + 1].friction = under;
            }
            World world = world_of(scene);
            run(world, 1.0);
            const std::vector<double> ways = slab_ways(slabs, 1.0);
            CAPTURE(count);
            CAPTURE(faster);
            for (int k = 0; k < count; ++k) CHECK(std::abs(world.state(k + 1).position.x() - ways[k]) < 1e-6);
        }
    }
}
