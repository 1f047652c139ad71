#include <algorithm>
#include <cmath>
#include <limits>

#include "toi/central_flight.hpp"
#include "world/hybrid.hpp"

namespace flying {
namespace {


/// [radii] Room about a flight, against rounding and the tolerance of touching.
constexpr double k_room = 0x1p-10;
/// [radii] Room about the way of a body in a step, within which the resting integrator watches for contacts.
constexpr double k_near = 0x1p-6;


} // namespace


/// What the rules of handing over need to know of a body.
Leaning Hybrid::leaning(int k) const
{
    const RestBody& body = resting_->body(k);
    const double speed = body.state.velocity.norm();
    const double pull = greatest_pull(body.state.position);
    const double fastest = speed + std::abs(body.state.spin) * radius_[k];
    const double way = setting_.step * (fastest + setting_.step * pull) + k_near * radius_[k];
    const bool is_disc = std::holds_alternative<Disc>(body.shape); // which looks the same from everywhere
    const Aabb box = bounding_box(body.shape, is_disc ? Pose{body.state.position, {}} : pose_of(body.state));
    return {k,
            body.state.position,
            radius_[k],
            speed,
            pull,
            {box.min - Vec2(way, way), box.max + Vec2(way, way)}};
}

std::vector<Leaning> Hybrid::leaning(std::span<const int> bodies) const
{
    std::vector<Leaning> all;
    for (const int k : bodies) all.push_back(leaning(k));
    return all;
}

/// Tell the rules of handing over of those that lean; of those that sleep only where others slept before.
void Hybrid::begin_hand_over()
{
    if (others_sleep_) hand_over_.set_asleep(leaning(movers_.list(BodyMover::asleep)));
    others_sleep_ = false;
    hand_over_.begin(leaning(movers_.list(BodyMover::rest)));
}


/// Holds all of a flight until the step ends; without end where it may pass the centre.
Aabb Hybrid::flight_box(int body) const
{
    const Flyer flyer = flying_.flyer(body);
    const double from = flying_.time();
    const Vec2 start = state_at(flyer, from).position;
    const Vec2 end = state_at(flyer, *step_ends_).position;
    const double room = (1.0 + k_room) * radius_[body] + bow_of(flyer, from, *step_ends_ - from);
    return {start.cwiseMin(end) - Vec2(room, room), start.cwiseMax(end) + Vec2(room, room)};
}

/// A flight leads, before the step ends, to where a body that leans may be.
bool Hybrid::comes_near(int body) const
{
    if (!step_ends_ || setting_.policy == EngineChoice::rest) return false;
    const Aabb box = flight_box(body);
    return !std::isfinite(box.max.x()) || hand_over_.is_near(box);
}

/// All whose flights come near those that lean, or what these may wake; ascending.
std::vector<int> Hybrid::find_near()
{
    hand_over_.reach(*step_ends_ - resting_->time());
    has_flights_ = false;
    std::vector<int> near;
    for (const int k : movers_.list(BodyMover::events)) {
        if (comes_near(k)) near.push_back(k);
    }
    return near;
}

/// Those whose flights come near what reaches further than before.
std::vector<int> Hybrid::find_near_to(std::span<const BoxCells::Entry> reaches)
{
    if (!has_flights_) {
        std::vector<BoxCells::Entry> flights;
        for (const int k : movers_.list(BodyMover::events)) flights.push_back({flight_box(k), k});
        flights_.sort(std::move(flights));
        has_flights_ = true;
    }
    std::vector<int> near;
    for (const BoxCells::Entry& reach : reaches) {
        flights_.visit_all_at(reach.box, [&](const BoxCells::Entry& flight) {
            if (movers_.of(flight.body) == BodyMover::events) near.push_back(flight.body);
            return true;
        });
    }
    std::sort(near.begin(), near.end());
    near.erase(std::unique(near.begin(), near.end()), near.end());
    return near;
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




double Hybrid::energy(int body, const BodyState& state) const
{
    const Inertia& inertia = flying_.inertia(body);
    if (inertia.inv_mass == 0.0) return 0.0;
    const double shift = state.velocity.squaredNorm() / inertia.inv_mass;
    const double turn = state.spin * state.spin / inertia.inv_moment_of_inertia;
    return 0.5 * (shift + turn) + potential_at(setting_.field, state.position) / inertia.inv_mass;
}

} // namespace flying
