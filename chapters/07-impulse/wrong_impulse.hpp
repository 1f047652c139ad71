#pragma once

namespace flying {


/// WRONG, and it looks right: at e = 1 it is.
[[nodiscard]] inline double impulse_two_e(double v_n, double w_n, double e)
{
    if (!(v_n < 0.0)) return 0.0;
    return -2.0 * e * v_n / w_n;
}



/// WRONG, and it looks right: the formula alone.
[[nodiscard]] inline double impulse_without_test(double v_n, double w_n, double e)
{
    return -(1.0 + e) * v_n / w_n;
}



/// WRONG, and it looks right: v_b is the velocity of B alone, along the normal.
[[nodiscard]] inline double impulse_of_one_body(double v_b, double w_n, double e)
{
    if (!(v_b < 0.0)) return 0.0;
    return -(1.0 + e) * v_b / w_n;
}


} // namespace flying
