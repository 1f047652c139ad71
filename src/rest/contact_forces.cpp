#include "rest/contact_forces.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "rest/energy_limit.hpp"
#include "rest/impacts.hpp"
#include "rest/rest_tolerance.hpp"
#include "rest/step_field.hpp"

namespace flying {

/// What bears goes on to bear. What is apart may come as near as to touch when the step ends; where impacts have
/// moments of their own only what is all but closed, and comes slowly, is held like that, since the step ends where
/// anything else closes.
void set_velocity_bias(const RestData& data, const Island& island)
{
    for (ContactPoint& c : island.points) {
        const double u = normal_speed(c, data.motion.before[c.a], data.motion.before[c.b]);
        const double gap = c.gap > data.bodies.touch_gap(c.a, c.b) ? c.gap : 0.0;
        c.bound = std::min(0.0, -2.0 * gap / data.motion.span - u);
        if (island.in_turn && gap > 0.0 && (gap > hardly_open(data, c) || comes_as_blow(data, island, c)))
            c.bound = -std::numeric_limits<double>::infinity();
    }
}

/// The same where nothing may be lost. A force does no work over a step in which the mean of the normal velocities is
/// zero: so a contact that bears leaves the step as fast as it came, the other way. An open one bears nothing, unless
/// it would close within a step that ends for no impact.
void set_lossless_bias(const RestData& data, const Island& island)
{
    const double rounding = rest_tolerance::k_stagnant * rest_tolerance::k_residual * top_speed(data, island);
    for (ContactPoint& c : island.points) {
        const double u = normal_speed(c, data.motion.before[c.a], data.motion.before[c.b]);
        const bool is_open = c.gap > data.bodies.touch_gap(c.a, c.b);
        const bool closes = !island.in_turn && c.gap + data.motion.span * u < 0.0;
        if (is_open && !closes) c.bound = -std::numeric_limits<double>::infinity();
        else c.bound = -u <= rounding ? std::min(0.0, -u) : -u;
    }
}

bool close_missed(const RestData& data, const Island& island)
{
    bool any = false;
    for (ContactPoint& c : island.points) {
        if (!std::isinf(c.bound)) continue;
        const double u = normal_speed(c, data.motion.before[c.a], data.motion.before[c.b]);
        const double u_after = normal_speed(c, data.motion.now[c.a], data.motion.now[c.b]);
        if (c.gap + 0.5 * data.motion.span * (u + u_after) >= -hardly_open(data, c)) continue;
        c.bound = -u;
        any = true;
    }
    return any;
}

namespace {

/// Of what tumbles or settles in a heap, where loads have many ways, sweeps find forces that are as good for a fraction
/// of a long search. Not so of a chain; nor where masses differ widely; nor where a body gets further in the step than
/// it is large, and is met elsewhere than where its points are; nor where hardly any moves, or none faster than from
/// rest in a step: what sweeps leave would keep it all moving. Of many points any long search would take too long,
/// unless all others stand still.
[[nodiscard]] bool is_better_swept(const RestData& data, const Island& island)
{
    const bool is_long = are_many(island.points);
    const double rest = is_long ? rest_tolerance::k_still : rest_tolerance::k_rest_speed;
    if (!is_heap(island) || is_chain(data, island) || hardly_any_moves(data, island, rest)) return false;
    if (!is_long && top_speed(data, island) <= field_speed(data, island)) return false;
    const auto flies = [&](int member) {
        const double way = data.motion.span * greatest_speed(data.motion.before, data.bodies.radius, {&member, 1});
        return way > data.bodies.radius[member];
    };
    return is_large(island) ||
           (!are_unequal(data, island.members) && std::none_of(island.members.begin(), island.members.end(), flies));
}

} // namespace

void find_impulses(RestData& data, Island& island, std::span<const Mover> start, double time)
{
    set_free(data, island, start, time);
    const std::span<ContactPoint> points = island.points;
    island.is_solved =
        data.solver.solve(data.motion.now, island.members, points, rest_tolerance::k_residual * top_speed(data, island),
                          is_better_swept(data, island) ? Effort::brief : Effort::full);
}

namespace {

/// Bodies that are all but still and get no faster, as a disc that has rolled out. (What has only just begun to fall
/// does.)
[[nodiscard]] bool have_rolled_out(const RestData& data, const Island& island)
{
    return std::all_of(island.members.begin(), island.members.end(), [&](int member) {
        const Mover& now = data.motion.now[member];
        const double before = kinetic_energy(data.motion.before[member]);
        return is_all_but_still(data, member, now) &&
               kinetic_energy(now) - before <= rest_tolerance::k_rounding * before;
    });
}

} // namespace

void calm(RestData& data, const Island& island)
{
    // Where impulses have grown beyond all bounds, as in a row that fits between two walls to the last digit, what
    // their rounding explains may be faster than anything is
    const double still = std::min(still_speed(data, island), rest_tolerance::k_blow * top_speed(data, island));
    const bool is_still = greatest_speed(data.motion.now, data.bodies.radius, island.members) <= still;
    const bool rests = is_still || have_rolled_out(data, island);
    const double rounding = rests ? 0.0 : solve_rounding(island);

    // What slides on a level floor neither sinks nor turns, where the solve could not tell what it does from nothing
    for (const int member : island.members) {
        Mover& mover = data.motion.now[member];
        const double top = std::max(std::abs(mover.v_x), std::abs(mover.v_y));
        const double limit =
            rests ? std::numeric_limits<double>::infinity() : std::min(rounding, rest_tolerance::k_still * top);
        if (std::abs(mover.v_x) <= limit) mover.v_x = 0.0;
        if (std::abs(mover.v_y) <= limit) mover.v_y = 0.0;
        if (std::abs(mover.spin) * data.bodies.radius[member] <= limit) mover.spin = 0.0;
    }
}

} // namespace flying
