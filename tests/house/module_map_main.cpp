#include <cstdio>
#include <fstream>
#include <sstream>

#include "module_map.hpp"

/// Draws the maps of docs/HOUSE.md anew: of modules, and of the files of `rest`.  module_map ROOT
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
    const std::vector<house::Source> sources = house::read_sources(root, "src");
    const auto draw = [&](const char* heading, const std::string& map) {
        const std::optional<house::MapPlace> place = house::find_map(page, heading);
        if (place) page.replace(place->begin, place->end - place->begin, map);
        else std::fprintf(stderr, "module_map: found no block of Mermaid in %s below %s", file.c_str(), heading);
        return place.has_value();
    };
    if (!draw(house::k_modules_heading, house::module_map(sources))) return 2;
    if (!draw(house::k_rest_heading, house::file_map(sources, "rest"))) return 2;
    std::ofstream(file) << page;
}
