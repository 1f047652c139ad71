// A hunt for a throw that breaks a wall, and the simplest throw that still does.

#include <cstdio>

#include "hunt.hpp"
#include "silence.hpp"

using namespace flying;
using namespace flying::breaking;

namespace {

void print(const char* label, const Throw& how)
{
    std::printf("%-8s x %.6g, y %.6g, u %.6g, v %.6g, g %.6g, e %.6g, h %.6g, %d steps\n", label, how.x, how.y, how.u,
                how.v, how.g, how.e, how.h, how.steps);
}

} // namespace

int main()
{
    // [breaking-it.demo]
    constexpr std::uint64_t k_most = 100'000;
    const std::optional<std::uint64_t> seed = hunt(gets_out, k_most);
    if (!seed) return 1;
    const Throw found = random_throw(*seed);
    int tries = 0;
    const Throw smallest = shrink(found, [&](const Throw& how) {
        ++tries;
        return gets_out(how);
    });
    // [breaking-it.demo]

    std::printf("A throw that gets out of the room\n");
    print("found", found);
    print("shrunk", smallest);
    std::printf("\nseed of the first that gets out = %d\n", static_cast<int>(*seed));
    std::printf("steps of the found throw = %d\n", found.steps);
    std::printf("steps of the shrunk throw = %d\n", smallest.steps);
    std::printf("throws tried while shrinking = %d\n", tries);

    // Of how many throws?
    int out = 0;
    constexpr int k_throws = 10'000;
    for (int k = 1; k <= k_throws; ++k) out += gets_out(random_throw(static_cast<std::uint64_t>(k))) ? 1 : 0;
    std::printf("share of throws that get out = %.3f\n", static_cast<double>(out) / k_throws);

    std::printf("\nSo many tries without a failure, and the share of cases that may fail (one chance in twenty)\n");
    for (const double n : {1.0, 10.0, 100.0, 1e3, 1e6, 1e9})
        std::printf("%10.0f  %.2g\n", n, share_that_may_fail(n, 0.05));
    std::printf("share that may fail after a thousand = %.4f\n", share_that_may_fail(1000.0, 0.05));
    return 0;
}
