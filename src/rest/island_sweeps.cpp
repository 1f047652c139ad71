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

    // What bears nothing and is far from closing has its turn once, at the end
    swept_.clear();
    far_.clear();
    for (std::size_t k = 0; k < points.size(); ++k) {
        const ContactPoint& c = points[k];
        const bool is_far =
            c.normal == 0.0 && normal_speed(c, movers[c.a], movers[c.b]) - c.bound > plan.far_from_closing;
        (is_far ? far_ : swept_).push_back(static_cast<int>(k));
    }
    batches_.lay_out(points, swept_, movers, members);
    counts.sweeps += batches_.sweep_ahead({plan.sweeps, std::max(plan.sweeps, plan.most_sweeps), plan.enough});
    batches_.get_impulses(points);
    batches_.get_velocities(movers, members);
    sweep_far(points, movers);
    ++counts.swept;
}

void IslandSweeps::sweep_far(std::span<ContactPoint> points, std::span<Mover> movers)
{
    for (const int k : far_) {
        ContactPoint& c = points[k];
        if (normal_speed(c, movers[c.a], movers[c.b]) >= c.bound) continue;
        SweepPoint point = sweep_point(c);
        flying::sweep(std::span(&point, 1), movers);
        c.normal = point.normal;
        c.tangent = point.tangent;
    }
}

} // namespace flying
