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
        members += group.member_count;
        points += group.point_count;
        group.member_count = group.point_count = 0;
    }

    // Lay them out, each group in the order of its bodies and pairs
    members_.resize(members);
    points_.resize(points);
    for (const int k : who) {
        Group& group = groups_[slot_[root(k)]];
        members_[group.first_member + group.member_count++] = k;
    }
    for (std::size_t k = 0; k < found_.size(); ++k) {
        Group& group = groups_[slots_[k]];
        points_[group.first_point + group.point_count++] = found_[k];
        group.all_points = group.point_count;
    }
    counts_.groups += static_cast<std::int64_t>(groups_.size());
    counts_.points += points;
}
// [rest.groups]

} // namespace flying
