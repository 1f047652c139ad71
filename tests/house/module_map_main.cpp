#include <cstdio>
#include <fstream>
#include <sstream>

#include "module_map.hpp"

/// Draws the map of modules anew into docs/HOUSE.md.  module_map ROOT
int main(int argc, char** argv)
{
    if (argc != 2) {
        std::fputs("module_map: expected the project's folder\n", stderr);
        return 2;
    }
    const std::filesystem::path root = argv[1];
    const std::filesystem::path file = root / "docs/HOUSE.md";
    std::ostringstream text;
    text << std::ifstream(file).rdbuf();
    std::string page = text.str();
    const std::optional<house::MapPlace> place = house::find_map(page);
    if (!place) {
        std::fprintf(stderr, "module_map: found no block of Mermaid in %s\n", file.c_str());
        return 2;
    }
    page.replace(place->begin, place->end - place->begin, house::module_map(house::read_sources(root, "src")));
    std::ofstream(file) << page;
}
