#pragma once

#include "motion/body.hpp"
#include "motion/field.hpp"

namespace flying {

/// Where a point is and how it moves, as seen from the centre of a central field.
struct PointMotion
{
    Vec2 position = Vec2::Zero(); ///< [m]
    Vec2 velocity = Vec2::Zero(); ///< [m/s]
};

/// A point's flight under the pull -mu x / |x|^3 of a centre that stays where it is. One closed form for every regime:
/// ellipse, parabola, hyperbola, straight in and straight out (universal variables: Stiefel, Scheifele, "Linear and
/// regular celestial mechanics", 1971). Times scale as 2^b and lengths as 2^a, with mu as 2^(3a - 2b), bit for bit;
/// turning time round, mirroring and quarter turns change no digit either.
class KeplerFlight
{
public:
    /// start  position, not zero, and velocity, both relative to the centre
    /// mu     strength of the centre, positive [m^3/s^2]
    KeplerFlight(const PointMotion& start, double mu);

    /// The point `t` later, or earlier where t is negative. The error is rounding: whole turns of an ellipse are taken
    /// off with a period of twice the digits.  t  finite [s]
    [[nodiscard]] PointMotion after(double t) const;

    /// 2 mu / r - v^2, the same all along the flight: positive on an ellipse, negative on a hyperbola.  [m^2/s^2]
    [[nodiscard]] double binding() const { return binding_; }

    /// Distance from the centre at the nearest point of the whole orbit, rounded downwards.  [m]
    [[nodiscard]] double nearest() const;

    /// And at the farthest, rounded upwards; infinite where the flight gets away.  [m]
    [[nodiscard]] double farthest() const;

    /// No point of the orbit at the distance r from the centre, or farther, is faster.  [m/s]
    [[nodiscard]] double greatest_speed(double r) const;

private:
    struct Progress;
    [[nodiscard]] double greatest_eccentricity() const;
    [[nodiscard]] Progress progress(double s, double direction) const;
    [[nodiscard]] double first_guess(double t, double outward) const;
    [[nodiscard]] double solve(double t, double direction) const;
    [[nodiscard]] double less_whole_turns(double t) const;

    PointMotion start_;
    double mu_;           // [m^3/s^2]
    double distance_;     // at the start [m]
    double outward_;      // x . v at the start, positive on the way out [m^2/s]
    double binding_;      // [m^2/s^2]
    double binding_tail_; // what the binding lost when it was rounded
    double root_;         // of |binding| [m/s]
};

/// The body at another moment, under the pull of a centre. Its spin stays as it is: the
/// pull acts at the centre of mass.
/// body  not at the centre; time  any moment [s]
[[nodiscard]] BodyState flight(const BodyState& body, const CentralField& field,
                               double time);

/// The body at another moment, in any field.
/// body  one that moves freely: static bodies feel no field; time  any moment [s]
[[nodiscard]] BodyState flight(const BodyState& body, const Field& field, double time);

} // namespace flying
