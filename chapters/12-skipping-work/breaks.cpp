#include <cmath>
#include <cstdio>
#include <string>

#include "plain_engine.hpp"

using namespace flying;


/// Nine hexagons in a box, three hundred impacts, by three engines side by side.
int main()
{
    PlainEngine none(hexagons(121), Bound::none);
    PlainEngine right(hexagons(121), Bound::right);
    PlainEngine spoilt(hexagons(121), Bound::spoilt);
    const double before = none.energy();
    int parted_right = 0;
    int parted_spoilt = 0;
    for (int k = 1; k <= 300; ++k) {
        if (!none.step() || !right.step() || !spoilt.step()) return 1;
        if (parted_right == 0 && right.hash() != none.hash()) parted_right = k;
        if (parted_spoilt == 0 && spoilt.hash() != none.hash()) parted_spoilt = k;
    }
    std::printf(
        "bound      first impact that differs   change of energy   deepest overlap\n");
    const auto print = [&](const char* name, int parted, const PlainEngine& engine) {
        std::printf("%-10s %25s %16.0e J %15.1e m\n", name,
                    parted == 0 ? "none" : std::to_string(parted).c_str(),
                    std::abs(engine.energy() - before), engine.deepest());
    };
    print("none", 0, none);
    print("right", parted_right, right);
    print("spoilt", parted_spoilt, spoilt);
    std::printf("\nfirst impact that differs = %d\n", parted_spoilt);
}

