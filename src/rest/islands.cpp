#include "rest/islands.hpp"

#include <algorithm>
#include <numeric>

#include "rest/rest_tolerance.hpp"

namespace flying {

bool goes_far(const RestData& data, int body)
{
    const double speed = greatest_speed(data.motion.before, data.bodies.radius, {&body, 1});
    return data.motion.span * speed > rest_tolerance::k_fair_overlap * data.bodies.breadth[body];
}

// [rest.islands.holds]
bool holds(const RestData& data, const ContactPoint& c, double fall)
{
    const StepMotion& motion = data.motion;
    if (is_lossless(c) || c.normal > 0.0 || c.closes_at < motion.span) return true;
    const double time = motion.span;
    const double u = normal_speed(c, motion.before[c.a], motion.before[c.b]);
    return c.gap + time * (std::min(u, 0.0) - 0.5 * time * fall) <= data.bodies.touch_gap(c.a, c.b);
}
// [rest.islands.holds]

int Islands::root_of(int body)
{
    while (parent_[body] != body) body = parent_[body] = parent_[parent_[body]];
    return body;
}

/// True where the two were of different islands. An island's root is its lowest body.
bool Islands::join(const ContactPoint& point)
{
    const int one = root_of(point.a);
    const int two = root_of(point.b);
    parent_[std::max(one, two)] = std::min(one, two);
    return one != two;
}

void Islands::split(const RestData& data, std::span<const int> bodies, std::vector<ContactPoint>& found)
{
    const StepMotion& motion = data.motion;
    parent_.resize(data.bodies.list.size());
    slot_.resize(data.bodies.list.size());
    is_inside_.resize(data.bodies.list.size());
    // [rest.islands.join]
    for (const int k : bodies) parent_[k] = k;
    int last = -1;
    for (const ContactPoint& point : found) {
        if (point.pair == last) continue;
        last = point.pair;
        if (motion.is_moved(point.a) && motion.is_moved(point.b)) join(point);
    }
    // [rest.islands.join]
    part_slow(data, bodies, found);
    count(motion, bodies, found);
    lay_out(bodies, found);
    for (Island& island : islands_) island.is_row = is_lossless(island) && is_row(motion, island);
}

/// No body meets more than two others that move, and none presses on another: blows to what is pressed never end.
bool Islands::is_row(const StepMotion& motion, const Island& island)
{
    for (const int member : island.members) slot_[member] = 0;
    int last = -1;
    for (const ContactPoint& point : island.points) {
        if (!motion.is_moved(point.a) || !motion.is_moved(point.b)) continue;
        if (point.normal > 0.0) return false;
        if (point.pair == last) continue;
        last = point.pair;
        if (++slot_[point.a] > 2 || ++slot_[point.b] > 2) return false;
    }
    return true;
}

/// Numbers the islands, and counts their members and points: as many as begin before each.
void Islands::count(const StepMotion& motion, std::span<const int> bodies, std::span<const ContactPoint> found)
{
    islands_.clear();
    first_member_.assign(1, 0);
    for (const int k : bodies) {
        const int root = root_of(k);
        if (root == k) {
            slot_[k] = static_cast<int>(islands_.size());
            islands_.emplace_back();
            first_member_.push_back(0);
        }
        ++first_member_[slot_[root] + 1];
    }
    first_point_.assign(first_member_.size(), 0);
    slots_.clear();
    int last = -1;
    int slot = 0;
    for (const ContactPoint& point : found) {
        if (point.pair != last) slot = slot_[root_of(motion.is_moved(point.a) ? point.a : point.b)];
        last = point.pair;
        slots_.push_back(slot);
        ++first_point_[slot + 1];
    }
    std::partial_sum(first_member_.begin(), first_member_.end(), first_member_.begin());
    std::partial_sum(first_point_.begin(), first_point_.end(), first_point_.begin());
}

/// Puts members and points where those of their islands stand.
void Islands::lay_out(std::span<const int> bodies, std::vector<ContactPoint>& found)
{
    members_.resize(bodies.size());
    next_ = first_member_;
    for (const int k : bodies) members_[next_[slot_[root_of(k)]]++] = k;
    if (islands_.size() == 1 ||
        (!found.empty() && first_point_[slots_[0] + 1] - first_point_[slots_[0]] == found.size())) {
        points_.swap(found); // all of one island, in order
    } else {
        points_.resize(found.size());
        next_ = first_point_;
        for (std::size_t k = 0; k < found.size(); ++k) points_[next_[slots_[k]]++] = found[k];
    }
    for (std::size_t k = 0; k < islands_.size(); ++k) {
        islands_[k].members = std::span(members_).subspan(first_member_[k], first_member_[k + 1] - first_member_[k]);
        islands_[k].points = std::span(points_).subspan(first_point_[k], first_point_[k + 1] - first_point_[k]);
    }
}

/// A large island in which nothing gets further in the step than an overlap that matters is made of bodies that bear on
/// each other, or come to: one that rolls beside the others, and touches none, would keep all of them awake.
void Islands::part_slow(const RestData& data, std::span<const int> bodies, std::vector<ContactPoint>& found)
{
    const StepMotion& motion = data.motion;
    const int most = std::min(rest_tolerance::k_most_whole, data.options.most_solved);
    if (static_cast<int>(bodies.size()) <= most) return;
    for (const int k : bodies) slot_[k] = 0;
    for (const int k : bodies) ++slot_[root_of(k)];
    parts_.clear();
    for (const int k : bodies) {
        if (slot_[root_of(k)] > most) parts_.push_back(k);
    }
    if (parts_.empty()) return;
    if (std::any_of(parts_.begin(), parts_.end(), [&](int k) { return goes_far(data, k); })) return;

    const auto wholes = std::count_if(parts_.begin(), parts_.end(), [&](int k) { return parent_[k] == k; });
    for (const int k : parts_) is_inside_[k] = 1;
    for (const int k : parts_) parent_[k] = k;
    const auto is_between = [&](const ContactPoint& c) { return is_inside_[c.a] != 0 && is_inside_[c.b] != 0; };
    auto parts = static_cast<std::ptrdiff_t>(parts_.size());
    for (const ContactPoint& point : found) {
        const double fall = motion.field_size[point.a] + motion.field_size[point.b]; // where one is held, too
        if (is_between(point) && holds(data, point, fall) && join(point)) --parts;
    }
    if (parts > wholes) {
        std::erase_if(found, [&](const ContactPoint& c) { return is_between(c) && root_of(c.a) != root_of(c.b); });
    }
    for (const int k : parts_) is_inside_[k] = 0;
}

} // namespace flying
