#include <cstdio>
#include <initializer_list>

#include "vertex_edge.hpp"
#include "misjudged.hpp"
#include "wrong_normal.hpp"

using namespace flying;
using namespace flying::corner;

namespace {

/// A thousand pairs of squares at each size, judged by a turn in an int.
void truncate()
{
    std::printf("     side   misjudged of 1000\n");
    for (const double side : {0.5, 1.0, 2.0, 4.0, 16.0, 100.0}) {
        std::printf("%7g m %12d\n", side, misjudged_pairs(side, 1000));
    }
}


/// A crate falls straight onto a floor 20 m long, at 3 m/s, here and there.
void lean()
{
    const Vec2 falling(0.0, -3.0);
    std::printf("\n  crate at    bounces at (m/s)    by the centres\n");
    for (const double x : {0.0, 0.5, 1.0, 4.0, 9.0}) {
        const Pose crate = at(x, 0.99);
        const Contact contact =
            entered_contacts(box(20, 1), at(0, 0), box(1, 1), crate).front();
        const Vec2 right = bounced(falling, contact.normal);
        const Vec2 wrong = bounced(falling, wrong_normal(Vec2::Zero(), crate.position));
        std::printf("%8.1f m   (%5.2f, %5.2f)     (%5.2f, %5.2f)\n", x, right.x(),
                    right.y(), wrong.x(), wrong.y());
    }
}


} // namespace

int main()
{
    truncate();
    lean();
}
