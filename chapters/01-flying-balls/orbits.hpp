#pragma once

#include <cmath>
#include <numbers>

#include "central.hpp"
#include "math/rotation.hpp"

namespace flying::steps {


/// An orbit round the origin, counter-clockwise. Its nearest point lies on the positive x
/// axis, and is passed at time 0.
struct Orbit
{
    double mu;  ///< strength of the centre [m^3/s^2]
    double a;   ///< half of the long axis, positive [m]
    double ecc; ///< eccentricity: below 1 an ellipse, above 1 a hyperbola [1]

    /// How fast the mean anomaly M grows.   [1/s]
    [[nodiscard]] double mean_motion() const { return std::sqrt(mu / a) / a; }
    [[nodiscard]] double period() const { return 2.0 * std::numbers::pi / mean_motion(); }
};



/// The E of Kepler's equation E - ecc sin E = M, for 0 <= M <= pi and 0 <= ecc < 1.   [rad]
[[nodiscard]] inline double eccentric_anomaly(double M, double ecc)
{
    // Newton's steps from the right end go left only, and never past the root
    double E = std::numbers::pi;
    for (;;) {
        const SineCosine sc = sine_cosine(E);
        const double next = E - (E - ecc * sc.sine - M) / (1.0 - ecc * sc.cosine);
        if (!(next < E)) return E;
        E = next;
    }
}



/// The body on its ellipse at any time t.
[[nodiscard]] inline Moving on_ellipse(const Orbit& o, double t)
{
    // Leave out whole turns; the way back from the farthest point mirrors the way there
    const double n = o.mean_motion();
    const double turn = 2.0 * std::numbers::pi;
    const double M = n * t - turn * std::floor(n * t / turn + 0.5);
    const double E = std::copysign(eccentric_anomaly(std::abs(M), o.ecc), M);

    const SineCosine sc = sine_cosine(E);
    const double flat = std::sqrt(1.0 - o.ecc * o.ecc);
    const double E_rate = n / (1.0 - o.ecc * sc.cosine);
    return {o.a * Vec2(sc.cosine - o.ecc, flat * sc.sine),
            (o.a * E_rate) * Vec2(-sc.sine, flat * sc.cosine)};
}



/// The H of ecc sinh H - H = M, for M >= 0 and ecc > 1.   [1]
[[nodiscard]] inline double hyperbolic_anomaly(double M, double ecc)
{
    // Start beyond the root: H is smaller than sinh H
    double H = std::asinh(M / (ecc - 1.0));
    for (;;) {
        const double next = H - (ecc * std::sinh(H) - H - M) / (ecc * std::cosh(H) - 1.0);
        if (!(next < H)) return H;
        H = next;
    }
}

/// The body on its hyperbola at any time t.
[[nodiscard]] inline Moving on_hyperbola(const Orbit& o, double t)
{
    const double n = o.mean_motion();
    const double H = std::copysign(hyperbolic_anomaly(std::abs(n * t), o.ecc), t);
    const double steep = std::sqrt(o.ecc * o.ecc - 1.0);
    const double H_rate = n / (o.ecc * std::cosh(H) - 1.0);
    return {o.a * Vec2(o.ecc - std::cosh(H), steep * std::sinh(H)),
            (o.a * H_rate) * Vec2(-std::sinh(H), steep * std::cosh(H))};
}



/// How long a body let go at distance r0 falls straight in until it is at distance r.   [s]
[[nodiscard]] inline double fall_time(double mu, double r0, double r)
{
    const double q = r / r0;
    return std::sqrt(r0 / (2.0 * mu)) * r0 *
           (std::acos(std::sqrt(q)) + std::sqrt(q * (1.0 - q)));
}


} // namespace flying::steps
