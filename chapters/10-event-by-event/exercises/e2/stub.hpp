#pragma once

/// A moment: the sum of both parts.
struct Moment
{
    double epoch = 0.0;  ///< the nearest double [s]
    double offset = 0.0; ///< what is left [s]
};

/// A time `dt` later.  [s]
inline Moment later(const Moment& moment, double dt)
{
    return {moment.epoch + moment.offset + dt, 0.0}; // your code here
}

/// From one moment to another.  [s]
inline double between(const Moment& from, const Moment& to)
{
    return to.epoch - from.epoch; // your code here
}
