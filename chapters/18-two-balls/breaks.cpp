#include <cstdio>

#include "wrong_loops.hpp"

using namespace flying;

namespace {

/// Twenty-five discs, with and without a look at what has been overtaken.
void believe_everything()
{
    std::printf("%29s   momentum             energy   widest gap\n", "pushes");
    const auto print = [](const char* name, const Few& few) {
        const FewSums sums = sums_of(few);
        std::printf("%-22s %6zu   %.4f, %.4f %9.4f J %10.1e m\n", name, few.handled.size(),
                    sums.momentum.x(), sums.momentum.y(), sums.energy, few.widest_gap);
    };
    Few right = crowd_of(5);
    Few wrong = right;
    print("start", right);
    right.run(100.0);
    run_all_foreseen(wrong, 100.0);
    print("overtaken left out", right);
    print("all that was foreseen", wrong);
}

} // namespace

int main()
{
    believe_everything();
}
