#include <algorithm>

#include "rest/rest_engine.hpp"

namespace flying {

// [rest.groups]
void RestEngine::gather_groups(std::span<const int> who)
{
    // Join bodies that a point connects; a group's root is its lowest body
    for (const int k : who) parent_[k] = k;
    const auto root = [&](int k) {
        while (parent_[k] != k) k = parent_[k] = parent_[parent_[k]];
        return k;
    };
    int last = -1;
    for (const ContactPoint& point : found_) {
        if (point.pair == last) continue;
        last = point.pair;
        if (!is_moved(point.a) || !is_moved(point.b)) continue;
        const int one = root(point.a);
        const int two = root(point.b);
        parent_[std::max(one, two)] = std::min(one, two);
    }

    // Count members and points
    groups_.clear();
    for (const int k : who) {
        const int r = root(k);
        if (r == k) {
            slot_[k] = static_cast<int>(groups_.size());
            groups_.emplace_back();
        }
        ++groups_[slot_[r]].member_count;
    }
    slots_.clear();
    last = -1;
    int slot = 0;
    for (const ContactPoint& point : found_) {
        if (point.pair != last) slot = slot_[root(is_moved(point.a) ? point.a : point.b)];
        last = point.pair;
        slots_.push_back(slot);
        ++groups_[slot].point_count;
    }
    int members = 0;
    int points = 0;
    for (Group& group : groups_) {
        group.first_member = members;
        group.first_point = points;
        group.all_points = group.point_count;
        members += group.member_count;
        points += group.point_count;
        group.member_count = 0;
    }

    // Lay them out, each group in the order of its bodies and pairs
    members_.resize(members);
    for (const int k : who) {
        Group& group = groups_[slot_[root(k)]];
        members_[group.first_member + group.member_count++] = k;
    }
    lay_out_points();
    counts_.groups += static_cast<std::int64_t>(groups_.size());
    counts_.points += points;
}

/// Points by groups, from those that were found, which are used up.
void RestEngine::lay_out_points()
{
    const int count = static_cast<int>(found_.size());
    if (count > 0 && groups_[slots_[0]].point_count == count) { // all of one group, in order
        points_.swap(found_);
        return;
    }
    points_.resize(found_.size());
    for (Group& group : groups_) group.point_count = 0;
    for (int k = 0; k < count; ++k) {
        Group& group = groups_[slots_[k]];
        points_[group.first_point + group.point_count++] = found_[k];
    }
}
// [rest.groups]

} // namespace flying
