#include <cmath>
#include <cstdio>
#include <initializer_list>

#include "math/safe_step.hpp"
#include "wrong_step.hpp"
#include "wrong_steps.hpp"

using namespace flying;

namespace {

/// A disc of 10 cm and a wall of 2 cm: when they meet, by sixty looks a second and by the engine.
void throw_discs()
{
    std::printf("      speed   from        sixty looks a second              engine\n");
    const double throws[][2] = {{-2.0, 5.0}, {-2.0, 10.0}, {-2.08, 10.0}, {-2.0, 60.0}, {-2.0, 1e6}};
    for (const auto& [x, speed] : throws) {
        const Flyer flyer = thrown(x, speed);
        const double looked = first_overlap(flyer, 1.0 / 60.0, 2.0);
        const double found = predict(Disc{k_disc_radius}, flyer, thin_wall(), {}, 0.0, {.windows = 1000}).time;
        std::printf("%7.0f m/s %6.2f", speed, x);
        if (looked == k_never) std::printf(" %27s", "passes through the wall");
        else std::printf(" %25.6f s", looked);
        std::printf(" %17.9g s\n", found);
    }
}

/// A point comes down at 1 m/s with next to no bend: the root is one second away for each metre.
void step_to_roots()
{
    std::printf("\n     height     school formula        safe step\n");
    for (const double f : {1e-3, 1e-6, 1e-9, 1e-12, 1e-15}) {
        const double bend = 1e-4;
        std::printf("%9.0e m %16.9e s %14.9e s\n", f, school_step(f, -1.0, bend), safe_step(f, -1.0, bend));
    }
}

} // namespace

int main()
{
    throw_discs();
    step_to_roots();
}
