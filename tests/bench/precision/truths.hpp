#pragma once

#include <vector>

#include "math/vec2.hpp"

/// Closed forms that the scenes of the diagrams are measured against. They share no line with the engine.
namespace flying::bench {

/// Height over the floor of a ball that is let go at height h and bounces without end; 0 from the end of the bounces
/// on. h  > 0 [m];  g  > 0 [m/s^2];  e  restitution, 0 ... 1;  t  >= 0 [s]      returns [m]
[[nodiscard]] double bounce_height(double h, double g, double e, double t);

/// When a ball let go at height h has bounced for the last time, e < 1.    [s]
[[nodiscard]] double end_of_bounces(double h, double g, double e);

/// Along one axis between two walls, both of which turn it round: where a point is that started at x with velocity v.
/// Unfolding: it goes straight on through mirrored rooms.                   [m]
[[nodiscard]] double folded(double x, double v, double t, double low, double high);

/// Velocities after an impact of a body with a smooth, immovable floor whose normal points up.
/// r  from the centre of mass to the point that touches [m];  m [kg];  I [kg m^2]
struct Struck
{
    Vec2 velocity = Vec2::Zero(); ///< [m/s]
    double spin = 0.0;            ///< [rad/s]
};
[[nodiscard]] Struck strike_floor(const Vec2& velocity, double spin, const Vec2& r, double m, double I, double e);

/// The same for a disc of radius R that doesn't spin, with friction: it sticks iff |ux| <= 3 mu (1+e) |uy|.
[[nodiscard]] Struck strike_floor_rough(const Vec2& velocity, double R, double e, double mu);

/// How far a block has slid down an incline from rest: not at all where mu >= tan(slope).     [m]
[[nodiscard]] double slid(double g, double slope, double mu, double t);

/// A disc that is thrown along a floor at v0 without spin: it slides, and rolls from v0 / (3 mu g) on.
struct Rolled
{
    double way = 0.0;   ///< [m]
    double angle = 0.0; ///< through which it has turned, against the clock [rad]
};
[[nodiscard]] Rolled slid_to_roll(double v0, double mu, double g, double R, double t);

/// Galperin's two balls and a wall: masses 1 and M, the heavy one comes at speed 1 towards the light one and the wall.
/// Velocities after the last collision, away from the wall positive, and their number.
struct Parted
{
    double heavy = 0.0;
    double light = 0.0;
    long collisions = 0;
};
[[nodiscard]] Parted parted(double M);

/// A row of equal elastic balls of radius R between two walls: equal balls swap velocities, so that as points they go
/// through each other. Places of the centres, in order.
/// x  from left to right [m];  v  of each [m/s]
[[nodiscard]] std::vector<double> row_places(const std::vector<double>& x, const std::vector<double>& v, double R,
                                             double low, double high, double t);

/// Angle of a block that rocks from one lower corner to the other without sliding or bouncing, by small steps of a
/// fourth-order method from impact to impact; at each, the spin falls to 1 - 1.5 sin^2(alpha) of itself.
/// b, h   half of its width and of its height [m]
/// start  its angle at rest, in (-alpha, alpha), alpha = atan(b / h) [rad]
/// times  ascending [s]      Returns the angle at each.      [rad]
[[nodiscard]] std::vector<double> rocking(double b, double h, double g, double start, const std::vector<double>& times);

} // namespace flying::bench
