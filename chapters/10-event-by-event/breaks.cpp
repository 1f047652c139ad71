#include <cstdio>
#include <initializer_list>
#include <numbers>

#include "three.hpp"
#include "wrong_few.hpp"

using namespace flying;

namespace {

// [events.breaks.stale]
/// Twenty-five discs, with and without a look at what has been overtaken.
void believe_everything()
{
    std::printf(
        "                      pushes   momentum            energy   widest gap at a push\n");
    const auto print = [](const char* name, const Few& few) {
        const FewSums sums = sums_of(few);
        std::printf("%-20s %7zu   %.4f, %.4f %9.4f J %12.1e m\n", name,
                    few.handled.size(), sums.momentum.x(), sums.momentum.y(),
                    sums.energy, few.widest_gap);
    };
    Few right = crowd_of(5);
    Few wrong = right;
    print("start", right);
    right.run(100.0);
    run_all_foreseen(wrong, 100.0);
    print("overtaken left out", right);
    print("all that was foreseen", wrong);
}
// [events.breaks.stale]

// [events.breaks.hops]
/// A ball at e = 1/2, whose first hop lasts a second.
void hop_for_ever()
{
    std::printf("\n     hops     time   last rebound\n");
    for (const long patience : {10L, 100L, 1000L, 10'000L, 1'000'000L}) {
        const Hops hops = hop_until(10.0, 4.9, 0.5, 9.8, patience);
        std::printf("%9ld %6.3f s %10.0e m/s\n", hops.count, hops.time, hops.speed);
    }
}
// [events.breaks.hops]

// [events.breaks.three]
/// Three balls in a row: how often they meet, and what the angle says.
void meet_in_a_row()
{
    std::printf("\n     e   pi / phi   impacts   gaps in the end\n");
    for (const double e : {1.0, 0.5, 0.2, 0.1, 0.08, 0.076, 0.074, 0.07, 0.05}) {
        EventEngine engine = three_in_a_row(e);
        if (engine.advance(100.0, -1)) continue;
        const auto gap = [&](int k) {
            const double left = state_at(engine.flyer(k), 100.0).position.x();
            return state_at(engine.flyer(k + 1), 100.0).position.x() - left - 1.0;
        };
        const double phi = row_angle(e);
        std::printf("%6.3f", e);
        if (phi > 0.0) std::printf("%11.2f", std::numbers::pi / phi);
        else std::printf("%11s", "-");
        std::printf(" %9ld %10.0e m, %.0e m\n", engine.counts().impacts, gap(0),
                    gap(1));
    }
}
// [events.breaks.three]

} // namespace

int main()
{
    believe_everything();
    hop_for_ever();
    meet_in_a_row();
}
