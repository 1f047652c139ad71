#include <cstdio>
#include <cstdlib>

#include "heap.hpp"

using namespace flying;
using namespace flying::test;

namespace {

void print_blocks(const char* name, int count, const Pairs& pairs)
{
    std::printf("%-16s %6d %9zu %8d %11ld\n", name, count, pairs.size(), blocks_of(count, pairs),
                blocks_by_hand(count, pairs).work);
}

/// What elimination takes.
void count_blocks()
{
    std::printf("                 bodies  contacts   blocks  operations\n");
    print_blocks("chain", 100, chain_of(100));
    print_blocks("ring", 100, ring_of(100));
    for (const int base : {10, 20, 40})
        print_blocks(("pyramid of " + std::to_string(base)).c_str(), base * (base + 1) / 2, pyramid_of(base));
}

/// What looking back gains.
void look_back()
{
    std::printf("\nboxes   sweeps to 1 %%   looking back\n");
    for (const int n : {10, 20, 40, 80}) {
        std::printf("%5d %14d %14d\n", n, sweeps_until(std::vector<double>(n, 1.0), 0.01),
                    sweeps_looking_back(n, 0.01));
    }
}

/// A heap that is poured, and falls asleep.
void pour(int count)
{
    RestEngine engine(over_a_pit(count));
    const double before = energy(engine);
    const double time = time_to_sleep(engine, 60.0);
    int asleep = 0;
    double deepest = 0.0;
    for (int k = 0; k < engine.body_count(); ++k) asleep += engine.is_asleep(k) ? 1 : 0;
    const std::vector<RestContact> contacts = engine.contacts();
    for (const RestContact& c : contacts) deepest = std::max(deepest, -c.gap);
    const Weighed weighed = weigh(engine);
    const RestCounts& counts = engine.counts();
    std::printf("\n%d discs: %d asleep after %.1f s\n", count, asleep, time);
    std::printf("contacts           %10zu\n", contacts.size());
    std::printf("deepest overlap    %10.0e m\n", deepest);
    std::printf("weight             %10.4f N\n", weighed.weight);
    std::printf("borne upwards      %10.4f N\n", weighed.borne);
    std::printf("energy lost        %10.1f J\n", before - energy(engine));
    std::printf("steps              %10ld\n", static_cast<long>(counts.steps));
    std::printf("searches for pairs %10ld\n", static_cast<long>(counts.looks));
    std::printf("islands swept      %10ld\n", static_cast<long>(engine.solve_counts().swept));
    std::printf("sweeps             %10ld\n", static_cast<long>(engine.solve_counts().sweeps));
    std::printf("overlap taken off  %10ld\n", static_cast<long>(counts.projected));
    std::printf("energy limited     %10ld\n", static_cast<long>(counts.limited));
}

} // namespace

/// count  discs to pour: 200 if none are given
int main(int argc, char** argv)
{
    count_blocks();
    look_back();
    pour(argc > 1 ? std::atoi(argv[1]) : 200);
}
