#include "rest/group_sweeps.hpp"

#include <algorithm>

#include "rest/sweeps.hpp"

namespace flying {

void GroupSweeps::sweep(std::span<Mover> movers, std::span<const int> members, std::span<ContactPoint> points,
                        const SweepPlan& plan, std::span<Mover> pushed, SolveCounts& counts)
{
    if (!plan.is_warm) forget_impulses(points);
    warm_start(points, movers);
    if (are_content(points, movers, plan.tolerance)) {
        for (const int member : members) pushed[member] = movers[member];
        ++counts.accepted;
    } else {
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
        if (plan.looks_ahead) {
            counts.sweeps += batches_.sweep_ahead({plan.sweeps, std::max(plan.sweeps, plan.most_sweeps), plan.enough});
        } else {
            batches_.sweep_to_and_fro(plan.sweeps);
            counts.sweeps += plan.sweeps;
        }
        batches_.get_impulses(points);
        batches_.get_velocities(movers, members);
        sweep_far(points, movers);
        for (const int member : members) pushed[member] = movers[member];
        ++counts.swept;
    }
    if (plan.push_sweeps > 0) push_apart(members, points, plan, pushed);
}

void GroupSweeps::sweep_far(std::span<ContactPoint> points, std::span<Mover> movers)
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

/// Push overlap apart, for the places alone: from the velocities that were found, and with impulses of its own, so that
/// no load remembers it.
void GroupSweeps::push_apart(std::span<const int> members, std::span<const ContactPoint> points, const SweepPlan& plan,
                             std::span<Mover> pushed)
{
    swept_.clear();
    for (std::size_t k = 0; k < points.size(); ++k) {
        if (points[k].gap < 0.0 || points[k].normal > 0.0) swept_.push_back(static_cast<int>(k));
    }
    batches_.lay_out(points, swept_, pushed, members);
    batches_.begin_push(points, plan.push_share, plan.time);
    batches_.sweep_to_and_fro(plan.push_sweeps);
    batches_.get_velocities(pushed, members);
}

} // namespace flying
