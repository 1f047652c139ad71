#include "world/hand_over.hpp"

#include <algorithm>

namespace flying {
namespace {

/// More that have come than this are better sorted into cells.
constexpr std::size_t k_few = 64;
/// So are more than this part of all.
constexpr std::size_t k_share = 16;

/// Sorts the ways of some into cells; entries name places in the list.
void sort_ways(const std::vector<Leaning>& leaning, BoxCells& cells)
{
    std::vector<BoxCells::Entry> boxes;
    for (int k = 0; k < static_cast<int>(leaning.size()); ++k) boxes.push_back({leaning[k].way, k});
    cells.sort(std::move(boxes));
}

} // namespace

void Connections::clear()
{
    nodes_.clear();
    any_is_faster_ = false;
}

int Connections::add(double speed)
{
    const int number = static_cast<int>(nodes_.size());
    nodes_.push_back({number, speed, false});
    return number;
}

int Connections::root_of(int k)
{
    while (nodes_[k].parent != k) k = nodes_[k].parent = nodes_[nodes_[k].parent].parent;
    return k;
}

void Connections::join(int one, int two)
{
    const int p = root_of(one);
    const int q = root_of(two);
    if (p == q) return;
    Node& first = nodes_[std::min(p, q)];
    Node& other = nodes_[std::max(p, q)];
    const double top = std::max(first.top_speed, other.top_speed);
    for (const Node& node : {first, other}) any_is_faster_ = any_is_faster_ || (node.is_known && node.top_speed < top);
    other.parent = std::min(p, q);
    first.top_speed = top;
    first.is_known = first.is_known || other.is_known;
}

void Connections::know_all()
{
    for (Node& node : nodes_) node.is_known = true;
    any_is_faster_ = false;
}

void HandOver::set_asleep(std::vector<Leaning> asleep)
{
    // Find out which may come to each other within a step
    const int count = static_cast<int>(asleep.size());
    looked_at_ += count;
    sort_ways(asleep, ways_asleep_);
    connections_.clear();
    for (const Leaning& one : asleep) connections_.add(one.speed);
    ways_asleep_.for_each_pair(
        [&](const BoxCells::Entry& one, const BoxCells::Entry& two) { connections_.join(one.body, two.body); });

    // Number the islands
    islands_.clear();
    island_.assign(asleep.size(), -1);
    for (int k = 0; k < count; ++k) {
        const int root = connections_.root_of(k); // no later than k
        if (root == k) {
            island_[k] = static_cast<int>(islands_.size());
            islands_.push_back({{}, connections_.top_speed(k), -1});
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
    connections_.clear();
    node_.clear();
    for (const Leaning& one : awake_) node_.push_back(connections_.add(one.speed));
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
            island.node = connections_.add(island.top_speed);
            reached_.push_back(island_[sleeper.body]);
            looked_at_ += static_cast<std::int64_t>(island.members.size());
        }
        connections_.join(node_[k], island.node);
        return true;
    });
}

void HandOver::reach(double time)
{
    time_ = time;
    new_reaches_.clear();
    for (std::size_t k = 0; k < awake_.size(); ++k) add_reach(awake_[k], node_[k]);
    for (const int island : reached_) {
        for (const int member : islands_[island].members) add_reach(asleep_[member], islands_[island].node);
    }
    connections_.know_all();
    reaches_.clear();
    first_new_ = 0;
    end();
}

void HandOver::add_reach(const Leaning& one, int node)
{
    // A blow gives it no more than twice the speed of what strikes it
    const double top = connections_.top_speed(node);
    const double way = time_ * (2.0 * top + one.pull * time_) + (1.0 + k_room) * one.radius;
    new_reaches_.push_back({{one.position - Vec2(way, way), one.position + Vec2(way, way)}, one.body});
}

std::span<const BoxCells::Entry> HandOver::add(const std::vector<Leaning>& more)
{
    const std::size_t first = awake_.size();
    const std::size_t first_island = reached_.size();
    awake_.insert(awake_.end(), more.begin(), more.end());
    if (awake_.size() > static_cast<std::size_t>(sorted_) + static_cast<std::size_t>(sorted_) / k_share + k_few) {
        begin(std::move(awake_));
        reach(time_);
        return reaches_.entries();
    }

    // Connect them
    for (int k = static_cast<int>(first); k < static_cast<int>(awake_.size()); ++k) {
        node_.push_back(connections_.add(awake_[k].speed));
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
    if (connections_.any_is_faster()) {
        reach(time_);
        return reaches_.entries();
    }

    // Nothing reaches further than before but for them, and what they may wake
    first_new_ = new_reaches_.size();
    for (std::size_t k = first; k < awake_.size(); ++k) {
        add_reach(awake_[k], node_[k]);
        connections_.know(node_[k]);
    }
    for (std::size_t i = first_island; i < reached_.size(); ++i) {
        const Island& island = islands_[reached_[i]];
        for (const int member : island.members) add_reach(asleep_[member], island.node);
    }
    return std::span(new_reaches_).subspan(first_new_);
}

void HandOver::end()
{
    if (new_reaches_.empty()) return;
    std::vector<BoxCells::Entry> all = reaches_.entries();
    all.insert(all.end(), new_reaches_.begin(), new_reaches_.end());
    new_reaches_.clear();
    reaches_.sort(std::move(all));
}

bool HandOver::is_near(const Aabb& box) const
{
    return !reaches_.visit_all_at(box, [](const BoxCells::Entry&) { return false; });
}

std::vector<int> HandOver::may_leave(const std::vector<int>& may_go)
{
    const std::vector<BoxCells::Entry>& entries = reaches_.entries();
    std::vector<char> goes;
    for (const BoxCells::Entry& one : entries)
        goes.push_back(std::binary_search(may_go.begin(), may_go.end(), one.body));

    // What stays holds back what is in its reach, and that holds back others
    std::vector<std::size_t> held;
    for (std::size_t k = 0; k < entries.size(); ++k) {
        if (!goes[k]) continue;
        goes[k] = reaches_.visit_all_at(
            entries[k].box, [&](const BoxCells::Entry& other) { return goes[&other - entries.data()] != 0; });
        if (!goes[k]) held.push_back(k);
    }
    for (std::size_t k = 0; k < held.size(); ++k) {
        reaches_.visit_all_at(entries[held[k]].box, [&](const BoxCells::Entry& other) {
            const std::ptrdiff_t place = &other - entries.data();
            if (goes[place]) held.push_back(place);
            goes[place] = 0;
            return true;
        });
    }
    looked_at_ += static_cast<std::int64_t>(may_go.size() + held.size());

    std::vector<int> going;
    for (std::size_t k = 0; k < entries.size(); ++k) {
        if (goes[k]) going.push_back(entries[k].body);
    }
    std::sort(going.begin(), going.end());
    return going;
}

} // namespace flying
