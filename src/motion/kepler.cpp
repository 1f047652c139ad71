#include "motion/kepler.hpp"

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "math/sine_cosine.hpp"
#include "math/twofold.hpp"
#include "motion/flight.hpp"

namespace flying {

namespace {

/// e^x for x >= 0, with the same bits everywhere; infinite beyond the range of doubles.
[[nodiscard]] double exponential(double x)
{
    constexpr double k_per_ln2 = 0x1.71547652b82fep+0;
    constexpr double k_ln2_upper = 0x1.62e42feep-1; // 32 bits: its products with the count are exact
    constexpr double k_ln2_lower = 0x1.a39ef35793c76p-33;
    constexpr double k_most = 709.0;
    if (!(x <= k_most)) return std::numeric_limits<double>::infinity();

    // Take off the powers of two; what is left is at most ln 2 / 2
    const double doublings = std::floor(x * k_per_ln2 + 0.5);
    const double rest = (x - doublings * k_ln2_upper) - doublings * k_ln2_lower;

    // Sum the series from its small end
    double tail = 0.0;
    for (double k = 14.0; k >= 3.0; k -= 1.0) tail = (1.0 + tail) * rest / k;
    const double series = 1.0 + (rest + 0.5 * rest * rest * (1.0 + tail));
    return series * std::bit_cast<double>(static_cast<std::uint64_t>(doublings + 1023.0) << 52);
}

/// The four functions of which flights are made: G0 = 1 - beta G2, G1 = s - beta G3, and each is the derivative of the
/// next by s. On an ellipse they are made of sine and cosine, on a hyperbola of their hyperbolic sisters; on a parabola
/// they are 1, s, s^2/2, s^3/6.
struct Universal
{
    double g0;
    double g1;
    double g2;
    double g3;
};

/// 1/(k+2)! and 1/(k+3)!, every second of them, with alternating signs: the first term left out is below 2^-58.
constexpr std::array<double, 11> k_second = {1.0 / 2.0,
                                             -1.0 / 24.0,
                                             1.0 / 720.0,
                                             -1.0 / 40320.0,
                                             1.0 / 3628800.0,
                                             -1.0 / 479001600.0,
                                             1.0 / 87178291200.0,
                                             -1.0 / 20922789888000.0,
                                             1.0 / 6402373705728000.0,
                                             -1.0 / 2432902008176640000.0,
                                             1.0 / 1124000727777607680000.0};
constexpr std::array<double, 11> k_third = {1.0 / 6.0,
                                            -1.0 / 120.0,
                                            1.0 / 5040.0,
                                            -1.0 / 362880.0,
                                            1.0 / 39916800.0,
                                            -1.0 / 6227020800.0,
                                            1.0 / 1307674368000.0,
                                            -1.0 / 355687428096000.0,
                                            1.0 / 121645100408832000.0,
                                            -1.0 / 51090942171709440000.0,
                                            1.0 / 25852016738884976640000.0};

/// root  of |beta|; s  >= 0
[[nodiscard]] Universal universal(double beta, double root, double s)
{
    constexpr double k_series = 2.0;
    const double z = beta * (s * s);
    if (std::abs(z) <= k_series) {
        // Few turns, or nearly a parabola: the series, which knows nothing of the kind of orbit
        double second = 0.0;
        double third = 0.0;
        for (std::size_t k = k_second.size(); k-- > 0;) {
            second = second * z + k_second[k];
            third = third * z + k_third[k];
        }
        const double g2 = s * s * second;
        const double g3 = s * s * s * third;
        return {1.0 - beta * g2, s - beta * g3, g2, g3};
    }

    // Half the angle, so that 1 - cos x = 2 sin^2 (x/2) doesn't cancel
    if (beta > 0.0) {
        const SineCosine half = sine_cosine(0.5 * (root * s));
        const double g1 = 2.0 * half.sine * half.cosine / root;
        const double versed = 2.0 * half.sine * half.sine;
        return {1.0 - versed, g1, versed / beta, (s - g1) / beta};
    }
    const double grown = exponential(0.5 * (root * s));
    const double sine = 0.5 * (grown - 1.0 / grown);
    const double cosine = 0.5 * (grown + 1.0 / grown);
    const double g1 = 2.0 * sine * cosine / root;
    const double versed = 2.0 * sine * sine;
    return {1.0 + versed, g1, versed / -beta, (g1 - s) / -beta};
}

/// Square root with twice the digits; a > 0.
[[nodiscard]] Twofold square_root(const Twofold& a)
{
    const double first = std::sqrt(a.upper);
    const Twofold left_over = a - Twofold(two_product(first, first));
    return two_sum_ordered(first, left_over.upper / (2.0 * first));
}

[[nodiscard]] Twofold square(const Vec2& a)
{
    return Twofold(two_product(a.x(), a.x())) + Twofold(two_product(a.y(), a.y()));
}

} // namespace

/// How far a flight has come.
struct KeplerFlight::Progress
{
    Universal g;
    double time;          ///< since the start [s]
    double distance;      ///< from the centre [m]
    double distance_rate; ///< its derivative by s [m^2/s]
};

KeplerFlight::KeplerFlight(const PointMotion& start, double mu) : start_(start), mu_(mu)
{
    // The two terms of the binding nearly cancel on long orbits, whose period needs all of its digits
    const Twofold r = square_root(square(start.position));
    const Twofold binding = Twofold(2.0 * mu) / r - square(start.velocity);
    distance_ = r.rounded();
    outward_ = start.position.dot(start.velocity);
    binding_ = binding.upper;
    binding_tail_ = binding.lower;
    root_ = std::sqrt(std::abs(binding_));
}

/// Eccentricity, rounded upwards: it is the root of a difference that vanishes on a circle.
double KeplerFlight::greatest_eccentricity() const
{
    constexpr double k_rounding = 0x1p-50;
    const double l = cross(start_.position, start_.velocity);
    const double flatness2 = 1.0 - binding_ * ((l / mu_) * (l / mu_));
    return std::sqrt((flatness2 > 0.0 ? flatness2 : 0.0) + k_rounding);
}

double KeplerFlight::nearest() const
{
    constexpr double k_downwards = 1.0 - 1e-12;
    const double l = cross(start_.position, start_.velocity);
    return k_downwards * (l * (l / mu_) / (1.0 + greatest_eccentricity()));
}

double KeplerFlight::farthest() const
{
    constexpr double k_upwards = 1.0 + 1e-12;
    if (!(binding_ > 0.0)) return std::numeric_limits<double>::infinity();
    return k_upwards * (mu_ / binding_ * (1.0 + greatest_eccentricity()));
}

double KeplerFlight::greatest_speed(double r) const
{
    constexpr double k_upwards = 1.0 + 1e-12;
    const double speed2 = 2.0 * mu_ / r - binding_;
    return speed2 > 0.0 ? k_upwards * std::sqrt(speed2) : 0.0;
}

/// s          grows along the flight by dt / r [s/m]
/// direction  +1 into the future, -1 into the past
KeplerFlight::Progress KeplerFlight::progress(double s, double direction) const
{
    const Universal g = universal(binding_, root_, s);
    const double outward = direction * outward_;
    Progress now{g, 0.0, 0.0, 0.0};
    now.time = (distance_ * g.g1 + outward * g.g2) + mu_ * g.g3;
    now.distance = (distance_ * g.g0 + outward * g.g1) + mu_ * g.g2;
    now.distance_rate = outward * g.g0 + (mu_ - binding_ * distance_) * g.g1;
    return now;
}

/// What is left of t > 0 after the nearest whole number of turns; t itself off the ellipse, or within half a turn.
double KeplerFlight::less_whole_turns(double t) const
{
    constexpr double k_turn = 0x1.921fb54442d18p+2; // 2 pi
    constexpr double k_turn_tail = 0x1.1a62633145c07p-52;
    constexpr double k_most_turns = 0x1p52;
    if (!(binding_ > 0.0)) return t;
    const double turns = std::floor(t * (binding_ * root_) / (k_turn * mu_) + 0.5);
    if (!(turns >= 1.0) || turns > k_most_turns) return turns > k_most_turns ? 0.0 : t;

    // Kepler's third law, with twice the digits
    const Twofold beta = Twofold(two_sum_ordered(binding_, binding_tail_));
    const Twofold period = Twofold(two_sum_ordered(k_turn, k_turn_tail)) * Twofold(mu_) / (beta * square_root(beta));
    return (Twofold(t) - Twofold(turns) * period).rounded();
}

/// Where to look for the s at which the time is t > 0.
double KeplerFlight::first_guess(double t, double outward) const
{
    // Shortly after the start: two terms of the series
    const double step = t / distance_;
    const double bend = mu_ - binding_ * distance_;
    if (std::abs(outward) * step <= 0.25 * distance_ && std::abs(bend) * (step * step) <= 0.5 * distance_) {
        return step * (1.0 - 0.5 * (outward / distance_) * step);
    }

    // On an ellipse: Kepler's equation as the difference of two anomalies (Danby, "The solution of Kepler's equation
    // III", 1987)
    constexpr double k_far_round = 0.5;
    constexpr double k_lead = 0.85;
    const double mean = t * (binding_ * root_) / mu_;
    if (binding_ > 0.0 && mean > k_far_round) {
        const double e_cosine = bend / mu_;
        const double e_sine = outward * root_ / mu_;
        const double middle = mean - e_sine;
        const SineCosine sc = sine_cosine(middle);
        const double height = e_sine * sc.cosine + e_cosine * sc.sine;
        const double e = std::sqrt(e_cosine * e_cosine + e_sine * e_sine);
        return (middle + std::copysign(k_lead * e, height)) / root_;
    }

    // Far from the start the cube of s takes over, up to a factor of two; on a hyperbola later its exponential
    const int cube = std::ilogb(6.0 * t / mu_);
    const int third = (cube >= 0 ? cube : cube - 2) / 3;
    double guess = std::ldexp(1.0, third);
    if (outward >= 0.0 && step < guess) guess = step;
    if (binding_ < 0.0 && guess * root_ > 1.0) {
        constexpr double k_ln2 = 0x1.62e42fefa39efp-1;
        const double grown = distance_ + outward / root_ + mu_ / -binding_;
        const double logarithm = k_ln2 * (std::ilogb(2.0 * (root_ * t) / grown) + 1);
        if (logarithm > 0.0 && logarithm < guess * root_) guess = logarithm / root_;
    }
    return guess;
}

/// The s at which the time is t > 0. The time grows with s, for its derivative is the distance: steps of third order
/// (Halley), kept between the last s that was too early and the last that was too late.
double KeplerFlight::solve(double t, double direction) const
{
    constexpr double k_converged = 0x1p-26; // steps this short leave an error of the third power
    constexpr double k_last_place = 0x1p-52;
    constexpr int k_patience = 30;
    constexpr int k_most_steps = 400;
    double early = 0.0;
    double late = std::numeric_limits<double>::infinity();
    double s = first_guess(t, direction * outward_);
    if (!(s > 0.0)) s = t / distance_;
    for (int k = 0; k < k_most_steps; ++k) {
        const Progress now = progress(s, direction);
        const double excess = now.time - t;
        if (excess == 0.0) return s;
        if (excess < 0.0) early = s;
        else late = s;

        // The step that a parabola through here asks for
        const double straight = excess / now.distance;
        const double step = excess / (now.distance - 0.5 * (now.distance_rate * straight));
        double next = s - step;
        if (std::abs(step) <= k_converged * s) return next;

        // Where it leads out of the bracket, or gets nowhere, halve the bracket
        const bool is_slow = k > k_patience && (k & 1) != 0;
        if (!(next > early && next < late) || is_slow) {
            next = late < std::numeric_limits<double>::infinity() ? 0.5 * (early + late) : 2.0 * s;
            if (std::abs(next - s) <= k_last_place * s) return next;
        }
        s = next;
    }
    return s;
}

PointMotion KeplerFlight::after(double t) const
{
    // Backwards is forwards with the velocity turned round
    double direction = t < 0.0 ? -1.0 : 1.0;
    double wait = less_whole_turns(std::abs(t));
    if (wait < 0.0) {
        direction = -direction;
        wait = -wait;
    }
    if (wait == 0.0) return start_;

    // A straight fall goes through the centre, where only the distance's rounding keeps the speed finite
    constexpr double k_centre = 0x1p-104;
    const Progress end = progress(solve(wait, direction), direction);
    const double r = end.distance > k_centre * distance_ ? end.distance : k_centre * distance_;

    // The new place and velocity are sums of the old ones: add what changes to what there was
    const double f_less_1 = -(mu_ * end.g.g2) / distance_;
    const double g = distance_ * end.g.g1 + direction * outward_ * end.g.g2;
    const double f_rate = -(mu_ * end.g.g1) / (distance_ * r);
    const double g_rate_less_1 = -(mu_ * end.g.g2) / r;
    const Vec2& x = start_.position;
    const Vec2 v = direction * start_.velocity;
    return {x + (f_less_1 * x + g * v), direction * (v + (f_rate * x + g_rate_less_1 * v))};
}

BodyState flight(const BodyState& body, const CentralField& field, double time)
{
    const double t = time - body.time;
    const KeplerFlight orbit({body.position - field.centre, body.velocity}, field.mu);
    const PointMotion motion = orbit.after(t);
    BodyState after = body;
    after.position = field.centre + motion.position;
    after.velocity = motion.velocity;
    after.angle = body.angle + body.spin * t;
    after.time = time;
    return after;
}

BodyState flight(const BodyState& body, const Field& field, double time)
{
    const auto* central = std::get_if<CentralField>(&field);
    return central ? flight(body, *central, time) : flight(body, uniform_acceleration(field), time);
}

} // namespace flying
