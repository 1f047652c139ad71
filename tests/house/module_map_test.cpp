#include "module_map.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <fstream>
#include <regex>
#include <sstream>

namespace {

std::string text_of(const std::filesystem::path& file)
{
    std::ostringstream text;
    text << std::ifstream(file).rdbuf();
    return text.str();
}

} // namespace

TEST_CASE("the maps in docs/HOUSE.md are what the includes say: ninja module-map draws them")
{
    const std::filesystem::path root = FLYING_SOURCE_DIR;
    const std::string page = text_of(root / "docs/HOUSE.md");
    const std::vector<house::Source> sources = house::read_sources(root, "src");
    const auto drawn = [&](const char* heading) {
        const std::optional<house::MapPlace> place = house::find_map(page, heading);
        REQUIRE(place);
        return page.substr(place->begin, place->end - place->begin);
    };
    CHECK(drawn(house::k_modules_heading) == house::module_map(sources));
    CHECK(drawn(house::k_rest_heading) == house::file_map(sources, "rest"));
}

TEST_CASE("each function of a walk through files, as a chapter's table tells it, is in the file that it names")
{
    // | 4 | `split` | {{file:src/rest/islands.cpp}} | ...
    const std::filesystem::path root = FLYING_SOURCE_DIR;
    const std::regex row(R"(\| \d+ \| `(\w+)` \| \{\{file:([^}]+)\}\} \|)");
    int rows = 0;
    for (const auto& entry : std::filesystem::directory_iterator(root / "chapters")) {
        const std::string text = text_of(entry.path() / "chapter.md");
        for (std::sregex_iterator match(text.begin(), text.end(), row), end; match != end; ++match) {
            CAPTURE(match->str());
            const std::regex definition("\\b" + (*match)[1].str() + R"(\([^;{}]*\)( const)?\n\{)");
            CHECK(std::regex_search(text_of(root / (*match)[2].str()), definition));
            ++rows;
        }
    }
    CHECK(rows >= 12);
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
                                        "    weave\n    draw --> motion\n    motion --> math\n");
    CHECK(!house::find_map("## The map\nno map here", "## The map\n"));
    CHECK(!house::find_map("```mermaid\n```", "## The map\n"));
}

TEST_CASE("the map of a module's files has a header and its source as one, and all arrows of a ring")
{
    const auto source = [](const std::string& path, const std::vector<std::string>& lines) {
        return house::Source{"src/rest/" + path, "rest", lines, lines};
    };
    const std::vector<house::Source> sources = {
        source("step.cpp",
               {"#include \"math/vec2.hpp\"", "#include \"rest/island.hpp\"", "#include \"rest/point.hpp\""}),
        source("island.hpp", {"#include \"rest/point.hpp\""}),
        source("island.cpp", {"#include \"rest/island.hpp\""}),
        source("point.hpp", {}),
        source("day.hpp", {"#include \"rest/sun.hpp\"", "#include \"rest/moon.hpp\""}),
        source("sun.hpp", {"#include \"rest/moon.hpp\"", "#include \"rest/point.hpp\""}),
        source("moon.hpp", {"#include \"rest/sun.hpp\"", "#include \"rest/point.hpp\""})};
    CHECK(
        house::file_map(sources, "rest") ==
        "flowchart LR\n    day --> moon\n    day --> sun\n    island --> point\n    moon --> point\n    moon --> sun\n"
        "    step --> island\n    sun --> moon\n    sun --> point\n");
}
