#pragma once

#include <array>

namespace flying {

/// Sine and cosine of one angle.
struct SineCosine
{
    double sine;
    double cosine;
};

/// Sine and cosine with the same bits on every machine, which no standard library promises. The sine is odd and the
/// cosine even, to the bit.
///
/// angle  [rad], finite; whole quarter turns are taken off with a pi/2 of over 210 bits, so that the error stays below
///        1 ulp of the result for |angle| <= 2^53, near its zeros too. Beyond that, and for values that are not finite,
///        both results are NaN.
[[nodiscard]] SineCosine sine_cosine(double angle);

/// The same of two angles, to the bit, in less than twice the time.
[[nodiscard]] std::array<SineCosine, 2> sine_cosine(double first, double second);

} // namespace flying
