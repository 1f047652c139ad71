#include <cstdio>
#include <initializer_list>

#include "counts.hpp"
#include "gas.hpp"

using namespace flying;

namespace {


/// Discs of radius 0.5 m in a square room that grows with their number: a disc on every 4
/// m².
void one_look()
{
    std::printf("    n   overlapping   all pairs     sweep     grid\n");
    for (const int n : {10, 30, 100, 300, 1000, 3000}) {
        Random random(92);
        const double W = 2.0 * std::sqrt(n);
        const Counts c = count(discs_in_room(n, 0.5, W, W, random), 0.5);
        std::printf("%5d %13ld %11ld %9ld %8ld\n", n, c.overlapping, c.all, c.sweep,
                    c.grid);
    }
}



/// A thousand discs fly for a hundred looks; between two looks none gets further than 0.1
/// m.
void look_again()
{
    Random random(93);
    std::vector<BoxedBody> bodies = discs_in_room(1000, 0.5, 64.0, 64.0, random);
    std::vector<Vec2> steps;
    for (int k = 0; k < 1000; ++k) {
        steps.push_back(Vec2{random.uniform(-0.1, 0.1), random.uniform(-0.1, 0.1)});
    }
    Sweep sweep;
    sweep.line_up(bodies);
    for (int look = 0; look < 100; ++look) {
        for (int k = 0; k < 1000; ++k) {
            bodies[k].box = {bodies[k].box.min + steps[k], bodies[k].box.max + steps[k]};
        }
        sweep.line_up(bodies);
    }
    std::printf("\nplaces moved for each body and look = %.2f\n",
                1e-5 * static_cast<double>(sweep.shifts()));
}



/// The event engine, a thousand impacts of n discs: work in comparisons.
void few_bodies()
{
    std::printf(
        "\n    n    all pairs: work    grid: comparisons    cells left      work\n");
    int fewest = 0;
    for (const int n : {4, 8, 12, 16, 20, 32, 64, 128}) {
        const EventCounts all = count_work(n, PairFinder::all_pairs);
        const EventCounts grid = count_work(n, PairFinder::grid);
        if (fewest == 0 && work(grid) < work(all)) fewest = n;
        std::printf("%5d %18.0f %20ld %13ld %9.0f\n", n, work(all), grid.predictions,
                    grid.cells, work(grid));
    }
    std::printf("\nfewest bodies for which the grid wins here = %d\n", fewest);
}


} // namespace


int main()
{
    one_look();
    look_again();
    few_bodies();
}

