#include "module_map.hpp"

#include <doctest/doctest.h>

#include <fstream>
#include <sstream>

TEST_CASE("the map in docs/HOUSE.md is what the includes say; ninja module-map draws it")
{
    const std::filesystem::path root = FLYING_SOURCE_DIR;
    std::ostringstream text;
    text << std::ifstream(root / "docs/HOUSE.md").rdbuf();
    const std::string page = text.str();
    const std::optional<house::MapPlace> place = house::find_map(page);
    REQUIRE(place);
    CHECK(page.substr(place->begin, place->end - place->begin) == house::module_map(house::read_sources(root, "src")));
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
