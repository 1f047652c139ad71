#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "motion/flight.hpp"
#include "orbits.hpp"

namespace {

using namespace flying;
using namespace flying::steps;

// [flying.demo.throw]
void throw_a_ball()
{
    // Set up
    BodyState ball;
    ball.velocity = Vec2(3.0, 10.0);
    const Vec2 g(0.0, -8.0);

    // Update
    std::printf("   t [s]     x [m]     y [m]   v_y [m/s]\n");
    for (int k = 0; k <= 5; ++k) {
        const BodyState now = flight(ball, g, 0.5 * k);
        const Vec2 x = now.position;
        std::printf("%8.2f %9.2f %9.2f %11.2f\n", now.time, x.x(), x.y(), now.velocity.y());
    }
    // End: nothing to clean up, the values go as they came
}
// [flying.demo.throw]

// [flying.demo.miss]
/// How far the stepper ends from the closed form: n steps from the nearest point on, for
/// three quarters of a period.
template <typename Step>
double miss(const Step& step, const Orbit& orbit, long n)
{
    const double t = 0.75 * orbit.period();
    const double h = t / static_cast<double>(n);
    const Moving found = run(step, on_ellipse(orbit, 0.0), CentralPull{orbit.mu}, h, n);
    return (found.x - on_ellipse(orbit, t).x).norm() / orbit.a;
}
// [flying.demo.miss]

void compare(const Orbit& orbit)
{
    // [flying.demo.compare]
    std::printf("\n   steps      Euler  symplectic     Verlet     (miss, in half axes)\n");
    for (long n = 1000; n <= 1000000; n *= 10)
        std::printf("%8ld %10.1e  %10.1e %10.1e\n", n, miss(k_euler, orbit, n),
                    miss(k_symplectic, orbit, n), miss(k_verlet, orbit, n));

    const auto order = [&](const auto& step) {
        return std::log10(miss(step, orbit, 100000) / miss(step, orbit, 1000000));
    };
    std::printf("\norder of Euler = %.2f\n", order(k_euler));
    std::printf("order of symplectic Euler = %.2f\n", order(k_symplectic));
    std::printf("order of Verlet = %.2f\n", order(k_verlet));
    // [flying.demo.compare]
}

/// What is left of the energy, and where the closed form ends.
void long_runs(const Orbit& orbit)
{
    const double w = -orbit.mu / (2.0 * orbit.a);
    const double h = orbit.period() / 1000.0;
    const auto size = [&](const auto& step, long periods) {
        const Moving end =
            run(step, on_ellipse(orbit, 0.0), CentralPull{orbit.mu}, h, 1000 * periods);
        return w / energy(end, orbit.mu);
    };
    std::printf("\nHalf axis over the true one, with 1000 steps a period:\n\n periods      "
                "Euler  symplectic     Verlet\n");
    for (const long periods : {1, 10, 100, 300, 1000})
        std::printf("%8ld %10.4f  %10.4f %10.4f\n", periods, size(k_euler, periods),
                    size(k_symplectic, periods), size(k_verlet, periods));

    const double t = 0.3 * orbit.period();
    const Moving late = on_ellipse(orbit, t + 1000.0 * orbit.period());
    std::printf("\nmiss of the closed form after 1000 periods = %.0e\n",
                (late.x - on_ellipse(orbit, t).x).norm() / orbit.a);
}

} // namespace

int main(int argc, char** argv)
{
    // The eccentricity may be given: try 0, or 0.9
    const double ecc = argc > 1 ? std::atof(argv[1]) : 0.5;
    if (!(ecc >= 0.0 && ecc < 1.0)) {
        std::fprintf(stderr, "found %s; expected an eccentricity from 0 to below 1\n",
                     argv[1]);
        return 2;
    }
    throw_a_ball();
    const Orbit orbit{1.0, 1.0, ecc};
    compare(orbit);
    long_runs(orbit);
}
