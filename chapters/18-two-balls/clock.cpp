#include <cstdio>
#include <initializer_list>

#include "wrong_loops.hpp"

using namespace flying;

namespace {

/// A ball at e = 1/2, whose first hop lasts a second.
void hop_for_ever()
{
    std::printf("     hops     time   last rebound\n");
    for (const long patience : {10L, 100L, 1000L, 10'000L, 1'000'000L}) {
        const Hops hops = hop_until(10.0, 4.9, 0.5, 9.8, patience);
        std::printf("%9ld %6.3f s %10.0e m/s\n", hops.count, hops.time, hops.speed);
    }
}

} // namespace

int main()
{
    hop_for_ever();
}
