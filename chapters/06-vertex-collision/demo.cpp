#include <cmath>
#include <cstdio>
#include <numbers>
#include <vector>

#include "collide/touching.hpp"
#include "vertex_edge.hpp"
#include "geometry/convex_parts.hpp"
#include "math/orientation.hpp"
#include "scenes.hpp"
#include "turns.hpp"

using namespace flying;
using namespace flying::corner;

namespace {

/// Sets B at A so that they just touch, and prints where.
void set(const char* what, const Shape& a, const Shape& b, const Pose& world_from_b)
{
    std::vector<Touch> touches;
    find_touches(a, at(0, 0), b, world_from_b, 1e-12, touches);
    for (const Touch& touch : touches) {
        std::printf("%-22s (%6.3f,%6.3f)   (%6.3f,%6.3f)\n", what, touch.r_a.x() + 0.0, touch.r_a.y() + 0.0,
                    touch.normal.x() + 0.0, touch.normal.y() + 0.0);
        what = "";
    }
}


void set_all()
{
    const double root = std::sqrt(0.5); // half the diagonal of a square of side 1
    const Polygon floor = box(10, 1);
    const double upright = 0.25 * std::numbers::pi;
    std::printf("                              point            normal\n");
    set("square on a corner", floor, box(1, 1), at(1.0, 0.5 + root, upright));
    set("crate, flat", floor, box(2, 1), at(1.0, 1.0));
    set("crate, half over", floor, box(2, 1), at(5.0, 1.0));
    set("squares, diagonal", box(2, 2), box(2, 2), at(2.0, 2.0));
    set("square beside square", box(2, 2), box(2, 2), at(2.0, 0.0));
    set("tip on a corner", box(2, 2), box(1, 1), at(1.0, 1.0 + root, upright));
    set("ball on a corner", box(2, 2), Disc{1.0}, at(1.6, 1.8));
    set("table on a floor", floor, table(), at(0.0, 0.5));
}


/// Cuts a few shapes into convex parts, and counts them.
void cut_all()
{
    const auto count = [](const char* what, const Polygon& polygon) {
        std::printf("%-10s %8zu %6zu\n", what, polygon.vertices().size(), convex_parts(polygon).size());
    };
    std::printf("\n           vertices  parts\n");
    count("square", box(1, 1));
    count("table", table());
    count("plus", plus());
    count("frame", frame());
}

/// Lays B on A and prints where the two have entered each other.
void lay(const char* what, const Polygon& a, const Polygon& b, const Pose& world_from_b)
{
    const std::vector<Contact> contacts = entered_contacts(a, at(0, 0), b, world_from_b);
    for (const Contact& contact : contacts) {
        const Vec2& p = contact.point;
        const Vec2& n = contact.normal;
        std::printf("%-18s (%6.3f,%6.3f)   (%4.1f,%4.1f)   %.3f\n", what, p.x(), p.y(), n.x() + 0.0, n.y() + 0.0,
                    -contact.separation);
        what = "";
    }
}


void lay_all()
{
    const Polygon floor = box(10, 1);
    const double upright = 0.25 * std::numbers::pi;
    std::printf("\nBodies that overlap:\n                        point           normal    depth\n");
    lay("square on a corner", floor, box(1, 1), at(1.0, 1.1, upright));
    lay("crate, flat", floor, box(2, 1), at(1.0, 0.9));
    lay("crate, half over", floor, box(2, 1), at(5.0, 0.9));
    lay("corner on corner", box(2, 2), box(2, 2), at(1.9, 1.5));
    lay("crossed bars", box(4, 0.5), box(0.25, 4), at(1.0, 0.0));
    lay("floor in a table", table(), box(20, 1), at(0.0, -0.4));
    lay("diamond in a frame", frame(), diamond(), at(0.0, 0.0));
}


/// A square of 64 by 64 neighbouring doubles beside one line, judged twice.
void judge_grid()
{
    int wrong = 0;
    for (int i = 0; i < 64; ++i) {
        for (int j = 0; j < 64; ++j) {
            const Vec2 a(0.5 + i * 0x1p-53, 0.5 + j * 0x1p-53);
            const Vec2 b(12.0, 12.0);
            const Vec2 c(24.0, 24.0);
            const double turn = rounded_turn(a, b, c);
            const int rounded = (turn > 0.0 ? 1 : 0) - (turn < 0.0 ? 1 : 0);
            if (rounded != orientation(a, b, c)) ++wrong;
        }
    }
    std::printf("\npoints beside a line = %d\n", 64 * 64);
    std::printf("misjudged by rounding = %d\n", wrong);
}

} // namespace

int main()
{
    set_all();
    cut_all();
    lay_all();
    judge_grid();
}
