// Nine discs in a room. It takes a compiler and these two files: g++ -O2 discs.cpp &&
// ./a.out
#include <cstdio>

#include "discs.hpp"

int main()
{
    discs::Room room = discs::nine_discs();
    const double before = discs::energy(room);
    std::printf("  time   impacts     energy over that at the start, less 1\n");
    long impacts = 0;
    double time = 0.0;
    for (const double until : {10.0, 40.0, 70.0, 100.0}) {
        impacts += discs::run(room, until - time);
        time = until;
        std::printf("%4.0f s %9ld %25.0e\n", time, impacts,
                    discs::energy(room) / before - 1.0);
    }
}
