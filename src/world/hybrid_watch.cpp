#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "toi/central_flight.hpp"
#include "world/hybrid.hpp"

namespace flying {
namespace {

/// [radii] Room about a body's circle, against rounding and the tolerance of touching.
constexpr double k_room = 0x1p-10;
/// [radii] Room about the way of a body in a step, within which the resting integrator watches for contacts.
constexpr double k_near = 0x1p-6;

} // namespace

// [hybrid.watch]
/// Find where those that lean, and those that they may wake, can get before the step ends.
void Hybrid::find_reaches()
{
    // Only what belongs to those that rest is touched: there may be few of them among many
    islands_.resize(hands_.size());
    for (const int k : rests_) islands_[k] = {};
    for (const int k : rests_) {
        Island& island = islands_[island_of(k)];
        island.top_speed = std::max(island.top_speed, rest_.state(k).velocity.norm());
        island.is_awake = island.is_awake || !rest_.is_asleep(k);
    }
    std::vector<BoxCells::Entry> reaches;
    const double left = step_ends_ - rest_.time();
    for (const int k : rests_) {
        const Island& island = islands_[island_of(k)];
        if (!island.is_awake) continue;

        // A blow gives it no more than twice the speed of what strikes it
        const Vec2 x = rest_.state(k).position;
        const double fall = greatest_pull(x) * left;
        const double way = left * (2.0 * island.top_speed + fall) + (1.0 + k_room) * radius_[k];
        reaches.push_back({{x - Vec2(way, way), x + Vec2(way, way)}, k});
    }
    reaches_.sort(std::move(reaches));
}

/// Join those that rest, awake or asleep, whose ways within a step come together.
void Hybrid::find_islands()
{
    island_.resize(hands_.size());
    std::vector<BoxCells::Entry> boxes;
    for (const int k : rests_) {
        island_[k] = k;
        boxes.push_back({way_of(k), k});
    }
    ways_.sort(std::move(boxes));
    late_ways_.clear();
    for (const BoxCells::Entry& one : ways_.entries()) {
        ways_.visit_all_at(one.box, [&](const BoxCells::Entry& two) {
            if (two.body < one.body) join_islands(one.body, two.body);
            return true;
        });
    }
}

/// The same for some who have come since the islands were found.
void Hybrid::add_to_islands(const std::vector<int>& bodies)
{
    constexpr std::size_t k_few = 64; // more are better sorted into cells
    if (late_ways_.size() + bodies.size() > k_few) {
        find_islands();
        return;
    }
    for (const int k : bodies) {
        island_[k] = k;
        const BoxCells::Entry one{way_of(k), k};
        ways_.visit_all_at(one.box, [&](const BoxCells::Entry& two) {
            join_islands(k, two.body);
            return true;
        });
        for (const BoxCells::Entry& two : late_ways_) {
            if (overlap(one.box, two.box)) join_islands(k, two.body);
        }
        late_ways_.push_back(one);
    }
}

int Hybrid::island_of(int k)
{
    while (island_[k] != k) k = island_[k] = island_[island_[k]];
    return k;
}

void Hybrid::join_islands(int one, int two)
{
    const int p = island_of(one);
    const int q = island_of(two);
    island_[std::max(p, q)] = std::min(p, q);
}

/// Where a body that rests may get within a whole step, as it moves now.
Aabb Hybrid::way_of(int k) const
{
    const RestBody& body = rest_.body(k);
    const double speed = body.state.velocity.norm() + std::abs(body.state.spin) * radius_[k];
    const double way = setting_.step * (speed + setting_.step * greatest_pull(body.state.position)) + k_near * radius_[k];
    const bool is_disc = std::holds_alternative<Disc>(body.shape); // which looks the same from everywhere
    const Aabb box = bounding_box(body.shape, is_disc ? Pose{body.state.position, {}} : pose_of(body.state));
    return {box.min - Vec2(way, way), box.max + Vec2(way, way)};
}

/// No less than the field at a place, and wherever a body may fall from there in a step.  [m/s^2]
double Hybrid::greatest_pull(const Vec2& place) const
{
    const auto* central = std::get_if<CentralField>(&setting_.field);
    if (!central) return uniform_acceleration(setting_.field).norm();
    const double least = std::max(central->radius, 0.5 * (place - central->centre).norm());
    return central->mu / (least * least);
}

/// How far a flight leads, at most, from the straight way between its ends; infinite where it may pass the centre.  [m]
double Hybrid::bow_of(const Flyer& flyer, double from, double left) const
{
    if (!flyer.central) return 0.125 * left * left * flyer.acceleration.norm();
    const CentralPath path(flyer, *flyer.central);
    const CentralPath::Outlook outlook = path.outlook(path.at(from).position, from);
    if (outlook.until >= from + left) return 0.125 * left * left * outlook.acceleration;
    return std::numeric_limits<double>::infinity();
}

/// Some body that leans, other than those marked, may get into the box.
bool Hybrid::has_leaning_near(const Aabb& box, const std::vector<char>* but) const
{
    return !reaches_.visit_all_at(box, [&](const BoxCells::Entry& reach) { return but && (*but)[reach.body]; });
}

/// A flight leads, before the step ends, to where a body that leans may be.
bool Hybrid::comes_near(const EventEngine& engine, int body) const
{
    const Flyer flyer = engine.flyer(body);
    const double from = engine.time();
    const Vec2 start = state_at(flyer, from).position;
    const Vec2 end = state_at(flyer, step_ends_).position;
    const double room = (1.0 + k_room) * radius_[body] + bow_of(flyer, from, step_ends_ - from);
    if (!std::isfinite(room)) return !reaches_.entries().empty();
    return has_leaning_near({start.cwiseMin(end) - Vec2(room, room), start.cwiseMax(end) + Vec2(room, room)}, nullptr);
}
// [hybrid.watch]

} // namespace flying
