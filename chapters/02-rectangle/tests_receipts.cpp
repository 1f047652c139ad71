#include <array>
#include <cmath>
#include <numbers>

#include "door.hpp"
#include "rectangle.hpp"
#include "math/random.hpp"
#include "pieces.hpp"
#include "support/receipts.hpp"
#include "wrong_triangle.hpp"

using namespace flying;

namespace {

/// Between 1/32 and 32, every octave as likely as the next.
double any(Random& random)
{
    return std::exp2(random.uniform(-5.0, 5.0));
}

} // namespace

// [rectangle.tests.inertia]
/// The integral of x^2 + y^2 over the plate by Simpson's rule along either side, which is exact for squares.
double by_simpson(double w, double h)
{
    const double weights[] = {1.0, 4.0, 1.0};
    double sum = 0.0;
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) {
            const double x = 0.5 * (i - 1) * w;
            const double y = 0.5 * (j - 1) * h;
            sum += weights[i] * weights[j] * (x * x + y * y);
        }
    }
    return sum / 36.0 * w * h;
}

TEST_CASE("a rectangle has a twelfth of its mass times the squares of its sides")
{
    Random random(201);
    for (int k = 0; k < 1000; ++k) {
        const double w = any(random);
        const double h = any(random);
        const double rho = any(random);
        const MassProperties plate = rectangle_mass(w, h, rho);
        const double m = rho * w * h;
        CHECK_EQUATION("rectangle.mass", plate.mass, m, 1e-15, {"\\rho", rho}, {"w", w},
                       {"h", h});
        CHECK_TWIN("rectangle.mass", plate.mass, 2.0 * m, 1e-15);
        const double I = plate.moment_of_inertia;
        // Nine positive terms, and some ten roundings of half a unit in the last place
        CHECK_EQUATION("rectangle.inertia", I, rho * by_simpson(w, h), 2e-15, {"m", m}, {"w", w}, {"h", h});
        const double slip = m / 12 * (w * w + h * h * h);
        CHECK_TWIN("rectangle.inertia", I, slip, 2e-15);
    }
}
// [rectangle.tests.inertia]

// [rectangle.tests.cubed]
TEST_CASE("h cubed for h squared is right at one height alone")
{
    const auto with_slip = [](double w, double h) {
        const double m = w * h;
        return m / 12 * (w * w + h * h * h);
    };
    const double at_one = rectangle_mass(2.0, 1.0, 1.0).moment_of_inertia;
    CHECK(with_slip(2.0, 1.0) == doctest::Approx(at_one).epsilon(1e-15));

    const double true_moment = rectangle_mass(2.0, 3.0, 1.0).moment_of_inertia;
    RECORD_VALUE("rectangle.slip", with_slip(2.0, 3.0) / true_moment);
    CHECK(with_slip(2.0, 3.0) > 2.0 * true_moment);
}
// [rectangle.tests.cubed]


TEST_CASE("n by n points fall short by one part in n squared")
{
    for (int n = 1; n <= 100; ++n) {
        const MassProperties plate = rectangle_mass(2.0, 1.0, 6.0);
        const double whole = plate.moment_of_inertia;
        const double lost = whole - inertia_by_pieces(plate.mass, 2.0, 1.0, n);

        // Up to 10,000 additions, whose roundings mostly cancel; the loss is over 1e-4
        const double bound = 1e-13;
        CHECK_EQUATION_SCALED("rectangle.lost", lost, whole / (n * n), whole, bound, {"I", whole}, {"n", n});
        CHECK_TWIN_SCALED("rectangle.lost", lost, whole / (n * n + 1), whole, bound);
    }
}


TEST_CASE("a rod as thin as a hair has a twelfth about its middle and a third about its end")
{
    Random random(202);
    for (int k = 0; k < 1000; ++k) {
        const double w = any(random);
        const double m = any(random);
        // The thickness adds its own square: 1e-18 of the length's
        const MassProperties rod = rectangle_mass(w, 1e-9 * w, m / (w * (1e-9 * w)));
        CHECK_EQUATION("rectangle.rod", rod.moment_of_inertia, m * w * w / 12, 2e-15, {"m", m}, {"w", w});
        CHECK_TWIN("rectangle.rod", rod.moment_of_inertia, m * w * w / 13, 2e-15);

        const double hinged = about_parallel_axis(rod, 0.5 * w);
        CHECK_EQUATION("rectangle.hinge", hinged, m * w * w / 3, 2e-15, {"m", m}, {"w", w});
        CHECK_TWIN("rectangle.hinge", hinged, m * w * w / 4, 2e-15);

        const double felt = mass_felt(hinged, w);
        CHECK_EQUATION("rectangle.handle", felt, m / 3, 2e-15, {"m", m});
        CHECK_TWIN("rectangle.handle", felt, m / 4, 2e-15);
    }
}

namespace {


/// A plate of density 1 about its own corner: a quarter of four such plates.
double about_corner(double width, double height)
{
    const MassProperties four = rectangle_mass(2 * width, 2 * height, 1.0);
    return four.moment_of_inertia / 4;
}


} // namespace

// [rectangle.tests.parallel]
TEST_CASE("an axis moved aside adds the mass times the distance squared")
{
    Random random(203);
    for (int k = 0; k < 1000; ++k) {
        const double w = any(random);
        const double h = any(random);
        const double d = any(random);
        const MassProperties plate = rectangle_mass(w, h, 1.0);
        // The oracle knows nothing of the theorem
        const double far = 2 * about_corner(d + w / 2, h / 2);
        const double across = 2 * about_corner(std::abs(d - w / 2), h / 2);
        const double near = d >= w / 2 ? across : -across;
        // Far and near may differ by little: the rounding counts with the larger
        const double moved = about_parallel_axis(plate, d);
        const auto [m, I] = plate;
        CHECK_EQUATION_SCALED("rectangle.parallel", moved, far - near, far, 2e-15, {"I", I},
                              {"m", m}, {"d", d});
        CHECK_TWIN_SCALED("rectangle.parallel", moved, I + 2 * m * d * d, far, 2e-15);
    }
}
// [rectangle.tests.parallel]


TEST_CASE("what the finger's work gives is the motion of the mass that it feels")
{
    Random random(204);
    for (int k = 0; k < 1000; ++k) {
        const double inertia = any(random);
        const double d = any(random);
        const double force = any(random);
        const double time = any(random);

        // A mass pushed freely comes as far as the finger does
        const double way = d * angle_turned(inertia, force * d, time);
        const double free_mass = force * time * time / (2 * way);
        CHECK_EQUATION("rectangle.felt", mass_felt(inertia, d), free_mass, 3e-15,
                       {"I_A", inertia}, {"d", d});
        CHECK_TWIN("rectangle.felt", mass_felt(inertia, d), 2 * free_mass, 3e-15);

        const double turned = angle_turned(inertia, force * d, time);
        const double closed = force * d * time * time / (2 * inertia);
        CHECK_EQUATION("rectangle.turned", turned, closed, 2e-15, {"F", force}, {"d", d},
                       {"t", time}, {"I_A", inertia});
        CHECK_TWIN("rectangle.turned", turned, force * d * time * time / inertia, 2e-15);
    }
}


TEST_CASE("discs and rings have half of their mass times the squares of their radii")
{
    Random random(205);
    for (int k = 0; k < 1000; ++k) {
        const double R = any(random);
        const double a = random.uniform(0.0, R);
        const double rho = any(random);
        const MassProperties disc = disc_mass(R, rho);
        const double m = rho * std::numbers::pi * R * R;
        // Simpson's rule, which is exact for the cube under the integral over the rings
        const double half = R / 2;
        const double by_rings = 2 * std::numbers::pi * rho * (4 * half * half * half + R * R * R) * R / 6;
        CHECK_EQUATION("rectangle.disc", disc.moment_of_inertia, by_rings, 2e-15, {"m", m}, {"R", R});
        CHECK_TWIN("rectangle.disc", disc.moment_of_inertia, m * R * R / 3, 2e-15);

        const MassProperties ring = annulus_mass(a, R, rho);
        const double left = rho * std::numbers::pi * (R * R - a * a);
        // R^2 - a^2 by squares loses digits where the two are near: the rounding counts with the disc
        CHECK_EQUATION_SCALED("rectangle.annulus_mass", ring.mass, left, m, 2e-15, {"\\rho", rho}, {"R", R}, {"a", a});
        CHECK_TWIN_SCALED("rectangle.annulus_mass", ring.mass, rho * std::numbers::pi * (R * R + a * a), m, 2e-15);
        const double closed = rho * std::numbers::pi / 2 * (R * R * R * R - a * a * a * a);
        const double whole = disc.moment_of_inertia;
        CHECK_EQUATION_SCALED("rectangle.annulus", ring.moment_of_inertia, closed, whole, 2e-15, {"m", ring.mass},
                              {"R", R}, {"a", a});
        CHECK_TWIN_SCALED("rectangle.annulus", ring.moment_of_inertia, ring.mass / 2 * (R * R - a * a), whole, 2e-15);
    }
}

// [rectangle.tests.thin]
TEST_CASE("the squares of two near radii lose what their product keeps")
{
    const double outer = 1.0;
    const double inner = 1.0 - 0x1p-40;
    const double ring = annulus_mass(inner, outer, 1.0).mass;

    // Both factors are exact here, so pi alone is rounded
    const double exact = std::numbers::pi * 0x1p-40 * (2.0 - 0x1p-40);
    CHECK(std::abs(ring - exact) <= 4e-16 * exact);

    const double pi = std::numbers::pi;
    const double by_squares = pi * outer * outer - pi * inner * inner;
    const double error = std::abs(by_squares - exact) / exact;
    RECORD_VALUE("rectangle.thin.by-squares", error);
    CHECK(error > 1e-6);
}
// [rectangle.tests.thin]


TEST_CASE("two triangles make their square")
{
    Random random(206);
    for (int k = 0; k < 1000; ++k) {
        const double L = any(random);
        const MassProperties half = half_square_mass(L, 1.0);
        const double d = L / (3.0 * std::sqrt(2.0));
        const double together = 2.0 * about_parallel_axis(half, d);
        const double square = rectangle_mass(L, L, 1.0).moment_of_inertia;
        CHECK(together == doctest::Approx(square).epsilon(2e-15));

        const double m = half.mass;
        const double inertia = half.moment_of_inertia;
        const double by_axes = square / 2 - m * d * d;
        CHECK_EQUATION("rectangle.half", inertia, by_axes, 3e-15, {"m", m}, {"L", L});
        CHECK_TWIN("rectangle.half", inertia, m * L * L / 36, 3e-15);

        const double wrong = wrong_half_square_mass(L, 1.0).moment_of_inertia;
        const double ratio = wrong / inertia;
        CHECK_EQUATION("rectangle.ratio", ratio, L * L / 4, 2e-15, {"L", L});
        CHECK_TWIN("rectangle.ratio", ratio, L / 2, 2e-15);
    }
}


// [rectangle.tests.units]
TEST_CASE("twice the lengths make sixteen times the moment of inertia")
{
    const auto growth = [](auto mass_of) {
        const double small = mass_of(0.7, 1.0).moment_of_inertia;
        return mass_of(2.0 * 0.7, 1.0).moment_of_inertia / small;
    };
    CHECK(growth(half_square_mass) == 16.0);
    CHECK(growth(wrong_half_square_mass) == 64.0);

    // At legs of 2 m no comparison of numbers can tell the two apart
    const auto wrong_share = [](double leg) {
        const double right = half_square_mass(leg, 1.0).moment_of_inertia;
        return wrong_half_square_mass(leg, 1.0).moment_of_inertia / right;
    };
    CHECK(wrong_share(2.0) == doctest::Approx(1.0).epsilon(1e-15));
    RECORD_VALUE("rectangle.wrong.at-100", wrong_share(100.0));
}
// [rectangle.tests.units]
