#include "weave/light_svg.hpp"

#include <cstdlib>
#include <string>

#include <doctest/doctest.h>

using flying::weave::light_svg;

TEST_CASE("an SVG's paths go by short steps to the same points")
{
    CHECK(light_svg("<path d=\"M 102.917969 -3.5 L 7 0.12345 H 9 L 9 30 Z M 102.917969 -3.5 \"/>") ==
          "<path d=\"m102.92-3.5l-95.92 3.62h2v29.88z\"/>");
    CHECK(light_svg("<path d=\"M 1 1 C 1.5 1 2 1.5 2 2 C 2.5 2 3 2.5 3 3\"/>") ==
          "<path d=\"m1 1c.5 0 1 .5 1 1 .5 0 1 .5 1 1\"/>");
    // Behind a contour that is closed the way goes on from its start
    CHECK(light_svg("<path d=\"M 5 5 L 9 5 L 9 8 Z M 6 6 L 7 7\"/>") == "<path d=\"m5 5h4v3zm1 1l1 1\"/>");
}

TEST_CASE("steps of a long path do not add up their rounding")
{
    // A hundred steps of 0.014 to the right, each with a corner
    std::string path = "M 0 0";
    for (int k = 1; k <= 100; ++k) path += " L " + std::to_string(0.014 * k) + (k % 2 == 0 ? " 0" : " 1");
    const std::string light = light_svg("<path d=\"" + path + "\"/>");
    double x = 0.0;
    const std::size_t start = light.find('l') + 1;
    const char* at = light.c_str() + start;
    for (int k = 0; k < 100; ++k) {
        char* end = nullptr;
        x += std::strtod(at, &end);
        (void)std::strtod(end, &end);
        at = end;
    }
    CHECK(x == doctest::Approx(1.4).epsilon(0.01));
}

TEST_CASE("points on the way to the next are left out")
{
    CHECK(light_svg("<path d=\"M 0 0 L 1 0.001 L 2 0 L 3 0 L 3 9\"/>") == "<path d=\"m0 0h3v9\"/>");
    CHECK(light_svg("<path d=\"M 0 0 L 4 0 L 0 0\"/>") == "<path d=\"m0 0h4-4\"/>");
    // A dot that a round cap paints stays
    CHECK(light_svg("<path d=\"M 3 3 L 3 3\"/>") == "<path d=\"m3 3l0 0\"/>");
}

TEST_CASE("what a light SVG can't shorten, it leaves")
{
    for (const char* same :
         {"", "<path d=\"M 1 2 A 3 3 0 0 1 4 5\"/>", "<path d=\"m 1 2 l 3 4\"/>", "<path d=\"L 1 2\"/>",
          "<path d=\"M 1 x\"/>", "<g transform=\"matrix(0.123456)\"/>", "<a style=\"fill:rgb(1,2,3);\"/>"})
        CHECK(light_svg(same) == same);
}

TEST_CASE("colours and opacities are as fine as a screen is")
{
    CHECK(light_svg("<path style=\"fill:rgb(100%,50.196078%,0%);fill-opacity:0.0206667;\"/>") ==
          "<path style=\"fill:#ff8000;fill-opacity:0.020;\"/>");
}

TEST_CASE("a region that clips more than one thing is written once")
{
    const std::string open = "<clipPath id=\"";
    const std::string region = "\">\n  <path d=\"m0 0h1v1z\"/>\n</clipPath>\n";
    const std::string other = "\">\n  <path d=\"m0 0h2v1z\"/>\n</clipPath>\n";
    const auto use = [](const char* name) { return "<g clip-path=\"url(#" + std::string(name) + ")\"/>\n"; };
    CHECK(light_svg(open + "a" + region + open + "b" + other + open + "c" + region + use("a") + use("b") + use("c")) ==
          open + "a" + region + open + "b" + other + use("a") + use("b") + use("a"));
}

TEST_CASE("the outline of a letter is as fine as a twentieth")
{
    CHECK(light_svg(
              "<symbol id=\"a\">\n<path d=\"M 1.02 1.04 L 2.08 3\"/>\n</symbol><path d=\"M 1.02 1.04 L 2.08 3\"/>") ==
          "<symbol id=\"a\">\n<path d=\"m1 1.05l1.1 1.95\"/>\n</symbol><path d=\"m1.02 1.04l1.06 1.96\"/>");
}

TEST_CASE("signs that are never shown go, and the others' places have fewer decimals")
{
    const auto symbol = [](const char* name) {
        return "<symbol overflow=\"visible\" id=\"" + std::string(name) + "\">\n</symbol>\n";
    };
    CHECK(light_svg(symbol("g-0") + symbol("g-1") + symbol("g-12") +
                    "<use xlink:href=\"#g-12\" x=\"294.117188\" y=\"20\"/>") ==
          symbol("g-12") + "<use xlink:href=\"#g-12\" x=\"294.117\" y=\"20\"/>");
}
