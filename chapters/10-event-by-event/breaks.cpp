#include <cstdio>

#include "wrong_cells.hpp"

using namespace flying;

namespace {

/// Twenty-five discs: all pairs, and the nine cells about a disc that was pushed.
void look_around_only()
{
    std::printf("%26s   momentum             energy   deepest overlap\n", "pushes");
    const auto print = [](const char* name, const Few& few, double deepest) {
        const FewSums sums = sums_of(few);
        std::printf("%-19s %6zu   %.4f, %.4f %9.4f J %15.1e m\n", name, few.handled.size(),
                    sums.momentum.x(), sums.momentum.y(), sums.energy, deepest);
    };
    Few right = crowd_of(5);
    Few wrong = right;
    const auto all = [](Few& few, int a, double) { few.foresee(a); };
    print("all pairs", right, run_looking(right, 100.0, all));
    print("nine cells", wrong, run_looking(wrong, 100.0, LookAround{1.25}));
}

} // namespace

int main()
{
    look_around_only();
}
