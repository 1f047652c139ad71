#include "rest/impacts.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "math/tolerance.hpp"
#include "rest/energy_limit.hpp"
#include "rest/find_contacts.hpp"
#include "rest/heap_sweeps.hpp"
#include "rest/impact.hpp"
#include "rest/rest_tolerance.hpp"
#include "rest/step_field.hpp"

namespace flying {

/// What approaches of an island are measured by.
struct ApproachSpeeds
{
    double rounding = 0.0; ///< no approach: what rounding explains [m/s]
    double by_field = 0.0; ///< what the field alone brings about in a small part of a whole step [m/s]

    ApproachSpeeds(const RestData& data, const Island& island)
        : rounding(solve_rounding(island) + tolerance::k_least_speed +
                   rest_tolerance::k_stagnant * rest_tolerance::k_residual * top_speed(data, island)),
          by_field(rest_tolerance::k_blow * field_speed(data, island) * (data.options.step / data.motion.span))
    {
    }

    /// The slowest approach that is a blow. What brings no rebound, and came by the field, is left to the load.  [m/s]
    /// rebound  the slowest approach that brings one [m/s]
    [[nodiscard]] double slowest_blow(double rebound) const { return rounding + std::min(rebound, by_field); }

    /// What approaches so fast, or opens, is about to lie on the other: it won't be thrown back.
    [[nodiscard]] bool lands(double approach, double rebound) const
    {
        return rounding + std::max(approach, 0.0) < rebound;
    }
};

namespace {

/// A rebound that would come back within the rest of the step doesn't happen, but for one that loses nothing: the
/// slowest approach that brings a rebound.  [m/s]
[[nodiscard]] double slowest_rebound(const RestData& data, const ContactPoint& c)
{
    if (is_lossless(c)) return 0.0;
    if (c.restitution == 0.0) return std::numeric_limits<double>::infinity();
    const double by_load = c.normal / c.normal_mass;
    const double by_fall =
        -std::min(data.motion.fall_of(c), data.motion.weight_of(c)) * (data.motion.span + data.motion.after);
    return std::max({by_load, by_fall, 0.0}) / (2.0 * c.restitution);
}

/// Both points lie between the same two bodies; what can't be moved counts as one.
[[nodiscard]] bool are_of_one_pair(const RestData& data, const ContactPoint& c, const ContactPoint& d)
{
    const auto mover_of = [&](int body) { return data.motion.is_moved(body) ? body : -1; };
    return std::minmax({mover_of(c.a), mover_of(c.b)}) == std::minmax({mover_of(d.a), mover_of(d.b)});
}

/// Its two bodies touch no others: what can be moved of them is in no point of another pair.
[[nodiscard]] bool is_of_lone_pair(const RestData& data, std::span<const ContactPoint> points, const ContactPoint& c)
{
    const auto is_of = [&](int body, const ContactPoint& d) {
        return data.motion.is_moved(body) && (body == d.a || body == d.b);
    };
    return std::all_of(points.begin(), points.end(), [&](const ContactPoint& d) {
        return are_of_one_pair(data, c, d) || !(is_of(c.a, d) || is_of(c.b, d));
    });
}

/// What follows the impacts begins with the velocities that they leave.
void keep_velocities(RestData& data, const Island& island)
{
    for (const int member : island.members) {
        const Mover& now = data.motion.before[member];
        BodyState& state = data.bodies.list[member].state;
        if (state.velocity == Vec2(now.v_x, now.v_y) && state.spin == now.spin) continue;
        state.velocity = Vec2(now.v_x, now.v_y);
        state.spin = now.spin;
        expect_flight(data, member, state.position); // what it bore before tells nothing any more
    }
}

} // namespace

double hardly_open(const RestData& data, const ContactPoint& c)
{
    return rest_tolerance::k_closed * data.bodies.size_of(c.a, c.b);
}

bool comes_as_blow(const RestData& data, const Island& island, const ContactPoint& c)
{
    const double u = normal_speed(c, data.motion.before[c.a], data.motion.before[c.b]);
    return -u > ApproachSpeeds(data, island).slowest_blow(slowest_rebound(data, c));
}

/// The moment of the first impact after the beginning; 0 where there is none.  [s]
double first_impact(const RestData& data, const Island& island)
{
    const ApproachSpeeds speeds(data, island);
    double first = data.motion.span;
    for (const ContactPoint& c : island.points) {
        if (c.closing_speed > speeds.slowest_blow(slowest_rebound(data, c))) first = std::min(first, c.closes_at);
    }
    return first < data.motion.span ? first : 0.0;
}

/// When an impact comes that was not foreseen, since bodies sped up otherwise than they did before: the first moment at
/// which a gap closes on the ways that were found, evenly sped up; 0 where none does.  [s]
double missed_impact(const RestData& data, const Island& island)
{
    double first = data.motion.span;
    for (const ContactPoint& c : island.points) {
        if (!std::isinf(c.bound)) continue;
        const double way = c.n_x * (data.motion.shift[c.b].x() - data.motion.shift[c.a].x()) +
                           c.n_y * (data.motion.shift[c.b].y() - data.motion.shift[c.a].y()) +
                           (data.motion.turn[c.b] * c.normal_arm_b - data.motion.turn[c.a] * c.normal_arm_a);
        if (!(c.gap + way < -hardly_open(data, c))) continue;
        const double u = normal_speed(c, data.motion.before[c.a], data.motion.before[c.b]);
        const double a = 2.0 * (way - data.motion.span * u) / (data.motion.span * data.motion.span);
        first = std::min(first, time_to_close(c.gap, u, a, data.motion.span));
    }
    return first < data.motion.span ? std::max(first, rest_tolerance::k_at_once * data.motion.span) : 0.0;
}

/// Finds the points that are closed, and where impacts have no moments of their own those that may come to be. True
/// where any of the first approaches.
///
/// within  what closes so soon is closed [s]
bool Impacts::find_closed(const RestData& data, const Island& island, const ApproachSpeeds& speeds, double within)
{
    // [rest.impacts.closed]
    // Find what is closed, or closes; what lands is closed a little early
    const auto is_open = [&](const ContactPoint& c, double approach, double rebound) {
        if (!(c.gap - within * approach > 0.0)) return false;
        const double size = data.bodies.size_of(c.a, c.b);
        const double landed = speeds.lands(approach, rebound) ? rest_tolerance::k_landed * size : 0.0;
        return c.gap > std::max(data.bodies.touch_gap(c.a, c.b), landed);
    };
    const auto approach_of = [&](const ContactPoint& c) {
        return -normal_speed(c, data.motion.before[c.a], data.motion.before[c.b]);
    };
    const auto is_blow = [&](const ContactPoint& c) {
        const double approach = approach_of(c);
        const double rebound = slowest_rebound(data, c);
        return approach > speeds.slowest_blow(rebound) && !is_open(c, approach, rebound);
    };
    if (std::none_of(island.points.begin(), island.points.end(), is_blow)) return false;
    // Corners of two feet that come down at one moment are found open by some digits, each by others
    const auto goes_with_blow = [&](const ContactPoint& c) {
        const auto is_beside = [&](const ContactPoint& struck) {
            return struck.normal == 0.0 && are_of_one_pair(data, c, struck) && is_blow(struck);
        };
        return island.in_turn && approach_of(c) > 0.0 && c.gap <= hardly_open(data, c) &&
               std::any_of(island.points.begin(), island.points.end(), is_beside);
    };
    struck_.clear();
    open_.clear();
    rebounds_.clear();
    blows_.clear();
    for (const ContactPoint& c : island.points) {
        const double rebound = slowest_rebound(data, c);
        if (is_open(c, approach_of(c), rebound) && !goes_with_blow(c)) {
            if (!island.in_turn) open_.push_back(c);
            continue;
        }
        struck_.push_back(c);
        struck_.back().bound = struck_.back().normal = struck_.back().tangent = 0.0;
        blows_.push_back(speeds.slowest_blow(rebound));
        rebounds_.push_back(std::max(blows_.back(), rebound));
    }
    // [rest.impacts.closed]
    return true;
}

/// Any of these points still misses its bound by more than is no blow.
bool Impacts::any_approaches(std::span<const Mover> velocities) const
{
    for (std::size_t k = 0; k < struck_.size(); ++k) {
        const ContactPoint& c = struck_[k];
        if (normal_speed(c, velocities[c.a], velocities[c.b]) < c.bound - blows_[k]) return true;
    }
    return false;
}

bool Impacts::strike(RestData& data, Island& island, HeapSweeps& sweeps)
{
    const std::span<Mover> velocities = data.motion.before;
    const auto closes = [&](const ContactPoint& c) { return normal_speed(c, velocities[c.a], velocities[c.b]) < 0.0; };
    if (std::none_of(island.points.begin(), island.points.end(), closes)) return false;
    const ApproachSpeeds speeds(data, island);
    const double within = island.in_turn ? rest_tolerance::k_at_once * data.motion.span : data.motion.span;
    if (!find_closed(data, island, speeds, within)) return false;

    // In a large heap that falls, blows go to and fro for long after all that matters of them is lost
    const bool is_whole = is_solved_whole(data, island);
    const bool wanes = !is_whole && !is_lossless(island);
    const int rounds = wanes ? rest_tolerance::k_few_sweeps : rest_tolerance::k_patience;
    data.counts.impacts += throw_back(velocities, struck_, rebounds_, speeds.rounding, rounds);
    // What was thrown may close other gaps, and all of them within a step whose impacts have no moments: there it is
    // thrown back in its turn
    const auto is_thrown_on = [&](const ContactPoint& c) {
        const double approach = -normal_speed(c, velocities[c.a], velocities[c.b]);
        return approach > slowest_rebound(data, c) && !(c.gap - within * approach > 0.0);
    };
    // (In a large pile each such look goes over thousands of points; in a row it leads on by one body, to its end.)
    const int looks = !is_large(island) ? rounds : is_chain(data, island) ? island.member_count() : 0;
    for (int k = 1; k < looks && std::any_of(open_.begin(), open_.end(), is_thrown_on); ++k) {
        if (!find_closed(data, island, speeds, within)) break;
        data.counts.impacts += throw_back(velocities, struck_, rebounds_, speeds.rounding, rounds);
    }
    for (const ContactPoint& c : open_) {
        struck_.push_back(c);
        struck_.back().bound = -c.gap / within;
        struck_.back().normal = struck_.back().tangent = 0.0;
        blows_.push_back(speeds.slowest_blow(slowest_rebound(data, c)));
    }
    if (any_approaches(velocities)) {
        if (is_lossless(island)) {
            // An end is not in sight, as in a pit that is packed to the last digit, and would not be in another part of
            // the step: over all of what is left of it the forces of the contacts turn round what approaches
            island.in_turn = false;
            return false;
        }
        end_approaches(data, island, is_whole, sweeps);
    }
    if (island.in_turn) keep_velocities(data, island);
    return true;
}

/// Two bodies by the law of two bodies, as in flight; more at once. Where masses differ widely no solve may end that,
/// and what it leaves could be energy from nothing.
void Impacts::end_approaches(RestData& data, Island& island, bool is_whole, HeapSweeps& sweeps)
{
    const std::span<const int> members = island.members;
    StepMotion& motion = data.motion;
    for (const int member : members) motion.now[member] = motion.before[member];
    if (island.in_turn) strike_lone_pairs(data, island);
    if (is_heap(island)) {
        const double enough = ApproachSpeeds(data, island).slowest_blow(std::numeric_limits<double>::infinity());
        const int rounds = is_large(island) ? rest_tolerance::k_few_sweeps : rest_tolerance::k_patience;
        // Rounds for all at once hardly ever end in a large island, but in a tower or a row
        const bool may_end = is_whole && (!is_large(island) || is_chain(data, island));
        if (!may_end || !stop_at_once(motion.before, struck_, enough, rounds))
            sweeps.sweep_velocities(data, island, motion.before, struck_);
    } else if (!struck_.empty())
        data.solver.solve(motion.before, members, struck_, rest_tolerance::k_residual * top_speed(data, island));
    const double share = neutral_share(data, island, motion.now, motion.before, Way::none);
    if (share < 1.0) take_share(data, island, motion.now, motion.before, Way::none, share);
    island.ended = kinetic_energy(island, motion.now) - kinetic_energy(island, motion.before);
}

/// By the law of two bodies, and without rebound; what is left is struck at once.
void Impacts::strike_lone_pairs(RestData& data, const Island& island)
{
    std::vector<ContactPoint> lone;
    std::vector<ContactPoint> tied;
    std::vector<double> blows;
    for (std::size_t k = 0; k < struck_.size(); ++k) {
        const ContactPoint& c = struck_[k];
        if (!is_of_lone_pair(data, struck_, c)) {
            tied.push_back(c);
            continue;
        }
        lone.push_back(c);
        lone.back().restitution = 0.0;
        blows.push_back(blows_[k]);
    }
    const double rests = ApproachSpeeds(data, island).rounding;
    throw_back(data.motion.before, lone, blows, rests, rest_tolerance::k_patience);
    struck_ = std::move(tied);
}

} // namespace flying
