#include <cstdio>

#include "outlines.hpp"
#include "wrong_polygon.hpp"

using namespace flying;
using namespace flying::outlines;

namespace {

void compare(const char* name, const Ring& ring)
{
    const AreaMoments right = moments_of_ring(ring);
    const AreaMoments wrong = moments_without_sign(ring);
    std::printf("%-16s %9.0f %9.0f %12.4g %12.4g %+8.1f %%\n", name, right.area, wrong.area, right.second_moment,
                wrong.second_moment, 100.0 * (wrong.second_moment / right.second_moment - 1.0));
}

} // namespace

int main()
{
    std::printf("shape           area [cm^2]  no signs  moment [cm^4]  no signs   wrong by\n");
    compare("square", square(Vec2(3, 7), 80));
    compare("house", house());
    compare("horseshoe", horseshoe());
    compare("dumbbell", dumbbell());
}
