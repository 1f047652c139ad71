// WRONG: the same hunt with an oracle that can't see what is broken.

#include <cstdio>

#include "hunt.hpp"

using namespace flying::breaking;

int main()
{
    // [breaking-it.breaks]
    constexpr std::uint64_t k_throws = 20'000;
    int got_out = 0;
    int gained = 0;
    for (std::uint64_t seed = 1; seed <= k_throws; ++seed) {
        Throw how = random_throw(seed);
        how.g = 0.0; // no field: energy is that of motion alone
        got_out += gets_out(how) ? 1 : 0;
        gained += gains_energy(how) ? 1 : 0;
    }
    // [breaking-it.breaks]

    std::printf("%d throws without gravity\n", static_cast<int>(k_throws));
    std::printf("broken, as energy sees it = %d\n", gained);
    std::printf("broken, as the walls see it = %d\n", got_out);
    return 0;
}
