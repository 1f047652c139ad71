#pragma once

#include <algorithm>
#include <optional>

#include "math/tolerance.hpp"
#include "motion/kepler.hpp"
#include "toi/prediction.hpp"

namespace flying {

/// The path of one body as seen from a centre: round it where the body moves, or one place where it is static.
class CentralPath
{
public:
    CentralPath(const Flyer& flyer, const CentralField& field)
        : still_{flyer.state.position - field.centre, Vec2::Zero()}, time_(flyer.state.time), mu_(field.mu)
    {
        if (flyer.central) orbit_.emplace(PointMotion{still_.position, flyer.state.velocity}, field.mu);
    }

    /// time  of the world's clock [s]
    [[nodiscard]] PointMotion at(double time) const { return orbit_ ? orbit_->after(time - time_) : still_; }

    /// What can be said of the near future without following the path.
    struct Outlook
    {
        double until = k_never;    ///< how long the rest of this holds [s]
        double nearest = 0.0;      ///< bound on the distance from the centre [m]
        double acceleration = 0.0; ///< bound [m/s^2]
    };

    /// From a place on, the body needs a while to come half as near, however it flies; and
    /// nearer than the nearest point of its orbit it never comes. The pull is no greater than
    /// at the farther of the two.
    [[nodiscard]] Outlook outlook(const Vec2& position, double time) const
    {
        const double distance = position.norm();
        if (!orbit_) return {k_never, distance, 0.0};
        const double half = 0.5 * distance;
        const double least = orbit_->nearest();
        const double nearest = std::max(half, least);
        const double speed = orbit_->greatest_speed(nearest);
        const bool always = least >= half || speed == 0.0;
        return {always ? k_never : time + half / speed, nearest, mu_ / (nearest * nearest)};
    }

    /// Distances from the centre between which the whole path lies.  [m]
    [[nodiscard]] double nearest() const { return orbit_ ? orbit_->nearest() : still_.position.norm(); }
    [[nodiscard]] double farthest() const { return orbit_ ? orbit_->farthest() : still_.position.norm(); }
    /// Distance from the centre at the state from which the path is known.  [m]
    [[nodiscard]] double start_distance() const { return still_.position.norm(); }

private:
    PointMotion still_; // a static body's; of one that moves, only the place counts, at its own time
    double time_;       // [s]
    double mu_;         // [m^3/s^2]
    std::optional<KeplerFlight> orbit_;
};

/// How body A flies as seen from body B, where at least one of them flies round a centre. Its acceleration isn't
/// constant: there is a bound on it that holds for a while.
class CentralPairFlight
{
public:
    CentralPairFlight(const Flyer& a, const Flyer& b, const CentralField& field) : a_(a, field), b_(b, field) {}

    [[nodiscard]] Vec2 offset_at(double time) const
    {
        look(time);
        return seen_a_.position - seen_b_.position;
    }
    [[nodiscard]] Vec2 rate_at(double time) const
    {
        look(time);
        return seen_a_.velocity - seen_b_.velocity;
    }
    /// Where A is, from the centre.  [m]
    [[nodiscard]] Vec2 place_a(double time) const
    {
        look(time);
        return seen_a_.position;
    }
    [[nodiscard]] Vec2 place_b(double time) const
    {
        look(time);
        return seen_b_.position;
    }

    [[nodiscard]] const CentralPath& a() const { return a_; }
    [[nodiscard]] const CentralPath& b() const { return b_; }

    /// The bound on the acceleration that counts from now on.  [m/s^2]
    void set_bound(double bound) { bound_ = bound; }
    [[nodiscard]] double bound() const { return bound_; }

private:

    /// Follow both paths to a moment. Offset and rate are asked for one after the other: the
    /// last answer is kept.
    void look(double time) const
    {
        if (time == seen_time_) return;
        seen_a_ = a_.at(time);
        seen_b_ = b_.at(time);
        seen_time_ = time;
    }

    CentralPath a_;
    CentralPath b_;
    double bound_ = 0.0;
    mutable double seen_time_ = k_never;
    mutable PointMotion seen_a_;
    mutable PointMotion seen_b_;
};

[[nodiscard]] inline double acceleration_bound(const CentralPairFlight& relative)
{
    return relative.bound();
}
[[nodiscard]] inline double acceleration_bound(const CentralPairFlight& relative, const Vec2&)
{
    return relative.bound();
}

} // namespace flying
