#include "math/sine_cosine.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "math/exact.hpp"

namespace flying {

namespace {

/// An angle as `quarters` times pi/2 and a rest in [-pi/4, pi/4], to rounding.
struct ReducedAngle
{
    double rest = 0.0;          ///< [rad]
    double rest_tail = 0.0;     ///< what the rest lost when it was rounded [rad]
    std::uint64_t quarters = 0; ///< only its last two bits count
};

constexpr double k_eighth_turn = 0x1.921fb54442d18p-1;         // pi/4
constexpr double k_near = 0x1p20;                              // [rad] up to which the short reduction serves
constexpr double k_far = 0x1p53;                               // [rad] up to which the long one does
constexpr double k_digits_run_out = 0x1p-12;                   // [rad] rests below it want the long one, too
constexpr double k_quarters_per_radian = 0x1.45f306dc9c883p-1; // 2/pi

/// Added to a number below 2^51, it pushes the fraction out of the last place and leaves the nearest whole number
/// there.
constexpr double k_rounder = 0x1.8p52;

/// Reduction for |angle| <= 2^20. The two first parts of pi/2 have 33 bits, so that their products with the number of
/// quarters, of 20 bits at most, are exact.
ReducedAngle reduce_near(double angle)
{
    constexpr double k_part_0 = 0x1.921fb544p+0;
    constexpr double k_part_1 = 0x1.0b4611a6p-34;
    constexpr double k_part_2 = 0x1.3198a2e037073p-69;

    // Count the quarters
    const double pushed = angle * k_quarters_per_radian + k_rounder;
    const double quarters = pushed - k_rounder;

    // Take them off, part by part: the first difference is exact, the second keeps its error
    const double coarse = angle - quarters * k_part_0;
    const Exact fine = two_sum(coarse, -quarters * k_part_1);
    const double tail = fine.error - quarters * k_part_2;
    const Exact rest = two_sum(fine.rounded, tail);
    return {rest.rounded, rest.error, std::bit_cast<std::uint64_t>(pushed)};
}

/// Reduction for any positive angle up to 2^53, and for those that lie so near a multiple of pi/2 that the short way
/// runs out of digits. Four parts of 53 bits, exact products, and a sum that carries its errors along (Ogita, Rump,
/// Oishi, "Accurate sum and dot product", 2005).
ReducedAngle reduce_far(double angle)
{
    constexpr std::array<double, 4> k_parts = {0x1.921fb54442d18p+0, 0x1.1a62633145c07p-54, -0x1.f1976b7ed8fbcp-110,
                                               0x1.4cf98e804177dp-164};
    double quarters = std::floor(angle * k_quarters_per_radian + 0.5);
    for (;;) {
        // List the terms of angle - quarters pi/2
        std::array<double, 8> terms{};
        terms[0] = angle;
        for (std::size_t k = 0; k < 3; ++k) {
            const Exact product = two_product(-quarters, k_parts[k]);
            terms[2 * k + 1] = product.rounded;
            terms[2 * k + 2] = product.error;
        }
        terms[7] = -quarters * k_parts[3];

        // Sum them: each sweep leaves the sum in the last term, and its errors in the others
        for (int sweep = 0; sweep < 4; ++sweep) {
            for (std::size_t k = 1; k < terms.size(); ++k) {
                const Exact sum = two_sum(terms[k], terms[k - 1]);
                terms[k] = sum.rounded;
                terms[k - 1] = sum.error;
            }
        }
        double tail = 0.0;
        for (std::size_t k = 0; k + 1 < terms.size(); ++k) tail += terms[k];
        const Exact rest = two_sum(terms[7], tail);

        // Beyond 2^50 the count can be off by one
        const double more = std::floor(rest.rounded * k_quarters_per_radian + 0.5);
        if (more == 0.0) return {rest.rounded, rest.error, static_cast<std::uint64_t>(quarters)};
        quarters += more;
    }
}

/// 1, -1/(3 2), 1/(5 4 3 2), ...: the Taylor series of the sine over x, in powers of x^2, after its first term.
constexpr std::array<double, 8> k_sine = {
    -1.0 / 6.0,        1.0 / 120.0,        -1.0 / 5040.0,          1.0 / 362880.0,
    -1.0 / 39916800.0, 1.0 / 6227020800.0, -1.0 / 1307674368000.0, 1.0 / 355687428096000.0};

/// The series of the cosine, after 1 - x^2/2.
constexpr std::array<double, 7> k_cosine = {
    1.0 / 24.0,        -1.0 / 720.0,         1.0 / 40320.0,         -1.0 / 3628800.0,
    1.0 / 479001600.0, -1.0 / 87178291200.0, 1.0 / 20922789888000.0};

/// Two numbers side by side, for what is done to two angles alike: the bits are those of one. (A vector of the
/// compilers' own: g++, clang.)
using Two [[gnu::vector_size(16)]] = double;

/// Sine and cosine of one angle or two.
template <typename Number>
struct Sums
{
    Number sine;
    Number cosine;
};

/// Sine and cosine of x + tail, |x| <= pi/4. The first term left out is below 2^-63 of the result.
/// Number  double or Two
template <typename Number>
Sums<Number> series(Number x, Number tail)
{
    const Number x2 = x * x;
    const Number x4 = x2 * x2;
    const Number x8 = x4 * x4;

    // Sum by pairs: the processor works on several at once
    const Number s01 = k_sine[0] + k_sine[1] * x2;
    const Number s23 = k_sine[2] + k_sine[3] * x2;
    const Number s45 = k_sine[4] + k_sine[5] * x2;
    const Number s67 = k_sine[6] + k_sine[7] * x2;
    const Number s = (s01 + s23 * x4) + (s45 + s67 * x4) * x8;
    const Number c01 = k_cosine[0] + k_cosine[1] * x2;
    const Number c23 = k_cosine[2] + k_cosine[3] * x2;
    const Number c45 = k_cosine[4] + k_cosine[5] * x2;
    const Number c = (c01 + c23 * x4) + (c45 + k_cosine[6] * x4) * x8;

    // Add the small to the large last, with what 1 - x^2/2 loses. The tail moves the sine by cos x times itself, the
    // cosine by -sin x times itself
    const Number half = 0.5 * x2;
    const Number most = 1.0 - half;
    const Number lost = (1.0 - most) - half;
    const Number sine = x + (x * (x2 * s) + tail * most);
    const Number cosine = most + (lost + (x4 * c - x * tail));
    return {sine, cosine};
}

/// Turns (cosine, sine) by a number of quarters.
SineCosine turned(const Sums<double>& sc, std::uint64_t quarters)
{
    const bool odd = (quarters & 1) != 0;
    const double sine = odd ? sc.cosine : sc.sine;
    const double cosine = odd ? sc.sine : sc.cosine;

    // Flip the signs by their bits: a branch would be guessed wrongly every other time
    const std::uint64_t sine_sign = (quarters & 2) << 62;
    const std::uint64_t cosine_sign = ((quarters + 1) & 2) << 62;
    return {std::bit_cast<double>(std::bit_cast<std::uint64_t>(sine) ^ sine_sign),
            std::bit_cast<double>(std::bit_cast<std::uint64_t>(cosine) ^ cosine_sign)};
}

/// The long way round, for what is rare. Positive angles only, so that the sine is odd to the bit.
SineCosine sine_cosine_far(double angle)
{
    const ReducedAngle reduced = reduce_far(std::abs(angle));
    const SineCosine sc = turned(series(reduced.rest, reduced.rest_tail), reduced.quarters);
    return {angle < 0.0 ? -sc.sine : sc.sine, sc.cosine};
}

} // namespace

SineCosine sine_cosine(double angle)
{
    const double size = std::abs(angle);

    if (size == 0.0) return {angle, 1.0};
    if (size <= k_eighth_turn) return turned(series(angle, 0.0), 0);
    if (size <= k_near) {
        const ReducedAngle reduced = reduce_near(angle);
        if (std::abs(reduced.rest) < k_digits_run_out) return sine_cosine_far(angle);
        return turned(series(reduced.rest, reduced.rest_tail), reduced.quarters);
    }
    if (size <= k_far) return sine_cosine_far(angle);

    constexpr double k_unknown = std::numeric_limits<double>::quiet_NaN();
    return {k_unknown, k_unknown};
}

std::array<SineCosine, 2> sine_cosine(double first, double second)
{
    const auto is_near = [](double angle) { return std::abs(angle) > k_eighth_turn && std::abs(angle) <= k_near; };
    if (!is_near(first) || !is_near(second)) return {sine_cosine(first), sine_cosine(second)};
    const ReducedAngle one = reduce_near(first);
    const ReducedAngle two = reduce_near(second);
    if (std::min(std::abs(one.rest), std::abs(two.rest)) < k_digits_run_out) {
        return {sine_cosine(first), sine_cosine(second)};
    }
    const Sums<Two> sums = series(Two{one.rest, two.rest}, Two{one.rest_tail, two.rest_tail});
    return {turned({sums.sine[0], sums.cosine[0]}, one.quarters), turned({sums.sine[1], sums.cosine[1]}, two.quarters)};
}

} // namespace flying
