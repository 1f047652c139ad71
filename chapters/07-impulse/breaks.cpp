#include <cstdio>
#include <initializer_list>

#include "response/one_point.hpp"
#include "wrong_impulse.hpp"

using namespace flying;

/// A ball of 1 kg and a wall: normal speeds before and after, by three formulas.
int main()
{
    const double w_n = 1.0;
    std::printf("              before    e   engine   two e   no test\n");
    for (const double v_n : {-1.0, 50.0}) {
        for (const double e : {1.0, 0.5, 0.0}) {
            const double right = v_n + w_n * newton_impulse(v_n, w_n, e);
            const double two_e = v_n + w_n * impulse_two_e(v_n, w_n, e);
            const double no_test = v_n + w_n * impulse_without_test(v_n, w_n, e);
            std::printf("%-10s %9.1f %4.1f %8.1f %7.1f %9.1f\n",
                        v_n < 0.0 ? "approaches" : "leaves", v_n, e, right + 0.0,
                        two_e + 0.0, no_test + 0.0);
        }
    }

    // Two balls of 1 kg, 3 m/s apart, watched from trains of several speeds
    std::printf("\n  train    relative   one body\n");
    for (const double train : {0.0, 1.0, 3.0, 5.0}) {
        const double v_a = 3.0 - train;
        const double v_b = 0.0 - train;
        const double right = newton_impulse(v_b - v_a, 2.0, 1.0);
        const double wrong = impulse_of_one_body(v_b, 2.0, 1.0);
        std::printf("%7.0f %7.1f N s %6.1f N s\n", train, right, wrong);
    }
}
