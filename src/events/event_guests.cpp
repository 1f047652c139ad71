#include <algorithm>
#include <cmath>

#include "events/event_engine.hpp"

namespace flying {

// [events.place]
// Bodies that others move for a while: how the engine lets go of them, and takes them back.

EventEngine::Kind EventEngine::kind_of(int body, Presence presence) const
{
    if (presence == Presence::lies) return Kind::lies;
    if (presence == Presence::away) return Kind::away;
    return std::holds_alternative<Disc>(shape_of(body)) ? Kind::disc : Kind::polygon;
}

EventEngine::Presence EventEngine::presence(int body) const
{
    const Kind kind = rows_[row_of(body)].kind;
    return kind == Kind::lies ? Presence::lies : kind == Kind::away ? Presence::away : Presence::flies;
}

void EventEngine::place(int body, Presence presence, const BodyState& state)
{
    const bool flies = presence == Presence::flies;
    const int place = row_of(body);
    Row& row = rows_[place];
    Sheet& sheet = sheets_[place];
    row.position = state.position;
    row.velocity = flies ? state.velocity : Vec2(Vec2::Zero());
    row.time = state.time;
    row.kind = kind_of(place, presence);
    forget(place);
    sheet.angle = state.angle;
    sheet.spin = flies ? state.spin : 0.0;
    sheet.crowding = 0;
    bounces_[body] = {};
    if (presence == Presence::away) return;

    // Enter the cells where others look, and look at the bodies there
    if (grid_) grid_->move(place, grid_->cell_at(row.position));
    predict_anew(place);
    if (queue_.size() > sweep_at_) sweep_queue();
}
// [events.place]

// [events.can_meet]
/// False where others see to the pair: one of them is away, or neither flies and one only lies.
bool EventEngine::can_meet(int a, int b) const
{
    const Kind kind_a = rows_[a].kind;
    const Kind kind_b = rows_[b].kind;
    if (kind_a == Kind::away || kind_b == Kind::away) return false;
    return !(is_fixed(a) && is_fixed(b)) || (kind_a != Kind::lies && kind_b != Kind::lies);
}
// [events.can_meet]

// [events.energy_change]
/// What new velocities give to a body's kinetic energy.  [J]
double EventEngine::energy_change(int body, const Vec2& velocity, double spin) const
{
    const Row& row = rows_[body];
    const Sheet& sheet = sheets_[body];
    if (sheet.inertia.inv_mass == 0.0) return 0.0;
    const double shift = (velocity - row.velocity).dot(velocity + row.velocity) / sheet.inertia.inv_mass;
    const double turn = (spin - sheet.spin) * (spin + sheet.spin) / sheet.inertia.inv_moment_of_inertia;
    return 0.5 * (shift + turn);
}
// [events.energy_change]

// [events.stays]
/// What the field does to a body where it is; nothing to what is fixed.  [m/s^2]
Vec2 EventEngine::pull_on(int body) const
{
    if (is_fixed(body)) return Vec2::Zero();
    return central_ ? acceleration_at(Field(*central_), rows_[body].position) : acceleration_;
}

/// After an impact that takes speed away, two bodies part at some point by so little that the field, which presses them
/// together there, ends that within the tolerance of touching. Impact would follow impact with no time between them: from
/// here on the two lean on each other.
bool EventEngine::stays(int a, int b, double touch) const
{
    if (combine(sheets_[a].material, sheets_[b].material).restitution == 1.0) return false;
    constexpr double k_hop = 16.0; // tolerances of touching: lower hops can't be told from contact
    const Vec2 pull = pull_on(a) - pull_on(b);
    return std::any_of(points_.begin(), points_.end(), [&](const ImpactPoint& point) {
        const double press = point.normal.dot(pull);
        const Vec2 velocity_a = rows_[a].velocity + cross(sheets_[a].spin, point.r_a);
        const Vec2 velocity_b = rows_[b].velocity + cross(sheets_[b].spin, point.r_b);
        const double leave = point.normal.dot(velocity_b - velocity_a);
        return press > 0.0 && leave * leave <= 2.0 * press * (k_hop * touch);
    });
}
// [events.stays]

// [events.end_of_bounces]
/// When bounces end that have just shrunk to a touch; nothing where they haven't.
///
/// A disc that leaves something flat at speed v, pressed on by g, is back after 2 v/g, and leaves with e v: all hops
/// together take 2 v / (g (1 - e)). Neither its spin nor its sliding knows of the normal motion. The end is found at
/// the first bounce, where v has all its digits, and kept as long as nothing else is met.
std::optional<double> EventEngine::end_of_bounces(int a, int b, double time, double touch)
{
    // Only a disc on what never moves
    const bool a_flies = !is_fixed(a);
    const int flyer = a_flies ? a : b;
    const int other = a_flies ? b : a;
    const double e = combine(sheets_[a].material, sheets_[b].material).restitution;
    if (rows_[flyer].kind != Kind::disc || rows_[other].kind != Kind::is_static || points_.size() != 1 || e == 1.0) {
        bounces_[rows_[a].id] = bounces_[rows_[b].id] = {};
        return std::nullopt;
    }

    // Find the end, unless this is one of the bounces for which it is known
    const Vec2 into = a_flies ? points_[0].normal : Vec2(-points_[0].normal);
    const double press = acceleration_.dot(into);
    const double leave = -rows_[flyer].velocity.dot(into);
    Bounces& bounces = bounces_[rows_[flyer].id];
    if (press <= 0.0) {
        bounces = {};
        return std::nullopt;
    }
    const bool is_known = bounces.on == rows_[other].id && bounces.normal == into;
    if (!is_known) bounces = {rows_[other].id, into, time + 2.0 * leave / (press * (1.0 - e))};

    constexpr double k_hop = 16.0; // tolerances of touching: lower hops can't be told from contact
    if (leave * leave > 2.0 * press * (k_hop * touch)) return std::nullopt;
    return bounces.end;
}
// [events.end_of_bounces]

} // namespace flying
