#include "rest/heap_sweeps.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "rest/energy_limit.hpp"
#include "rest/rest_tolerance.hpp"
#include "rest/step_field.hpp"
#include "rest/sweeps.hpp"

namespace flying {
namespace {

/// [breadths] What sweeps may add to an overlap in one step. What lands loses enough energy to pay for lifting bodies
/// apart again. What stands has none to spend, and if it had to lift itself in every step it would never come to rest.
[[nodiscard]] double most_added(bool is_landing)
{
    return is_landing ? rest_tolerance::k_most_overlap : 0.5 * rest_tolerance::k_fair_overlap;
}

/// What free fall through one step brings, from rest, twice over; infinite without a field, where nothing presses on.
[[nodiscard]] double energy_of_fall(const RestData& data, const Island& island)
{
    double sum = 0.0;
    for (const int member : island.members) {
        sum += (data.motion.span * data.motion.field[member]).squaredNorm() / data.motion.now[member].inv_mass;
    }
    return sum > 0.0 ? sum : std::numeric_limits<double>::infinity();
}

/// How fast bodies move as a step begins, turning included.  [m/s]
[[nodiscard]] double mean_speed(const RestData& data, std::span<const int> members)
{
    double sum = 0.0;
    for (const int member : members) sum += greatest_speed(data.motion.before, data.bodies.radius, {&member, 1});
    return sum / static_cast<double>(members.size());
}

/// Places may move by the mean of the velocities before and after: what bodies had when the step began leads none into
/// another. Sweeps leave something of a blow, and that does.
[[nodiscard]] bool may_go_by_the_mean(const RestData& data, std::span<const ContactPoint> points)
{
    const std::vector<Mover>& before = data.motion.before;
    const std::vector<Mover>& now = data.motion.now;
    const auto keeps_apart = [&](const ContactPoint& c) {
        const double mean = 0.5 * (normal_speed(c, before[c.a], before[c.b]) + normal_speed(c, now[c.a], now[c.b]));
        const double most = most_added(false) * data.bodies.breadth_of(c.a, c.b);
        return std::max(c.gap, 0.0) + data.motion.span * mean >= -most;
    };
    return std::all_of(points.begin(), points.end(), keeps_apart);
}

/// By how much the step changes a velocity, turning included.  [m/s]
[[nodiscard]] double greatest_change(const RestData& data, std::span<const int> members)
{
    double top = 0.0;
    for (const int member : members) {
        const Mover& old = data.motion.before[member];
        const Mover& now = data.motion.now[member];
        const double rim = std::abs(now.spin - old.spin) * data.bodies.radius[member];
        top = std::max({top, std::abs(now.v_x - old.v_x), std::abs(now.v_y - old.v_y), rim});
    }
    return top;
}

void stop(RestData& data, std::span<const int> members)
{
    for (const int member : members) {
        Mover& mover = data.motion.now[member];
        mover.v_x = mover.v_y = mover.spin = 0.0;
    }
}

void take_back(std::span<Mover> movers, std::span<const ContactPoint> points)
{
    for (const ContactPoint& c : points) push(c, -c.normal, -c.tangent, movers[c.a], movers[c.b]);
}

} // namespace

bool HeapSweeps::stays(RestData& data, Island& island) const
{
    if (!data.options.warm_starts || !stood(data, island)) return false;
    set_velocity_bias_swept(data, island, true);
    set_free(data, island, data.motion.before, data.motion.span);
    warm_start(island.points, data.motion.now);
    const double rest = rest_tolerance::k_rest_speed * field_speed(data, island);
    if (greatest_speed(data.motion.now, data.bodies.radius, island.members) > rest) return false;
    stop(data, island.members);
    island.is_exact = false;
    return true;
}

void HeapSweeps::sweep_large(RestData& data, Island& island)
{
    if (stays(data, island)) return;
    island.is_exact = false;
    const std::span<ContactPoint> points = island.points;
    const std::span<const int> members = island.members;
    const double field = field_speed(data, island);
    const double rest = rest_tolerance::k_rest_speed * field;
    const double before = greatest_speed(data.motion.before, data.bodies.radius, members);
    set_velocity_bias_swept(data, island, before <= rest);
    set_free(data, island, data.motion.before, data.motion.span);
    SweepPlan plan;
    plan.is_warm = data.options.warm_starts;
    plan.sweeps = data.options.sweeps;
    plan.most_sweeps = data.options.most_sweeps;
    plan.enough = rest_tolerance::k_blow * energy_of_fall(data, island);
    plan.tolerance = rest_tolerance::k_blow * field;
    sweeps_.sweep(data.motion.now, members, points, plan, data.solver.counts());
    settle(data, island, points, std::max(rest, mean_speed(data, members)));
    const bool is_standing = before <= rest_tolerance::k_standing * field;
    sweep_on(data, island, data.motion.now, points, {data.options.step, !is_standing && is_large(island)});

    // What hardly moves comes to rest, where its impulses would hold it there, too, and not only stop it
    if (before <= rest && greatest_change(data, members) <= rest) stop(data, members);
    // Sweeps that go on from what bore too much lift a heap. With no impulses it would fall through the step, and lose
    // energy by that; with some share of them it neither gains nor loses any
    const Way way = may_go_by_the_mean(data, points) ? Way::mean_velocity : Way::end_velocity;
    const double share = neutral_share(data, island, data.motion.before, data.motion.now, way);
    if (share < 1.0) {
        scale_impulses(island, share);
        take_share(data, island, data.motion.before, data.motion.now, way, share);
    }
    const double of_old = way == Way::mean_velocity ? 0.5 * data.motion.span : 0.0; // [s]
    const double of_now = data.motion.span - of_old;
    for (const int member : members) {
        const Mover& old = data.motion.before[member];
        const Mover& now = data.motion.now[member];
        data.motion.shift[member] = of_old * Vec2(old.v_x, old.v_y) + of_now * Vec2(now.v_x, now.v_y);
        data.motion.turn[member] = of_old * old.spin + of_now * now.spin;
    }
}

/// What each point of a row of bodies lacks adds up along it, and no row of a heap need be longer than the root of how
/// many bodies it has. So a heap is swept again where any point lacks more than that part of how fast bodies move,
/// or of the speed that counts as rest. Sweeps hardly lead on what light bodies bear of heavy ones; alternating
/// directions do, whatever the masses. They also find the forces of what is to stand from the start, as a wall that was
/// built and not poured: by sweeps it would sink until its impulses have grown, and shake for long.
///
/// speed  of the bodies, or that of rest [m/s]
void HeapSweeps::settle(RestData& data, const Island& island, std::span<ContactPoint> points, double speed)
{
    const std::span<Mover> movers = data.motion.now;
    const double most = speed / std::sqrt(static_cast<double>(island.member_count()));
    if (are_satisfied(points, movers, most)) return;
    take_back(movers, points);
    const bool has_stood = stood(data, island);
    if (has_stood || are_unequal(data, island.members)) {
        const int rounds = (has_stood ? rest_tolerance::k_few_sweeps : 1) * rest_tolerance::k_more_sweeps;
        data.solver.solve_by_turns(movers, island.members, points, most, rounds);
        take_back(movers, points);
    }
    SweepPlan plan;
    plan.sweeps = data.options.most_sweeps;
    sweeps_.sweep(movers, island.members, points, plan, data.solver.counts());
}

/// Sweeps go on where more is left: a blow to a heap is felt all through it, but few points still miss their bounds by
/// too much after the first sweeps. Where more of them do, as in smooth discs that lie in layers, each sweep leads on
/// by one layer, and alternating directions by all. In what isn't large the direct solve finds the rest, if it can.
void HeapSweeps::sweep_on(RestData& data, const Island& island, std::span<Mover> movers, std::span<ContactPoint> points,
                          const Aim& aim)
{
    allow(data, points, most_added(aim.is_landing) / aim.span);
    const int sweeps = is_large(island) ? rest_tolerance::k_few_sweeps : rest_tolerance::k_more_sweeps;
    const int most = sweeps * static_cast<int>(points.size());
    if (local_.sweep(movers, points, allowed_, most)) return;
    take_back(movers, points);
    if (is_large(island)) {
        const double least = *std::min_element(allowed_.begin(), allowed_.end());
        data.solver.solve_by_turns(movers, island.members, points, 0.5 * least, rest_tolerance::k_few_sweeps);
        (void)local_.sweep(movers, points, allowed_, most);
        return;
    }
    (void)data.solver.solve(movers, island.members, points, rest_tolerance::k_residual * top_speed(data, island));
}

/// By how much each point may miss its least normal velocity.
///
/// most  [breadths/s], or [breadths] where places are swept
void HeapSweeps::allow(const RestData& data, std::span<const ContactPoint> points, double most)
{
    allowed_.clear();
    for (const ContactPoint& c : points) allowed_.push_back(most * data.bodies.breadth_of(c.a, c.b));
}

void HeapSweeps::set_velocity_bias_swept(const RestData& data, const Island& island, bool is_calm) const
{
    const double field = field_speed(data, island);
    for (ContactPoint& c : island.points) {
        // All of a gap passes with the velocities that the step ends with. In a calm island nothing comes to close one:
        // what bears over a gap that a calm speed would close goes on to bear, or its load would wane for minutes
        c.bound = -std::max(c.gap, 0.0) / data.motion.span;
        if (is_calm && c.normal > 0.0 && -c.bound <= rest_tolerance::k_rest_speed * field) c.bound = 0.0;
    }
}

void HeapSweeps::sweep_velocities(RestData& data, const Island& island, std::span<Mover> velocities,
                                  std::span<ContactPoint> points)
{
    sweep(data, island, velocities, points, -1.0);
}

void HeapSweeps::sweep_places(RestData& data, const Island& island, std::span<Mover> pushes,
                              std::span<ContactPoint> points, double tolerance)
{
    sweep(data, island, pushes, points, tolerance);
    sweep_on(data, island, pushes, points, {1.0, false});
}

/// tolerance  where no point asks for a greater change, impulses stay as they are; below 0 they never do
void HeapSweeps::sweep(RestData& data, const Island& island, std::span<Mover> movers, std::span<ContactPoint> points,
                       double tolerance)
{
    SweepPlan plan;
    plan.is_warm = data.options.warm_starts;
    plan.sweeps = rest_tolerance::k_few_sweeps;
    plan.tolerance = tolerance;
    sweeps_.sweep(movers, island.members, points, plan, data.solver.counts());
}

} // namespace flying
