#include "world/hand_over.hpp"

#include <algorithm>

namespace flying {
namespace {


/// [radii] Room about a body's circle, against rounding and the tolerance of touching.
constexpr double k_room = 0x1p-10;

/// More that have come than this are better sorted into cells.
constexpr std::size_t k_few = 64;


} // namespace


void HandOver::begin(std::vector<Leaning> leaning)
{
    leaning_ = std::move(leaning);
    sorted_ = static_cast<int>(leaning_.size());
    std::vector<BoxCells::Entry> boxes;
    parent_.resize(leaning_.size());
    for (int k = 0; k < sorted_; ++k) {
        parent_[k] = k;
        boxes.push_back({leaning_[k].way, k});
    }
    ways_.sort(std::move(boxes));
    for (const BoxCells::Entry& one : ways_.entries()) {
        ways_.visit_all_at(one.box, [&](const BoxCells::Entry& two) {
            if (two.body < one.body) join(one.body, two.body);
            return true;
        });
    }
}

void HandOver::add(std::vector<Leaning> more)
{
    const std::size_t first = leaning_.size();
    leaning_.insert(leaning_.end(), more.begin(), more.end());
    if (leaning_.size() - sorted_ > k_few) {
        begin(std::move(leaning_));
        return;
    }
    for (int k = static_cast<int>(first); k < static_cast<int>(leaning_.size()); ++k) {
        parent_.push_back(k);
        const Aabb& way = leaning_[k].way;
        ways_.visit_all_at(way, [&](const BoxCells::Entry& two) {
            join(k, two.body);
            return true;
        });
        for (int late = sorted_; late < k; ++late) {
            if (overlap(way, leaning_[late].way)) join(k, late);
        }
    }
}

int HandOver::root_of(int k)
{
    while (parent_[k] != k) k = parent_[k] = parent_[parent_[k]];
    return k;
}

void HandOver::join(int one, int two)
{
    const int p = root_of(one);
    const int q = root_of(two);
    parent_[std::max(p, q)] = std::min(p, q);
}



void HandOver::reach(double time)
{
    islands_.assign(leaning_.size(), {});
    for (int k = 0; k < static_cast<int>(leaning_.size()); ++k) {
        Island& island = islands_[root_of(k)];
        island.top_speed = std::max(island.top_speed, leaning_[k].speed);
        island.is_awake = island.is_awake || leaning_[k].is_awake;
    }
    std::vector<BoxCells::Entry> reaches;
    for (int k = 0; k < static_cast<int>(leaning_.size()); ++k) {
        const Leaning& one = leaning_[k];
        const Island& island = islands_[root_of(k)];
        if (!island.is_awake) continue;

        // A blow gives it no more than twice the speed of what strikes it
        const double way = time * (2.0 * island.top_speed + one.pull * time) + (1.0 + k_room) * one.radius;
        reaches.push_back({{one.position - Vec2(way, way), one.position + Vec2(way, way)}, one.body});
    }
    reaches_.sort(std::move(reaches));
}

bool HandOver::is_near(const Aabb& box) const
{
    return !reaches_.visit_all_at(box, [](const BoxCells::Entry&) { return false; });
}



std::vector<int> HandOver::may_leave(std::vector<char> may_go) const
{
    std::vector<int> going;
    for (bool changed = true; changed;) {
        changed = false;
        going.clear();
        for (const BoxCells::Entry& one : reaches_.entries()) {
            if (!may_go[one.body]) continue;
            const bool stays_clear =
                reaches_.visit_all_at(one.box, [&](const BoxCells::Entry& other) { return may_go[other.body] != 0; });
            if (stays_clear) {
                going.push_back(one.body);
            } else {
                may_go[one.body] = 0;
                changed = true;
            }
        }
    }
    std::sort(going.begin(), going.end());
    return going;
}


} // namespace flying
