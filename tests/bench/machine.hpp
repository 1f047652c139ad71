#pragma once

#include <string>
#include <vector>

namespace flying::bench {

/// What the figures were measured on and with.
struct Machine
{
    std::string cpu;
    int cores = 0;
    std::string compiler;
    std::string flags;
    std::string box2d;
    std::string chipmunk;
    std::string siconos;
};

[[nodiscard]] Machine this_machine();

/// Seconds that this process has computed. Everything here runs on one thread, so that on an idle machine this is the
/// time on the clock on the wall; on a busy one it is the fairer of the two.
[[nodiscard]] double cpu_seconds();
[[nodiscard]] double wall_seconds();

[[nodiscard]] double median(std::vector<double> values);

} // namespace flying::bench
