// The comparison of part "skips", run by an engine of which one line was spoilt before it was compiled: it must turn red.
//
//   spoilt_NAME SKIP KIND   status 0 where some scene differs without the skip, 1 where all agree

#include <cstdio>
#include <string>

#include "stress/random_scenes.hpp"

int main(int count, char** words)
{
    using namespace flying::stress;
    constexpr std::uint64_t k_most = 3000;
    if (count != 3) return 2;
    const std::string skip = words[1];
    const std::string kind = words[2];
    std::uint64_t scenes = 0;
    for (std::uint64_t seed = 1; scenes < k_most; ++seed) {
        if (name_of(kind_of(seed)) != kind) continue;
        ++scenes;
        const flying::Scene scene = random_scene(seed);
        const std::string off = difference(trace_of(scene, {}), trace_of(scene, {skip}));
        if (off.empty()) continue;
        std::printf("scene %llu, the %lluth of its kind, without %s: %s\n", static_cast<unsigned long long>(seed),
                    static_cast<unsigned long long>(scenes), skip.c_str(), off.c_str());
        return 0;
    }
    std::printf("%llu scenes agree: the comparison has no teeth\n", static_cast<unsigned long long>(k_most));
    return 1;
}
