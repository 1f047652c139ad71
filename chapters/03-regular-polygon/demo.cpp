#include <cstdio>
#include <initializer_list>

#include "beside_disc.hpp"

using namespace flying;

namespace {


/// How far regular polygons are from discs, of the same radius and the same area.
void compare_with_discs()
{
    std::printf("  sides   same radius     same area\n");
    for (const int n : {3, 4, 5, 6, 8, 12, 36, 100, 1000}) {
        const double radius = 1.0 - beside_disc_of_same_radius(n);
        const double area = beside_disc_of_same_area(n) - 1.0;
        std::printf("%7d %13.3e %13.3e\n", n, -radius, area);
    }
}



/// The fewest sides that come within a share of a disc.
template <typename Ratio>
int sides_within(double share, Ratio beside_disc)
{
    int n = 3;
    while (beside_disc(n) < 1.0 - share || beside_disc(n) > 1.0 + share) ++n;
    return n;
}

void count_sides()
{
    std::printf("\n  within   same radius   same area\n");
    for (const double share : {1e-1, 1e-2, 1e-3, 1e-6}) {
        const int by_radius = sides_within(share, beside_disc_of_same_radius);
        const int by_area = sides_within(share, beside_disc_of_same_area);
        std::printf("%8.0e %11d %11d\n", share, by_radius, by_area);
    }
}


} // namespace

int main()
{
    compare_with_discs();
    count_sides();
}
