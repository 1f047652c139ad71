#include <cstdio>
#include <fstream>
#include <string>

#include "scene/fault.hpp"
#include "scene/read.hpp"

using namespace flying;

// [simulator.faults]
int main()
{
    // The text, with the numbers of its lines
    std::ifstream text(FLYING_HERE "/five-faults.toml");
    int number = 0;
    for (std::string line; std::getline(text, line);) {
        std::printf("%2d  %s\n", ++number, line.c_str());
    }

    // What is wrong with it; without the folder, which differs from machine to machine
    const Expected<Scene> scene = read_scene_file(FLYING_HERE "/five-faults.toml");
    if (scene) return 1;
    for (Fault fault : scene.faults()) {
        fault.place.erase(0, sizeof FLYING_HERE);
        std::printf("\n%s\n", format_fault(fault).c_str());
    }
}
// [simulator.faults]
