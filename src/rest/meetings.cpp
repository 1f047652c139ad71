#include "rest/meetings.hpp"

#include <algorithm>
#include <cmath>

#include "rest/find_contacts.hpp"
#include "rest/rest_tolerance.hpp"

namespace flying {
namespace {

/// The lowest gap of a pair; `margin` where it is greater.  [m]
[[nodiscard]] double gap_of(const RestData& data, const RestPair& pair, const BodyState& a, const BodyState& b,
                            double margin)
{
    const Manifold manifold = look(data, pair, pose_of(a), pose_of(b), margin);
    double least = margin;
    for (int k = 0; k < manifold.count; ++k) least = std::min(least, manifold.contacts[k].separation);
    return least;
}

} // namespace

double way_since(const RestData& data, const BodyBefore& before, int body)
{
    const BodyState& now = data.bodies.list[body].state;
    const double arc = std::abs(now.angle - before.state.angle) * data.bodies.turning[body];
    return (now.position - before.state.position).norm() + arc;
}

Meetings find_meetings(const RestData& data, std::span<const BodyBefore> before, const BodySet& moved)
{
    Meetings meetings{data.motion.span, {}};
    const auto is_thrown = [&](int body) {
        return moved.has(body) && way_since(data, before[body], body) > before[body].reach;
    };
    const auto state_before = [&](int body) {
        return moved.has(body) ? before[body].state : data.bodies.list[body].state;
    };
    for (const RestPair& pair : data.pairs.pairs()) {
        if (!is_thrown(pair.a) && !is_thrown(pair.b)) continue;
        const double size = std::min(data.bodies.radius[pair.a], data.bodies.radius[pair.b]);
        const double depth = -gap_of(data, pair, data.bodies.list[pair.a].state, data.bodies.list[pair.b].state, 0.0);
        if (!(depth > rest_tolerance::k_most_overlap * size)) continue;

        // As if the gap had closed evenly
        const double gap = gap_of(data, pair, state_before(pair.a), state_before(pair.b), size);
        const double share = gap > 0.0 ? gap / (gap + depth) : 0.5;
        meetings.first = std::min(meetings.first, share * data.motion.span);
        for (const int body : {pair.a, pair.b}) {
            if (moved.has(body)) meetings.islands.push_back(before[body].island);
        }
    }
    std::sort(meetings.islands.begin(), meetings.islands.end());
    return meetings;
}

} // namespace flying
