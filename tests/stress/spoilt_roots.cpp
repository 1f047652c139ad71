// The comparison of part "roots", with an engine of which one line was spoilt before it was compiled: status 0 where the
// dense search finds a wrong answer, 1 where it finds none.

#include <cstdio>

#include "stress/random_pairs.hpp"

int main()
{
    using namespace flying::stress;
    constexpr std::uint64_t k_most = 200'000;
    for (std::uint64_t seed = 1; seed <= k_most; ++seed) {
        const RandomPair pair = random_pair(seed);
        const Verdict verdict = judge(pair, foresee(pair));
        if (verdict.right) continue;
        std::printf("pair %llu: %s\n", static_cast<unsigned long long>(seed), verdict.why.c_str());
        return 0;
    }
    std::printf("%llu pairs agree: the dense search has no teeth\n", static_cast<unsigned long long>(k_most));
    return 1;
}
