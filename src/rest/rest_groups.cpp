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
    for (const ContactPoint& point : found_) {
        if (bodies_[point.a].is_static || bodies_[point.b].is_static) continue;
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
    const auto slot_of = [&](const ContactPoint& point) {
        return slot_[root(bodies_[point.a].is_static ? point.b : point.a)];
    };
    for (const ContactPoint& point : found_) ++groups_[slot_of(point)].point_count;
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
    for (const ContactPoint& point : found_) {
        Group& group = groups_[slot_of(point)];
        points_[group.first_point + group.point_count++] = point;
        group.all_points = group.point_count;
    }
    counts_.groups += static_cast<std::int64_t>(groups_.size());
    counts_.points += points;
}
// [rest.groups]

} // namespace flying
