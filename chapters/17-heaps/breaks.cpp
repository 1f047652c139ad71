#include <cstdio>

#include "rest/sweeps.hpp"
#include "wrong_heap.hpp"

using namespace flying;
using namespace flying::test;

/// Bodies on one, two and three points: what they bear after each round, in weights.
int main()
{
    std::printf("points   one after the other   all at once, round by round\n");
    for (int count = 1; count <= 3; ++count) {
        OnPoints right = on_points(count, 1.0);
        sweep(right.points, right.movers);
        double borne = 0.0;
        for (const ContactPoint& c : right.points) borne += c.normal;
        std::printf("%6d %23.0f  ", count, borne);
        OnPoints wrong = on_points(count, 1.0);
        for (int round = 0; round < 6; ++round) {
            sweep_at_once(wrong.points, wrong.movers);
            borne = 0.0;
            for (const ContactPoint& c : wrong.points) borne += c.normal;
            std::printf(" %3.0f", borne);
        }
        std::printf("\n");
    }
}
