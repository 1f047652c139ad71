#include "rest/meetings.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "rest/find_contacts.hpp"
#include "rest/rest_tolerance.hpp"

namespace flying {
namespace {

/// The lowest point of a pair; one of this gap where there is none as low.
[[nodiscard]] Contact lowest_point(const RestData& data, const RestPair& pair, const BodyState& a, const BodyState& b,
                                   double gap)
{
    const Manifold manifold = look(data, pair, pose_of(a), pose_of(b), gap);
    Contact lowest;
    lowest.separation = gap;
    for (int k = 0; k < manifold.count; ++k) {
        if (manifold.contacts[k].separation < lowest.separation) lowest = manifold.contacts[k];
    }
    return lowest;
}

} // namespace

double way_since(const RestData& data, const BodyBefore& before, int body)
{
    const BodyState& now = data.bodies.list[body].state;
    const double arc = std::abs(now.angle - before.state.angle) * data.bodies.turning[body];
    return (now.position - before.state.position).norm() + arc;
}

bool find_meetings(const RestData& data, std::span<const RestPair> pairs, std::span<const BodyBefore> before,
                   const BodySet& moved, Meetings& met)
{
    double first = data.motion.span;
    const std::size_t islands_before = met.islands.size();
    const auto state_before = [&](int body) {
        return moved.has(body) ? before[body].state : data.bodies.list[body].state;
    };
    const auto thrown_at = [&](int body) {
        return moved.has(body) ? before[body].thrown_at : std::numeric_limits<double>::infinity();
    };
    for (const RestPair& pair : pairs) {
        const double size = data.bodies.size_of(pair.a, pair.b);
        const BodyState& a = data.bodies.list[pair.a].state;
        const BodyState& b = data.bodies.list[pair.b].state;
        const Contact deepest = lowest_point(data, pair, a, b, 0.0);
        const double depth = -deepest.separation;
        if (!(depth > rest_tolerance::k_most_overlap * data.bodies.breadth_of(pair.a, pair.b))) continue;

        // What met nothing that it knew of came in as fast as it now goes. If it goes out again, the gap closed evenly
        const double ago = depth / -opening_speed(deepest, a, b);
        double when = data.motion.span - ago;
        if (!(ago > 0.0 && when > 0.0)) {
            const double gap = lowest_point(data, pair, state_before(pair.a), state_before(pair.b), size).separation;
            when = (gap > 0.0 ? gap / (gap + depth) : 0.5) * data.motion.span;
        }
        // It came after the blow that threw one of them
        const double thrown = std::min(thrown_at(pair.a), thrown_at(pair.b));
        if (thrown < data.motion.span && when <= thrown)
            when = thrown + rest_tolerance::k_blow * (data.motion.span - thrown);
        first = std::min(first, when);
        for (const int body : {pair.a, pair.b}) {
            if (moved.has(body)) met.islands.push_back(before[body].island);
            else if (!data.bodies.list[body].is_static) met.sleepers.push_back(body);
        }
    }
    if (met.islands.size() == islands_before) return false;
    std::sort(met.islands.begin(), met.islands.end());
    met.moments.insert(std::upper_bound(met.moments.begin(), met.moments.end(), first), first);
    return true;
}

} // namespace flying
