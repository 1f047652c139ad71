#include <cstdio>
#include <initializer_list>

#include "by_side.hpp"
#include "regular_polygon.hpp"


int main()
{
    std::printf("      sides   mass, sines   mass, law of cosines\n");
    const int k = 1000;
    for (const int n : {8, k, k * k, 10 * k * k, 100 * k * k, 200 * k * k, k * k * k}) {
        const double right = flying::regular_polygon_mass(n, 1.0, 1.0).mass;
        const double wrong = flying::wrong_polygon_mass(n, 1.0, 1.0).mass;
        std::printf("%11d %13.9f", n, right);
        if (wrong > 0.0) std::printf(" %22.9f\n", wrong);
        else std::printf(" %22s\n", "not a number");
    }
}

