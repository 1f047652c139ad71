#pragma once

#include <algorithm>
#include <array>

#include "broadphase/grid.hpp"
#include "toi/prediction.hpp"

namespace flying {

/// When a body leaves its cell, and by which side: 0 right, 1 left, 2 up, 3 down.
struct CellExit
{
    double time = k_never; ///< [s]
    int side = 0;
};

/// The step from a cell to the one beyond a side.
[[nodiscard]] inline Cell step_over(int side)
{
    const int way = side % 2 == 0 ? 1 : -1;
    return side < 2 ? Cell{way, 0} : Cell{0, way};
}

/// The three cells that come near when a body steps out of one.
[[nodiscard]] inline std::array<Cell, 3> cells_ahead(const Cell& from, const Cell& step)
{
    const Cell middle{from.column + 2 * step.column, from.row + 2 * step.row};
    return {Cell{middle.column - step.row, middle.row - step.column}, middle,
            Cell{middle.column + step.row, middle.row + step.column}};
}

/// On a straight path only the two borders ahead count.
/// x, v  position and velocity at `time`
[[nodiscard]] inline CellExit straight_exit(const Vec2& x, const Vec2& v, double time, const Cell& cell,
                                            double cell_size, double now)
{
    const int right = v.x() > 0.0 ? 1 : 0;
    const int up = v.y() > 0.0 ? 1 : 0;
    const double room_x = (static_cast<double>(cell.column) + right) * cell_size - x.x();
    const double room_y = (static_cast<double>(cell.row) + up) * cell_size - x.y();
    const double time_x = v.x() != 0.0 ? time + room_x / v.x() : k_never;
    const double time_y = v.y() != 0.0 ? time + room_y / v.y() : k_never;
    if (time_x <= time_y) return {std::max(time_x, now), 1 - right};
    return {std::max(time_y, now), 3 - up};
}

/// First time, not before `now`, at which a flyer crosses a border of its cell outwards. Only the direction of crossing
/// counts, so that a body that stands on the border by rounding is not sent back and forth.
[[nodiscard]] inline CellExit next_cell_exit(const Flyer& flyer, const Cell& cell, double cell_size, double now)
{
    CellExit exit;
    const Vec2& a = flyer.acceleration;
    if (a.x() == 0.0 && a.y() == 0.0) {
        return straight_exit(flyer.state.position, flyer.state.velocity, flyer.state.time, cell, cell_size, now);
    }

    const auto column = static_cast<double>(cell.column);
    const auto row = static_cast<double>(cell.row);
    const Vec2& x = flyer.state.position;
    const Vec2& v = flyer.state.velocity;

    const auto consider = [&](double room, double speed, double acceleration, int side) {
        // `room` is the distance to the border; it falls through zero when the body crosses
        double time = flyer.state.time + falling_root(room, -speed, -acceleration);

        // A crossing in the past was undone by a later one, or it is still under way
        if (time < now) {
            const bool outwards = speed + acceleration * (now - flyer.state.time) > 0.0;
            time = outwards ? now : k_never;
        }
        if (time < exit.time) exit = {time, side};
    };

    consider((column + 1.0) * cell_size - x.x(), v.x(), a.x(), 0);
    consider(x.x() - column * cell_size, -v.x(), -a.x(), 1);
    consider((row + 1.0) * cell_size - x.y(), v.y(), a.y(), 2);
    consider(x.y() - row * cell_size, -v.y(), -a.y(), 3);

    return exit;
}

} // namespace flying
