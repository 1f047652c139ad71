#include <algorithm>
#include <cmath>
#include <vector>

#include "exact_moments.hpp"
#include "mass/polygon.hpp"
#include "../02-rectangle/rectangle.hpp"
#include "math/random.hpp"
#include "outlines.hpp"
#include "support/receipts.hpp"
#include "wrong_polygon.hpp"

using namespace flying;
using namespace flying::outlines;

namespace {

/// Between 1/32 and 32, every octave as likely as the next.
double any(Random& random)
{
    return std::exp2(random.uniform(-5.0, 5.0));
}

Vec2 any_point(Random& random)
{
    const double x = random.uniform(-1.0, 1.0);
    const double y = random.uniform(-1.0, 1.0);
    return Vec2(x, y);
}

/// Second moment about another point.
double about_point(const AreaMoments& moments, const Vec2& point)
{
    return moments.second_moment + moments.area * (moments.centroid - point).squaredNorm();
}

} // namespace

TEST_CASE("a triangle about its corner: the integral on its edges, by hand and by the engine")
{
    Random random(401);
    for (int k = 0; k < 1000; ++k) {
        const Vec2 a = any_point(random);
        const Vec2 b = any_point(random);
        const double rho = any(random);
        const AreaMoments engine = moments_of_ring(std::vector<Vec2>{Vec2(0, 0), a, b});

        // Cross products of near vectors cancel: the oracle's roundings count with the products
        const double size = a.norm() * b.norm();
        const double area = 0.5 * (a.x() * b.y() - a.y() * b.x());
        CHECK_EQUATION_SCALED("polygon.cross", engine.area, area, size, 1e-15, {"A_x", a.x()}, {"A_y", a.y()},
                              {"B_x", b.x()}, {"B_y", b.y()});
        CHECK_TWIN_SCALED("polygon.cross", engine.area, 2 * area, size, 1e-15);

        const double m = rho * engine.area;
        const double I_T = rho * about_point(engine, Vec2(0, 0));
        // [polygon.tests.triangle]
        const double u = a.norm();
        const double side = (b - a).norm();
        const double c = a.dot(b - a);
        const double scale = std::abs(m) * (u * u + side * side);
        CHECK_EQUATION_SCALED("polygon.triangle", I_T,
                              m / 2 * (side * side / 3 + c + u * u), scale, 2e-15, {"m", m},
                              {"b", side}, {"c", c}, {"u", u});
        CHECK_TWIN_SCALED("polygon.triangle", I_T, m / 2 * (side * side / 2 + c + u * u),
                          scale, 2e-15);
        CHECK(std::abs(triangle_inertia(m, a, b) - I_T) <= 2e-15 * scale);
        // [polygon.tests.triangle]

        const double products = a.squaredNorm() + a.dot(b) + b.squaredNorm();
        CHECK_EQUATION_SCALED("polygon.corner_form", I_T, m / 6 * products, scale, 2e-15, {"m", m}, {"A_x", a.x()},
                              {"A_y", a.y()}, {"B_x", b.x()}, {"B_y", b.y()});
        CHECK_TWIN_SCALED("polygon.corner_form", I_T, m / 3 * products, scale, 2e-15);

        const Vec2 third = engine.centroid;
        CHECK_EQUATION_SCALED("polygon.third", third.x(), (a.x() + b.x()) / 3, 1.0, 1e-15, {"A_x", a.x()},
                              {"B_x", b.x()});
        CHECK_TWIN_SCALED("polygon.third", third.x(), (a.x() + b.x()) / 2, 1.0, 1e-15);
    }
}

TEST_CASE("half a square about its right angle has a third of m L^2")
{
    Random random(402);
    for (int k = 0; k < 1000; ++k) {
        const double L = any(random);
        const Ring half = {{0, 0}, {L, 0}, {0, L}};
        const AreaMoments engine = moments_of_ring(half);
        const double m = 3.0 * engine.area;
        const double I_T = 3.0 * about_point(engine, Vec2(0, 0));
        CHECK_EQUATION("polygon.corner", I_T, m * L * L / 3, 2e-15, {"m", m}, {"L", L});
        CHECK_TWIN("polygon.corner", I_T, m * L * L / 9, 2e-15);
    }
}

TEST_CASE("sums of signed triangles are the trapezia of exact rationals")
{
    Random random(403);
    for (int k = 0; k < 300; ++k) {
        // Any corners will do, crossing edges included: both sides count each point as
        // often as the ring winds round it
        Ring ring;
        const int n = 3 + random.below(9);
        for (int v = 0; v < n; ++v) ring.push_back(any_point(random));
        // [polygon.tests.oracle]
        const AreaMoments engine = moments_of_ring(ring);
        const oracle::Moments exact = oracle::moments_of_rings({ring});
        const double area = static_cast<double>(exact.area);
        const double x = static_cast<double>(exact.x);
        const double second = static_cast<double>(exact.second_moment);
        CHECK_EQUATION("polygon.area", engine.area, area, 4e-16);
        CHECK_TWIN("polygon.area", engine.area, 2 * area, 4e-16);
        CHECK_EQUATION("polygon.centroid", engine.centroid.x(), x, 4e-16);
        CHECK_TWIN("polygon.centroid", engine.centroid.x(), 1.5 * x, 4e-16);

        const MassProperties body = polygon_mass(Polygon({ring}), 2.0);
        CHECK_EQUATION("polygon.inertia", body.moment_of_inertia, 2.0 * second, 4e-16);
        CHECK_TWIN("polygon.inertia", body.moment_of_inertia, second, 4e-16);
        // [polygon.tests.oracle]
    }
}

TEST_CASE("the middle of a house lies below the mean of its corners")
{
    Random random(404);
    for (int k = 0; k < 1000; ++k) {
        const double w = any(random);
        const double H = any(random);
        const double t = any(random);
        const Ring ring = {{0, 0}, {w, 0}, {w, H}, {0.5 * w, H + t}, {0, H}};
        const double y = moments_of_ring(ring).centroid.y();
        CHECK_EQUATION("polygon.house", y, (3 * H * H + 3 * H * t + t * t) / (3 * (2 * H + t)), 2e-15, {"H", H},
                       {"t", t});
        CHECK_TWIN("polygon.house", y, (3 * H * H + 3 * H * t + t * t) / (2 * (2 * H + t)), 2e-15);

        const double mean = vertex_mean(ring).y();
        CHECK_EQUATION("polygon.house.mean", mean, (3 * H + t) / 5, 2e-15, {"H", H}, {"t", t});
        CHECK_TWIN("polygon.house.mean", mean, (3 * H + t) / 6, 2e-15);
    }
    const AreaMoments moments = moments_of_ring(house());
    RECORD_VALUE("polygon.house.y", moments.centroid.y());
    RECORD_VALUE("polygon.house.mean-costs",
                 100.0 * (about_point(moments, vertex_mean(house())) / moments.second_moment - 1.0));
}

TEST_CASE("a hole counts negatively, and pushes the middle away")
{
    Random random(405);
    for (int k = 0; k < 1000; ++k) {
        const double a = any(random);
        const double s = a * random.uniform(0.1, 0.8);
        const double e = random.uniform(0.0, 0.1) * a;
        const Polygon polygon({square(Vec2(0, 0), a), reversed(square(Vec2(e, 0), s))});
        const AreaMoments moments = moments_of(polygon);

        // The corners are rounded once, the closed form a few times; what is left of the area is a third or more
        CHECK_EQUATION_SCALED("polygon.hole", moments.centroid.x(), -s * s * e / (a * a - s * s), a, 2e-15, {"s", s},
                              {"e", e}, {"a", a});
        CHECK_TWIN_SCALED("polygon.hole", moments.centroid.x(), s * s * e / (a * a - s * s), a, 2e-15);
        const double second = (a * a * a * a - s * s * s * s) / 6 - s * s * e * e * a * a / (a * a - s * s);
        CHECK_EQUATION("polygon.hole.moment", moments.second_moment, second, 1e-14, {"a", a}, {"s", s}, {"e", e});
        CHECK_TWIN("polygon.hole.moment", moments.second_moment, (a * a * a * a - s * s * s * s) / 12, 1e-14);
    }
}

// [polygon.tests.thin]
TEST_CASE("a frame of thin bars keeps its digits, though nearly all triangles cancel")
{
    const double a = 1.0;
    const double s = 1.0 - 0x1p-40;
    const std::vector<Ring> rings = {square(Vec2(0, 0), a),
                                     reversed(square(Vec2(0, 0), s))};
    const AreaMoments engine = moments_of(Polygon(rings));
    const oracle::Moments exact = oracle::moments_of_rings(rings);
    CHECK(oracle::ulps(engine.area, exact.area) <= 0.5);
    CHECK(oracle::ulps(engine.second_moment, exact.second_moment) <= 0.5);

    // The same sums in plain doubles, about the same corner
    const Vec2 corner = rings[0].front();
    const AreaMoments outer = plain_moments(rings[0], corner);
    const AreaMoments inner = plain_moments(rings[1], corner);
    const double plain = about_point(outer, Vec2(0, 0)) + about_point(inner, Vec2(0, 0));
    const double error = std::abs(plain / static_cast<double>(exact.second_moment) - 1.0);
    RECORD_VALUE("polygon.thin.plain", error);
    CHECK(error > 1e-8);
}
// [polygon.tests.thin]

TEST_CASE("the seed's dumbbell, with signs and without")
{
    const AreaMoments moments = moments_of_ring(dumbbell());
    const AreaMoments wrong = moments_without_sign(dumbbell());
    CHECK(moments.area == 9600.0);
    CHECK(wrong.area == 12800.0);
    CHECK(moments.second_moment == 160000.0 * 184.0);
    RECORD_VALUE("polygon.sign.area", 100.0 * (wrong.area / moments.area - 1.0));
    RECORD_VALUE("polygon.sign.moment", 100.0 * (wrong.second_moment / moments.second_moment - 1.0));
}

// [polygon.tests.mean]
TEST_CASE(
    "corners that change no outline change no moment, but move the mean of the corners")
{
    const AreaMoments before = moments_of_ring(dumbbell());
    for (int j = 1; j <= 400; ++j) {
        const Ring ring = with_corners(dumbbell(), 9, j); // the edge at x = 80
        const AreaMoments after = moments_of_ring(ring);
        CHECK(after.area == doctest::Approx(before.area).epsilon(1e-15));
        CHECK(after.centroid.norm() < 1e-13);
        CHECK(after.second_moment == doctest::Approx(before.second_moment).epsilon(1e-15));

        // The sum of j roundings
        const double X = 80.0;
        CHECK_EQUATION("polygon.mean", vertex_mean(ring).x(), j * X / (12 + j), 1e-14,
                       {"j", j}, {"X", X});
        CHECK_TWIN("polygon.mean", vertex_mean(ring).x(), j * X / (13 + j), 1e-14);
    }
}
// [polygon.tests.mean]

TEST_CASE("sixteen corners have their mean a quarter of the way to the edge")
{
    RECORD_VALUE("polygon.mean.sixteen", vertex_mean(with_corners(dumbbell(), 9, 4)).x());
}

// [polygon.tests.cut]
TEST_CASE("a shape weighs what its two halves weigh, but not without signs")
{
    // The dumbbell cut upright through its middle: each half has two corners on the cut
    const Ring right = {{0, -20}, {40, -20}, {40, -40}, {80, -40},
                        {80, 40}, {40, 40},  {40, 20},  {0, 20}};
    Ring left = right;
    for (Vec2& vertex : left) vertex = -vertex;

    const double whole = moments_of_ring(dumbbell()).area;
    CHECK(moments_of_ring(right).area + moments_of_ring(left).area == whole);

    const double wrong_whole = moments_without_sign(dumbbell()).area;
    const double wrong_parts =
        moments_without_sign(right).area + moments_without_sign(left).area;
    CHECK(std::abs(wrong_parts / wrong_whole - 1.0) > 0.1);
}
// [polygon.tests.cut]

// [polygon.tests.far]
TEST_CASE("a house moved a million kilometres is the same house, but not about the origin")
{
    const AreaMoments here = moments_of_ring(house());
    const Ring ring = moved(house(), Vec2(1e11, 1e11));
    CHECK(moments_of_ring(ring).second_moment == here.second_moment);
    CHECK(moments_of_ring(ring).area == here.area);

    const AreaMoments wrong = moments_about_origin(ring);
    CHECK_FALSE(std::abs(wrong.second_moment / here.second_moment - 1.0) < 1.0);
}
// [polygon.tests.far]

TEST_CASE("about the origin the error grows with the fourth power of the distance")
{
    // Places and offsets have 20 binary places: the move is exact, the products are not
    const double true_moment = moments_of_ring(tilted_house()).second_moment;
    const auto mean_error = [&](double far) {
        double sum = 0.0;
        for (int k = 0; k < 256; ++k) {
            const Vec2 offset(on_grid(far * (1.0 + k / 331.0)), on_grid(far * (1.5 - k / 577.0)));
            sum += std::abs(moments_about_origin(moved(tilted_house(), offset)).second_moment / true_moment - 1.0);
        }
        return sum / 256.0;
    };

    // Over two decades; 256 places leave the mean uncertain by a tenth or so
    const double order = std::log10(mean_error(3e5) / mean_error(3e3)) / 2.0;
    RECORD_VALUE("polygon.far.order", order);
    CHECK(order == doctest::Approx(4.0).epsilon(0.05));
}

TEST_CASE("a bow tie has two halves that cancel")
{
    const AreaMoments moments = moments_of_ring(std::vector<Vec2>{{-1, -1}, {1, 1}, {1, -1}, {-1, 1}});
    CHECK(moments.area == 0.0);
}

TEST_CASE("the worst of 2000 random polygons, against exact rationals")
{
    Random random(406);
    double worst = 0.0;
    for (int k = 0; k < 2000; ++k) {
        Ring ring;
        const int n = 3 + random.below(20);
        for (int v = 0; v < n; ++v) ring.push_back(any_point(random));
        const AreaMoments found = moments_of_ring(ring);
        const oracle::Moments exact = oracle::moments_of_rings({ring});
        worst = std::max({worst, oracle::ulps(found.area, exact.area),
                          oracle::ulps(found.second_moment, exact.second_moment),
                          oracle::ulps(found.centroid.x(), exact.x), oracle::ulps(found.centroid.y(), exact.y)});
    }
    RECORD_VALUE("polygon.worst", worst);
    CHECK(worst < 0.51);
}
