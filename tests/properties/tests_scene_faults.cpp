// Bad scenes, each with the faults that it must give: all of them, in the order of the text, with line and column.

#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "scene/fault.hpp"
#include "scene/read.hpp"

using namespace flying;

namespace {

/// A scene text and the beginnings of its faults, each without the file's name. What the module `scene` says itself
/// stands here in full; of what `validate` says, as far as its wording is no matter.
struct BadScene
{
    const char* what;
    const char* text;
    std::vector<std::string> faults;
};

// One line with a sound shape and place, for what is wrong elsewhere
#define SOUND "shape = { kind = \"disc\", radius = 1.0 }\nposition = [0.0, 0.0]\n"

const std::vector<BadScene>& bad_scenes()
{
    static const std::vector<BadScene> scenes = {
        // No TOML
        {"a word alone", "until", {"1:6: this is no TOML: "}},
        {"a word without quotation marks",
         "[[body]]\nshape = { kind = disc, radius = 1 }\n",
         {"2:18: this is no TOML: Error while parsing value: could not determine value type (a word stands between "
          "quotation marks)"}},
        {"no value", "until =\n", {"1:8: this is no TOML: "}},
        {"an open string", "title = \"two\nuntil = 1.0\n", {"1:13: this is no TOML: "}},
        {"a key twice", "until = 1.0\nuntil = 2.0\n", {"2:9: this is no TOML: "}},
        {"an open array", "[[body]]\nposition = [1.0, 2.0\n", {"2:22: this is no TOML: "}},
        {"an open header", "[world\nfriction = 0.0\n", {"1:7: this is no TOML: "}},
        {"bytes that are no UTF-8", "title = \"\xff\xfe\"\n", {"1:9: this is no TOML: "}},
        {"an accented letter in a key", "[world]\nfriction = 0.5\nl\u00e4nge = 1\n", {"3:2: this is no TOML: "}},
        {"an accented letter in a number", "until = 4.\u00e9\n", {"1:11: this is no TOML: "}},
        {"a tower of dots behind a string that ends in five quotation marks",
         "title = \"\"\"a\n\"\"\"\"\" # \u00e4\na.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a = 1\n",
         {"3:34: found a key of more than 16 parts"}},
        {"a tower of dots",
         "a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a = 1\n",
         {"1:34: found a key of more than 16 parts, expected a key of a scene"}},
        {"a tower of brackets",
         "title = [[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[\n",
         {"1:41: this is no TOML: "}},

        // Keys
        {"an unknown key at the top",
         "untill = 1.0\n",
         {"1:1: found the unknown key \"untill\", expected one of title, until, world, body (did you mean until?)"}},
        {"an unknown key that is like nothing",
         "colour = 3\n",
         {"1:1: found the unknown key \"colour\", expected one of title, until, world, body"}},
        {"an unknown key of the world",
         "[world]\nfritcion = 0.5\n",
         {"2:1: world: found the unknown key \"fritcion\", expected one of field, restitution, friction, box (did you "
          "mean friction?)"}},
        {"gravity beside the field that it belongs into",
         "[world]\ngravity = [0, -9.81]\n",
         {"2:1: world: found the unknown key \"gravity\", expected one of field, restitution, friction, box (did you "
          "mean "
          "field = { kind = \"uniform\", gravity = [x, y] }?)"}},
        {"gravity at the top",
         "gravity = [0, -9.81]\n",
         {"1:1: found the unknown key \"gravity\", expected one of title, until, world, body (did you mean field, "
          "under "
          "[world]?)"}},
        {"a circle",
         "[[body]]\nshape = { kind = \"circle\", radius = 1.0 }\nposition = [0, 0]\n",
         {"2:18: body 0, shape.kind: found \"circle\", expected one of disc, rectangle, square, triangle, regular, "
          "polygon (did you mean disc?)"}},
        {"a centre spelt another way: nothing is said of bodies about it",
         "[world]\nfield = { kind = \"central\", center = [9, 0], mu = 1.0, radius = 2.0 }\n[[body]]\n" SOUND,
         {"2:9: world.field.centre: found nothing, expected two numbers [x, y] [m]",
          "2:29: world.field: found the unknown key \"center\", expected one of kind, centre, mu, radius (did you mean "
          "centre?)"}},
        {"bodies for body",
         "[[bodies]]\n" SOUND,
         {"1:3: found the unknown key \"bodies\", expected one of title, until, world, body (did you mean [[body]]?)"}},
        {"the end of the run below a body",
         "[[body]]\n" SOUND "until = 5.0\n",
         {"4:1: body 0: found the unknown key \"until\", expected one of name, shape, position, angle, velocity, spin, "
          "static, density, mass, restitution, friction (did you mean until, above the first [[body]]?)"}},
        {"an unknown key beside a field",
         "[world]\nfield = { kind = \"uniform\", gravity = [0, -9.81] }\nfrction = 0.5\n",
         {"3:1: world: found the unknown key \"frction\", expected one of field, restitution, friction, box (did you "
          "mean friction?)"}},
        {"an unknown key of a body",
         "[[body]]\nname = \"a\"\n" SOUND "vellocity = [1, 2]\n",
         {"5:1: body \"a\": found the unknown key \"vellocity\", expected one of name, shape, position, angle, "
          "velocity, "
          "spin, static, density, mass, restitution, friction (did you mean velocity?)"}},
        {"an unknown key of a shape",
         "[[body]]\nshape = { kind = \"disc\", raduis = 1.0 }\nposition = [0, 0]\n",
         {"2:9: body 0, shape.radius: found nothing, expected a positive length [m]",
          "2:26: body 0, shape: found the unknown key \"raduis\", expected one of kind, radius (did you mean "
          "radius?)"}},
        {"a key of another shape",
         "[[body]]\nshape = { kind = \"disc\", radius = 1, side = 1 }\nposition = [0, 0]\n",
         {"2:38: body 0, shape: found the unknown key \"side\", expected one of kind, radius"}},
        {"a body with nothing in it",
         "[[body]]\n",
         {"1:1: body 0, shape: found nothing, expected a shape { kind = ... }",
          "1:1: body 0, position: found nothing, expected two numbers [x, y] [m]"}},

        // Types
        {"a number for a title", "title = 3\n", {"1:9: title: found 3, expected a title between quotation marks"}},
        {"a string for a time", "until = \"ten\"\n", {"1:9: until: found \"ten\", expected a time of 0 or more [s]"}},
        {"a date for a time",
         "until = 2001-02-03\n",
         {"1:9: until: found a date or time, expected a time of 0 or more [s]"}},
        {"a number for the world", "world = 1\n", {"1:9: world: found 1, expected a table"}},
        {"one body in single brackets",
         "[body]\n" SOUND,
         {"1:1: body: found a table, expected a list of bodies, each under its own [[body]]"}},
        {"bodies that are no tables",
         "body = [1, \"two\"]\n",
         {"1:9: body 0: found 1, expected a table", "1:12: body 1: found \"two\", expected a table"}},
        {"a number for a name",
         "[[body]]\nname = 7\n" SOUND,
         {"2:8: body 0, name: found 7, expected a name between quotation marks"}},
        {"a string for a shape",
         "[[body]]\nshape = \"disc\"\nposition = [0, 0]\n",
         {"2:9: body 0, shape: found \"disc\", expected a shape { kind = ... }"}},
        {"three coordinates",
         "[[body]]\nshape = { kind = \"disc\", radius = 1 }\nposition = [1, 2, 3]\n",
         {"3:12: body 0, position: found an array of 3 values, expected two numbers [x, y] [m]"}},
        {"a word in a vector",
         "[[body]]\n" SOUND "velocity = [1.0, \"fast\"]\n",
         {"4:18: body 0, velocity[1]: found \"fast\", expected a number"}},
        {"yes for true",
         "[[body]]\n" SOUND "static = \"yes\"\n",
         {"4:10: body 0, static: found \"yes\", expected true or false"}},
        {"half a side",
         "[[body]]\nshape = { kind = \"regular\", sides = 3.5, radius = 1 }\nposition = [0, 0]\n",
         {"2:37: body 0, shape.sides: found 3.5, expected a whole number of 3 or more"}},
        {"more sides than an int holds",
         "[[body]]\nshape = { kind = \"regular\", sides = 99999999999, radius = 1 }\nposition = [0, 0]\n",
         {"2:37: body 0, shape.sides: found 99999999999, expected a whole number of 3 or more"}},
        {"vertices that are no points",
         "[[body]]\nshape = { kind = \"polygon\", vertices = [[0, 0], [1], 2] }\nposition = [0, 0]\n",
         {"2:49: body 0, shape.vertices[1]: found an array of 1 value, expected two numbers [x, y] [m]",
          "2:54: body 0, shape.vertices[2]: found 2, expected two numbers [x, y] [m]"}},
        {"holes that are no rings",
         "[[body]]\nshape = { kind = \"polygon\", vertices = [[0,0],[9,0],[0,9]], holes = [[1, 1]] }\nposition = "
         "[0,0]\n",
         {"2:71: body 0, shape.holes[0][0]: found 1, expected two numbers [x, y] [m]",
          "2:74: body 0, shape.holes[0][1]: found 1, expected two numbers [x, y] [m]"}},

        // Words
        {"an unknown shape",
         "[[body]]\nname = \"b\"\nshape = { kind = \"disk\", radius = 1 }\nposition = [0, 0]\n",
         {"3:18: body \"b\", shape.kind: found \"disk\", expected one of disc, rectangle, square, triangle, regular, "
          "polygon (did you mean disc?)"}},
        {"a shape without kind",
         "[[body]]\nshape = { radius = 1 }\nposition = [0, 0]\n",
         {"2:9: body 0, shape.kind: found nothing, expected one of disc, rectangle, square, triangle, regular, "
          "polygon"}},
        {"an unknown field",
         "[world]\nfield = { kind = \"unifrom\", gravity = [0, 1] }\n",
         {"2:18: world.field.kind: found \"unifrom\", expected one of none, uniform, central (did you mean uniform?)"}},
        {"a central field without strength",
         "[world]\nfield = { kind = \"central\", centre = [0, 0], core = 1.0 }\n",
         {"2:9: world.field.mu: found nothing, expected a positive number [m^3/s^2]",
          "2:46: world.field: found the unknown key \"core\", expected one of kind, centre, mu, radius"}},
        {"a uniform field without gravity",
         "[world]\nfield = { kind = \"uniform\" }\n",
         {"2:9: world.field.gravity: found nothing, expected two numbers [x, y] [m/s^2]"}},
        {"half a box",
         "[world]\nbox = { min = [0, 0] }\n",
         {"2:7: world.box.max: found nothing, expected two numbers [x, y] [m]"}},

        // What the world finds
        {"a negative time", "until = -1.0\n", {"1:9: until: found -1, expected "}},
        {"a negative radius",
         "[[body]]\nname = \"left\"\nshape = { kind = \"disc\", radius = -1.0 }\nposition = [0.0, 0.0]\n",
         {"3:35: body \"left\", shape.radius: found -1, expected a positive length"}},
        {"not a number", "[[body]]\n" SOUND "velocity = [1.0, nan]\n", {"4:18: body 0, velocity[1]: found nan"}},
        {"infinite",
         "[[body]]\nshape = { kind = \"disc\", radius = inf }\nposition = [0, 0]\n",
         {"2:35: body 0, shape.radius: found inf, expected a positive length"}},
        {"a box inside out",
         "[world]\nbox = { min = [1, 1], max = [0, 0] }\n",
         {"2:30: world.box.max[0]: found 0", "2:33: world.box.max[1]: found 0"}},
        {"too much restitution, in the world and in a body",
         "[[body]]\n" SOUND "restitution = 1.5\n[world]\nrestitution = 2\n",
         {"4:15: body 0, restitution: found 1.5", "6:15: world.restitution: found 2"}},
        {"a static body that moves",
         "[[body]]\n" SOUND "velocity = [1, 0]\nstatic = true\n",
         {"4:12: body 0, velocity: found [1, 0]"}},
        {"a polygon of two vertices",
         "[[body]]\nshape = { kind = \"polygon\", vertices = [[0, 0], [1, 0]] }\n"
         "position = [0, 0]\n",
         {"2:40: body 0, shape.vertices: found "}},
        {"one name twice",
         "[[body]]\nname = \"a\"\n" SOUND "[[body]]\nname = \"a\"\nshape = { kind = \"disc\", radius = 1 }\n"
         "position = [9, 0]\n",
         {"6:8: body \"a\", name: found "}},
        {"two bodies in one place",
         "[[body]]\n" SOUND "[[body]]\nshape = { kind = \"disc\", radius = 1.0 }\nposition = [1.0, 0.0]\n",
         {"6:12: body 1, position: found body 1 overlaps body 0 by 1 m"}},

        // All together, and nothing made up about what could not be read
        {"faults of every sort",
         "until = -2\n[world]\nfrction = 1\n[[body]]\nname = \"a\"\nshape = { kind = \"disc\", radius = \"big\" }\n"
         "position = [0, 0]\n[[body]]\nshape = { kind = \"disc\", radius = -3 }\nposition = [0, 0]\n[[body]]\n" SOUND,
         {"1:9: until: found -2",
          "3:1: world: found the unknown key \"frction\", expected one of field, restitution, friction, box (did you "
          "mean "
          "friction?)",
          "6:35: body \"a\", shape.radius: found \"big\", expected a positive length [m]",
          "9:35: body 1, shape.radius: found -3"}},
        {"a body with a mistyped key, and more",
         "[[body]]\nshape = { kind = \"disc\", radius = -1 }\npostion = [0, 0]\ndensity = nan\nfrction = 1\n"
         "velocity = [\"fast\", inf]\n",
         {"1:1: body 0, position: found nothing", "2:35: body 0, shape.radius: found -1, expected a positive length",
          "3:1: body 0: found the unknown key \"postion\"", "4:11: body 0, density: found nan",
          "5:1: body 0: found the unknown key \"frction\"", "6:13: body 0, velocity[0]: found \"fast\"",
          "6:21: body 0, velocity[1]: found inf"}},
        {"a shape with one side that is none, and one that is no number",
         "[[body]]\nshape = { kind = \"rectangle\", width = 0.0, height = \"tall\" }\nposition = [0, 0]\n",
         {"2:39: body 0, shape.width: found 0", "2:53: body 0, shape.height: found \"tall\""}},
        {"a wall perhaps, which may weigh nothing, and may be in the way of nothing",
         "[world]\nbox = { min = [-1, -1], max = [1, 1] }\n[[body]]\n" SOUND "static = 1\nmass = 0\nspin = inf\n"
         "friction = -1\n[[body]]\n" SOUND "angle = \"up\"\n[[body]]\n" SOUND,
         {"6:10: body 0, static: found 1", "9:12: body 0, friction: found -1", "13:9: body 1, angle: found \"up\""}},
        {"a ring with a point that is none is not told to cross itself",
         "[[body]]\nshape = { kind = \"polygon\", vertices = [[1, 1], \"a\", [0, 1], [1, 0]] }\n"
         "position = [nan, 0]\n",
         {"2:49: body 0, shape.vertices[1]: found \"a\"", "3:13: body 0, position[0]: found nan"}},
        {"a world with a mistyped key still has its box",
         "[world]\nfrction = 1\nbox = { min = [0, \"a\"], max = [nan, 1] }\nfriction = -1\n",
         {"2:1: world: found the unknown key \"frction\"", "3:19: world.box.min[1]: found \"a\"",
          "3:32: world.box.max[0]: found nan", "4:12: world.friction: found -1"}},
        {"a body outside the box of a world with a mistyped key",
         "[world]\nfrction = 1\nbox = { min = [4, 4], max = [9, 9] }\n[[body]]\n" SOUND,
         {"2:1: world: found the unknown key \"frction\"", "6:12: body 0, position: found body 0 reaches",
          "6:12: body 0, position: found body 0 reaches"}},
        {"an overlap behind a broken body",
         "[[body]]\n[[body]]\n" SOUND "[[body]]\n" SOUND,
         {"1:1: body 0, shape: found nothing", "1:1: body 0, position: found nothing",
          "7:12: body 2, position: found body 2 overlaps body 1 by 2 m"}},
        {"a column after letters of two bytes",
         "title = \"\u00e4\u00f6\u00fc\"\n[[body]]\nname = \"\u00e9\u00e8\"\n" SOUND "spin = [\"\u00e9\", 1]\n",
         {"6:8: body \"\u00e9\u00e8\", spin: found an array of 2 values, expected a number [rad/s]"}},
    };
    return scenes;
}

#undef SOUND

} // namespace

TEST_CASE("A bad scene gives all of its faults, each with line and column")
{
    CHECK(bad_scenes().size() >= 40);
    for (const BadScene& bad : bad_scenes()) {
        const Expected<Scene> scene = read_scene_text(bad.text, "scene.toml");
        INFO(bad.what);
        REQUIRE(!scene.has_value());
        INFO(format_faults(scene.faults()));
        REQUIRE(scene.faults().size() == bad.faults.size());
        for (std::size_t k = 0; k < bad.faults.size(); ++k) {
            const std::string found = format_fault(scene.faults()[k]);
            const std::string expected = "scene.toml:" + bad.faults[k];
            CHECK_MESSAGE(found.substr(0, expected.size()) == expected, found, "\nexpected: ", expected);
        }
    }
}

TEST_CASE("A text with a zero byte, an empty one, and one of comments are read as TOML has them")
{
    CHECK(!read_scene_text(std::string_view("until = 1.0\n\0", 13), "scene.toml"));
    CHECK(read_scene_text("\xef\xbb\xbftitle = \"with a byte order mark\"\n", "scene.toml"));
    CHECK(read_scene_text("", "scene.toml"));
    CHECK(read_scene_text("# nothing ... but a.b.c.d.e.f.g.h.i.j.k.l.m.n.o.p.q.r.s dots\n", "scene.toml"));
    CHECK(read_scene_text("title = 'dots: ....................... and no end'\n", "scene.toml"));
    CHECK(read_scene_text("title = \"\"\"\ndots: \\\" ....................... \n\"\"\"\n", "scene.toml"));
}

TEST_CASE("Whole numbers stand for floats, a field may be a word, and keys may have dots")
{
    const Expected<Scene> scene = read_scene_text("until = 3\n"
                                                  "world.field = \"none\"\n"
                                                  "[[body]]\n"
                                                  "shape.kind = \"square\"\n"
                                                  "shape.side = 2\n"
                                                  "position = [1, -2]\n"
                                                  "static = true\n",
                                                  "scene.toml");
    REQUIRE(scene);
    CHECK(scene.value().until == 3.0);
    CHECK(std::holds_alternative<NoField>(scene.value().world.field));
    REQUIRE(scene.value().bodies.size() == 1);
    CHECK(std::get<SquareDef>(scene.value().bodies[0].shape).side == 2.0);
    CHECK(scene.value().bodies[0].position == Vec2(1.0, -2.0));
    CHECK(scene.value().bodies[0].is_static);
}

TEST_CASE("The word that was meant is found through one slip")
{
    const std::vector<std::string> words = {"radius", "restitution", "friction", "static", "spin"};
    CHECK(nearest_word("raduis", words) == "radius");
    CHECK(nearest_word("radiu", words) == "radius");
    CHECK(nearest_word("sspin", words) == "spin");
    CHECK(nearest_word("frictoin", words) == "friction");
    CHECK(nearest_word("bounciness", words).empty());
    CHECK(nearest_word("", words).empty());
    CHECK(nearest_word(std::string(100000, 'r'), words).empty());
}
