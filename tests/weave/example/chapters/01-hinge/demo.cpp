#include <cstdio>

#include "rods/rod.hpp"

int main()
{
    std::printf("inertia = %.3f kg m^2\n", flying::rod_about_end(3.0, 2.0));
}
