#include "stress.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "literature/statistics.hpp"

namespace flying::stress {

void run_speeds(const Job& job, Tally& tally)
{
    // From one speed for all, in a hundred bins of equal weight: one run in a thousand has a chi^2 above 148.2
    gas::BoxOptions options{32, 0.3, 1.0, job.seed};
    options.equal_speeds = true;
    gas::Gas box = gas::make_gas(options);
    gas::Bins bins(100);
    gas::mix(box, 20.0);
    const long samples = std::max(job.count / box.count, 1L);
    for (long k = 0; k < samples; ++k) {
        gas::mix(box, 4.0);
        for (int disc = 0; disc < box.count; ++disc)
            bins.add(-std::expm1(-0.5 * box.engine.flyer(disc).state.velocity.squaredNorm()));
        tally.progress(fmt::format("speeds: {} of {} samples", k + 1, samples));
    }
    tally.result(bins.chi_square() < 148.2, fmt::format("speeds: {} speeds of discs against Maxwell's distribution: chi^2 {:.1f} in a "
                                                        "hundred bins (below 148.2 but once in a thousand runs)",
                                                        samples * box.count, bins.chi_square()));
}

void run_spins(const Job& job, Tally& tally)
{
    gas::BoxOptions options{16, 0.3, 1.0, job.seed};
    options.squares = true;
    const gas::Equipartition found = gas::share_of_spin(options, static_cast<int>(std::max(job.count / 256, 20L)));
    const double off = found.share.value - 1.0 / 3.0;
    tally.result(std::abs(off) <= 4.0 * found.share.error && found.chi_square < 43.8,
                 fmt::format("spins: a gas of squares has {:.5f} +- {:.5f} of its energy in spin, a third expected; chi^2 of the spins "
                             "{:.1f} in twenty bins (below 43.8 but once in a thousand runs)",
                             found.share.value, found.share.error, found.chi_square));
}

void run_cooling(const Job& job, Tally& tally)
{
    const int side = std::max(static_cast<int>(std::sqrt(static_cast<double>(job.count))), 32);
    const gas::Cooling found = gas::cool({side, 0.1, 0.99, job.seed}, 2.0);
    const double allowed = 0.005 + 1.0 / side; // discs at walls collide less often, and in large boxes currents arise
    tally.result(found.worst <= allowed, fmt::format("cooling: {} discs at e = 0.99 keep to T0 / (1 + t / tau)^2 within {:.2f} %, for two "
                                                     "tau; {:.2f} % allowed",
                                                     side * side, 100.0 * found.worst, 100.0 * allowed));
}

} // namespace flying::stress
