#include "world/make_shape.hpp"

#include <cstdint>
#include <numbers>
#include <utility>

#include "geometry/make_polygon.hpp"
#include "math/number_text.hpp"
#include "math/sine_cosine.hpp"
#include "world/checks.hpp"

namespace flying {

namespace {

constexpr const char* k_length = "length in m";

/// Corners at exactly plus and minus half of the sides, so that the centre of mass is the origin without rounding.
Polygon rectangle(double width, double height)
{
    const double x = 0.5 * width;
    const double y = 0.5 * height;
    return Polygon({{Vec2(-x, -y), Vec2(x, -y), Vec2(x, y), Vec2(-x, y)}});
}

/// The point of the unit circle at the angle pi p / q, 0 <= p < 2 q. Whole numbers fold the angle into the first eighth
/// of the circle, so that points which mirror one another do so to the bit.
Vec2 circle_point(std::int64_t p, std::int64_t q)
{
    if (p > q) {
        const Vec2 above = circle_point(2 * q - p, q);
        return Vec2(above.x(), -above.y());
    }
    if (2 * p > q) {
        const Vec2 right = circle_point(q - p, q);
        return Vec2(-right.x(), right.y());
    }
    if (4 * p > q) {
        const Vec2 below_diagonal = circle_point(q - 2 * p, 2 * q);
        return Vec2(below_diagonal.y(), below_diagonal.x());
    }
    if (4 * p == q) return Vec2(0.5 * std::numbers::sqrt2, 0.5 * std::numbers::sqrt2);

    const SineCosine sc = sine_cosine(std::numbers::pi * static_cast<double>(p) / static_cast<double>(q));
    return Vec2(sc.cosine, sc.sine);
}

Polygon regular(int sides, double radius)
{
    std::vector<Vec2> ring;
    ring.reserve(static_cast<std::size_t>(sides));
    for (int k = 0; k < sides; ++k) ring.push_back(radius * circle_point(2 * static_cast<std::int64_t>(k), sides));
    return Polygon({ring});
}

Expected<Shape> make(const DiscDef& def)
{
    Faults faults;
    Checks(faults).positive("radius", def.radius, k_length);
    if (!faults.empty()) return faults;
    return Shape(Disc{def.radius});
}

Expected<Shape> make(const RectangleDef& def)
{
    Faults faults;
    Checks(faults).positive("width", def.width, k_length);
    Checks(faults).positive("height", def.height, k_length);
    if (!faults.empty()) return faults;
    return Shape(rectangle(def.width, def.height));
}

Expected<Shape> make(const SquareDef& def)
{
    Faults faults;
    Checks(faults).positive("side", def.side, k_length);
    if (!faults.empty()) return faults;
    return Shape(rectangle(def.side, def.side));
}

Expected<Shape> make(const TriangleDef& def)
{
    Faults faults;
    Checks checks(faults);
    checks.positive("sides[0]", def.sides[0], k_length);
    checks.positive("sides[1]", def.sides[1], k_length);
    const bool angle_fits = def.angle >= k_least_number && def.angle < std::numbers::pi;
    if (!angle_fits)
        checks.fault("angle", number_text(def.angle), "an angle between the sides in rad, above 0 and below pi");
    if (!faults.empty()) return faults;

    // Both sides start at the origin; the door to polygons moves the centroid there
    const SineCosine sc = sine_cosine(def.angle);
    const Vec2 first(def.sides[0], 0.0);
    const Vec2 second(def.sides[1] * sc.cosine, def.sides[1] * sc.sine);
    const Vec2 ring[] = {Vec2(Vec2::Zero()), first, second};
    Expected<CentredPolygon> made = make_polygon(ring);
    if (made) return Shape(std::move(made).value().polygon);
    checks.fault("angle",
                 number_text(def.angle) + " between sides of " + number_text(def.sides[0]) + " and " +
                     number_text(def.sides[1]),
                 "a triangle that is more than a line");
    return faults;
}

Expected<Shape> make(const RegularDef& def)
{
    Faults faults;
    Checks checks(faults);
    if (def.sides < 3 || def.sides > k_most_sides) {
        checks.fault("sides", std::to_string(def.sides), "3 to " + std::to_string(k_most_sides) + " sides");
    }
    checks.positive("radius", def.radius, k_length);
    if (!faults.empty()) return faults;
    return Shape(regular(def.sides, def.radius));
}

Expected<Shape> make(const PolygonDef& def)
{
    // Numbers out of range first: whether edges cross can't be asked of those
    Faults faults;
    const auto check_ring = [&](const std::string& name, const std::vector<Vec2>& ring) {
        for (std::size_t k = 0; k < ring.size(); ++k) {
            Checks(faults, name).vector("[" + std::to_string(k) + "]", ring[k], k_length);
        }
    };
    check_ring("vertices", def.vertices);
    for (std::size_t k = 0; k < def.holes.size(); ++k) {
        check_ring("holes[" + std::to_string(k) + "]", def.holes[k]);
    }
    if (!faults.empty()) return faults;

    Expected<CentredPolygon> made = make_polygon(def.vertices, def.holes);
    if (!made) return made.faults();
    const double radius = made.value().polygon.radius();
    if (Checks(faults).positive("vertices", radius, "distance of the furthest vertex from the centroid, in m")) {
        return Shape(std::move(made).value().polygon);
    }
    return faults;
}

} // namespace

Expected<Shape> make_shape(const ShapeDef& def)
{
    return std::visit([](const auto& kind) { return make(kind); }, def);
}

} // namespace flying
