#include "geometry/stoutness.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <vector>

#include "math/tolerance.hpp"

using namespace flying;

namespace {

constexpr double k_rounding = 8.0 * tolerance::k_epsilon;

Shape shape_of(const std::vector<std::vector<Vec2>>& rings)
{
    return Polygon(rings);
}

} // namespace

TEST_CASE("a square is as stout as its side is long, and a disc as its diameter")
{
    CHECK(std::abs(stoutness(shape_of({{{-1.5, -1.5}, {1.5, -1.5}, {1.5, 1.5}, {-1.5, 1.5}}})) - 3.0) <=
          3.0 * k_rounding);
    CHECK(stoutness(Disc{0.7}) == 1.4);
}

TEST_CASE("long arms are as stout as twice their width, straight, bent or closed to a frame")
{
    const Shape plank = shape_of({{{-50.0, -0.1}, {50.0, -0.1}, {50.0, 0.1}, {-50.0, 0.1}}});
    CHECK(std::abs(stoutness(plank) - 0.4) < 0.01 * 0.4);
    const Shape angle = shape_of({{{0.0, 0.0}, {50.0, 0.0}, {50.0, 0.2}, {0.2, 0.2}, {0.2, 50.0}, {0.0, 50.0}}});
    CHECK(std::abs(stoutness(angle) - 0.4) < 0.01 * 0.4);
    const Shape frame = shape_of({{{-25.0, -25.0}, {25.0, -25.0}, {25.0, 25.0}, {-25.0, 25.0}},
                                  {{-24.8, -24.8}, {-24.8, 24.8}, {24.8, 24.8}, {24.8, -24.8}}});
    CHECK(std::abs(stoutness(frame) - 0.4) <= 50.0 * k_rounding);
}
