#include "rest/pair_list.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
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

/// A box reaches into a half-plane.
[[nodiscard]] bool overlap(const Aabb& box, const HalfPlane& wall)
{
    const double x = wall.normal.x() > 0.0 ? box.min.x() : box.max.x();
    const double y = wall.normal.y() > 0.0 ? box.min.y() : box.max.y();
    const double height = wall.normal.x() * x + wall.normal.y() * y;
    return height <= wall.offset;
}

} // namespace

bool PairList::all_inside(std::span<const RestBody> bodies, std::span<const double> radius,
                          std::span<const double> reach) const
{
    for (std::size_t k = 0; k < bodies.size(); ++k) {
        const RestBody& body = bodies[k];
        if (body.is_static || !body.is_active) continue;
        const double moved = (body.state.position - homes_[k].position).norm();
        const double turned = std::abs(body.state.angle - homes_[k].angle) * radius[k];
        if (moved + turned + reach[k] > homes_[k].room) return false;
    }
    return true;
}

void PairList::remember(std::vector<RestPair> pairs, int bodies)
{
    pairs_ = std::move(pairs);
    make_index(bodies);
    valid_ = false;
}

bool PairList::update(std::span<const RestBody> bodies, std::span<const CollisionShape> shapes,
                      std::span<const double> radius, std::span<const double> reach)
{
    if (valid_ && all_inside(bodies, radius, reach)) return false;

    homes_.resize(bodies.size());
    boxes_.resize(bodies.size());
    for (std::size_t k = 0; k < bodies.size(); ++k) {
        const RestBody& body = bodies[k];
        const bool moves = !body.is_static && body.is_active;
        const double room =
            moves ? rest_tolerance::k_room_reaches * reach[k] + rest_tolerance::k_room_radii * radius[k] : 0.0;
        homes_[k] = {body.state.position, body.state.angle, room};
        const Aabb box = bounding_box(body.shape, pose_of(body.state));
        boxes_[k] = {box.min - Vec2(room, room), box.max + Vec2(room, room)};
    }
    find_partners(bodies);
    place_parts(bodies, shapes);
    add_pairs(bodies, radius);
    make_index(static_cast<int>(bodies.size()));
    valid_ = true;
    return true;
}

void PairList::find_partners(std::span<const RestBody> bodies)
{
    // Sort the boxes of all that have one into cells
    const int count = static_cast<int>(bodies.size());
    std::vector<BoxCells::Entry> entries;
    entries.reserve(bodies.size());
    for (int k = 0; k < count; ++k) {
        if (bodies[k].is_active && !std::holds_alternative<HalfPlane>(bodies[k].shape))
            entries.push_back({boxes_[k], k});
    }
    cells_.sort(std::move(entries));
    found_.clear();
    cells_.for_each_pair([&](const BoxCells::Entry& one, const BoxCells::Entry& two) {
        if (bodies[one.body].is_static && bodies[two.body].is_static) return;
        found_.emplace_back(std::min(one.body, two.body), std::max(one.body, two.body));
    });

    // Walls without end meet what reaches into them
    for (int w = 0; w < count; ++w) {
        const auto* wall = std::get_if<HalfPlane>(&bodies[w].shape);
        if (!wall || !bodies[w].is_active) continue;
        for (const auto& [box, k] : cells_.entries()) {
            if (!bodies[k].is_static && overlap(box, *wall)) found_.emplace_back(std::min(w, k), std::max(w, k));
        }
    }

    // Sort by the first body, then each few by the second
    partner_start_.assign(count + 1, 0);
    for (const auto& [a, b] : found_) ++partner_start_[a + 1];
    for (int k = 0; k < count; ++k) partner_start_[k + 1] += partner_start_[k];
    partners_.resize(found_.size());
    for (const auto& [a, b] : found_) partners_[partner_start_[a]++] = b;
    for (int k = count; k > 0; --k) partner_start_[k] = partner_start_[k - 1];
    partner_start_[0] = 0;
    for (int k = 0; k < count; ++k) {
        std::sort(partners_.begin() + partner_start_[k], partners_.begin() + partner_start_[k + 1]);
    }
}

void PairList::place_parts(std::span<const RestBody> bodies, std::span<const CollisionShape> shapes)
{
    circles_.clear();
    first_circle_.assign(1, 0);
    for (std::size_t k = 0; k < bodies.size(); ++k) {
        const Pose pose = pose_of(bodies[k].state);
        for (const ConvexPart& part : shapes[k].parts) circles_.push_back({pose * part.centre, part.radius});
        first_circle_.push_back(static_cast<int>(circles_.size()));
    }
}

/// The circles of a body's parts that another body may reach.
///
/// radius  of the other body's bounding circle [m]
/// room    gap that the two may close before one of them leaves its box, with what is watched beyond that [m]
void PairList::find_parts_near(const RestBody& other, double radius, int body, double room,
                               std::vector<int>& parts) const
{
    parts.clear();
    const auto* wall = std::get_if<HalfPlane>(&other.shape);
    for (int k = first_circle_[body]; k < first_circle_[body + 1]; ++k) {
        const Vec2& centre = circles_[k].centre;
        const double distance =
            wall ? wall->normal.dot(centre) - wall->offset : (centre - other.state.position).norm() - radius;
        const bool is_all = first_circle_[body + 1] - first_circle_[body] == 1;
        if (is_all || distance <= circles_[k].radius + room) parts.push_back(k);
    }
}

void PairList::add_pairs(std::span<const RestBody> bodies, std::span<const double> radius)
{
    old_.swap(pairs_);
    pairs_.clear();
    std::size_t next = 0;
    for (int a = 0; a < static_cast<int>(bodies.size()); ++a) {
        for (int i = partner_start_[a]; i < partner_start_[a + 1]; ++i) {
            RestPair pair;
            pair.a = a;
            pair.b = partners_[i];
            const Material material = combine(bodies[a].material, bodies[pair.b].material);
            pair.friction = material.friction;
            pair.restitution = material.restitution;
            const double room =
                homes_[a].room + homes_[pair.b].room + rest_tolerance::k_watch * std::min(radius[a], radius[pair.b]);
            find_parts_near(bodies[pair.b], radius[pair.b], a, room, near_a_);
            find_parts_near(bodies[a], radius[a], pair.b, room, near_b_);
            for (const int one : near_a_) {
                for (const int two : near_b_) {
                    const double clear = circles_[one].radius + circles_[two].radius + room;
                    const bool is_far = (circles_[two].centre - circles_[one].centre).squaredNorm() > clear * clear;
                    if (is_far) continue;
                    pair.part_a = one - first_circle_[a];
                    pair.part_b = two - first_circle_[pair.b];
                    // [rest.pairs.known]
                    // Both lists are in order: what the pair bore is found by walking along
                    while (next < old_.size() && key(old_[next]) < key(pair)) ++next;
                    const bool known = next < old_.size() && key(old_[next]) == key(pair);
                    pairs_.push_back(known ? old_[next] : pair);
                    // [rest.pairs.known]
                }
            }
        }
    }
}

void PairList::make_index(int bodies)
{
    starts_.assign(bodies + 1, 0);
    for (const RestPair& pair : pairs_) ++starts_[pair.a + 1];
    std::partial_sum(starts_.begin(), starts_.end(), starts_.begin());
    second_starts_.assign(bodies + 1, 0);
    for (const RestPair& pair : pairs_) ++second_starts_[pair.b + 1];
    for (int k = 0; k < bodies; ++k) second_starts_[k + 1] += second_starts_[k];
    by_second_.resize(pairs_.size());
    for (int k = 0; k < static_cast<int>(pairs_.size()); ++k) by_second_[second_starts_[pairs_[k].b]++] = k;
    for (int k = bodies; k > 0; --k) second_starts_[k] = second_starts_[k - 1];
    second_starts_[0] = 0;
}

} // namespace flying
