#pragma once

#include <array>
#include <cmath>

#include "motion/flight.hpp"
#include "toi/prediction.hpp"

namespace flying {

/// How one body flies as seen from another that doesn't turn. Differences are taken once, so
/// that nothing is lost far from the world's origin.
struct RelativeFlight
{
    double start = 0.0;                ///< [s]
    Vec2 offset = Vec2::Zero();        ///< from B's position to A's, at the start [m]
    Vec2 rate = Vec2::Zero();          ///< velocity of A relative to B, at the start [m/s]
    Vec2 acceleration = Vec2::Zero();  ///< of A relative to B [m/s^2]

    [[nodiscard]] Vec2 offset_at(double time) const
    {
        const double t = time - start;
        return offset + t * (rate + (0.5 * t) * acceleration);
    }
    [[nodiscard]] Vec2 rate_at(double time) const { return rate + (time - start) * acceleration; }
};

/// Bounds on the relative acceleration, and on its part along a normal; both are exact here.  [m/s^2]
[[nodiscard]] inline double acceleration_bound(const RelativeFlight& relative) { return relative.acceleration.norm(); }
[[nodiscard]] inline double acceleration_bound(const RelativeFlight& relative, const Vec2& normal)
{
    return std::abs(normal.dot(relative.acceleration));
}

/// start  common_start of the two, or any other moment  [s]
[[nodiscard]] inline RelativeFlight relative_flight(const Flyer& a, const Flyer& b, double start)
{
    const BodyState at_a = flight(a.state, a.acceleration, start);
    const BodyState at_b = flight(b.state, b.acceleration, start);
    return {start, at_a.position - at_b.position, at_a.velocity - at_b.velocity, a.acceleration - b.acceleration};
}

/// How a body turns. One that has no spin has its sines taken once.
class Turning
{
public:
    explicit Turning(const BodyState& body)
        : angle_(body.angle), spin_(body.spin), time_(body.time),
          still_(body.spin == 0.0 ? Rotation::of(body.angle) : Rotation{})
    {
    }

    [[nodiscard]] Rotation at(double time) const { return spin_ == 0.0 ? still_ : Rotation::of(angle_at(time)); }
    [[nodiscard]] double spin() const { return spin_; }

    /// Two at a time.
    friend std::array<Rotation, 2> both_at(const Turning& p, const Turning& q, double time)
    {
        if (p.spin_ == 0.0 || q.spin_ == 0.0) return {p.at(time), q.at(time)};
        const auto [of_p, of_q] = sine_cosine(p.angle_at(time), q.angle_at(time));
        return {Rotation{of_p.cosine, of_p.sine}, Rotation{of_q.cosine, of_q.sine}};
    }

private:
    [[nodiscard]] double angle_at(double time) const { return angle_ + spin_ * (time - time_); }

    double angle_;
    double spin_;
    double time_;
    Rotation still_;
};

} // namespace flying
