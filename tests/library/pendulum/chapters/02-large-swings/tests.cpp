#include <cmath>

#include "pendulum/large.hpp"
#include "support/receipts.hpp"

TEST_CASE("swings of any width take what the elliptic integral says")
{
    for (double l = 0.2; l < 5.0; l *= 2.1)
        for (double theta = 0.1; theta < 3.0; theta += 0.3) {
            const double g = 9.81;
            const double k = std::sin(0.5 * theta);
            const double period = pendulum::large_period(l, g, theta);

            // The standard library's integral has about as many digits
            const double expected = 4.0 * std::sqrt(l / g) * std::comp_ellint_1(k);
            CHECK_EQUATION("large.period", period, expected, 1e-13, {"l", l}, {"g", g}, {"k", k});
            CHECK_TWIN("large.period", period, 1.01 * expected, 1e-13);
        }
}
