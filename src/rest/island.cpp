#include "rest/island.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "rest/rest_tolerance.hpp"

namespace flying {
namespace {

/// How many pairs have points, of those that count.
template <typename Counts>
[[nodiscard]] int count_pairs(const Island& island, const Counts& counts)
{
    int pairs = 0;
    int last = -1;
    for (const ContactPoint& c : island.points) {
        if (c.pair != last && counts(c)) ++pairs;
        last = c.pair;
    }
    return pairs;
}

/// How many pairs of bodies that can both be moved have points.
[[nodiscard]] int count_pairs_that_move(const RestData& data, const Island& island)
{
    return count_pairs(island,
                       [&](const ContactPoint& c) { return data.motion.is_moved(c.a) && data.motion.is_moved(c.b); });
}

} // namespace

bool is_lossless(const Island& island)
{
    return std::all_of(island.points.begin(), island.points.end(),
                       [](const ContactPoint& c) { return is_lossless(c); });
}

bool is_heap(const Island& island)
{
    if (island.is_row) return false;
    const int most = is_lossless(island) ? rest_tolerance::k_most_whole : rest_tolerance::k_most_in_detail;
    return island.member_count() > most;
}

bool is_large(const Island& island)
{
    return island.member_count() > rest_tolerance::k_most_whole;
}

bool are_unequal(const RestData& data, std::span<const int> members)
{
    double least = std::numeric_limits<double>::infinity(); // [1/kg]
    double greatest = 0.0;
    for (const int member : members) {
        const double inv_mass = data.bodies.list[member].inertia.inv_mass;
        least = std::min(least, inv_mass);
        greatest = std::max(greatest, inv_mass);
    }
    return greatest > rest_tolerance::k_unequal_masses * least;
}

bool hardly_any_moves(const RestData& data, const Island& island, double share)
{
    const double still = share * field_speed(data, island);
    const auto moves = [&](int member) {
        return greatest_speed(data.motion.before, data.bodies.radius, {&member, 1}) > still;
    };
    return std::count_if(island.members.begin(), island.members.end(), moves) <= rest_tolerance::k_most_in_detail;
}

bool is_chain(const RestData& data, const Island& island)
{
    return 2 * count_pairs_that_move(data, island) < 3 * island.member_count();
}

bool is_loose(const RestData& data, const Island& island)
{
    return !is_large(island) && !is_lossless(island) && count_pairs_that_move(data, island) < island.member_count();
}

bool is_solved_whole(const RestData& data, const Island& island)
{
    if (island.member_count() <= std::min(rest_tolerance::k_most_whole, data.options.most_solved)) return true;
    const bool stands = top_speed(data, island) <= rest_tolerance::k_standing * field_speed(data, island);
    if (!stands && !hardly_any_moves(data, island, rest_tolerance::k_rest_speed)) return false;
    if (island.member_count() <= data.options.most_solved) return true;
    return count_pairs(island, [](const ContactPoint&) { return true; }) <= island.member_count();
}

double greatest_speed(std::span<const Mover> movers, std::span<const double> radius, std::span<const int> members)
{
    double top = 0.0;
    for (const int member : members) {
        const Mover& mover = movers[member];
        top = std::max({top, std::abs(mover.v_x), std::abs(mover.v_y), std::abs(mover.spin) * radius[member]});
    }
    return top;
}

double field_speed(const RestData& data, const Island& island)
{
    double top = 0.0;
    for (const int member : island.members) {
        const Vec2& g = data.motion.field[member];
        top = std::max({top, std::abs(g.x()), std::abs(g.y())});
    }
    return data.motion.span * top;
}

double top_speed(const RestData& data, const Island& island)
{
    return std::max(field_speed(data, island), greatest_speed(data.motion.before, data.bodies.radius, island.members));
}

double solve_rounding(const Island& island)
{
    return rest_tolerance::k_stagnant * rounding_of(island.points, island.members.size());
}

double still_speed(const RestData& data, const Island& island)
{
    return rest_tolerance::k_still * field_speed(data, island) + solve_rounding(island);
}

bool stood(const RestData& data, const Island& island)
{
    return greatest_speed(data.motion.before, data.bodies.radius, island.members) == 0.0;
}

bool any_slip_ended(const Island& island, std::span<const Mover> before, std::span<const Mover> after, double still)
{
    for (const ContactPoint& c : island.points) {
        if (!(c.normal > 0.0) || c.friction == 0.0) continue;
        const double slip = tangent_speed(c, before[c.a], before[c.b]);
        const double slips_on = tangent_speed(c, after[c.a], after[c.b]);
        if (std::abs(slip) > still && (slip > 0.0 ? slips_on <= still : slips_on >= -still)) return true;
    }
    return false;
}

StaticHold static_hold(const RestData& data, std::span<const ContactPoint> points)
{
    StaticHold hold;
    for (const ContactPoint& c : points) {
        if (data.motion.is_moved(c.a) && data.motion.is_moved(c.b)) continue;
        if (!(c.normal > 0.0) && c.gap > data.bodies.touch_gap(c.a, c.b)) continue;
        const Vec2 n(c.n_x, c.n_y);
        if (hold.directions == 0) hold = {1, n};
        else if (std::abs(cross(hold.normal, n)) > rest_tolerance::k_same_normal) return {2, Vec2::Zero()};
    }
    return hold;
}

void set_end_poses(RestData& data, const Island& island, double part)
{
    for (const int member : island.members) data.motion.end_poses[member] = pose_along(data, member, part);
}

void scale_impulses(const Island& island, double factor)
{
    for (ContactPoint& c : island.points) {
        c.normal *= factor;
        c.tangent *= factor;
    }
}

void recall_impulses(const RestData& data, const Island& island)
{
    const double part = data.motion.span / data.whole_step;
    for (ContactPoint& c : island.points) {
        const RestPair& pair = data.pairs.pairs()[c.pair];
        c.normal = part * pair.normal[c.own];
        c.tangent = part * pair.tangent[c.own];
    }
}

} // namespace flying
