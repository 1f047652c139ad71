#include <algorithm>
#include <cstdio>

#include "lying.hpp"
#include "wrong_rest.hpp"

using namespace flying;
using namespace flying::test;


/// A body that was put down at rest, seen now and then for ten seconds.
int main()
{
    const double dt = 1.0 / 60.0;
    Lying bounced;
    Lying pushed;
    RestOptions options;
    options.sleeps = false;
    RestEngine engine({wall(Vec2(0.0, 1.0), 0.0, {0.5, 0.5}),
                       box(1.0, 1.0, Vec2(0.0, 0.5), 1.0, {0.5, 0.5})},
                      options);
    std::printf("          bounced after the move    pushed by the overlap    engine\n");
    std::printf("time        height     velocity      height     velocity    height\n");
    for (int k = 1; k <= 600; ++k) {
        move_then_bounce(bounced, k_gravity, dt, 0.5);
        push_by_overlap(pushed, k_gravity, dt);
        engine.step();
        const bool shown = k <= 6 || k == 60 || k == 599 || k == 600;
        if (!shown) continue;
        std::printf("%5.2f s %7.1f mm %8.1f mm/s %7.1f mm %8.1f mm/s %5.1f mm\n",
                    k * dt, 1e3 * bounced.x, 1e3 * bounced.v, 1e3 * pushed.x,
                    1e3 * pushed.v, 1e3 * (engine.state(1).position.y() - 0.5));
    }
}

