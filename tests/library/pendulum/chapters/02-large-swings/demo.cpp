#include <cstdio>
#include <numbers>

#include "pendulum/large.hpp"

int main()
{
    const double wide = pendulum::large_period(1.0, 9.81, 0.5 * std::numbers::pi);
    std::printf("late = %.3f %%\n", 100.0 * (wide / pendulum::small_period(1.0, 9.81) - 1.0));
}
