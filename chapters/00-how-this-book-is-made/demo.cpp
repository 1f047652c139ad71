#include <cmath>
#include <cstdio>

#include "falling.hpp"

// [made.demo]
int main()
{
    const double g = 9.81;
    const double t = 2.0;
    const double exact = flying::fall_distance(g, t);
    std::printf("exact distance = %.4f m\n\n  steps   by steps   short by\n", exact);
    for (int steps = 10; steps <= 10000; steps *= 10) {
        const double s = flying::fall_by_steps(g, t, steps);
        std::printf("%7d %10.4f %9.1e\n", steps, s, (exact - s) / exact);
    }
    std::printf("\nshare lost in 10 steps = %.3f\n", 1.0 - flying::fall_by_steps(g, t, 10) / exact);
}
// [made.demo]
