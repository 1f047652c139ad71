#include <algorithm>
#include <cmath>

#include "rest/rest_engine.hpp"

namespace flying {
namespace {


/// [speeds that the field gives in a step] A large group whose bodies are all slower may part.
constexpr double k_slow = 0x1p-4;
/// [steps] Who would not touch within so many, as things go, is not held together by that.
constexpr double k_ahead = 4.0;


} // namespace


int RestEngine::root_of(int body)
{
    while (parent_[body] != body) body = parent_[body] = parent_[parent_[body]];
    return body;
}

/// True where the two were of different groups.
bool RestEngine::join(const ContactPoint& point)
{
    const int one = root_of(point.a);
    const int two = root_of(point.b);
    parent_[std::max(one, two)] = std::min(one, two);
    return one != two;
}

void RestEngine::gather_groups(std::span<const int> who)
{
    // Join bodies that a point connects; a group's root is its lowest body
    for (const int k : who) parent_[k] = k;
    int last = -1;
    for (const ContactPoint& point : found_) {
        if (point.pair == last) continue;
        last = point.pair;
        if (is_moved(point.a) && is_moved(point.b)) join(point);
    }
    part_slow(who);

    // Count members and points
    groups_.clear();
    for (const int k : who) {
        const int r = root_of(k);
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
        if (point.pair != last) slot = slot_[root_of(is_moved(point.a) ? point.a : point.b)];
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
        group.member_count = 0;
    }

    // Lay them out, each group in the order of its bodies and pairs
    members_.resize(members);
    for (const int k : who) {
        Group& group = groups_[slot_[root_of(k)]];
        members_[group.first_member + group.member_count++] = k;
    }
    lay_out_points();
    counts_.groups += static_cast<std::int64_t>(groups_.size());
    counts_.points += points;
}

/// A large group that hardly moves is that of those that bear on each other, or come to: whoever rolls beside it, and
/// touches nobody, would keep all of it awake.
void RestEngine::part_slow(std::span<const int> who)
{
    if (static_cast<int>(who.size()) <= options_.most_solved) return;
    for (const int k : who) slot_[k] = 0;
    for (const int k : who) ++slot_[root_of(k)];
    const auto is_large = [&](int k) { return slot_[root_of(k)] > options_.most_solved; };
    double field = 0.0; // [m/s]
    parts_.clear();
    for (const int k : who) {
        if (!is_large(k)) continue;
        parts_.push_back(k);
        field = std::max(field, span_ * field_size_[k]);
    }
    if (parts_.empty() || greatest_speed(before_, radius_, parts_) > k_slow * field) return;

    const auto holds = [&](const ContactPoint& c) {
        if (c.normal > 0.0 || c.closes_at < span_) return true;
        const double time = k_ahead * span_;
        const double u = normal_speed(c, before_[c.a], before_[c.b]);
        return c.gap + time * (std::min(u, 0.0) + 0.5 * time * std::min(fall_of(c), 0.0)) <= touch_gap(c.a, c.b);
    };
    const auto groups = std::count_if(parts_.begin(), parts_.end(), [&](int k) { return parent_[k] == k; });
    for (const int k : parts_) is_inside_[k] = 1;
    for (const int k : parts_) parent_[k] = k;
    const auto is_between = [&](const ContactPoint& c) { return is_inside_[c.a] != 0 && is_inside_[c.b] != 0; };
    auto parts = static_cast<std::ptrdiff_t>(parts_.size());
    for (const ContactPoint& point : found_) {
        if (is_between(point) && holds(point) && join(point)) --parts;
    }
    if (parts > groups) {
        std::erase_if(found_, [&](const ContactPoint& c) { return is_between(c) && root_of(c.a) != root_of(c.b); });
    }
    for (const int k : parts_) is_inside_[k] = 0;
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


} // namespace flying
