#include <cstdio>
#include <numbers>
#include <vector>

#include "collide/vertex_edge.hpp"
#include "math/orientation.hpp"
#include "scenes.hpp"
#include "turns.hpp"

using namespace flying;
using namespace flying::corner;

namespace {

/// Lays B on A and prints where the two have entered each other.
void lay(const char* what, const Polygon& a, const Polygon& b, const Pose& world_from_b)
{
    const std::vector<Contact> contacts = entered_contacts(a, at(0, 0), b, world_from_b);
    for (const Contact& contact : contacts) {
        const Vec2& p = contact.point;
        const Vec2& n = contact.normal;
        std::printf("%-18s (%6.3f,%6.3f)   (%4.1f,%4.1f)   %.3f\n", what, p.x(), p.y(),
                    n.x() + 0.0, n.y() + 0.0, -contact.separation);
        what = "";
    }
}

// [corner.demo.pairs]
void lay_all()
{
    const Polygon floor = box(10, 1);
    const double upright = 0.25 * std::numbers::pi;
    std::printf("                        point           normal    depth\n");
    lay("square on a corner", floor, box(1, 1), at(1.0, 1.1, upright));
    lay("crate, flat", floor, box(2, 1), at(1.0, 0.9));
    lay("crate, half over", floor, box(2, 1), at(5.0, 0.9));
    lay("corner on corner", box(2, 2), box(2, 2), at(1.9, 1.5));
    lay("crossed bars", box(4, 0.5), box(0.25, 4), at(1.0, 0.0));
    lay("floor in a table", table(), box(20, 1), at(0.0, -0.4));
    lay("diamond in a frame", frame(), diamond(), at(0.0, 0.0));
}
// [corner.demo.pairs]

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
    lay_all();
    judge_grid();
}
