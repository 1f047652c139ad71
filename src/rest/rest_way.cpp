#include "rest/rest_way.hpp"

#include <algorithm>
#include <cmath>

namespace flying {
namespace {

/// The number at a share s of a leg that grows by `way` in all: the cubic with the slopes of its ends, for a whole leg.
[[nodiscard]] double cubic(double s, double way, double slope_start, double slope_end)
{
    const double t = 1.0 - s;
    return s * s * (3.0 - 2.0 * s) * way + s * t * (t * slope_start - s * slope_end);
}

/// Its slope.
[[nodiscard]] double slope(double s, double way, double slope_start, double slope_end)
{
    const double t = 1.0 - s;
    return 6.0 * s * t * way + t * (1.0 - 3.0 * s) * slope_start + s * (3.0 * s - 2.0) * slope_end;
}

} // namespace

BodyState along(const std::vector<Leg>& legs, double time)
{
    // Find the leg; what rounding leaves beyond the last belongs to it
    std::size_t k = 0;
    double before = 0.0;
    while (k + 1 < legs.size() && before + legs[k].length <= time) before += legs[k++].length;
    const Leg& leg = legs[k];
    const double h = leg.length;
    const double s = h > 0.0 ? std::clamp((time - before) / h, 0.0, 1.0) : 1.0;
    BodyState state = leg.start;
    const double bow = leg.kind == Leg::Kind::bent ? 0.5 * s * (1.0 - s) * h : 0.0;
    if (leg.kind == Leg::Kind::curved) {
        state.position += Vec2(cubic(s, leg.shift.x(), h * leg.start.velocity.x(), h * leg.velocity.x()),
                               cubic(s, leg.shift.y(), h * leg.start.velocity.y(), h * leg.velocity.y()));
        state.angle += cubic(s, leg.turn, h * leg.start.spin, h * leg.spin);
    } else {
        state.position += s * leg.shift - bow * (leg.velocity - leg.start.velocity);
        state.angle += s * leg.turn - bow * (leg.spin - leg.start.spin);
    }
    if (leg.kind == Leg::Kind::curved && h > 0.0) {
        state.velocity = Vec2(slope(s, leg.shift.x(), h * leg.start.velocity.x(), h * leg.velocity.x()),
                              slope(s, leg.shift.y(), h * leg.start.velocity.y(), h * leg.velocity.y())) /
                         h;
        state.spin = slope(s, leg.turn, h * leg.start.spin, h * leg.spin) / h;
    } else {
        state.velocity = leg.start.velocity + s * (leg.velocity - leg.start.velocity);
        state.spin = leg.start.spin + s * (leg.spin - leg.start.spin);
    }
    return state;
}

} // namespace flying
