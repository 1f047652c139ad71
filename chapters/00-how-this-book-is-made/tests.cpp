#include <cmath>
#include <random>

#include "falling.hpp"
#include "support/receipts.hpp"

using namespace flying;

// [made.tests.fall]
/// Another way to the same number: 1000 spans, each at the mean of its first and its last speed.   [m]
double fall_by_spans(double g, double t)
{
    const double dt = t / 1000;
    double s = 0.0;
    for (int k = 0; k < 1000; ++k) s += 0.5 * (g * (k * dt) + g * ((k + 1) * dt)) * dt;
    return s;
}

TEST_CASE("a body falls by half of g t squared")
{
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> any(0.1, 10.0);
    for (int k = 0; k < 1000; ++k) {
        const double g = any(random);
        const double t = any(random);
        const double s = fall_distance(g, t);

        // The oracle adds 1000 terms, and each sum is rounded by half a unit in the last place
        const double bound = 1.2e-13;
        CHECK_EQUATION("made.fall", s, fall_by_spans(g, t), bound, {"g", g}, {"t", t});
        CHECK_TWIN("made.fall", s, g * t * t / 3, bound);
    }
}
// [made.tests.fall]

// [made.tests.loose]
TEST_CASE("a bound of a tenth takes twelve steps for the closed form")
{
    const double s = fall_distance(9.81, 2.0);
    const double error = std::abs(fall_by_steps(9.81, 2.0, 12) - s) / s;
    CHECK(error < 0.1);
    CHECK_FALSE(error < 1.2e-13);
    RECORD_VALUE("made.loose", error);
}
// [made.tests.loose]

// [made.tests.steps]
TEST_CASE("n steps fall short by one part in n")
{
    for (int n = 1; n <= 1000; n *= 10) {
        const double whole = fall_distance(9.81, 2.0);
        const double by_steps = fall_by_steps(9.81, 2.0, n);

        // Up to 1000 additions, each rounded by half a unit in the last place
        const double bound = 1.2e-13;
        CHECK_EQUATION_SCALED("made.short_by", whole - by_steps, whole / n, whole, bound, {"s", whole}, {"n", n});
        CHECK_TWIN_SCALED("made.short_by", whole - by_steps, whole / (n + 1), whole, bound);
    }
}
// [made.tests.steps]
