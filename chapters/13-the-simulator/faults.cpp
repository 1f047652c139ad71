#include <cstdio>
#include <fstream>
#include <sstream>
#include <string>

#include "scene/fault.hpp"
#include "scene/read.hpp"

using namespace flying;

namespace {


/// A sentence in lines of at most so many letters.
void print_wrapped(const std::string& text, std::size_t most)
{
    std::size_t column = 0;
    std::istringstream words(text);
    for (std::string word; words >> word;) {
        if (column > 0 && column + 1 + word.size() > most) {
            std::printf("\n   ");
            column = 3;
        }
        std::printf("%s%s", column > 0 ? " " : "", word.c_str());
        column += word.size() + (column > 0 ? 1 : 0);
    }
    std::printf("\n");
}


} // namespace


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
        std::printf("\n");
        print_wrapped(format_fault(fault), 74);
    }
}

