#include <cstdio>
#include <initializer_list>

#include "response/push_line.hpp"
#include "strikes.hpp"

using namespace flying;

namespace {


/// A ball and a rod, each of 1 kg: struck in the middle, and ever further out.
void strike_rods()
{
    std::printf("ball and rod, e = 1\n");
    std::printf("  struck at    felt    impulse      ball       rod      spin    energy\n");
    for (const double d : {0.0, 0.125, 0.25, 0.375, 0.5}) {
        const double felt = 1.0 / (1.0 + 12.0 * d * d);
        const ImpactResult after = strike_rod(1.0, d, 1.0);
        const double ball = after.velocity_a.y();
        const double rod = after.velocity_b.y();
        const double energy =
            0.5 * (ball * ball + rod * rod + after.spin_b * after.spin_b / 12.0);
        std::printf("%9.3f m %4.2f kg %6.3f N s %9.3f %9.3f %9.3f %9.3f\n", d, felt,
                    1.0 - ball, ball, rod, after.spin_b, energy);
    }
}


/// A disc on a rough floor, faster and faster along it.
void strike_floors()
{
    std::printf("\ndisc on the floor, e = 1, mu = 0.5\n");
    std::printf("   slip before     after      spin   kept of the energy\n");
    for (const double slip : {1.0, 2.0, 3.0, 4.0, 6.0}) {
        const ImpactResult after = strike_floor(slip, {1.0, 0.5});
        const double left = after.velocity_b.x() + after.spin_b;
        const double before = slip * slip + 1.0;
        const double kept =
            after.velocity_b.squaredNorm() + 0.5 * after.spin_b * after.spin_b;
        std::printf("%10.1f m/s %9.3f %9.3f %12.3f\n", slip, left, after.spin_b,
                    kept / before);
    }
}

/// Five equal balls that touch; the first comes in at 1 m/s.
void strike_rows()
{
    const Row start{1.0, 0.0, 0.0, 0.0, 0.0};
    const auto print = [](const char* law, double e, const Row& v) {
        double momentum = 0.0;
        double energy = 0.0;
        for (const double each : v) momentum += each, energy += each * each;
        std::printf("%-8s %4.1f %7.3f %7.3f %7.3f %7.3f %7.3f %9.3f %9.3f\n", law, e, v[0],
                    v[1], v[2], v[3], v[4], momentum, energy);
    };
    std::printf(
        "\nfive balls    e       1       2       3       4       5  momentum    energy\n");
    for (const double e : {1.0, 0.9}) {
        print("in turn", e, struck_in_turn(start, e));
        print("at once", e, struck_at_once(start, e));
    }
}

} // namespace


int main()
{
    strike_rods();
    strike_floors();
    strike_rows();
}

