#include <cmath>
#include <cstdio>
#include <initializer_list>

#include "toi/discs.hpp"
#include "wrong_quadratic.hpp"

using namespace flying;

namespace {

/// Two discs of 1 m radius on paths half a metre apart, from farther and farther away.
void meet_from_afar()
{
    std::printf("  distance  school formula off by   engine off by\n");
    for (const double distance : {1e1, 1e3, 1e5, 1e7, 1e9}) {
        const FarPair far = far_pair(distance, 0.5);
        const double expected = exactly(far, 2.0);
        const double school = school_meet(far.x, far.v, 2.0);
        const double engine = time_to_meet(far.x, far.v, 2.0);
        std::printf("%8.0e m", distance);
        if (school == k_never) std::printf(" %22s", "never meet");
        else std::printf(" %20.1e s", std::abs(school - expected));
        std::printf(" %13.1e s\n", std::abs(engine - expected));
    }
}

} // namespace

int main()
{
    meet_from_afar();
}
