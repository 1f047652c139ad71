#include "module_map.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <fstream>
#include <sstream>

TEST_CASE("the map in docs/HOUSE.md is what the includes say: ninja module-map draws it")
{
    const std::filesystem::path root = FLYING_SOURCE_DIR;
    std::ostringstream text;
    text << std::ifstream(root / "docs/HOUSE.md").rdbuf();
    const std::string page = text.str();
    const std::optional<house::MapPlace> place = house::find_map(page);
    REQUIRE(place);
    CHECK(page.substr(place->begin, place->end - place->begin) == house::module_map(house::read_sources(root, "src")));
}

TEST_CASE("book.toml has a line for each module, each above all that use it, as the manual's first page says")
{
    const std::filesystem::path root = FLYING_SOURCE_DIR;
    std::vector<std::string> order;
    std::ifstream book(root / "chapters/book.toml");
    bool inside = false;
    for (std::string line; std::getline(book, line);) {
        if (line.starts_with("[")) inside = line == "[modules]";
        else if (inside && line.find(" = ") != std::string::npos) order.push_back(line.substr(0, line.find(' ')));
    }
    const auto place = [&](const std::string& module) { return std::find(order.begin(), order.end(), module); };
    const std::vector<house::Source> sources = house::read_sources(root, "src");
    for (const house::Source& source : sources) {
        CAPTURE(source.module);
        CHECK((source.module.empty() || place(source.module) != order.end()));
    }
    std::istringstream map(house::module_map(sources));
    int arrows = 0;
    for (std::string line; std::getline(map, line);) {
        const std::size_t arrow = line.find(" --> ");
        if (arrow == std::string::npos) continue;
        CAPTURE(line);
        CHECK(place(line.substr(arrow + 5)) < place(line.substr(4, arrow - 4)));
        ++arrows;
    }
    CHECK(arrows > 10);
}

TEST_CASE("arrows that follow from others are left out of the map, and a page without one has none")
{
    const auto source = [](const std::string& module, const std::vector<std::string>& lines) {
        return house::Source{"src/" + module + "/a.hpp", module, lines, lines};
    };
    const std::vector<house::Source> sources = {
        source("math", {"#include <vector>"}),
        source("motion", {"#include \"math/a.hpp\"", "#include \"motion/b.hpp\""}),
        source("draw", {"#include \"math/a.hpp\"", "#include \"motion/a.hpp\""}), source("weave", {})};
    CHECK(house::module_map(sources) == "flowchart TD\n    subgraph engine\n        math\n        motion\n    end\n"
                                        "    draw --> motion\n    motion --> math\n    weave\n");
    CHECK(!house::find_map("no map here"));
}
