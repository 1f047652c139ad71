#include <cmath>
#include <numbers>

#include "pendulum/small.hpp"
#include "support/receipts.hpp"

TEST_CASE("small swings take two pi times the root of length over acceleration")
{
    for (double l = 0.1; l < 10.0; l *= 1.7)
        for (double g = 1.0; g < 30.0; g *= 1.9) {
            const double period = pendulum::small_period(l, g);
            const double omega = std::sqrt(g / l);

            // A few roundings on each side
            CHECK_EQUATION("small.period", period, 2.0 * std::numbers::pi / omega, 1e-15, {"l", l}, {"g", g});
            CHECK_TWIN("small.period", period, 2.02 * std::numbers::pi / omega, 1e-15);
        }
}
