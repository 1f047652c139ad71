#pragma once

#include "math/exact.hpp"

namespace flying {

/// A number carried with twice the digits, as a double and the much smaller rest: relative
/// error of a sum, product or quotient below 2^-100, given that the products' bounds of
/// math/exact.hpp hold. Sums of terms with both signs keep their digits where plain doubles
/// lose them. Methods of Dekker 1971.
struct Twofold
{
    double upper = 0.0;
    double lower = 0.0;

    Twofold() = default;
    Twofold(double a) : upper(a) {}
    Twofold(const Exact& a) : upper(a.rounded), lower(a.error) {}

    /// The nearest double.
    [[nodiscard]] double rounded() const { return upper + lower; }

    friend Twofold operator-(const Twofold& a)
    {
        Twofold negative;
        negative.upper = -a.upper;
        negative.lower = -a.lower;
        return negative;
    }

    friend Twofold operator+(const Twofold& a, const Twofold& b)
    {
        const Exact upper_sum = two_sum(a.upper, b.upper);
        const Exact lower_sum = two_sum(a.lower, b.lower);
        const Exact sum =
            two_sum_ordered(upper_sum.rounded, upper_sum.error + lower_sum.rounded);
        return two_sum_ordered(sum.rounded, sum.error + lower_sum.error);
    }

    friend Twofold operator-(const Twofold& a, const Twofold& b) { return a + -b; }

    friend Twofold operator*(const Twofold& a, const Twofold& b)
    {
        const Exact product = two_product(a.upper, b.upper);
        const double crossed = a.upper * b.lower + a.lower * b.upper;
        return two_sum_ordered(product.rounded, product.error + crossed);
    }

    /// b not zero.
    friend Twofold operator/(const Twofold& a, const Twofold& b)
    {
        // Divide, look at what is left over, divide that too
        const double first = a.upper / b.upper;
        const Twofold left_over = a - b * Twofold(first);
        const double second = left_over.upper / b.upper;
        const Twofold left_after = left_over - b * Twofold(second);
        return Twofold(two_sum_ordered(first, second)) +
               Twofold(left_after.upper / b.upper);
    }
};

} // namespace flying
