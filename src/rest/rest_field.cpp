#include <algorithm>
#include <cmath>

#include "motion/kepler.hpp"
#include "rest/rest_engine.hpp"

namespace flying {


/// The acceleration by which the field acts on a body that goes from one place to another.  [m/s^2]
///
/// Round a centre, with r and s the distances of the two places x and y from it, it is -mu (x + y) / (r s (r + s)). Its
/// work along the way between them is mu (1/s - 1/r), just what the potential loses, since (x + y) . (y - x) = s^2 - r^2;
/// it pulls where the middle of the way lies, so that it turns nothing about the centre; and for a body that stays where
/// it is, y = x, it is the field at that place.
Vec2 RestEngine::mean_field(int body, const Vec2& from, const Vec2& to) const
{
    if (!options_.centre) return field_[body];
    if (!is_moved(body)) return Vec2::Zero();
    const Vec2 x = from - options_.centre->centre;
    const Vec2 y = to - options_.centre->centre;
    const double r = x.norm();
    const double s = y.norm();
    if (r == 0.0 || s == 0.0) return Vec2::Zero();
    return (-options_.centre->mu / (r * s * (r + s))) * (x + y);
}

/// The field at a place.  [m/s^2]
Vec2 RestEngine::field_at(int body, const Vec2& place) const { return mean_field(body, place, place); }

/// What the field does on the way of a body's step, for each kilogram.  [J/kg]
double RestEngine::work_of_field(int body) const
{
    const Vec2& from = bodies_[body].state.position;
    return mean_field(body, from, from + shift_[body]).dot(shift_[body]);
}



/// Set the acceleration for a step, or a part of one, by where the body is expected to get in it.
void RestEngine::aim_field(int body)
{
    if (!options_.centre) return;
    const BodyState& s = bodies_[body].state;
    const Vec2 there = s.position + span_ * (s.velocity + (0.5 * span_) * pull_[body]);

    // A way that leads past the centre itself says nothing: there is no body that could go it
    const double near = 0.5 * (s.position - options_.centre->centre).norm();
    const bool is_past = !((there - options_.centre->centre).norm() >= near);
    field_[body] = is_past ? field_at(body, s.position) : mean_field(body, s.position, there);
    field_size_[body] = field_[body].norm();
}

/// No less than the field anywhere that the body may get to within so long, unless it comes to half its distance.  [m/s^2]
double RestEngine::greatest_field(int body, double within) const
{
    if (!options_.centre || !is_moved(body)) return field_size_[body];
    const BodyState& s = bodies_[body].state;
    const double distance = (s.position - options_.centre->centre).norm();
    const double here = field_at(body, s.position).norm();
    const double way = within * (s.velocity.norm() + within * here);
    const double least = std::max(distance - way, 0.5 * distance);
    return least > 0.0 ? options_.centre->mu / (least * least) : here;
}



/// Bodies that no point holds fly: round a centre by the closed form, as everywhere.
void RestEngine::fly(Group& group)
{
    set_free(group, span_);
    if (!options_.centre) return;
    for (const int member : std::span(members_).subspan(group.first_member, group.member_count)) {
        const BodyState& s = bodies_[member].state;
        const Vec2 x = s.position - options_.centre->centre;
        if (!is_moved(member) || x.isZero(0.0)) continue;
        const PointMotion end = KeplerFlight({x, s.velocity}, options_.centre->mu).after(span_);
        movers_[member].v_x = end.velocity.x();
        movers_[member].v_y = end.velocity.y();
        shift_[member] = end.position - x;
        turn_[member] = span_ * s.spin;
        group.has_ways = true;
    }
}


} // namespace flying
