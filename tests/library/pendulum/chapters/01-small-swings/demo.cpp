#include <cstdio>

#include "pendulum/small.hpp"

int main()
{
    std::printf("period = %.6f s\n", pendulum::small_period(1.0, 9.81));
}
