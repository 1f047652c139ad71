#include "world/reach_in_step.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <variant>

#include "toi/central_flight.hpp"

namespace flying {
namespace {

/// [radii] Room about the way of a body in a step, within which the resting integrator watches for contacts.
constexpr double k_near = 0x1p-6;

} // namespace

double bow_of(const Flyer& flyer, double from, double left)
{
    if (!flyer.central) return 0.125 * left * left * flyer.acceleration.norm();
    const CentralPath path(flyer, *flyer.central);
    const CentralPath::Outlook outlook = path.outlook(path.at(from).position, from);
    if (outlook.until >= from + left) return 0.125 * left * left * outlook.acceleration;
    return std::numeric_limits<double>::infinity();
}

Aabb flight_box(const Flyer& flyer, double radius, double from, double until)
{
    const Vec2 start = state_at(flyer, from).position;
    const Vec2 end = state_at(flyer, until).position;
    const double room = (1.0 + k_room) * radius + bow_of(flyer, from, until - from);
    return {start.cwiseMin(end) - Vec2(room, room), start.cwiseMax(end) + Vec2(room, room)};
}

double greatest_pull(const Field& field, const Vec2& place)
{
    const auto* central = std::get_if<CentralField>(&field);
    if (!central) return uniform_acceleration(field).norm();
    const double least = std::max(central->radius, 0.5 * (place - central->centre).norm());
    return central->mu / (least * least);
}

Leaning leaning_of(int body, const Shape& shape, const BodyState& state, double radius, const Field& field, double step)
{
    const double speed = state.velocity.norm();
    const double pull = greatest_pull(field, state.position);
    const double fastest = speed + std::abs(state.spin) * radius;
    const double way = step * (fastest + step * pull) + k_near * radius;
    const bool is_disc = std::holds_alternative<Disc>(shape); // which looks the same from everywhere
    const Aabb box = bounding_box(shape, is_disc ? Pose{state.position, {}} : pose_of(state));
    return {body, state.position, radius, speed, pull, {box.min - Vec2(way, way), box.max + Vec2(way, way)}};
}

} // namespace flying
