#include "rods/rod.hpp"
#include "support/receipts.hpp"

TEST_CASE("a rod about its end has a third of m l squared")
{
    for (double m = 0.5; m < 20.0; m *= 1.7)
        for (double l = 0.1; l < 4.0; l *= 1.3) {
            const double inertia = flying::rod_about_end(m, l);

            // Three roundings on each side
            CHECK_EQUATION("hinge.end", inertia, m / 3.0 * l * l, 1e-15, {"m", m}, {"l", l});
            CHECK_TWIN("hinge.end", inertia, m / 12.0 * l * l, 1e-15);
        }
}
