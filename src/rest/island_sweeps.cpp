#include "rest/island_sweeps.hpp"

#include <algorithm>

#include "rest/sweeps.hpp"

namespace flying {

void IslandSweeps::sweep(std::span<Mover> movers, std::span<const int> members, std::span<ContactPoint> points,
                         const SweepPlan& plan, SolveCounts& counts)
{
    if (!plan.is_warm) forget_impulses(points);
    warm_start(points, movers);
    if (are_satisfied(points, movers, plan.tolerance)) {
        ++counts.accepted;
        return;
    }

    batches_.lay_out(points, movers, members);
    counts.sweeps += batches_.sweep_ahead({plan.sweeps, std::max(plan.sweeps, plan.most_sweeps), plan.enough});
    batches_.get_impulses(points);
    batches_.get_velocities(movers, members);
    ++counts.swept;
}

} // namespace flying
