#include <cstdio>

#include "scene/fault.hpp"
#include "scene/read.hpp"

using namespace flying;

// [simulator.faults]
int main()
{
    const Expected<Scene> scene = read_scene_file(FLYING_HERE "/five-faults.toml");
    if (scene) return 1;
    for (Fault fault : scene.faults()) {
        // Without the folder, which differs from machine to machine
        fault.place.erase(0, sizeof FLYING_HERE);
        std::printf("%s\n", format_fault(fault).c_str());
    }
}
// [simulator.faults]
