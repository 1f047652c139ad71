#include <cstdio>
#include <initializer_list>

#include "wrong_triangle.hpp"


int main()
{
    std::printf("   leg [m]   right [kg m^2]   wrong [kg m^4]      wrong / right\n");
    for (const double leg : {0.02, 1.0, 2.0, 20.0, 100.0}) {
        const double right = flying::half_square_mass(leg, 1.0).moment_of_inertia;
        const double wrong = flying::wrong_half_square_mass(leg, 1.0).moment_of_inertia;
        std::printf("%10g %16.6g %16.6g %18.6g\n", leg, right, wrong, wrong / right);
    }
}

