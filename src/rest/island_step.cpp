#include "rest/island_step.hpp"

#include <algorithm>

#include "rest/contact_forces.hpp"
#include "rest/energy_limit.hpp"
#include "rest/rest_tolerance.hpp"
#include "rest/step_field.hpp"

namespace flying {
namespace {

[[nodiscard]] bool bears(const ContactPoint& c)
{
    return c.normal > 0.0;
}

/// Deepest overlap that the step has begun with.  [breadths]
double overlap_at_start(const RestData& data, const Island& island)
{
    double worst = 0.0;
    for (const ContactPoint& c : island.points) {
        worst = std::max(worst, -c.gap / data.bodies.breadth_of(c.a, c.b));
    }
    return worst;
}

/// When a load that wanes evenly comes to its end: where it is less than a third of what it was over the step before,
/// that is within this one; 0 where none does.  [s]
double end_of_load(const RestData& data, const Island& island)
{
    double first = data.motion.span;
    const double part = first / data.whole_step;
    for (const ContactPoint& c : island.points) {
        const double before = part * data.pairs.pairs()[c.pair].normal[c.own];
        if (!(3.0 * c.normal < before)) continue;

        // Both are means, and stand for the middles of their steps; of one that has ended before that, less is known
        const double share = c.normal > 0.0 ? 0.5 + c.normal / (before - c.normal) : 0.25;
        first = std::min(first, share * data.motion.span);
    }
    return first < data.motion.span ? first : 0.0;
}

/// The step may end as it was found: with little overlap or no more than there was, and no body beyond the room of its
/// box.
bool is_fair(const RestData& data, const Island& island, double overlap)
{
    const double fair = is_heap(island) ? rest_tolerance::k_most_overlap : rest_tolerance::k_fair_overlap;
    if (overlap > fair && overlap > overlap_at_start(data, island)) return false;
    return std::all_of(island.members.begin(), island.members.end(), [&](int member) {
        return farthest_way(data, member) <= rest_tolerance::k_room_reaches * data.motion.reach[member];
    });
}

/// Ways of an island whose velocities are found.
void find_places(RestData& data, const Island& island)
{
    if (island.has_ways || !island.is_exact) return;

    // Places move by the mean of the velocities before and after
    StepMotion& motion = data.motion;
    for (const int member : island.members)
        motion.add_mean_way(member, motion.before[member], motion.now[member], motion.span);
}

} // namespace

void IslandStep::find(RestData& data, Island& island, bool may_be_parted)
{
    if (island.points.empty()) {
        fly(data, island);
        return;
    }
    // Strike, or end the part where the first impact comes; small islands go on from there with another look
    island.in_turn = may_be_parted;
    bool is_struck = impacts_.strike(data, island, sweeps_);
    if (island.in_turn) island.cut_at = is_struck ? data.motion.span : first_impact(data, island);
    if (island.cut_at > 0.0) return;
    // Where nothing may be lost, what was struck goes on to strike what it would meet within the step
    for (int k = 0; k < rest_tolerance::k_patience && is_struck && !is_heap(island) && is_lossless(island); ++k)
        is_struck = impacts_.strike(data, island, sweeps_);

    // Find the forces of the contacts
    const bool sweeps = !is_solved_whole(data, island);
    const bool is_followed = !sweeps && CurvedWays::may_follow(data, island);
    if (is_lossless(island)) {
        find_lossless(data, island, sweeps);
    } else if (is_heap(island) && sweeps_.stays(data, island)) {
        return; // another search would end as that of the last step
    } else if (sweeps) {
        sweeps_.sweep_large(data, island);
        return;
    } else {
        if (!is_followed) curves_.take_lines_halfway(data, island);
        set_velocity_bias(data, island);
        find_impulses(data, island, data.motion.before, data.motion.span);
        if (is_heap(island) && !island.is_solved) {
            // It would cost more than it brings to look on; sweeps go on from what bore before
            recall_impulses(data, island);
            sweeps_.sweep_large(data, island);
            return;
        }
    }
    if (is_followed && curves_.follow(data, island)) {
        if (island.in_turn) island.cut_at = curves_.end_of_slip(data, island);
    } else if (is_followed && island.in_turn && curves_.lets_go()) {
        // A straight way would bear it on, and throw it
        island.cut_at = 0.5 * data.motion.span;
    } else if (std::none_of(island.points.begin(), island.points.end(), bears)) {
        fly(data, island);
        return;
    } else if (!is_heap(island) || is_loose(data, island)) slip_ends_.part(data, island);
    calm(data, island);
}

/// Forces where nothing may be lost. They are found again as long as gaps close that were thought to stay open.
void IslandStep::find_lossless(RestData& data, Island& island, bool sweeps)
{
    set_lossless_bias(data, island);
    for (int k = 0; k < rest_tolerance::k_quick_rounds; ++k) {
        if (sweeps) {
            set_free(data, island, data.motion.before, data.motion.span);
            sweeps_.sweep_velocities(data, island, data.motion.now, island.points);
        } else find_impulses(data, island, data.motion.before, data.motion.span);
        const std::span<const Mover> before = data.motion.before;
        const double share = neutral_share(data, island, before, data.motion.now, Way::mean_velocity);
        if (share != 1.0) {
            scale_impulses(island, share);
            take_share(data, island, before, data.motion.now, Way::mean_velocity, share);
        }
        if (island.in_turn || !close_missed(data, island)) return;
    }
}

/// Ends the step of an island earlier, with the same forces: says where its bodies are then, and forgets it. Of parts
/// that the step is made in, or made again in, the last one that begins by then has the say.
void IslandStep::look_within(RestData& data, const Island& island, WithinStep& within)
{
    StepMotion& motion = data.motion;
    const double span = motion.span;
    const double time = within.since - (data.options.step - motion.after - span);
    if (time < -rest_tolerance::k_rounding * data.options.step) return;
    struct Found
    {
        Mover now;
        Vec2 shift;
        double turn;
    };
    std::vector<Found> found;
    for (const int member : island.members)
        found.push_back({motion.now[member], motion.shift[member], motion.turn[member]});
    go_along(motion, island, std::clamp(time, 0.0, span));

    // Take off overlap; where a step would be made in parts for what is left, once more
    if (!island.points.empty()) {
        double overlap = projection_.measure_overlap(data, island);
        for (int k = 0; k < rest_tolerance::k_few_rounds; ++k) {
            const double left = projection_.put_apart(data, island, overlap, sweeps_);
            if (left <= rest_tolerance::k_most_overlap) break;
            overlap = left;
        }
        limit_energy(data, island);
    }
    for (std::size_t k = 0; k < found.size(); ++k) {
        const int member = island.members[k];
        Mover& seen = motion.now[member];
        BodyState state = data.bodies.list[member].state;
        state.position += motion.shift[member];
        state.angle += motion.turn[member];
        state.velocity = Vec2(seen.v_x, seen.v_y);
        state.spin = seen.spin;
        within.states[member] = state;
        seen = found[k].now;
        motion.shift[member] = found[k].shift;
        motion.turn[member] = found[k].turn;
    }
    motion.span = span;
}

double IslandStep::end_early(RestData& data, Island& island, bool may_be_halved, WithinStep* within)
{
    find_places(data, island);
    if (island.in_turn) {
        const double missed = missed_impact(data, island);
        if (missed > 0.0) return missed;
        if (island.has_ways && data.motion.span == data.options.step) {
            const double end = end_of_load(data, island);
            if (end > 0.0) return end;
        }
    }
    if (within) look_within(data, island, *within);
    if (island.points.empty()) return 0.0;
    const bool is_even = is_heap(island) && !are_unequal(data, island.members);
    const double overlap = projection_.measure_overlap(data, island);
    if (may_be_halved && !is_even && !is_fair(data, island, overlap)) return 0.5 * data.motion.span;
    const double left = projection_.put_apart(data, island, overlap, sweeps_);
    // With all that it may leave, the next step would begin where its pushes are no longer paid for
    const double room = 0.5 * rest_tolerance::k_most_overlap;
    return may_be_halved && is_even && left > room ? 0.5 * data.motion.span : 0.0;
}

} // namespace flying
