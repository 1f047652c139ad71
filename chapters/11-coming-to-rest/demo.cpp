#include <cstdio>
#include <cstdlib>
#include <map>
#include <string>

#include "column.hpp"
#include "lying.hpp"

using namespace flying;
using namespace flying::test;

namespace {


/// A ball let go at 1 m: when it lies still, and when it should.
void let_go(double e)
{
    RestEngine ball = zeno_ball(1.0, e, 1.0 / 960.0);
    const double time = time_to_rest(ball);
    std::printf("%5.2f %9ld %11.3f s %11.3f s\n", e,
                static_cast<long>(ball.counts().impacts), time, end_of_hops(1.0, e));
}



/// Columns of equal bodies, and a heavy one on a light one.
void count_sweeps()
{
    std::printf("\nbodies   a sweep leaves   sweeps to 1 %%   all at once, error\n");
    for (const int n : {2, 5, 10, 20, 50, 100}) {
        const std::vector<double> masses(n, 1.0);
        std::printf("%6d %16.5f %14d %13.0e\n", n, rate_of_sweeps(masses, 5 * n * n),
                    sweeps_until(masses, 0.01), solve_at_once(masses).error);
    }
    std::printf("\nheavy on light   a sweep leaves   sweeps to 1 %%   all at once\n");
    for (const double ratio : {1.0, 10.0, 100.0, 1000.0, 1e4}) {
        const std::vector<double> masses = {1.0, ratio};
        std::printf("%12.0f : 1 %16.5f %14d %13.0e\n", ratio,
                    rate_of_sweeps(masses, 20), sweeps_until(masses, 0.01),
                    solve_at_once(masses).error);
    }
}



/// What a second leaves of a stack, for sweeps shared out in three ways: from nothing,
/// from the step before, and among four times as many steps. And of a pyramid.
void warm_up()
{
    std::printf("\nsinks in 1 s     sweeps   from nothing   warm start   4 sub-steps\n");
    for (const int sweeps : {4, 8, 16, 32}) {
        std::printf("stack of 10     %7d %12.0e m %10.0e m %11.0e m\n", sweeps,
                    sinks_in_a_second(10, 60, sweeps, false),
                    sinks_in_a_second(10, 60, sweeps, true),
                    sinks_in_a_second(10, 240, sweeps / 4, true));
    }
    std::printf("\npyramid of 55   sweeps in 1 s     sinks\n");
    for (const bool is_warm : {false, true}) {
        const SweptPyramid pyramid = sweep_pyramid(10, is_warm);
        std::printf("%-13s %15lld %7.0e m\n", is_warm ? "warm start" : "from nothing",
                    static_cast<long long>(pyramid.sweeps), pyramid.sunk);
    }
}



/// Boxes one on the other: what each lies on bears, in newtons.
void weigh(int count)
{
    RestEngine engine(stack(count));
    engine.advance(60.0);
    std::map<int, double> force;
    for (const RestContact& contact : engine.contacts())
        force[contact.b] += contact.normal_force;
    std::printf("\nbox of %d   below it   weights above    fell   asleep\n", count);
    for (int k = 1; k <= count; k += (count + 4) / 5) {
        std::printf("%9d %9.4f N %13.4f N %4.0e m %6s\n", k, force[k],
                    k_gravity * (count - k + 1),
                    k - 0.5 - engine.state(k).position.y(),
                    engine.is_asleep(k) ? "yes" : "no");
    }
}



/// Limits found by letting go and looking, and those on paper.
void find_limits()
{
    std::printf("\nlimit                       found        on paper\n");
    const auto print = [](const char* name, double found, double paper) {
        std::printf("%-20s %15.6f %15.6f\n", name, found, paper);
    };
    print("sticks, tan 1/2", limit_of(1.0, 0.1, 24, [](double mu) {
              return left_on_slope(0.5, mu) == Fate::lies;
          }),
          0.5);
    print("stands, width 0.7 m", limit_of(0.1, 2.0, 24, [](double tangent) {
              return left_on_slope(tangent, 5.0) == Fate::lies;
          }),
          0.7);
    for (const int n : {1, 2, 3, 4}) {
        double reach = 0.0;
        for (int k = 1; k <= n; ++k) reach += 1.0 / k;
        const std::string name = "planks: " + std::to_string(n);
        print(name.c_str(), greatest_overhang(n), reach);
    }
}


} // namespace

/// e      restitution of one more ball
/// count  boxes in the stack: 10 if none are given
int main(int argc, char** argv)
{
    std::printf("    e   bounces   lies still   by the sum\n");
    for (const double e : {0.1, 0.3, 0.5, 0.7, 0.8}) let_go(e);
    if (argc > 1) let_go(std::atof(argv[1]));
    count_sweeps();
    warm_up();
    weigh(argc > 2 ? std::atoi(argv[2]) : 10);
    find_limits();
}
