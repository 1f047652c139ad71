// A number that is cut off by the end of its line, as in `tit = n`, was quoted with that line's end: the fault took two
// lines, and who reads faults line by line lost half of it.

#include <doctest/doctest.h>

#include "scene/fault.hpp"
#include "scene/read.hpp"

using namespace flying;

TEST_CASE("a fault is one line, wherever the text of a scene is cut off")
{
    for (const char* text : {"tit = n\n", "tit = i\n", "tit = t\r\n", "tit = f\n", "tit = n\t", "[wor\nld]\n",
                             "\"a\nb\" = 1\n", "a = 'x\n"}) {
        CAPTURE(text);
        const Expected<Scene> scene = read_scene_text(text, "scene.toml");
        REQUIRE_FALSE(scene);
        for (const Fault& fault : scene.faults()) {
            const std::string line = format_fault(fault);
            CHECK(line.starts_with("scene.toml:"));
            CHECK(line.find_first_of("\n\r\t") == std::string::npos);
        }
    }
}
