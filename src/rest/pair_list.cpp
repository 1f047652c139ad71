#include "rest/pair_list.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <tuple>
#include <utility>

#include "response/impact.hpp"
#include "rest/rest_tolerance.hpp"

namespace flying {
namespace {

[[nodiscard]] auto key(const RestPair& pair)
{
    return std::tie(pair.a, pair.b, pair.part_a, pair.part_b);
}

[[nodiscard]] bool in_order(const RestPair& one, const RestPair& two)
{
    return key(one) < key(two);
}

/// Moves those that belong there from one list in order to another.
template <typename Belongs>
void move_pairs(std::vector<RestPair>& from, std::vector<RestPair>& to, Belongs&& belongs)
{
    const auto middle = std::ssize(to);
    std::copy_if(from.begin(), from.end(), std::back_inserter(to), belongs);
    if (std::ssize(to) == middle) return;
    std::erase_if(from, belongs);
    std::inplace_merge(to.begin(), to.begin() + middle, to.end(), in_order);
}

/// Puts them in order, each once.
void sort_once(std::vector<std::pair<int, int>>& found)
{
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
}

/// A box reaches into a half-plane.
[[nodiscard]] bool overlap(const Aabb& box, const HalfPlane& wall)
{
    const double x = wall.normal.x() > 0.0 ? box.min.x() : box.max.x();
    const double y = wall.normal.y() > 0.0 ? box.min.y() : box.max.y();
    const double height = wall.normal.x() * x + wall.normal.y() * y;
    return height <= wall.offset;
}

/// The box of a body that may get so far, and beyond it the gap within which others are watched; where it is static,
/// the others have such room.
[[nodiscard]] Aabb roomy_box(const RestBodies& bodies, int body, const Pose& pose, double farthest)
{
    const double room = farthest + (bodies.list[body].is_static ? 0.0 : rest_tolerance::k_watch * bodies.radius[body]);
    const Aabb box = bounding_box(bodies.list[body].shape, pose);
    return {box.min - Vec2(room, room), box.max + Vec2(room, room)};
}

} // namespace

bool may_meet(const RestBodies& bodies, int a, int b, std::span<const double> farthest)
{
    const auto box_of = [&](int body) { return roomy_box(bodies, body, bodies.poses[body], farthest[body]); };
    if (const auto* wall = std::get_if<HalfPlane>(&bodies.list[a].shape)) return overlap(box_of(b), *wall);
    if (const auto* wall = std::get_if<HalfPlane>(&bodies.list[b].shape)) return overlap(box_of(a), *wall);
    return overlap(box_of(a), box_of(b));
}

bool PairList::all_inside(const RestBodies& bodies, std::span<const double> farthest, const BodySet& awake) const
{
    for (const int k : awake.list()) {
        const BodyState& state = bodies.list[k].state;
        const double moved = (state.position - homes_[k].position).norm();
        const double turned = std::abs(state.angle - homes_[k].angle) * bodies.radius[k];
        if (moved + turned + farthest[k] > homes_[k].room) return false;
    }
    return true;
}

void PairList::separate(const RestBodies& bodies, const BodySet& awake)
{
    const auto is_awake = [&](const RestPair& pair) { return awake.has(pair.a) || awake.has(pair.b); };
    const auto is_asleep = [&](const RestPair& pair) { return !is_awake(pair); };
    const auto is_gone = [&](const RestPair& pair) {
        return !bodies.list[pair.a].is_active || !bodies.list[pair.b].is_active;
    };
    const int count = bodies.count();
    awake_.clear_index(count);
    asleep_.clear_index(count);
    std::vector<RestPair> woken;
    move_pairs(asleep_.pairs, woken, is_awake);
    move_pairs(awake_.pairs, asleep_.pairs, is_asleep);
    move_pairs(woken, awake_.pairs, is_awake);
    std::erase_if(asleep_.pairs, is_gone);
    awake_.make_index();
    asleep_.make_index();
}

void PairList::remember(std::vector<RestPair> pairs, const RestBodies& bodies, const BodySet& awake)
{
    awake_.clear_index(bodies.count());
    asleep_.clear_index(bodies.count());
    asleep_.pairs.clear();
    awake_.pairs = std::move(pairs);
    separate(bodies, awake);
    is_new_ = true;
}

std::vector<RestPair> PairList::all() const
{
    std::vector<RestPair> all;
    all.reserve(awake_.pairs.size() + asleep_.pairs.size());
    std::merge(awake_.pairs.begin(), awake_.pairs.end(), asleep_.pairs.begin(), asleep_.pairs.end(),
               std::back_inserter(all), in_order);
    return all;
}

int PairList::update(const RestBodies& bodies, const PairReach& reach, const BodySet& awake)
{
    if (!is_new_ && is_valid_ && all_inside(bodies, reach.farthest, awake)) return 0;
    boxes_sorted_ = 0;
    if (is_new_) {
        search_all(bodies, reach);
        separate(bodies, awake);
    } else search(bodies, reach, awake);
    return boxes_sorted_;
}

/// For the pairs of all that move, those that sleep too.
void PairList::search_all(const RestBodies& bodies, const PairReach& reach)
{
    const int count = bodies.count();
    homes_.resize(bodies.list.size());
    boxes_.resize(bodies.list.size());
    walls_.clear();
    first_circle_.assign(1, 0);
    for (const CollisionShape& shape : bodies.shapes)
        first_circle_.push_back(first_circle_.back() + static_cast<int>(shape.parts.size()));
    circles_.resize(first_circle_.back());
    std::vector<int> movers;
    for (int k = 0; k < count; ++k) {
        const RestBody& body = bodies.list[k];
        if (std::holds_alternative<HalfPlane>(body.shape)) walls_.push_back(k);
        if (body.is_static) make_box(bodies, k, 0.0);
        else if (body.is_active) movers.push_back(k);
    }
    BodySet all(count);
    all.insert(movers);
    awake_.clear_index(count);
    asleep_.clear_index(count);
    awake_.pairs = this->all();
    asleep_.pairs.clear();
    sort_others(bodies, all);
    search(bodies, reach, all);
    is_new_ = false;
}

/// For the pairs of some, among which are all that may have left their boxes; all pairs of theirs are known as `pairs`.
void PairList::search(const RestBodies& bodies, const PairReach& reach, const BodySet& movers)
{
    // What was searched for last has another box by now than when the others were sorted
    const auto is_other = [&](int k) { return bodies.list[k].is_active && !movers.has(k); };
    if (std::any_of(searched_.begin(), searched_.end(), is_other)) sort_others(bodies, movers);
    searched_.assign(movers.list().begin(), movers.list().end());

    for (const int k : movers.list()) {
        const double room = std::max(rest_tolerance::k_room_reaches * reach.usual[k], reach.farthest[k]);
        make_box(bodies, k, room);
    }
    find_partners(bodies, movers);
    awake_.clear_index(bodies.count());
    add_pairs(bodies);
    awake_.make_index();
    is_valid_ = true;
}

/// room  that the body has in it [m]
void PairList::make_box(const RestBodies& bodies, int k, double room)
{
    const BodyState& state = bodies.list[k].state;
    const Pose pose = pose_of(state);
    homes_[k] = {state.position, state.angle, room};
    put_circles(bodies, k, pose, circles_);
    boxes_[k] = roomy_box(bodies, k, pose, room);
}

void PairList::put_circles(const RestBodies& bodies, int k, const Pose& pose, std::vector<PartCircle>& circles) const
{
    int circle = first_circle_[k];
    for (const ConvexPart& part : bodies.shapes[k].parts) circles[circle++] = {pose * part.centre, part.radius};
}

void PairList::sort_others(const RestBodies& bodies, const BodySet& movers)
{
    std::vector<BoxCells::Entry> entries;
    for (int k = 0; k < bodies.count(); ++k) {
        const RestBody& body = bodies.list[k];
        const bool has_box = body.is_active && !std::holds_alternative<HalfPlane>(body.shape);
        if (has_box && !movers.has(k)) entries.push_back({boxes_[k], k});
    }
    boxes_sorted_ += static_cast<int>(entries.size());
    others_.sort(std::move(entries));
}

void PairList::find_partners(const RestBodies& bodies, const BodySet& movers)
{
    // Sort the boxes of those that are searched for into cells
    std::vector<BoxCells::Entry> entries;
    entries.reserve(movers.list().size());
    for (const int k : movers.list()) entries.push_back({boxes_[k], k});
    boxes_sorted_ += static_cast<int>(entries.size());
    cells_.sort(std::move(entries));
    found_.clear();
    cells_.for_each_pair([&](const BoxCells::Entry& one, const BoxCells::Entry& two) {
        found_.emplace_back(std::minmax(one.body, two.body));
    });
    for (const BoxCells::Entry& entry : cells_.entries()) find_partners_among(others_, entry, bodies, movers, found_);
    sort_once(found_);
}

/// The others stay where they are, and walls without end meet what reaches into them.
void PairList::find_partners_among(const BoxCells& others, const BoxCells::Entry& entry, const RestBodies& bodies,
                                   const BodySet& movers, std::vector<std::pair<int, int>>& found) const
{
    others.visit_all_at(entry.box, [&](const BoxCells::Entry& other) {
        if (bodies.list[other.body].is_active && !movers.has(other.body))
            found.emplace_back(std::minmax(entry.body, other.body));
        return true;
    });
    for (const int wall : walls_) {
        if (overlap(entry.box, std::get<HalfPlane>(bodies.list[wall].shape)))
            found.emplace_back(std::minmax(entry.body, wall));
    }
}

std::vector<RestPair> PairList::pairs_at(std::span<const BodyPose> placed, const RestBodies& bodies) const
{
    // Find the bodies whose boxes overlap theirs
    std::vector<BoxCells::Entry> boxes;
    std::vector<int> movers;
    for (const auto& [body, pose] : placed) {
        boxes.push_back({bounding_box(bodies.list[body].shape, pose), body});
        movers.push_back(body);
    }
    BodySet moved(bodies.count());
    moved.insert(movers);
    BoxCells cells;
    cells.sort(std::move(boxes));
    std::vector<std::pair<int, int>> found;
    cells.for_each_pair([&](const BoxCells::Entry& one, const BoxCells::Entry& two) {
        found.emplace_back(std::minmax(one.body, two.body));
    });
    for (const BoxCells::Entry& entry : cells.entries()) {
        find_partners_among(cells_, entry, bodies, moved, found);
        find_partners_among(others_, entry, bodies, moved, found);
    }
    sort_once(found);

    // List the parts of the two whose circles come near
    std::vector<PartCircle> circles = circles_;
    for (const auto& [body, pose] : placed) put_circles(bodies, body, pose, circles);
    std::vector<RestPair> pairs;
    for (const auto& [a, b] : found) {
        const double room = (moved.has(a) ? 0.0 : homes_[a].room) + (moved.has(b) ? 0.0 : homes_[b].room) +
                            rest_tolerance::k_watch * bodies.size_of(a, b);
        for (int one = first_circle_[a]; one < first_circle_[a + 1]; ++one) {
            for (int two = first_circle_[b]; two < first_circle_[b + 1]; ++two) {
                if (!are_near(circles[one], circles[two], room)) continue;
                RestPair& pair = pairs.emplace_back();
                pair.a = a;
                pair.b = b;
                pair.part_a = one - first_circle_[a];
                pair.part_b = two - first_circle_[b];
            }
        }
    }
    return pairs;
}

/// The circles of a body's parts that another body may reach.
///
/// room  gap that the two may close before one of them leaves its box, with what is watched beyond that [m]
void PairList::find_parts_near(const RestBodies& bodies, int other, int body, double room,
                               std::vector<int>& parts) const
{
    parts.clear();
    const auto* wall = std::get_if<HalfPlane>(&bodies.list[other].shape);
    const Vec2& place = bodies.list[other].state.position;
    const double radius = bodies.radius[other];
    for (int k = first_circle_[body]; k < first_circle_[body + 1]; ++k) {
        const Vec2& centre = circles_[k].centre;
        const double distance = wall ? wall->normal.dot(centre) - wall->offset : (centre - place).norm() - radius;
        const bool is_all = first_circle_[body + 1] - first_circle_[body] == 1;
        if (is_all || distance <= circles_[k].radius + room) parts.push_back(k);
    }
}

void PairList::add_pairs(const RestBodies& bodies)
{
    old_.swap(awake_.pairs);
    std::vector<RestPair>& pairs = awake_.pairs;
    pairs.clear();
    std::size_t next = 0;
    for (const auto& [a, b] : found_) {
        RestPair pair;
        pair.a = a;
        pair.b = b;
        const Material material = combine(bodies.list[a].material, bodies.list[b].material);
        pair.friction = material.friction;
        pair.restitution = material.restitution;
        const double room = homes_[a].room + homes_[b].room + rest_tolerance::k_watch * bodies.size_of(a, b);
        find_parts_near(bodies, b, a, room, near_a_);
        find_parts_near(bodies, a, b, room, near_b_);
        for (const int one : near_a_) {
            for (const int two : near_b_) {
                if (!are_near(circles_[one], circles_[two], room)) continue;
                pair.part_a = one - first_circle_[a];
                pair.part_b = two - first_circle_[b];
                // [rest.pairs.known]
                // Both lists are in order: what the pair bore is found by walking along
                while (next < old_.size() && key(old_[next]) < key(pair)) ++next;
                const bool known = next < old_.size() && key(old_[next]) == key(pair);
                pairs.push_back(known ? old_[next] : pair);
                // [rest.pairs.known]
            }
        }
    }
}

void PairList::Pairs::clear_index(int bodies)
{
    firsts.resize(bodies, -1);
    seconds.resize(bodies, -1);
    for (const RestPair& pair : pairs) firsts[pair.a] = seconds[pair.b] = -1;
}

void PairList::Pairs::make_index()
{
    const int count = static_cast<int>(pairs.size());
    ends.resize(count);
    next_of_second.resize(count);
    for (int k = count - 1; k >= 0; --k) {
        const RestPair& pair = pairs[k];
        const bool goes_on = k + 1 < count && pairs[k + 1].a == pair.a && pairs[k + 1].b == pair.b;
        ends[k] = goes_on ? ends[k + 1] : k + 1;
        next_of_second[k] = goes_on ? next_of_second[k + 1] : seconds[pair.b];
        firsts[pair.a] = seconds[pair.b] = k;
    }
}

} // namespace flying
