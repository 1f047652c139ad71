#include "stress.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "literature/disc_gas.hpp"
#include "literature/equation_of_state.hpp"

namespace flying::stress {
namespace {

/// The mean of several runs of one length.
class Sum
{
public:
    void add(const gas::Mean& run)
    {
        sum_ += run.value;
        squares_ += run.error * run.error;
        ++runs_;
    }
    [[nodiscard]] gas::Mean mean() const { return {sum_ / runs_, std::sqrt(squares_) / runs_}; }

private:
    double sum_ = 0.0;
    double squares_ = 0.0;
    double runs_ = 0.0;
};

} // namespace

void run_gas(const Job& job, Tally& tally)
{
    // The bulk of 4096 discs, in blocks of a million collisions, which are long against the time sound takes to cross it
    constexpr double k_packing = 0.3;
    constexpr int k_side = 64;
    constexpr double k_margin = 6.0;
    constexpr double k_literature = 2.0632;
    constexpr double k_within = 2e-4;
    constexpr double k_rate_within = 1e-3;
    constexpr long k_block = 1'000'000;
    constexpr long k_gas = 50 * k_block; // then a new gas, from the next seed
    const long gases = std::max(job.count / k_gas, 1L);
    const int blocks = static_cast<int>(std::max(std::min(job.count, k_gas) / k_block, 8L));
    Sum count;
    Sum virial;
    Sum rate;
    double drift = 0.0;
    for (long k = 0; k < gases; ++k) {
        const std::uint64_t seed = job.seed + static_cast<std::uint64_t>(k);
        gas::Gas box = gas::make_gas({k_side, k_packing, 1.0, seed});
        gas::mix(box, 100.0);
        const gas::Figures found = gas::measure(box, k_packing, k_margin, blocks, k_block, [&](int done) {
            tally.progress(fmt::format("gas: seed {}, block {} of {}", seed, done, blocks));
        });
        count.add(found.z_count);
        virial.add(found.z_virial);
        rate.add(found.rate);
        drift = std::max(drift, std::abs(found.energy_change));
        tally.note(fmt::format("        gas, seed {}: {} collisions in the bulk, energy changed by {:.1e}, packing {:.6f}; so far Z from "
                               "their number {:.6f} +- {:.6f}, from their momentum {:.6f} +- {:.6f}",
                               seed, found.collisions, found.energy_change, found.packing, count.mean().value, count.mean().error,
                               virial.mean().value, virial.mean().error));
    }
    const auto judge = [&](const char* how, const gas::Mean& z) {
        // Allowed is the literature's figure within 2e-4; a run too short to tell says so
        const bool tells = z.error <= 0.5 * k_within;
        const double off = z.value - k_literature;
        const double allowed = tells ? k_within : k_within + 2.0 * z.error;
        tally.result(std::abs(off) <= allowed,
                     fmt::format("gas: Z(0.3) from the {} of collisions {:.6f} +- {:.6f}, {} off by {:+.1e}{}", how,
                                 z.value, z.error, k_literature, off,
                                 tells ? "" : " (run longer for an error below 1e-4)"));
    };
    tally.result(drift <= 4e-12, fmt::format("gas: energy changes by {:.1e} at most", drift));
    judge("number", count.mean());
    judge("momentum", virial.mean());
    tally.result(std::abs(rate.mean().value - 1.0) <= k_rate_within + 2.0 * rate.mean().error,
                 fmt::format("gas: collisions of a disc in unit time, over 4 (Z - 1) sqrt(kT / pi m) / d: {:.6f} +- {:.6f}",
                             rate.mean().value, rate.mean().error));
}

} // namespace flying::stress
