#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <numbers>

#include "beside_disc.hpp"
#include "by_side.hpp"
#include "../02-rectangle/rectangle.hpp"
#include "regular_polygon.hpp"
#include "math/random.hpp"
#include "support/receipts.hpp"

using namespace flying;

namespace {

/// Between 1/32 and 32, every octave as likely as the next.
double any(Random& random)
{
    return std::exp2(random.uniform(-5.0, 5.0));
}

} // namespace

TEST_CASE("a regular polygon is its triangles, about their common tip")
{
    Random random(301);
    for (int k = 0; k < 1000; ++k) {
        const int n = 3 + random.below(98);
        const double R = any(random);
        const double rho = any(random);
        const MassProperties found = regular_polygon_mass(n, R, rho);
        const double m = found.mass;
        const double inertia = found.moment_of_inertia;

        // [regular.tests.inertia]
        // Sine and cosine of the library; each side has about ten roundings
        const double x = std::numbers::pi / n;
        const double area = n * R * R * std::sin(x) * std::cos(x);
        CHECK_EQUATION("regular.mass", m, rho * area, 2e-15, {"\\rho", rho}, {"n", n},
                       {"R", R});
        CHECK_TWIN("regular.mass", m, rho * area / 2, 2e-15);

        const double closed = m * R * R * (0.5 - std::sin(x) * std::sin(x) / 3);
        CHECK_EQUATION("regular.inertia", inertia, closed, 2e-15, {"m", m}, {"n", n},
                       {"R", R});
        const double quarter = m * R * R * (0.5 - std::sin(x) * std::sin(x) / 4);
        CHECK_TWIN("regular.inertia", inertia, quarter, 2e-15);
        // [regular.tests.inertia]

        const double l = 2 * R * std::sin(x);
        const double cot = std::cos(x) / std::sin(x);
        const double by_side = m * l * l / 24 * (1 + 3 * cot * cot);
        CHECK_EQUATION("regular.by_cotangent", inertia, by_side, 3e-15, {"m", m}, {"l", l},
                       {"n", n});
        CHECK_TWIN("regular.by_cotangent", inertia, by_side / 2, 3e-15);
    }
}

TEST_CASE("three, four and six sides are what they were by hand")
{
    Random random(302);
    for (int k = 0; k < 1000; ++k) {
        const double l = any(random);
        const auto of_side = [l](int n) {
            const double radius = 0.5 * l / std::sin(std::numbers::pi / n);
            return regular_polygon_mass(n, radius, 1.0);
        };

        // [regular.tests.special]
        const auto [m_three, three] = of_side(3);
        CHECK_EQUATION("regular.three", three, m_three * l * l / 12, 2e-15, {"m", m_three},
                       {"l", l});
        CHECK_TWIN("regular.three", three, m_three * l * l / 36, 2e-15);

        // The square of chapter 3 comes out of a formula that never met it
        const auto [m_four, four] = of_side(4);
        const double square = rectangle_mass(l, l, 1.0).moment_of_inertia;
        CHECK_EQUATION("regular.four", four, square, 3e-15, {"m", m_four}, {"l", l});
        CHECK_TWIN("regular.four", four, m_four * l * l / 12, 3e-15);
        // [regular.tests.special]

        const auto [m_six, six] = of_side(6);
        CHECK_EQUATION("regular.six", six, 5 * m_six * l * l / 12, 2e-15, {"m", m_six},
                       {"l", l});
        CHECK_TWIN("regular.six", six, 5 * m_six * l * l / 24, 2e-15);
    }
}

// [regular.tests.rates]
TEST_CASE("the gap to a disc closes with the second or the fourth power")
{
    const double pi = std::numbers::pi;
    for (int n = 256; n <= 1024; n *= 2) {
        // What the limits leave out is below x^2; rounding adds up to 1e-4 of the area's
        const double bound = pi * pi / n / n + 1e-4;
        const double left = n * 1.0 * n * (1.0 - beside_disc_of_same_radius(n));
        CHECK_EQUATION("regular.rate", left, 4 * pi * pi / 3, 3e-4, {"n", n});
        CHECK(std::abs(left / (4 * pi * pi / 3) - 1.0) < bound);
        CHECK_TWIN("regular.rate", left, 2 * pi * pi / 3, 3e-4);

        const double over = std::pow(n, 4) * (beside_disc_of_same_area(n) - 1.0);
        const double limit = 4 * std::pow(pi, 4) / 45;
        CHECK_EQUATION("regular.rate_of_area", over, limit, 3e-4, {"n", n});
        CHECK(std::abs(over / limit - 1.0) < bound);
        CHECK_TWIN("regular.rate_of_area", over, limit / 2, 3e-4);
    }
}
// [regular.tests.rates]

// [regular.tests.ratios]
TEST_CASE("beside a disc, a polygon has what the ratios say")
{
    for (int n = 3; n <= 300; ++n) {
        const double x = std::numbers::pi / n;
        const double last = 1 - 2 * std::sin(x) * std::sin(x) / 3;
        const double radius = std::sin(2 * x) / (2 * x) * last;
        const double q_r = beside_disc_of_same_radius(n);
        CHECK_EQUATION("regular.same_radius", q_r, radius, 2e-15, {"x", x});
        CHECK_TWIN("regular.same_radius", q_r, std::sin(x) / x * last, 2e-15);

        const double area = 2 * x / std::sin(2 * x) * last;
        const double q_a = beside_disc_of_same_area(n);
        CHECK_EQUATION("regular.same_area", q_a, area, 2e-15, {"x", x});
        CHECK_TWIN("regular.same_area", q_a, x / std::sin(2 * x) * last, 2e-15);
    }
}
// [regular.tests.ratios]

TEST_CASE("numbers for the text: the hexagon, a race, and the digits of a double")
{
    const double three = beside_disc_of_same_area(3);
    const double six = beside_disc_of_same_area(6);
    CHECK(three > six);
    RECORD_VALUE("regular.hexagon.percent", 100.0 * (six - 1.0));
    RECORD_VALUE("regular.triangle.percent", 100.0 * (three - 1.0));
    RECORD_VALUE("regular.race.triangle", 5.0 * (1.0 - 1.0 / three));
    RECORD_VALUE("regular.race.hexagon", 1800.0 * (1.0 - 1.0 / six));

    // Sides at which the gap falls below half a unit in the last place
    RECORD_VALUE("regular.double.radius", std::numbers::pi * std::sqrt(4.0 / 3.0 * 0x1p53));
    RECORD_VALUE("regular.double.area", std::numbers::pi * std::pow(4.0 / 45.0 * 0x1p53, 0.25));
}

// [regular.tests.cotangent]
TEST_CASE("the cotangent grows without bound, and harms nothing")
{
    double worst = 0.0;
    for (int n = 3; n < 1000000000; n += 1 + n / 7) {
        const MassProperties a = polygon_by_cotangent(n, 1.3, 0.7);
        const MassProperties b = regular_polygon_mass(n, 1.3, 0.7);
        const double ratio = a.moment_of_inertia / b.moment_of_inertia;
        worst = std::max(worst, std::abs(ratio - 1.0));
    }
    RECORD_VALUE("regular.cotangent.worst", worst);
    CHECK(worst < 3e-15);
}
// [regular.tests.cotangent]

// [regular.tests.inside]
TEST_CASE("more sides never weigh less, and never more than the disc around")
{
    const auto keeps_order = [](auto mass_of) {
        double last = 0.0;
        for (int n = 4; n <= (1 << 29); n *= 2) {
            const double mass = mass_of(n, 1.0, 1.0).mass;
            // Half a dozen roundings
            const bool grows = mass >= last * (1.0 - 2e-15);
            const bool fits = mass <= std::numbers::pi * (1.0 + 2e-15);
            if (!grows || !fits) return false;
            last = mass;
        }
        return true;
    };
    CHECK(keeps_order(regular_polygon_mass));
    CHECK(keeps_order(polygon_by_cotangent));
    CHECK(!keeps_order(wrong_polygon_mass));
}
// [regular.tests.inside]

// [regular.tests.wrong]
TEST_CASE("the law of cosines is right at eight sides and void at a billion")
{
    const double right = regular_polygon_mass(8, 1.0, 1.0).moment_of_inertia;
    const double wrong = wrong_polygon_mass(8, 1.0, 1.0).moment_of_inertia;
    CHECK(wrong == doctest::Approx(right).epsilon(2e-15));

    const double million = wrong_polygon_mass(1000000, 1.0, 1.0).mass;
    const double error = million / regular_polygon_mass(1000000, 1.0, 1.0).mass - 1.0;
    RECORD_VALUE("regular.wrong.at-a-million", std::abs(error));
    CHECK(std::abs(error) > 1e-9);
    CHECK(!(wrong_polygon_mass(1000000000, 1.0, 1.0).mass > 0.0));
}
// [regular.tests.wrong]
