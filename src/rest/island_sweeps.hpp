#pragma once

#include <span>
#include <vector>

#include "rest/contact_point.hpp"
#include "rest/solve_counts.hpp"
#include "rest/sweep_batches.hpp"

namespace flying {

/// How an island too large to factorise in each step is swept.
struct SweepPlan
{
    bool is_warm = true; ///< from the impulses that the points have; else from none
    int sweeps = 8;
    int most_sweeps = 0;     ///< as many where fewer don't bring a sweep's changes below `enough`
    double enough = 0.0;     ///< [J]
    double tolerance = -1.0; ///< where no point asks for a greater change, impulses stay as they are [m/s]
};

/// Sweeps over all points of an island (projected Gauss-Seidel), from where the step before has ended.
class IslandSweeps
{
public:
    /// movers   all bodies; those of the island hold the velocities that they would have without contacts
    /// members  the island's bodies that can move, ascending
    /// points   the island's points with impulses to start from, not yet applied; on return those found, applied
    void sweep(std::span<Mover> movers, std::span<const int> members, std::span<ContactPoint> points,
               const SweepPlan& plan, SolveCounts& counts);

private:
    SweepBatches batches_;
};

} // namespace flying
