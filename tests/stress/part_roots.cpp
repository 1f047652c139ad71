#include "stress.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "stress/random_pairs.hpp"

namespace flying::stress {

void run_roots(const Job& job, Tally& tally)
{
    long impacts = 0;
    long grazing = 0;
    long wrong = 0;
    long undecided = 0;
    long samples = 0;
    double worst_gap = 0.0;
    for (long k = 0; k < job.count; ++k) {
        const std::uint64_t seed = job.seed + static_cast<std::uint64_t>(k);
        const RandomPair pair = random_pair(seed);
        const Verdict verdict = judge(pair, foresee(pair));
        impacts += verdict.impact ? 1 : 0;
        grazing += pair.is_grazing ? 1 : 0;
        samples += verdict.samples;
        if (pair.flying.flyer_a.state.position.norm() < 100.0) worst_gap = std::max(worst_gap, std::abs(verdict.gap));
        if (verdict.undecided) {
            // Where bodies fall through the centre itself, the dense search's steps shrink without end
            ++undecided;
            tally.note(fmt::format("        pair {}: {}", seed, verdict.why));
        } else if (!verdict.right) {
            ++wrong;
            if (wrong <= 20) tally.note(fmt::format("        pair {}: {}", seed, verdict.why));
        }
        if (k % 10'000 == 9'999) tally.progress(fmt::format("roots: {} of {} pairs, {} wrong", k + 1, job.count, wrong));
        if (k % 1'000'000 == 999'999) {
            tally.note(fmt::format("        roots: seeds {} to {}: {} wrong so far", job.seed, seed, wrong));
        }
    }
    constexpr long k_rare = 1'000'000; // one in so many, and one more, may stay undecided
    tally.result(wrong == 0 && undecided <= 1 + job.count / k_rare,
                 fmt::format("roots: {} of {} pairs wrong, {} undecided (seeds {} to {}; {} impacts, {} made to graze, "
                             "{:.1f} samples a pair, worst gap at an impact {:.1e} sizes)",
                             wrong, job.count, undecided, job.seed,
                             job.seed + static_cast<std::uint64_t>(job.count) - 1, impacts, grazing,
                             static_cast<double>(samples) / static_cast<double>(job.count), worst_gap));
}

void run_shift(const Job& job, Tally& tally)
{
    constexpr double k_shift = 1e6;
    long wrong = 0;
    long unfit = 0;
    double worst = 0.0;
    for (long k = 0; k < job.count; ++k) {
        const std::uint64_t seed = job.seed + static_cast<std::uint64_t>(k);
        const double error = shifted_root_error(random_pair(seed), k_shift);
        if (error < 0.0) ++unfit;
        worst = std::max(worst, error);
        if (error > 1.0) {
            ++wrong;
            if (wrong <= 20) tally.note(fmt::format("        pair {}: its root moves by {:.3g} of what rounding allows", seed, error));
        }
    }
    tally.result(wrong == 0, fmt::format("shift: {} of {} roots move by more than rounding when all times grow by {} s (worst "
                                         "{:.2f} of it; {} graze within it)",
                                         wrong, job.count, k_shift, worst, unfit));
}

} // namespace flying::stress
