#include "stress.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "math/random.hpp"
#include "motion/kepler.hpp"
#include "scene/generate.hpp"
#include "stress/reversal.hpp"
#include "world/world.hpp"

namespace flying::stress {

void run_billiard(const Job& job, Tally& tally)
{
    const int most = static_cast<int>(std::min(job.count, 8L));
    for (int exponent = 0; exponent <= most; ++exponent) {
        GenerateOptions options;
        options.billiard = "pi";
        options.exponent = exponent;
        const Expected<Scene> scene = generate("billiard", options);
        WorldOptions world_options;
        world_options.engine = EngineChoice::events;
        Expected<World> made = scene ? World::make(scene.value(), world_options) : Expected<World>(scene.faults());
        if (!made) {
            tally.result(false, fmt::format("billiard: the scene of 100^{} is refused", exponent));
            continue;
        }
        World& world = made.value();
        const double kinetic = world.report().energy.total();
        const long expected = static_cast<long>(std::floor(std::numbers::pi * std::pow(10.0, exponent)));

        // Until all fly apart for good: no event is left
        bool failed = false;
        for (long before = -1; !failed && before != world.events();) {
            before = world.events();
            failed = world.advance(scene.value().until, 1'000'000).has_value();
            tally.progress(fmt::format("billiard: 100^{}, {} collisions", exponent, world.collisions()));
        }
        const double change = world.report().energy.total() / kinetic - 1.0;
        tally.result(!failed && world.collisions() == expected,
                     fmt::format("billiard: masses 1 : 100^{} collide {} times, {} expected; energy changes by {:.1e}", exponent,
                                 world.collisions(), expected, change));
    }
}

void run_reversal(const Job& job, Tally& tally)
{
    // Roundings grow with every collision, most for the disc that has the most of them: of many gases a few end farther off
    constexpr double k_collisions = 10.0;
    constexpr double k_within = 1e-6;
    constexpr double k_farthest = 1e-4;
    double worst = 0.0;
    long within = 0;
    bool failed = false;
    for (long k = 0; k < job.count; ++k) {
        const Reversal found = reverse_gas(32, k_collisions, job.seed + static_cast<std::uint64_t>(k));
        worst = std::max(worst, found.farthest);
        within += found.farthest <= k_within ? 1 : 0;
        failed = failed || found.failed;
        tally.progress(fmt::format("reversal: {} of {} gases", k + 1, job.count));
    }
    tally.result(!failed && within * 20 >= job.count * 19 && worst <= k_farthest,
                 fmt::format("reversal: {} of {} gases of 1024 discs, {} collisions each and back, end within {:.0e} diameters of the start, the "
                             "worst within {:.1e}",
                             within, job.count, k_collisions, k_within, worst));
}

void run_orbits(const Job& job, Tally& tally)
{
    // Ellipses of e = 0.6 in any direction, from any point of theirs: after whole turns they are back
    double worst = 0.0;
    Random random(job.seed);
    constexpr int k_ellipses = 100;
    for (int k = 0; k < k_ellipses; ++k) {
        const double a = random.uniform(0.5, 2.0);
        const double e = 0.6;
        const double mu = random.uniform(0.5, 20.0);
        const double anomaly = random.uniform(0.0, 2.0 * std::numbers::pi);
        const double heading = random.uniform(0.0, 2.0 * std::numbers::pi);
        const double p = a * (1.0 - e * e);
        const double r = p / (1.0 + e * std::cos(anomaly));
        const Vec2 radial(std::cos(heading + anomaly), std::sin(heading + anomaly));
        const Vec2 across(-radial.y(), radial.x());
        const double h = std::sqrt(mu / p);
        const PointMotion start{r * radial, h * (e * std::sin(anomaly) * radial + (1.0 + e * std::cos(anomaly)) * across)};

        // The period that the rounded state has: the axis from its own energy, in more digits than a double
        const auto x = static_cast<long double>(start.position.x());
        const auto y = static_cast<long double>(start.position.y());
        const auto vx = static_cast<long double>(start.velocity.x());
        const auto vy = static_cast<long double>(start.velocity.y());
        const auto strength = static_cast<long double>(mu);
        const long double binding = 2.0L * strength / std::sqrt(x * x + y * y) - (vx * vx + vy * vy);
        const long double axis = strength / binding;
        const long double period = 2.0L * std::numbers::pi_v<long double> * std::sqrt(axis * axis * axis / strength);
        const KeplerFlight orbit(start, mu);
        for (long turn = 1; turn <= job.count; turn = turn < 16 ? turn + 1 : turn * 3 / 2) {
            const auto time = static_cast<double>(period * static_cast<long double>(turn));
            worst = std::max(worst, (orbit.after(time).position - start.position).norm() / a);
        }
    }
    tally.result(worst <= 1e-11, fmt::format("orbits: {} ellipses of e = 0.6 are back after up to {} turns within {:.1e} axes", k_ellipses, job.count,
                                             worst));
}

} // namespace flying::stress
