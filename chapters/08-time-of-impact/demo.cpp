#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <initializer_list>

#include "bar.hpp"
#include "collide/separation.hpp"

using namespace flying;

namespace {

// [toi.demo.march]
/// A bar turns in place and strikes the floor: every reading of the march.
void march_of_bar(double y, double spin, double looseness)
{
    const double expected = bar_strikes(y, spin);
    const MarchBounds bounds = bar_bounds(y, spin, looseness);
    int readings = 0;
    const auto read = [&](double time) {
        const EdgeReading now = read_corner(y, spin, time);
        std::printf("%7d %18.15f %10.2e", ++readings, time, now.gap);
        std::printf("%10.3f %12.2e\n", now.gap_rate, expected - time);
        return now;
    };
    std::printf("bar, %g m up, %g rad/s\n", y, spin);
    std::printf("reading               time        gap      rate    too early\n");
    const MarchEnd end = march(read(0.0), read, bounds, 0.0, k_never);
    std::printf("found   %18.15f s, closed form %18.15f s\n", end.time, expected);
}
// [toi.demo.march]

// [toi.demo.turns]
/// The same bar comes down from higher and higher: how often is its corner read?
void count_readings(double spin, double looseness)
{
    std::printf("\ncomes down at 1 m/s\n   from   turns   readings            gap found\n");
    for (const double y : {1.5, 3.0, 6.0, 12.0, 24.0}) {
        int readings = 0;
        const auto read = [&](double time) {
            ++readings;
            EdgeReading now = read_corner(y, spin, time);
            now.gap -= time;
            now.gap_rate -= 1.0;
            return now;
        };
        const MarchBounds bounds = bar_bounds(y, spin, looseness);
        const MarchEnd end = march(read(0.0), read, bounds, 0.0, k_never);
        std::printf("%5.1f m %7.2f %10d %18.1e m\n", y, spin * end.time / 6.2831853, readings, read(end.time).gap);
    }
}
// [toi.demo.turns]

// [toi.demo.far]
/// A turning bar meets one that stands, here and far from the world's origin. The places are such that doubles can't
/// hold them, and hold them worse the further out they are.
void move_away(double spin)
{
    std::printf("\n     moved by               time       off by            gap      tolerance\n");
    double here = 0.0;
    for (const double moved : {0.0, 0x1p10, 0x1p20, 0x1p30}) {
        Flyer a = turning_bar(0.0, spin);
        Flyer b;
        a.state.position = {moved - 3.9, moved + 1.0 / 3.0};
        a.state.velocity = {1.0, 0.0};
        b.state.position = {moved + 0.1, moved};
        b.state.angle = 1.5;
        const Prediction answer = predict(bar(), a, bar(), b, 0.0, {.windows = 1000});
        if (moved == 0.0) here = answer.time;

        const Pose pose_a = pose_of(flight(a.state, Vec2::Zero(), answer.time));
        const double gap = separation(bar(), pose_a, bar(), pose_of(b.state));
        const double reach = 1.5 * moved + 4.0;
        const double noise = 4.0 * gap_tolerance(1.0, 1.0, reach, 1.0 + spin, answer.time).noise;
        const double off = std::abs(answer.time - here);
        std::printf("%11.0f m %18.15f %10.1e s %12.1e m %12.1e m\n", moved, answer.time, off, gap, noise);
    }
}
// [toi.demo.far]

} // namespace

// [toi.demo.main]
/// demo [HEIGHT [SPIN [LOOSENESS]]]
int main(int argc, char** argv)
{
    const double y = argc > 1 ? std::atof(argv[1]) : 0.75;
    const double spin = argc > 2 ? std::atof(argv[2]) : 2.0;
    const double looseness = argc > 3 ? std::atof(argv[3]) : 1.0;
    if (!(y > 0.0 && y < k_arm && spin > 0.0 && looseness > 0.0)) return 2;
    march_of_bar(y, spin, looseness);
    count_readings(spin, looseness);
    move_away(spin);
}
// [toi.demo.main]
