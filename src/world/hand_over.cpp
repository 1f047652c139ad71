#include "world/hand_over.hpp"

#include <algorithm>

namespace flying {
namespace {


/// [radii] Room about a body's circle, against rounding and the tolerance of touching.
constexpr double k_room = 0x1p-10;

/// More that have come than this are better sorted into cells.
constexpr std::size_t k_few = 64;

/// Sorts the ways of some into cells; entries name places in the list.
void sort_ways(const std::vector<Leaning>& leaning, BoxCells& cells)
{
    std::vector<BoxCells::Entry> boxes;
    for (int k = 0; k < static_cast<int>(leaning.size()); ++k) boxes.push_back({leaning[k].way, k});
    cells.sort(std::move(boxes));
}


} // namespace


void Connections::begin(int count)
{
    parent_.resize(static_cast<std::size_t>(count));
    for (int k = 0; k < count; ++k) parent_[k] = k;
}

int Connections::add()
{
    parent_.push_back(count());
    return count() - 1;
}

int Connections::root_of(int k)
{
    while (parent_[k] != k) k = parent_[k] = parent_[parent_[k]];
    return k;
}

void Connections::join(int one, int two)
{
    const int p = root_of(one);
    const int q = root_of(two);
    parent_[std::max(p, q)] = std::min(p, q);
}



void HandOver::set_asleep(std::vector<Leaning> asleep)
{
    // Find out which may come to each other within a step
    const int count = static_cast<int>(asleep.size());
    looked_at_ += count;
    sort_ways(asleep, ways_asleep_);
    connections_.begin(count);
    ways_asleep_.for_each_pair(
        [&](const BoxCells::Entry& one, const BoxCells::Entry& two) { connections_.join(one.body, two.body); });

    // Number the islands
    islands_.clear();
    island_.assign(asleep.size(), -1);
    for (int k = 0; k < count; ++k) {
        const int root = connections_.root_of(k); // no later than k
        if (root == k) {
            island_[k] = static_cast<int>(islands_.size());
            islands_.emplace_back();
        }
        island_[k] = island_[root];
        islands_[island_[k]].members.push_back(k);
    }
    asleep_ = std::move(asleep);
    reached_.clear();
}

void HandOver::begin(std::vector<Leaning> awake)
{
    awake_ = std::move(awake);
    sorted_ = static_cast<int>(awake_.size());
    looked_at_ += sorted_;
    sort_ways(awake_, ways_);
    connections_.begin(sorted_);
    node_.resize(awake_.size());
    for (int k = 0; k < sorted_; ++k) node_[k] = k;
    for (const int island : reached_) islands_[island].node = -1;
    reached_.clear();
    ways_.for_each_pair(
        [&](const BoxCells::Entry& one, const BoxCells::Entry& two) { connections_.join(one.body, two.body); });
    for (int k = 0; k < sorted_; ++k) connect_to_sleepers(k);
}

/// The sleeping islands that one may come to within a step.
void HandOver::connect_to_sleepers(int k)
{
    ways_asleep_.visit_all_at(awake_[k].way, [&](const BoxCells::Entry& sleeper) {
        Island& island = islands_[island_[sleeper.body]];
        if (island.node < 0) {
            island.node = connections_.add();
            reached_.push_back(island_[sleeper.body]);
            looked_at_ += static_cast<std::int64_t>(island.members.size());
        }
        connections_.join(node_[k], island.node);
        return true;
    });
}

void HandOver::add(const std::vector<Leaning>& more)
{
    const std::size_t first = awake_.size();
    awake_.insert(awake_.end(), more.begin(), more.end());
    if (awake_.size() - static_cast<std::size_t>(sorted_) > k_few) {
        begin(std::move(awake_));
        return;
    }
    for (int k = static_cast<int>(first); k < static_cast<int>(awake_.size()); ++k) {
        node_.push_back(connections_.add());
        const Aabb& way = awake_[k].way;
        ways_.visit_all_at(way, [&](const BoxCells::Entry& two) {
            connections_.join(node_[k], node_[two.body]);
            return true;
        });
        for (int late = sorted_; late < k; ++late) {
            if (overlap(way, awake_[late].way)) connections_.join(node_[k], node_[late]);
        }
        connect_to_sleepers(k);
    }
}



void HandOver::reach(double time)
{
    // Find how fast the fastest is of those that are connected
    top_speed_.assign(static_cast<std::size_t>(connections_.count()), 0.0);
    for (std::size_t k = 0; k < awake_.size(); ++k) {
        double& top = top_speed_[connections_.root_of(node_[k])];
        top = std::max(top, awake_[k].speed);
    }

    // A blow gives a body no more than twice the speed of what strikes it
    std::vector<BoxCells::Entry> reaches;
    const auto add = [&](const Leaning& one, int node) {
        const double top = top_speed_[connections_.root_of(node)];
        const double way = time * (2.0 * top + one.pull * time) + (1.0 + k_room) * one.radius;
        reaches.push_back({{one.position - Vec2(way, way), one.position + Vec2(way, way)}, one.body});
    };
    for (std::size_t k = 0; k < awake_.size(); ++k) add(awake_[k], node_[k]);
    for (const int island : reached_) {
        for (const int member : islands_[island].members) add(asleep_[member], islands_[island].node);
    }
    reaches_.sort(std::move(reaches));
}

bool HandOver::is_near(const Aabb& box) const
{
    return !reaches_.visit_all_at(box, [](const BoxCells::Entry&) { return false; });
}



std::vector<int> HandOver::may_leave(std::vector<int> may_go) const
{
    const auto goes = [&](int body) { return std::binary_search(may_go.begin(), may_go.end(), body); };
    while (true) {
        std::vector<int> going;
        for (const BoxCells::Entry& one : reaches_.entries()) {
            if (!goes(one.body)) continue;
            const bool stays_clear =
                reaches_.visit_all_at(one.box, [&](const BoxCells::Entry& other) { return goes(other.body); });
            if (stays_clear) going.push_back(one.body);
        }
        std::sort(going.begin(), going.end());
        if (going.size() == may_go.size()) return going;
        may_go = std::move(going);
    }
}


} // namespace flying
