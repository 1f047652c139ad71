#include "events/at_once.hpp"

#include <algorithm>
#include <array>
#include <set>
#include <utility>

#include "events/meeting.hpp"
#include "response/tied_pairs.hpp"

namespace flying {

std::vector<Event> ImpactsAtOnce::put(const BodyRows& bodies, const StaticSurfaces& surfaces,
                                      std::vector<Event> impacts)
{
    // Two bodies that came into each other's sight have both foreseen it; and static ones side by side are struck as
    // one
    const auto never_moves = [&](int id) { return bodies.never_moves(bodies.row_of(id)); };
    const auto struck = [&](int id) { return never_moves(id) ? surfaces.surface_of(id) : id; };
    std::set<std::pair<int, int>> seen;
    std::erase_if(impacts, [&](const Event& impact) {
        return !seen.insert(std::minmax({struck(impact.a), struck(impact.b)})).second;
    });

    const auto tie = [&](int id) { return never_moves(id) ? -1 : id; };
    std::vector<std::array<int, 2>> pairs;
    for (const Event& impact : impacts) pairs.push_back({tie(impact.a), tie(impact.b)});
    std::vector<Event> left;
    for (const std::vector<int>& members : tied_pairs(pairs)) {
        std::vector<Event> group;
        for (const int k : members) group.push_back(impacts[k]);
        if (group.front().time == impacts.front().time) groups_.push_back(std::move(group));
        else left.insert(left.end(), group.begin(), group.end());
    }
    std::reverse(groups_.begin(), groups_.end());
    return left;
}

std::vector<Event> ImpactsAtOnce::take(const BodyRows& bodies)
{
    std::vector<Event> group = std::move(groups_.back());
    groups_.pop_back();
    std::erase_if(group, [&](const Event& impact) { return !bodies.is_current(impact); });
    return group;
}

bool is_at_once(const BodyRows& bodies, const Event& impact, double time)
{
    const int a = bodies.row_of(impact.a);
    const int b = bodies.row_of(impact.b);
    const double speed = bodies.top_speed(a) + bodies.top_speed(b);
    return (impact.time - time) * speed <= touch_tolerance(bodies, a, b, time);
}

} // namespace flying
