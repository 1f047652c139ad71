#include "rest/heap_sweeps.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "rest/energy_limit.hpp"
#include "rest/rest_tolerance.hpp"
#include "rest/step_field.hpp"

namespace flying {
namespace {

/// What free fall through one step brings, from rest, twice over; infinite without a field, where nothing presses on.
[[nodiscard]] double energy_of_fall(const RestData& data, const Island& island)
{
    double sum = 0.0;
    for (const int member : island.members) {
        sum += (data.motion.span * data.motion.field[member]).squaredNorm() / data.motion.now[member].inv_mass;
    }
    return sum > 0.0 ? sum : std::numeric_limits<double>::infinity();
}

} // namespace

/// A group too large to be solved whole: each step goes on with the sweeps of the last.
void HeapSweeps::sweep_large(RestData& data, Island& island)
{
    island.is_exact = false;
    const std::span<ContactPoint> points = island.points;
    const std::span<const int> members = island.members;
    const double field = field_speed(data, island);
    const double before = greatest_speed(data.motion.before, data.bodies.radius, members);
    set_velocity_bias_swept(data, island, before <= rest_tolerance::k_rest_speed * field);
    set_free(data, island, data.motion.before, data.motion.span);
    SweepPlan plan;
    plan.is_warm = data.options.warm_starts;
    plan.sweeps = data.options.sweeps;
    plan.most_sweeps = data.options.most_sweeps;
    plan.enough = rest_tolerance::k_enough * energy_of_fall(data, island);
    plan.far_from_closing = rest_tolerance::k_far * std::max(before, field);
    plan.tolerance = rest_tolerance::k_blow * field;
    sweeps_.sweep(data.motion.now, members, points, plan, data.solver.counts());
    if (island.member_count() <= rest_tolerance::k_most_swept_on) {
        const double most =
            before > rest_tolerance::k_standing * field ? rest_tolerance::k_deep : rest_tolerance::k_slow_approach;
        double enough = most;
        if (const double left = approaches_left(data, points); left > most) {
            enough = std::max(most, rest_tolerance::k_gets_on * left);
            // Sweeps take the longer the more masses differ: what these leave is swept on, and then ended all at once
            plan.sweeps = plan.most_sweeps = rest_tolerance::k_more_sweeps;
            plan.tolerance = 0.0;
            set_free(data, island, data.motion.before, data.motion.span);
            sweeps_.sweep(data.motion.now, members, points, plan, data.solver.counts());
        }
        if (approaches_left(data, points) > enough) {
            set_free(data, island, data.motion.before, data.motion.span);
            const double tolerance = rest_tolerance::k_residual * top_speed(data, island);
            if (!data.solver.solve(data.motion.now, members, points, tolerance)) {
                set_free(data, island, data.motion.before, data.motion.span);
                data.solver.end_approaches(data.motion.now, members, points);
            }
        }
    }

    // What hardly moves comes to rest
    const double after = greatest_speed(data.motion.now, data.bodies.radius, members);
    if (before <= rest_tolerance::k_rest_speed * field && after <= rest_tolerance::k_rest_speed * field) {
        for (const int member : members) {
            Mover& mover = data.motion.now[member];
            mover.v_x = mover.v_y = mover.spin = 0.0;
        }
    }
    scale_impulses_to_energy(data, island);
    for (const int member : members) {
        const Mover& now = data.motion.now[member];
        data.motion.shift[member] = data.motion.span * Vec2(now.v_x, now.v_y);
        data.motion.turn[member] = data.motion.span * now.spin;
    }
}

/// How much deeper points come to overlap in the step than they may.  [sizes]
double HeapSweeps::approaches_left(const RestData& data, std::span<const ContactPoint> points) const
{
    double worst = 0.0;
    for (const ContactPoint& c : points) {
        const double missed =
            data.motion.span * (c.bound - normal_speed(c, data.motion.now[c.a], data.motion.now[c.b]));
        worst = std::max(worst, missed / std::min(data.bodies.radius[c.a], data.bodies.radius[c.b]));
    }
    return worst;
}

/// Sweeps that go on from what bore too much lift a heap. With no impulses it would fall through the step, and lose
/// energy by that; with some share of them it neither gains nor loses any.
void HeapSweeps::scale_impulses_to_energy(RestData& data, const Island& island)
{
    // [rest.heaps.share]
    // With a share s of the impulses the energy grows by  square s^2 + linear s + constant
    double square = 0.0;   // [J]
    double linear = 0.0;   // [J]
    double constant = 0.0; // [J]
    double before = 0.0;
    const std::span<const int> members = island.members;
    for (const int member : members) {
        const Mover& old = data.motion.before[member];
        const Mover& now = data.motion.now[member];
        const Vec2 velocity(old.v_x, old.v_y);
        const Vec2 fall = data.motion.span * data.motion.field[member];
        const Vec2 change = Vec2(now.v_x, now.v_y) - velocity - fall;
        const double spin = now.spin - old.spin;
        square += 0.5 * (change.squaredNorm() / now.inv_mass + spin * spin / now.inv_moment);
        linear += velocity.dot(change) / now.inv_mass + old.spin * spin / now.inv_moment;
        constant -= 0.5 * fall.squaredNorm() / now.inv_mass;
        before += 0.5 * (velocity.squaredNorm() / now.inv_mass + old.spin * old.spin / now.inv_moment);
    }
    const double scale = before + square - constant;
    if (!(square + linear + constant > rest_tolerance::k_rounding * scale)) return;
    const double root = std::sqrt(linear * linear - 4.0 * square * constant);
    const double share = linear > 0.0 ? -2.0 * constant / (linear + root) : (root - linear) / (2.0 * square);
    // [rest.heaps.share]

    for (ContactPoint& c : island.points) {
        c.normal *= share;
        c.tangent *= share;
    }
    for (const int member : members) {
        const Mover& old = data.motion.before[member];
        const Vec2 fall = data.motion.span * data.motion.field[member];
        Mover& now = data.motion.now[member];
        const Mover all = now;
        now.v_x = (old.v_x + fall.x()) + share * (all.v_x - (old.v_x + fall.x()));
        now.v_y = (old.v_y + fall.y()) + share * (all.v_y - (old.v_y + fall.y()));
        now.spin = old.spin + share * (all.spin - old.spin);
    }
}

void HeapSweeps::set_velocity_bias_swept(const RestData& data, const Island& island, bool is_calm) const
{
    const double field = field_speed(data, island);
    for (ContactPoint& c : island.points) {
        // All of a gap passes with the velocities that the step ends with. In a calm group nothing comes to close one:
        // what bears over a gap that a calm speed would close goes on to bear, or its load would wane for minutes
        c.bound = -std::max(c.gap, 0.0) / data.motion.span;
        if (is_calm && c.normal > 0.0 && -c.bound <= rest_tolerance::k_rest_speed * field) c.bound = 0.0;
    }
}

/// Sweeps over what the direct solve rarely finds where a heap moves, for all its factorisations.
///
/// tolerance  where no point asks for a greater change, impulses stay as they are; below 0 they never do [m/s]
void HeapSweeps::sweep_heap(RestData& data, const Island& island, std::span<Mover> movers,
                            std::span<ContactPoint> points, double tolerance)
{
    const std::span<const int> members = island.members;
    SweepPlan plan;
    plan.is_warm = data.options.warm_starts;
    plan.sweeps = rest_tolerance::k_heap_sweeps;
    plan.tolerance = tolerance;
    sweeps_.sweep(movers, members, points, plan, data.solver.counts());
}

} // namespace flying
