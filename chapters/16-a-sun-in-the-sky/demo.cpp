#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <numbers>

#include "../01-flying-balls/orbits.hpp"
#include "motion/kepler.hpp"

namespace {

using namespace flying;
using namespace flying::steps;

/// A turn in eight equal spans of time: the anomalies, the place by the ellipse's own form, and how far the engine's one
/// form is from it.
void go_round(const Orbit& orbit)
{
    const Moving start = on_ellipse(orbit, 0.0);
    const KeplerFlight flight({start.x, start.v}, orbit.mu);
    std::printf("  t / T         M         E         r     speed   engine's miss\n");
    for (int k = 0; k <= 8; ++k) {
        const double share = k / 8.0;
        const double M = 2.0 * std::numbers::pi * share;
        const double E =
            k <= 4 ? eccentric_anomaly(M, orbit.ecc)
                   : 2.0 * std::numbers::pi -
                         eccentric_anomaly(2.0 * std::numbers::pi - M, orbit.ecc);
        const Moving here = on_ellipse(orbit, share * orbit.period());
        const Vec2 engine = flight.after(share * orbit.period()).position;
        std::printf("%7.3f %9.4f %9.4f %9.4f %9.4f %15.0e\n", share, M, E, here.x.norm(),
                    here.v.norm(), (engine - here.x).norm());
    }
}

/// The share of a turn that the body spends in the outer half of its ellipse: E from a
/// quarter of a turn to three quarters.
double share_outside(double ecc)
{
    const double quarter = 0.5 * std::numbers::pi;
    const double from = quarter - ecc; // M at E = pi/2
    return 1.0 - from / std::numbers::pi;
}

} // namespace

int main(int argc, char** argv)
{
    const double ecc = argc > 1 ? std::atof(argv[1]) : 0.5;
    if (!(ecc >= 0.0 && ecc < 1.0)) {
        std::fprintf(stderr, "found %s; expected an eccentricity from 0 to below 1\n",
                     argv[1]);
        return 2;
    }
    const Orbit orbit{1.0, 1.0, ecc};
    go_round(orbit);
    std::printf("\nshare of the time in the outer half = %.3f\n", share_outside(ecc));
    std::printf("fall from the earth's orbit into the sun = %.1f days\n",
                fall_time(1.32712440018e20, 1.495978707e11, 0.0) / 86400.0);
}
