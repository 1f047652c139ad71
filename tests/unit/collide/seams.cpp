#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "collide/manifold.hpp"
#include "collide/seams.hpp"

using namespace flying;

namespace {

Polygon rectangle(const Vec2& least, const Vec2& greatest)
{
    return Polygon({{least, {greatest.x(), least.y()}, greatest, {least.x(), greatest.y()}}});
}

/// What a body touches near the seam is what it would touch of the polygon alone.
void keeps_its_contact(const Polygon& part, const Seam& seam, const Polygon& body, const Pose& place, double separation)
{
    const Manifold plain = make_manifold(part, Pose{}, body, place, 0.05);
    REQUIRE(plain.count == 1);
    REQUIRE(plain.contacts[0].separation == doctest::Approx(separation));
    Manifold mended = plain;
    mend_at_seams(part, Pose{}, std::vector{seam}, Owner::a, body, place, 0.03, 0.05, mended);
    REQUIRE(mended.count == 1);
    CHECK(mended.contacts[0].separation == plain.contacts[0].separation);
    CHECK(mended.contacts[0].normal == plain.contacts[0].normal);
}

} // namespace

TEST_CASE("an edge that lies on a corner at a loose hollow is touched there, and not where its end is")
{
    // A square; at its lower right corner a neighbour's surface leads down, as if the two made a hollow
    const Polygon part = rectangle(Vec2::Zero(), Vec2(1.0, 1.0));
    Seam seam{1, 1, 0, Vec2(1.0, -1.0).normalized(), Vec2(-1.0, -1.0).normalized(), 1e-9, Seam::Bend::hollow, true};
    // A bar leans on that corner from the right, a hundredth away; its ends are far
    for (const double lean : {0.2, 0.5, 0.7}) {
        CAPTURE(lean);
        const Rotation rotation = Rotation::of(-lean);
        const Pose place{Vec2(1.0, 0.0) + rotation * Vec2(0.01, 0.0), rotation};
        for (const double low : {-1.4, -0.5}) {
            CAPTURE(low);
            const Polygon bar = rectangle(Vec2(0.0, low), Vec2(0.3, low + 2.0));
            keeps_its_contact(part, seam, bar, place, 0.01);
        }
    }
}

TEST_CASE("a corner that comes into a loose hollow touches the open side of it")
{
    const Polygon part = rectangle(Vec2::Zero(), Vec2(1.0, 1.0));
    Seam seam{1, 1, 0, Vec2(1.0, -1.0).normalized(), Vec2(-1.0, -1.0).normalized(), 1e-9, Seam::Bend::hollow, true};
    // A corner of a square that stands on its tip, below the corner of the first and to its right
    const Polygon square = rectangle(Vec2(-0.5, -0.5), Vec2(0.5, 0.5));
    const Pose place{Vec2(1.01, -0.01 - std::numbers::sqrt2 / 2.0), Rotation::of(std::numbers::pi / 4.0)};
    Manifold manifold = make_manifold(part, Pose{}, square, place, 0.05);
    REQUIRE(manifold.count == 1);
    mend_at_seams(part, Pose{}, std::vector{seam}, Owner::a, square, place, 0.03, 0.05, manifold);
    REQUIRE(manifold.count == 1);
    CHECK((manifold.contacts[0].normal - Vec2(0.0, -1.0)).norm() < 1e-15);
    CHECK(manifold.contacts[0].separation == doctest::Approx(0.01));
}

TEST_CASE(
    "what lies beside two neighbours, deeper below their joint surface than bodies overlap, keeps its own contact")
{
    // The right side of a square is hidden by a neighbour that goes on from its upper corner; both may move
    const Polygon part = rectangle(Vec2::Zero(), Vec2(1.0, 1.0));
    const Polygon square = rectangle(Vec2(-0.5, -0.5), Vec2(0.5, 0.5));
    for (const bool is_loose : {false, true}) {
        const Seam seam{2, 1, 2, Vec2(1.0, 0.0), Vec2(0.0, 1.0), 1e-9, Seam::Bend::none, is_loose};
        for (const double depth : {0.002, 0.01, 0.025}) {
            CAPTURE(depth);
            // One that stands on its tip, a thousandth away from that side, all within the size of a contact
            const Pose place{Vec2(1.001 + std::numbers::sqrt2 / 2.0, 1.0 - depth),
                             Rotation::of(std::numbers::pi / 4.0)};
            keeps_its_contact(part, seam, square, place, 0.001);
        }
        // As deep as an overlap, it lies on the neighbour
        const Pose place{Vec2(1.001 + std::numbers::sqrt2 / 2.0, 0.9995), Rotation::of(std::numbers::pi / 4.0)};
        Manifold mended = make_manifold(part, Pose{}, square, place, 0.05);
        mend_at_seams(part, Pose{}, std::vector{seam}, Owner::a, square, place, 0.03, 0.05, mended);
        CHECK(mended.count == 0);
    }
}
