// Two faults of looks, each of which threw bodies out of a heap: a corner that touched a thin ring tip to tip was told
// to leave it by the far side, and one that flew past the end of two flush surfaces to rise onto them.

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "rest/rest_engine.hpp"

using namespace flying;

namespace {

[[nodiscard]] std::vector<Vec2> corners(int count, double radius)
{
    std::vector<Vec2> ring;
    for (int k = 0; k < count; ++k) {
        const double angle = 2.0 * std::numbers::pi * k / count;
        ring.push_back({radius * std::cos(angle), radius * std::sin(angle)});
    }
    return ring;
}

[[nodiscard]] RestBody body_at(Shape shape, const Vec2& position, double angle, const Vec2& velocity)
{
    RestBody body{std::move(shape), {}, {1.0, 50.0}, {0.0, 0.3}};
    body.state.position = position;
    body.state.angle = angle;
    body.state.velocity = velocity;
    return body;
}

} // namespace

TEST_CASE("two thin rings that touch tip to tip have no overlap as deep as a ring is thick")
{
    // Tips that lead along the sides of the other, to rounding: whether one looks at a side was decided by the last bit
    const double thickness = 0.03;
    std::vector<Vec2> inner = corners(6, 0.3 - thickness);
    std::reverse(inner.begin(), inner.end());
    const Polygon ring({corners(6, 0.3), inner});
    const Vec2 none = Vec2::Zero();
    RestEngine engine({body_at(ring, {0.41804378606726317, 4.4667818196312314}, 3.3288894755491043, none),
                       body_at(ring, {0.3213265641142331, 4.9772092221654907}, 2.2817577139292702, none)});
    engine.step();
    CHECK(engine.max_overlap() < 0.01 * 0.3);
    CHECK((engine.state(0).position - Vec2(0.41804378606726317, 4.4667818196312314)).norm() < 0.01 * 0.3);
}

TEST_CASE("a disc beside the corner of a square that lies flush with a triangle overlaps neither")
{
    const double angle = 5.3253918884477054;
    RestEngine engine({body_at(Disc{0.24391604062284067}, {3.2256919196009322, 13.379254113189463}, angle,
                               {-0.0021555059225911314, 0.0006216839685814667}),
                       body_at(Polygon({corners(3, 0.23206933262866375)}), {3.0163658452930928, 13.720407211613587},
                               3.7629260591364551, {-0.0023676322378630879, 0.00028820833806250434}),
                       body_at(Polygon({corners(4, 0.2845640259185771)}), {3.2642455655047686, 13.91916337878782},
                               6.1191213707583669, {-0.0023496255783173976, 0.00024010084362488215})});
    engine.step();
    CHECK(engine.max_overlap() < 0.01 * 0.23);
    for (int k = 0; k < 3; ++k) CHECK(engine.state(k).velocity.norm() < 0.01);
}
