#include "weave/light_svg.hpp"

#include <string>

#include <doctest/doctest.h>

using flying::weave::light_svg;

TEST_CASE("an SVG's paths go by short steps to the same points, to a tenth")
{
    CHECK(light_svg("<path d=\"M 102.917969 -3.5 L 7 0.12345 L 9 0.12345 L 9 30 Z M 102.917969 -3.5 \"/>") ==
          "<path d=\"m102.9-3.5l-95.9 3.6 2 0 0 29.9zm0 0\"/>");
    CHECK(light_svg("<path d=\"M 1 1 C 1.5 1 2 1.5 2 2 C 2.5 2 3 2.5 3 3\"/><path d=\"M 4 4 L 4 4\"/>") ==
          "<path d=\"m1 1c.5 0 1 .5 1 1 .5 0 1 .5 1 1\"/><path d=\"m4 4l0 0\"/>");
    // Behind a contour that is closed the way goes on from its start
    CHECK(light_svg("<path d=\"M 5 5 L 9 5 L 9 8 Z M 6 6 L 7 7\"/>") == "<path d=\"m5 5l4 0 0 3zm1 1l1 1\"/>");
}

TEST_CASE("steps of a long path do not add up their rounding")
{
    // From 0 to 7 by steps of 0.07: each alone would be a tenth, and all of them 10
    std::string path = "M 0 0";
    for (int k = 1; k <= 100; ++k) path += " L " + std::to_string(0.07 * k) + " 0";
    const std::string light = light_svg("<path d=\"" + path + "\"/>");
    int tenths = 0;
    for (std::size_t at = light.find(".1 0"); at != std::string::npos; at = light.find(".1 0", at + 1)) ++tenths;
    CHECK(tenths == 70);
}

TEST_CASE("what a light SVG can't shorten, it leaves")
{
    for (const char* same :
         {"", "<path d=\"M 1 2 A 3 3 0 0 1 4 5\"/>", "<path d=\"m 1 2 l 3 4\"/>", "<path d=\"L 1.26 2\"/>",
          "<path d=\"M 1.26 x\"/>", "<path d=\"M 1.26\"/>", "<g transform=\"matrix(0.123456)\"/>",
          "<path style=\"o:0.02;\"/>", "<g transform=\"matrix(0.123456", "<path d=\"M 1.26"})
        CHECK(light_svg(same) == same);
}

TEST_CASE("places in an SVG have one decimal at most, and colours two")
{
    CHECK(light_svg("<use x=\"294.117188\" y=\"20.5\" style=\"fill:rgb(98.823529%,97.6%,0%);\"/>") ==
          "<use x=\"294.1\" y=\"20.5\" style=\"fill:rgb(98.82%,97.6%,0%);\"/>");
}

TEST_CASE("letters that an SVG doesn't use are left out")
{
    const std::string used = "<symbol overflow=\"visible\" id=\"glyph0-1\">\n<path d=\"\"/>\n</symbol>\n";
    const std::string unused = "<symbol overflow=\"visible\" id=\"glyph0-10\">\n<path d=\"\"/>\n</symbol>\n";
    const std::string rest = "<use xlink:href=\"#glyph0-1\"/>";
    CHECK(light_svg(unused + used + unused + rest) == used + rest);
    CHECK(light_svg("<symbol id=\"a\">") == "<symbol id=\"a\">");
}
