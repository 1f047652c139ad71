#include "events/body_rows.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "math/tolerance.hpp"

namespace flying {

BodyRows::BodyRows(std::vector<EventBody> bodies)
{
    double lightest = std::numeric_limits<double>::infinity(); // [kg]
    double heaviest = 0.0;                                     // [kg]
    for (EventBody& body : bodies) {
        const BodyState& state = body.flyer.state;
        const bool is_disc = std::holds_alternative<Disc>(body.shape);
        const Kind kind = body.is_static ? Kind::is_static : is_disc ? Kind::disc : Kind::polygon;
        const int id = static_cast<int>(rows_.size());
        rows_.push_back({state.position, state.velocity, state.time, bounding_radius(body.shape), 0, kind, id});
        places_.push_back({id, 0});
        sheets_.push_back({state.angle, state.spin, body.inertia, body.material, 0});
        if (!body.is_static) acceleration_ = body.flyer.acceleration;
        if (body.inertia.inv_mass > 0.0) {
            lightest = std::min(lightest, 1.0 / body.inertia.inv_mass);
            heaviest = std::max(heaviest, 1.0 / body.inertia.inv_mass);
        }
        if (body.flyer.central) central_ = *body.flyer.central;
        shapes_.push_back(std::move(body.shape));
    }
    if (heaviest > 0.0) mass_ratio_ = heaviest / lightest;
}

BodyRows::Presence BodyRows::presence(int row) const
{
    const Kind kind = rows_[row].kind;
    return kind == Kind::lies ? Presence::lies : kind == Kind::away ? Presence::away : Presence::flies;
}

bool BodyRows::can_meet(int a, int b) const
{
    const Kind kind_a = rows_[a].kind;
    const Kind kind_b = rows_[b].kind;
    if (kind_a == Kind::away || kind_b == Kind::away) return false;
    return !(is_fixed(a) && is_fixed(b)) || (kind_a != Kind::lies && kind_b != Kind::lies);
}

Vec2 BodyRows::pull_on(int row) const
{
    if (is_fixed(row)) return Vec2::Zero();
    return central_ ? acceleration_at(Field(*central_), rows_[row].position) : acceleration_;
}

double BodyRows::energy_change(int row, const Vec2& velocity, double spin) const
{
    const Row& body = rows_[row];
    const Sheet& sheet = sheets_[row];
    if (sheet.inertia.inv_mass == 0.0) return 0.0;
    const double shift = (velocity - body.velocity).dot(velocity + body.velocity) / sheet.inertia.inv_mass;
    const double turn = (spin - sheet.spin) * (spin + sheet.spin) / sheet.inertia.inv_moment_of_inertia;
    return 0.5 * (shift + turn);
}

bool BodyRows::move_to(int row, double time)
{
    Row& body = rows_[row];
    if (is_fixed(row)) return false;
    const double way = top_speed(row) * (time - body.time);

    const BodyState after = state_at(flyer_of(row), time);
    body.position = after.position;
    body.velocity = after.velocity;
    body.time = time;
    sheets_[row].angle = after.angle;
    return way > tolerance::k_touch * body.radius;
}

void BodyRows::set_motion(int row, const Vec2& velocity, double spin)
{
    Row& body = rows_[row];
    if (body.kind == Kind::is_static) return;
    if (body.kind == Kind::lies) body.kind = Kind::away;
    body.velocity = velocity;
    sheets_[row].spin = spin;
    outdate(body);
}

void BodyRows::put(int row, Presence presence, const BodyState& state)
{
    const bool flies = presence == Presence::flies;
    const bool is_disc = std::holds_alternative<Disc>(shape_of(row));
    Row& body = rows_[row];
    Sheet& sheet = sheets_[row];
    body.position = state.position;
    body.velocity = flies ? state.velocity : Vec2(Vec2::Zero());
    body.time = state.time;
    body.kind = presence == Presence::lies   ? Kind::lies
                : presence == Presence::away ? Kind::away
                : is_disc                    ? Kind::disc
                                             : Kind::polygon;
    sheet.angle = state.angle;
    sheet.spin = flies ? state.spin : 0.0;
    sheet.crowding = 0;
    outdate(body);
}

void BodyRows::line_up(std::span<const int> old_rows)
{
    std::vector<Row> rows;
    std::vector<Sheet> sheets;
    rows.reserve(rows_.size());
    sheets.reserve(rows_.size());
    for (const int old : old_rows) {
        places_[rows_[old].id].row = static_cast<int>(rows.size());
        rows.push_back(rows_[old]);
        sheets.push_back(sheets_[old]);
    }
    rows_.swap(rows);
    sheets_.swap(sheets);
}

} // namespace flying
