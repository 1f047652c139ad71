#include "rest/rest_way.hpp"

namespace flying {
namespace {

/// One coordinate of a body on its way.
struct Along
{
    double way = 0.0;
    double velocity = 0.0;
};

/// The cubic with the velocities of its ends, at a share s of a time h.
///
/// way         in all of that time
/// start, end  the velocities
[[nodiscard]] Along cubic(double s, double h, double way, double start, double end)
{
    const double t = 1.0 - s;
    const double mean = way / h;
    return {s * s * (3.0 - 2.0 * s) * way + s * t * h * (t * start - s * end),
            6.0 * s * t * mean + t * (1.0 - 3.0 * s) * start + s * (3.0 * s - 2.0) * end};
}

/// Straight on, while the velocity changes evenly.
[[nodiscard]] Along straight(double s, double way, double start, double end)
{
    return {s * way, start + s * (end - start)};
}

} // namespace

void go_along(StepMotion& motion, const Island& island, double time)
{
    const double h = motion.span;
    const double s = time / h;
    const auto at = [&](double way, double start, double end) {
        return island.is_exact ? cubic(s, h, way, start, end) : straight(s, way, start, end);
    };
    for (const int member : island.members) {
        const Mover& old = motion.before[member];
        Mover& now = motion.now[member];
        const Along x = at(motion.shift[member].x(), old.v_x, now.v_x);
        const Along y = at(motion.shift[member].y(), old.v_y, now.v_y);
        const Along turn = at(motion.turn[member], old.spin, now.spin);
        motion.shift[member] = Vec2(x.way, y.way);
        motion.turn[member] = turn.way;
        now.v_x = x.velocity;
        now.v_y = y.velocity;
        now.spin = turn.velocity;
    }
    motion.span = time;
}

} // namespace flying
