#pragma once

namespace flying {

/// A rounded result and what rounding took from it: `rounded + error` is the exact result.
struct Exact
{
    double rounded;
    double error;
};

/// a + b without loss, for all finite numbers whose sum is finite (Knuth, "The Art of
/// Computer Programming 2", 4.2.2).
[[nodiscard]] inline Exact two_sum(double a, double b)
{
    const double sum = a + b;
    const double b_seen = sum - a;
    const double a_seen = sum - b_seen;
    return {sum, (a - a_seen) + (b - b_seen)};
}

/// a + b without loss where |a| >= |b| or a is zero.
[[nodiscard]] inline Exact two_sum_ordered(double a, double b)
{
    const double sum = a + b;
    return {sum, b - (sum - a)};
}

/// `a` as the sum of two numbers of 26 bits each; |a| <= 2^996.
[[nodiscard]] inline Exact halves(double a)
{
    const double scaled = 134217729.0 * a; // 2^27 + 1
    const double upper = scaled - (scaled - a);
    return {upper, a - upper};
}

/// a b without loss, where |a| and |b| are at most 2^996, and the product is zero or between 2^-968 and 2^1020 (Dekker,
/// "A floating-point technique for extending the available precision", 1971). No fused multiply-add: some machines have
/// none.
[[nodiscard]] inline Exact two_product(double a, double b)
{
    const double product = a * b;
    const Exact a_half = halves(a);
    const Exact b_half = halves(b);
    const double upper = a_half.rounded * b_half.rounded - product;
    const double middle = (upper + a_half.rounded * b_half.error) + a_half.error * b_half.rounded;
    return {product, middle + a_half.error * b_half.error};
}

/// x^2 + y^2 - 1 for a unit vector (x, y) as rounding leaves it, |x| and |y| at most 2; error below 2^-75.
///
/// Near 1 the sum of squares in doubles can't tell: above 1 doubles are twice as far apart as below, so what it loses leans
/// to one side. Each component is split into a multiple of 2^-26, whose square is exact, and a rest.
[[nodiscard]] inline double excess_of_unit(double x, double y)
{
    constexpr double k_multiples = 100663296.0; // 1.5 * 2^26: added to x, its last digit stands for 2^-26
    const double x_upper = (x + k_multiples) - k_multiples;
    const double y_upper = (y + k_multiples) - k_multiples;
    const double upper = (x_upper * x_upper - 1.0) + y_upper * y_upper;
    return upper + ((x - x_upper) * (x + x_upper) + (y - y_upper) * (y + y_upper));
}

} // namespace flying
