#include "math/orientation.hpp"

#include <array>
#include <cmath>

#include "math/exact.hpp"

namespace flying {

namespace {

int sign(double x)
{
    return (x > 0.0 ? 1 : 0) - (x < 0.0 ? 1 : 0);
}

/// Sign of a sum of six exact products. An expansion, a list of numbers that overlap in no
/// bit and grow from term to term, takes up one product after another without loss.
int sign_of_sum(const std::array<std::array<double, 2>, 6>& factors)
{
    std::array<double, 12> expansion{};
    std::size_t count = 0;
    for (const auto& [a, b] : factors) {
        const Exact product = two_product(a, b);
        for (double term : {product.error, product.rounded}) {
            // Carry the term through: each place keeps what the sum there loses
            for (std::size_t k = 0; k < count; ++k) {
                const Exact sum = two_sum(term, expansion[k]);
                term = sum.rounded;
                expansion[k] = sum.error;
            }
            expansion[count++] = term;
        }
    }
    // [orientation.exact.last]
    for (std::size_t k = count; k-- > 0;) {
        if (expansion[k] != 0.0) return sign(expansion[k]);
    }
    return 0;
    // [orientation.exact.last]
}

} // namespace

int orientation(const Vec2& a, const Vec2& b, const Vec2& c)
{
    const double ux = a.x() - c.x();
    const double uy = a.y() - c.y();
    const double vx = b.x() - c.x();
    const double vy = b.y() - c.y();

    // [orientation.signs]
    // Compare the signs of the products: no difference of doubles rounds to a wrong sign
    const int left_sign = sign(ux) * sign(vy);
    const int right_sign = sign(uy) * sign(vx);
    if (left_sign != right_sign) return left_sign > right_sign ? 1 : -1;
    if (left_sign == 0) return 0;
    // [orientation.signs]

    // [orientation.filter]
    // Trust the rounded difference where it is larger than all that rounding can do
    constexpr double k_unit = 0x1p-53;
    constexpr double k_worst_error = (3.0 + 16.0 * k_unit) * k_unit;
    constexpr double k_no_underflow = 0x1p-900;
    const double left = ux * vy;
    const double right = uy * vx;
    const double difference = left - right;
    const double size = std::abs(left + right);
    if (size > k_no_underflow && std::abs(difference) > k_worst_error * size)
        return sign(difference);
    // [orientation.filter]

    // [orientation.last]
    // Multiply out, so that only given numbers are multiplied, and sum without loss
    return sign_of_sum({{{a.x(), b.y()},
                         {-a.y(), b.x()},
                         {b.x(), c.y()},
                         {-b.y(), c.x()},
                         {c.x(), a.y()},
                         {-c.y(), a.x()}}});
    // [orientation.last]
}

} // namespace flying
