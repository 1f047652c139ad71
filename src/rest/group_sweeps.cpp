#include <algorithm>
#include <cmath>

#include "rest/group_solver.hpp"
#include "rest/rest_tolerance.hpp"

namespace flying {

// [rest.group.sweeps]
void GroupSolver::sweep_group(std::span<Mover> movers, std::span<const int> members, std::span<ContactPoint> points,
                              const SweepPlan& plan, std::span<Mover> pushed)
{
    warm_start(points, movers);
    if (worst_complaint(points, movers) <= plan.tolerance) {
        for (const int member : members) pushed[member] = movers[member];
        ++counts_.accepted;
    } else {
        // What bears nothing and is far from closing has its turn once, at the end
        sweep_points_.clear();
        swept_.clear();
        far_.clear();
        for (std::size_t k = 0; k < points.size(); ++k) {
            const ContactPoint& c = points[k];
            const bool is_far =
                c.normal == 0.0 && normal_speed(c, movers[c.a], movers[c.b]) - c.bound > plan.far_from_closing;
            (is_far ? far_ : swept_).push_back(static_cast<int>(k));
            if (!is_far) sweep_points_.push_back(sweep_point(c));
        }
        if (plan.looks_ahead) sweep_ahead(movers, members, plan.sweeps);
        else sweep_to_and_fro(movers, plan.sweeps);
        take_impulses(points);
        sweep_points_.clear();
        swept_.clear();
        for (const int k : far_) {
            const ContactPoint& c = points[k];
            if (normal_speed(c, movers[c.a], movers[c.b]) >= c.bound) continue;
            swept_.push_back(k);
            sweep_points_.push_back(sweep_point(c));
        }
        sweep(sweep_points_, movers);
        take_impulses(points);
        for (const int member : members) pushed[member] = movers[member];
        counts_.sweeps += plan.sweeps;
        ++counts_.unsolved;
    }
    if (plan.push_sweeps > 0) push_apart(points, plan, pushed);
}

void GroupSolver::take_impulses(std::span<ContactPoint> points) const
{
    for (std::size_t i = 0; i < swept_.size(); ++i) {
        points[swept_[i]].normal = sweep_points_[i].normal;
        points[swept_[i]].tangent = sweep_points_[i].tangent;
    }
}

void GroupSolver::sweep_to_and_fro(std::span<Mover> movers, int sweeps)
{
    for (int k = 0; k < sweeps; ++k) {
        if (k % 2 == 0) sweep(sweep_points_, movers);
        else sweep_back(sweep_points_, movers);
    }
}
// [rest.group.sweeps]

// [rest.group.ahead]
/// Sweeps that go on in the direction of those before, as conjugate gradients do: of what one sweep takes off little,
/// many would take off alike. Wherever a sweep changes more than the last, the directions are forgotten (Silcowitz,
/// Niebe and Erleben, A nonsmooth nonlinear conjugate gradient method, 2010).
void GroupSolver::sweep_ahead(std::span<Mover> movers, std::span<const int> members, int sweeps)
{
    way_.assign(sweep_points_.size(), Way{});
    drift_.assign(members.size(), Drift{});
    double last = 0.0;
    for (int k = 0; k < sweeps; ++k) {
        for (std::size_t i = 0; i < way_.size(); ++i) {
            way_[i].old_normal = sweep_points_[i].normal;
            way_[i].old_tangent = sweep_points_[i].tangent;
        }
        for (std::size_t i = 0; i < members.size(); ++i) drift_[i].old = movers[members[i]];
        sweep(sweep_points_, movers);
        if (k + 1 == sweeps) break; // what a sweep leaves lies in Coulomb's cones; what goes ahead may not

        double now = 0.0;
        for (std::size_t i = 0; i < way_.size(); ++i) {
            const SweepPoint& c = sweep_points_[i];
            const double normal = c.normal - way_[i].old_normal;
            const double tangent = c.tangent - way_[i].old_tangent;
            now += normal * normal / c.normal_mass + tangent * tangent / c.tangent_mass;
        }
        const double share = k > 0 && last > 0.0 ? now / last : 0.0;
        last = now;
        go_ahead(movers, members, share <= 1.0 ? share : 0.0);
    }
}

void GroupSolver::go_ahead(std::span<Mover> movers, std::span<const int> members, double share)
{
    // The way of a sweep, and a share of the way before it
    for (std::size_t i = 0; i < way_.size(); ++i) {
        SweepPoint& c = sweep_points_[i];
        Way& way = way_[i];
        const double normal = c.normal - way.old_normal;
        const double tangent = c.tangent - way.old_tangent;
        c.normal += share * way.normal;
        c.tangent += share * way.tangent;
        way.normal = share * way.normal + normal;
        way.tangent = share * way.tangent + tangent;
    }
    for (std::size_t i = 0; i < members.size(); ++i) {
        Mover& mover = movers[members[i]];
        Drift& drift = drift_[i];
        const double v_x = mover.v_x - drift.old.v_x;
        const double v_y = mover.v_y - drift.old.v_y;
        const double spin = mover.spin - drift.old.spin;
        mover.v_x += share * drift.v_x;
        mover.v_y += share * drift.v_y;
        mover.spin += share * drift.spin;
        drift.v_x = share * drift.v_x + v_x;
        drift.v_y = share * drift.v_y + v_y;
        drift.spin = share * drift.spin + spin;
    }
}
// [rest.group.ahead]

// [rest.group.push]
/// Push overlap apart, for the places alone: from the velocities that were found, and with impulses of its own, so that
/// no load remembers it.
void GroupSolver::push_apart(std::span<const ContactPoint> points, const SweepPlan& plan, std::span<Mover> pushed)
{
    sweep_points_.clear();
    for (const ContactPoint& c : points) {
        if (!(c.gap < 0.0 || c.normal > 0.0)) continue;
        SweepPoint& point = sweep_points_.emplace_back(sweep_point(c));
        if (c.gap < 0.0) point.bound = plan.push_share * -c.gap / plan.time;
        point.normal = point.tangent = point.friction = 0.0;
    }
    sweep_to_and_fro(pushed, plan.push_sweeps);
}
// [rest.group.push]

} // namespace flying
