#pragma once

namespace flying {


/// Moment of inertia of a plate about its centre, each of n x n equal pieces
/// taken for a point.   [kg m^2]
[[nodiscard]] inline double inertia_by_pieces(double mass, double width, double height,
                                              int n)
{
    const double piece = mass / n / n;
    double sum = 0.0;
    for (int i = 1; i <= n; ++i) {
        for (int j = 1; j <= n; ++j) {
            const double x = (2 * i - n - 1) * width / (2 * n);
            const double y = (2 * j - n - 1) * height / (2 * n);
            sum += piece * (x * x + y * y);
        }
    }
    return sum;
}


} // namespace flying
