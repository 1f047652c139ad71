#include <algorithm>
#include <cmath>

#include "motion/kepler.hpp"
#include "rest/rest_engine.hpp"

namespace flying {

// [rest.field.mean]
/// The acceleration by which the field acts on a body that goes from one place to another.  [m/s^2]
///
/// Round a centre, with r and s the distances of the two places x and y from it, it is -mu (x + y) / (r s (r + s)). Its
/// work along the way between them is mu (1/s - 1/r), just what the potential loses, since (x + y) . (y - x) = s^2 - r^2;
/// it pulls where the middle of the way lies, so that it turns nothing about the centre; and for a body that stays where
/// it is, y = x, it is the field at that place.
Vec2 RestEngine::mean_field(int body, const Vec2& from, const Vec2& to) const
{
    if (!options_.centre) return motion_.field[body];
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
    const Vec2& from = bodies_.list[body].state.position;
    return mean_field(body, from, from + motion_.shift[body]).dot(motion_.shift[body]);
}
// [rest.field.mean]

// [rest.field.aim]
/// Set the acceleration for a step, or a part of one, by where the body is expected to get in it.
void RestEngine::aim_field(int body)
{
    if (!options_.centre) return;
    const BodyState& s = bodies_.list[body].state;
    const Vec2 there = s.position + motion_.span * (s.velocity + (0.5 * motion_.span) * motion_.pull[body]);

    // A way that leads past the centre itself says nothing: there is no body that could go it
    const double near = 0.5 * (s.position - options_.centre->centre).norm();
    const bool is_past = !((there - options_.centre->centre).norm() >= near);
    motion_.field[body] = is_past ? field_at(body, s.position) : mean_field(body, s.position, there);
    motion_.field_size[body] = motion_.field[body].norm();
}

/// No less than the field anywhere that the body may get to within so long, unless it comes to half its distance.  [m/s^2]
double RestEngine::greatest_field(int body, double within) const
{
    if (!options_.centre || !is_moved(body)) return motion_.field_size[body];
    const BodyState& s = bodies_.list[body].state;
    const double distance = (s.position - options_.centre->centre).norm();
    const double here = field_at(body, s.position).norm();
    const double way = within * (s.velocity.norm() + within * here);
    const double least = std::max(distance - way, 0.5 * distance);
    return least > 0.0 ? options_.centre->mu / (least * least) : here;
}
// [rest.field.aim]

// [rest.field.fly]
/// Bodies that no point holds fly: round a centre by the closed form, as everywhere.
void RestEngine::fly(Group& group)
{
    set_free(group, motion_.span);
    if (!options_.centre) return;
    for (const int member : group.members) {
        const BodyState& s = bodies_.list[member].state;
        const Vec2 x = s.position - options_.centre->centre;
        if (!is_moved(member) || x.isZero(0.0)) continue;
        const PointMotion end = KeplerFlight({x, s.velocity}, options_.centre->mu).after(motion_.span);
        motion_.now[member].v_x = end.velocity.x();
        motion_.now[member].v_y = end.velocity.y();
        motion_.shift[member] = end.position - x;
        motion_.turn[member] = motion_.span * s.spin;
        group.has_ways = true;
    }
}
// [rest.field.fly]

} // namespace flying
