#include <cstdio>
#include <cstdlib>
#include <numbers>

#include "billiard.hpp"

using namespace flying;

namespace {

/// Two balls and a wall, each time with a hundred times the mass.
void count_digits(int digits)
{
    std::printf("masses              impacts     pi / theta   light ball after   by the circle\n");
    double ratio = 1.0;
    for (int k = 0; k < digits; ++k, ratio *= 100.0) {
        discs::Room room = billiard_room(ratio);
        const long impacts = discs::run(room, 1000.0);
        std::printf("1 : %-12.0f %10ld %14.2f %14.6f m/s %11.6f m/s\n", ratio, impacts,
                    std::numbers::pi / billiard_angle(ratio), room.discs[0].vx,
                    billiard_speeds_after(ratio).light);
    }
}

} // namespace

/// digits  how many of pi to count: 6 if none are given; 8 take some seconds
int main(int argc, char** argv)
{
    count_digits(argc > 1 ? std::atoi(argv[1]) : 6);
}
