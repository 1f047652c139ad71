#pragma once

#include <limits>
#include <utility>
#include <vector>

struct Ball
{
    double m; ///< mass [kg]
    double x; ///< place [m]
    double v; ///< velocity, to the right [m/s]
};

/// How many impacts there are. wall  whether there is one at x = 0, on the left
inline long collide_row(std::vector<Ball> balls, bool wall)
{
    for (long count = 0;; ++count) {
        // The earliest meeting: number k is that of ball k with ball k + 1, and -1 that of ball 0 with the wall. Only
        // what approaches can meet.
        double first = std::numeric_limits<double>::infinity();
        int at = -2;
        const auto consider = [&](int k, double gap, double approach) {
            if (!(approach > 0.0)) return;
            const double time = gap > 0.0 ? gap / approach : 0.0;
            if (time < first) {
                first = time;
                at = k;
            }
        };
        if (wall) consider(-1, balls[0].x, -balls[0].v);
        for (int k = 0; k + 1 < static_cast<int>(balls.size()); ++k)
            consider(k, balls[k + 1].x - balls[k].x, balls[k].v - balls[k + 1].v);
        if (at == -2) return count;

        for (Ball& ball : balls) ball.x += first * ball.v;
        if (at == -1) {
            balls[0].x = 0.0;
            balls[0].v = -balls[0].v;
            continue;
        }
        Ball& a = balls[at];
        Ball& b = balls[at + 1];
        const double j = 2.0 * (a.v - b.v) / (1.0 / a.m + 1.0 / b.m);
        a.v -= j / a.m;
        b.v += j / b.m;
        b.x = a.x;
    }
}
