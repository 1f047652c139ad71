#pragma once

#include <algorithm>

#include "broadphase/grid.hpp"
#include "toi/prediction.hpp"

namespace flying {

// [events.cell_exit.result]
/// When a body leaves its cell, and for which.
struct CellExit
{
    double time = k_never; ///< [s]
    Cell to;
};
// [events.cell_exit.result]

// [events.cell_exit]
/// First time, not before `now`, at which a flyer crosses a border of its cell outwards. Only the direction of crossing
/// counts, so that a body that stands on the border by rounding is not sent back and forth.
[[nodiscard]] inline CellExit next_cell_exit(const Flyer& flyer, const Cell& cell, double cell_size, double now)
{
    CellExit exit;
    // [events.cell_exit.straight]
    // On a straight path only the two borders ahead count
    const auto column = static_cast<double>(cell.column);
    const auto row = static_cast<double>(cell.row);
    const Vec2& x = flyer.state.position;
    const Vec2& v = flyer.state.velocity;
    const Vec2& a = flyer.acceleration;
    if (a.x() == 0.0 && a.y() == 0.0) {
        const int right = v.x() > 0.0 ? 1 : 0;
        const int up = v.y() > 0.0 ? 1 : 0;
        const double room_x = (column + right) * cell_size - x.x();
        const double room_y = (row + up) * cell_size - x.y();
        const double time_x = v.x() != 0.0 ? flyer.state.time + room_x / v.x() : k_never;
        const double time_y = v.y() != 0.0 ? flyer.state.time + room_y / v.y() : k_never;
        if (time_x <= time_y) return {std::max(time_x, now), {cell.column + (2 * right - 1), cell.row}};
        return {std::max(time_y, now), {cell.column, cell.row + (2 * up - 1)}};
    }
    // [events.cell_exit.straight]
    // [events.cell_exit.crossing]
    const auto consider = [&](double room, double speed, double acceleration, Cell to) {
        // `room` is the distance to the border; it falls through zero when the body crosses
        double time = flyer.state.time + falling_root(room, -speed, -acceleration);

        // A crossing in the past was undone by a later one, or it is still under way
        if (time < now) {
            const bool outwards = speed + acceleration * (now - flyer.state.time) > 0.0;
            time = outwards ? now : k_never;
        }
        if (time < exit.time) exit = {time, to};
    };
    // [events.cell_exit.crossing]
    // [events.cell_exit.borders]
    consider((column + 1.0) * cell_size - x.x(), v.x(), a.x(), {cell.column + 1, cell.row});
    consider(x.x() - column * cell_size, -v.x(), -a.x(), {cell.column - 1, cell.row});
    consider((row + 1.0) * cell_size - x.y(), v.y(), a.y(), {cell.column, cell.row + 1});
    consider(x.y() - row * cell_size, -v.y(), -a.y(), {cell.column, cell.row - 1});
    // [events.cell_exit.borders]
    return exit;
}
// [events.cell_exit]

} // namespace flying
