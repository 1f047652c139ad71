#include "rest/step_field.hpp"

#include <algorithm>
#include <cmath>

#include "motion/kepler.hpp"
#include "rest/rest_tolerance.hpp"

namespace flying {

/// The acceleration by which the field acts on a body that goes from one place to another.  [m/s^2]
///
/// Round a centre, with r and s the distances of the two places x and y from it, it is -mu (x + y) / (r s (r + s)). Its
/// work along the way between them is mu (1/s - 1/r), just what the potential loses, since (x + y) . (y - x) = s^2 -
/// r^2; it pulls where the middle of the way lies, so that it turns nothing about the centre; and for a body that stays
/// where it is, y = x, it is the field at that place.
Vec2 mean_field(const RestData& data, int body, const Vec2& from, const Vec2& to)
{
    if (!data.options.centre) return data.motion.field[body];
    const Vec2 x = from - data.options.centre->centre;
    const Vec2 y = to - data.options.centre->centre;
    const double r = x.norm();
    const double s = y.norm();
    if (r == 0.0 || s == 0.0) return Vec2::Zero();
    return (-data.options.centre->mu / (r * s * (r + s))) * (x + y);
}

Vec2 field_at(const RestData& data, int body, const Vec2& place)
{
    return mean_field(data, body, place, place);
}

double work_of_field(const RestData& data, int body)
{
    const Vec2& from = data.bodies.list[body].state.position;
    return mean_field(data, body, from, from + data.motion.shift[body]).dot(data.motion.shift[body]);
}

void aim_field(RestData& data, int body)
{
    if (!data.options.centre) return;
    const BodyState& s = data.bodies.list[body].state;
    const Vec2 there = s.position + data.motion.span * (s.velocity + (0.5 * data.motion.span) * data.motion.pull[body]);

    // A way that leads past the centre itself says nothing: there is no body that could go it
    const double near = 0.5 * (s.position - data.options.centre->centre).norm();
    const bool is_past = !((there - data.options.centre->centre).norm() >= near);
    data.motion.field[body] = is_past ? field_at(data, body, s.position) : mean_field(data, body, s.position, there);
    data.motion.field_size[body] = data.motion.field[body].norm();
}

double greatest_field(const RestData& data, int body, double within)
{
    if (!data.options.centre) return data.motion.field_size[body];
    const BodyState& s = data.bodies.list[body].state;
    const double distance = (s.position - data.options.centre->centre).norm();
    const double here = field_at(data, body, s.position).norm();
    const double way = within * (s.velocity.norm() + within * here);
    const double least = std::max(distance - way, 0.5 * distance);
    return least > 0.0 ? data.options.centre->mu / (least * least) : here;
}

double reach_of(const RestData& data, int body, double within)
{
    const BodyState& s = data.bodies.list[body].state;
    const double radius = data.bodies.radius[body];
    const double speed = s.velocity.norm() + std::abs(s.spin) * radius;
    return within * (speed + within * greatest_field(data, body, within)) + rest_tolerance::k_watch * radius;
}

void expect_flight(RestData& data, int body, const Vec2& place)
{
    data.motion.pull[body] = data.motion.is_moved(body) ? field_at(data, body, place) : Vec2(Vec2::Zero());
    data.motion.expected_angular_acceleration[body] = 0.0;
}

void set_free(RestData& data, const Island& island, std::span<const Mover> start, double time)
{
    for (const int member : island.members) {
        Mover& mover = data.motion.now[member];
        mover = start[member];
        mover.v_x += time * data.motion.field[member].x();
        mover.v_y += time * data.motion.field[member].y();
    }
}

void fly(RestData& data, Island& island)
{
    set_free(data, island, data.motion.before, data.motion.span);
    if (!data.options.centre) return;
    for (const int member : island.members) {
        const Vec2 x = data.bodies.list[member].state.position - data.options.centre->centre;
        if (x.isZero(0.0)) continue;
        const Mover& start = data.motion.before[member];
        const PointMotion end =
            KeplerFlight({x, Vec2(start.v_x, start.v_y)}, data.options.centre->mu).after(data.motion.span);
        data.motion.now[member].v_x = end.velocity.x();
        data.motion.now[member].v_y = end.velocity.y();
        data.motion.shift[member] = end.position - x;
        data.motion.turn[member] = data.motion.span * start.spin;
        island.has_ways = true;
    }
}

} // namespace flying
