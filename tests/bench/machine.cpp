#include "machine.hpp"

#include <time.h>

#include <chipmunk/chipmunk.h>

#include <algorithm>
#include <fstream>
#include <thread>

namespace flying::bench {
namespace {

double read(clockid_t clock)
{
    timespec now = {};
    clock_gettime(clock, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

} // namespace

Machine this_machine()
{
    Machine machine;
    machine.cores = static_cast<int>(std::thread::hardware_concurrency());
    machine.compiler = FLYING_COMPILER;
    machine.flags = FLYING_FLAGS;
    machine.box2d = std::string("Box2D ") + FLYING_BOX2D_VERSION + " of the distribution, assertions on, floats";
    machine.chipmunk = std::string("Chipmunk ") + cpVersionString + " of the distribution, assertions on, doubles";
#ifdef FLYING_SICONOS
    machine.siconos = "Siconos 4 of the distribution, doubles";
#else
    machine.siconos = "Siconos not built in";
#endif
    std::ifstream file("/proc/cpuinfo");
    for (std::string line; std::getline(file, line);) {
        if (!line.starts_with("model name")) continue;
        machine.cpu = line.substr(std::min(line.find(':') + 2, line.size()));
        break;
    }
    return machine;
}

double cpu_seconds()
{
    return read(CLOCK_PROCESS_CPUTIME_ID);
}
double wall_seconds()
{
    return read(CLOCK_MONOTONIC);
}

double median(std::vector<double> values)
{
    if (values.empty()) return 0.0;
    std::sort(values.begin(), values.end());
    const std::size_t middle = values.size() / 2;
    return values.size() % 2 == 1 ? values[middle] : 0.5 * (values[middle - 1] + values[middle]);
}

} // namespace flying::bench
