// Scenes as text: what is written is read back to the same bits, and every scene of the course is fit to run.

#include <doctest/doctest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>

#include "math/random.hpp"
#include "scene/fault.hpp"
#include "scene/read.hpp"
#include "scene/write.hpp"

using namespace flying;

namespace {

const std::filesystem::path k_scenes = std::filesystem::path(FLYING_SOURCE_DIR) / "chapters" / "scenes";

std::vector<std::filesystem::path> scene_files()
{
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(k_scenes)) {
        if (entry.path().extension() == ".toml") files.push_back(entry.path());
    }
    std::sort(files.begin(), files.end());
    return files;
}

std::string content(const std::filesystem::path& path)
{
    std::ifstream file(path, std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

bool same(double a, double b)
{
    return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}
bool same(const Vec2& a, const Vec2& b)
{
    return same(a.x(), b.x()) && same(a.y(), b.y());
}
bool same(const std::optional<double>& a, const std::optional<double>& b)
{
    return a.has_value() == b.has_value() && (!a || same(*a, *b));
}

bool same(const std::vector<Vec2>& a, const std::vector<Vec2>& b)
{
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const Vec2& p, const Vec2& q) { return same(p, q); });
}

bool same_shape(const ShapeDef& a, const ShapeDef& b)
{
    if (a.index() != b.index()) return false;
    if (const auto* disc = std::get_if<DiscDef>(&a)) return same(disc->radius, std::get<DiscDef>(b).radius);
    if (const auto* square = std::get_if<SquareDef>(&a)) return same(square->side, std::get<SquareDef>(b).side);
    if (const auto* rectangle = std::get_if<RectangleDef>(&a)) {
        const auto& other = std::get<RectangleDef>(b);
        return same(rectangle->width, other.width) && same(rectangle->height, other.height);
    }
    if (const auto* triangle = std::get_if<TriangleDef>(&a)) {
        const auto& other = std::get<TriangleDef>(b);
        return same(triangle->sides[0], other.sides[0]) && same(triangle->sides[1], other.sides[1]) &&
               same(triangle->angle, other.angle);
    }
    if (const auto* regular = std::get_if<RegularDef>(&a)) {
        const auto& other = std::get<RegularDef>(b);
        return regular->sides == other.sides && same(regular->radius, other.radius);
    }
    const auto& polygon = std::get<PolygonDef>(a);
    const auto& other = std::get<PolygonDef>(b);
    return same(polygon.vertices, other.vertices) &&
           std::equal(polygon.holes.begin(), polygon.holes.end(), other.holes.begin(), other.holes.end(),
                      [](const auto& p, const auto& q) { return same(p, q); });
}

bool same_body(const BodyDef& a, const BodyDef& b)
{
    return a.name == b.name && same_shape(a.shape, b.shape) && same(a.position, b.position) && same(a.angle, b.angle) &&
           same(a.velocity, b.velocity) && same(a.spin, b.spin) && a.is_static == b.is_static &&
           same(a.density, b.density) && same(a.mass, b.mass) && same(a.restitution, b.restitution) &&
           same(a.friction, b.friction);
}

bool same_scene(const Scene& a, const Scene& b)
{
    const bool same_field = a.world.field.index() == b.world.field.index() &&
                            same(uniform_acceleration(a.world.field), uniform_acceleration(b.world.field));
    const bool same_box =
        a.world.box.has_value() == b.world.box.has_value() &&
        (!a.world.box || (same(a.world.box->min, b.world.box->min) && same(a.world.box->max, b.world.box->max)));
    return a.title == b.title && same(a.until, b.until) && same_field && same_box &&
           same(a.world.restitution, b.world.restitution) && same(a.world.friction, b.world.friction) &&
           std::equal(a.bodies.begin(), a.bodies.end(), b.bodies.begin(), b.bodies.end(), same_body);
}

/// A valid scene with every sort of shape and key, numbers of all sizes with all their bits.
Scene random_file_scene(Random& random)
{
    const auto number = [&] {
        const double mantissa = random.uniform(-1.0, 1.0);
        const int power = random.below(40) - 20;
        return std::ldexp(mantissa, power);
    };
    const auto point = [&] {
        const double x = number();
        const double y = number();
        return Vec2(x, y);
    };
    const auto size = [&] { return std::abs(number()) + 0x1p-30; };
    const auto choice = [&](double value) { return random.below(2) == 0 ? std::optional(value) : std::nullopt; };

    Scene scene;
    if (random.below(4) > 0) scene.title = "a \"title\" \\ with\ttabs,\nlines, \x01 and \u00e9\u4e2d\U0001f600";
    scene.until = size();
    if (random.below(2) == 0) scene.world.field = UniformField{point()};
    scene.world.restitution = random.uniform();
    scene.world.friction = size();
    if (random.below(4) == 0) scene.world.box = BoxDef{Vec2(-0x1p60, -0x1p60), Vec2(0x1p60, 0x1.8p60)};
    for (int k = 0; k < 6; ++k) {
        BodyDef& body = scene.bodies.emplace_back();
        if (random.below(2) == 0) body.name = "body no. " + std::to_string(k);
        const Vec2 at = point();
        const double s = 1.0 + random.uniform();
        switch (k) {
        case 0:
            body.shape = DiscDef{size()};
            break;
        case 1:
            body.shape = RectangleDef{size(), 1.0};
            break;
        case 2:
            body.shape = SquareDef{size()};
            break;
        case 3:
            body.shape = TriangleDef{{s, 2.0 * s}, random.uniform(0.5, 2.5)};
            break;
        case 4:
            body.shape = RegularDef{3 + random.below(9), size()};
            break;
        default:
            body.shape = PolygonDef{{at, at + Vec2(8.0 * s, 0.0), at + Vec2(8.0 * s, 7.0 * s), at + Vec2(0.0, 8.0 * s)},
                                    {{at + Vec2(s, s), at + Vec2(2.0 * s, s), at + Vec2(s, 2.0 * s)},
                                     {at + Vec2(4.0 * s, s), at + Vec2(5.0 * s, s), at + Vec2(4.0 * s, 2.0 * s)}}};
        }

        // Far enough apart for shapes of 2^20 m
        body.position = Vec2(0x1p24 * (k + random.uniform(0.0, 0.5)), number());
        body.angle = random.below(2) == 0 ? number() : (random.below(2) == 0 ? -0.0 : 0.0);
        body.is_static = random.below(3) == 0;
        if (!body.is_static) {
            body.velocity = random.below(2) == 0 ? point() : Vec2(-0.0, 0.0);
            body.spin = number();
            (random.below(2) == 0 ? body.mass : body.density) = choice(size());
        }
        body.restitution = choice(random.uniform());
        body.friction = choice(size());
    }
    return scene;
}

} // namespace

TEST_CASE("A scene that is written and read again is the same to the bit")
{
    Random random(20240601);
    for (int round = 0; round < 300; ++round) {
        const Scene scene = random_file_scene(random);
        const std::string text = write_scene(scene, "a comment\n\nof three lines");
        const Expected<Scene> again = read_scene_text(text, "scene.toml");
        INFO(text);
        INFO((again ? std::string() : format_faults(again.faults())));
        REQUIRE(again);
        CHECK(same_scene(scene, again.value()));
        CHECK(write_scene(again.value(), "a comment\n\nof three lines") == text);
    }
}

TEST_CASE("A number is written in the fewest digits that read back to the same bits, as TOML wants it")
{
    CHECK(write_number(1.0) == "1.0");
    CHECK(write_number(-0.0) == "-0.0");
    CHECK(write_number(0.1) == "0.1");
    CHECK(write_number(1e6) == "1000000.0");
    CHECK(write_number(1e300) == "1e+300");
    CHECK(write_number(-1e-7) == "-1e-07");
    CHECK(write_number(std::numeric_limits<double>::infinity()) == "inf");
    CHECK(write_number(std::numeric_limits<double>::quiet_NaN()) == "nan");

    Random random(7);
    for (int k = 0; k < 20000; ++k) {
        const double value = std::bit_cast<double>(random.bits());
        if (!std::isfinite(value)) continue;
        const std::string text = write_number(value);
        CHECK_MESSAGE(same(std::strtod(text.c_str(), nullptr), value), text);
    }
}

TEST_CASE("Every scene of the course is read without fault, and survives being written")
{
    const std::vector<std::filesystem::path> files = scene_files();
    CHECK(files.size() >= 10);
    for (const std::filesystem::path& file : files) {
        INFO(file.string());
        const Expected<Scene> scene = read_scene_file(file.string());
        INFO((scene ? std::string() : format_faults(scene.faults())));
        REQUIRE(scene);
        CHECK(!scene.value().title.empty());
        CHECK(content(file).starts_with("# "));
        const Expected<Scene> again = read_scene_text(write_scene(scene.value()), "again");
        REQUIRE(again);
        CHECK(same_scene(scene.value(), again.value()));
    }
}

TEST_CASE("The original's wedges stand flat at floor and ceiling with their right angles inwards")
{
    // Legs of 2 m: the long side lies sqrt(2)/3 m from the centroid, the right angle 2 sqrt(2)/3 m on the other side;
    // the original's height of 800/17 pixels is 0.8 mm less than the former
    const Expected<Scene> scene = read_scene_file((k_scenes / "original-polygons.toml").string());
    REQUIRE(scene);
    for (int k = 0; k < 2; ++k) {
        const BodyDef& wedge = scene.value().bodies[static_cast<std::size_t>(k)];
        REQUIRE(wedge.is_static);
        const double c = std::cos(wedge.angle);
        const double s = std::sin(wedge.angle);
        const Vec2 corners[3] = {Vec2(-2.0 / 3.0, -2.0 / 3.0), Vec2(4.0 / 3.0, -2.0 / 3.0),
                                 Vec2(-2.0 / 3.0, 4.0 / 3.0)};
        Vec2 placed[3];
        for (int i = 0; i < 3; ++i) {
            placed[i] =
                wedge.position + Vec2(c * corners[i].x() - s * corners[i].y(), s * corners[i].x() + c * corners[i].y());
        }
        const double wall = k == 0 ? 8.0 : 0.0;
        const double inwards = k == 0 ? -1.0 : 1.0;
        CHECK(placed[0].x() == doctest::Approx(4.0));
        CHECK(placed[0].y() == doctest::Approx(wall + inwards * (8.0 / 17.0 + 2.0 * std::sqrt(2.0) / 3.0)));
        CHECK(placed[1].y() == doctest::Approx(wall + inwards * (8.0 / 17.0 - std::sqrt(2.0) / 3.0)));
        CHECK(placed[1].y() == doctest::Approx(placed[2].y()));
        CHECK(std::abs(placed[1].y() - wall) < 1e-3);
    }
}

TEST_CASE("Files that are no scenes say why")
{
    const auto reason = [](const std::string& path) {
        const Expected<Scene> scene = read_scene_file(path);
        return scene ? std::string() : format_faults(scene.faults());
    };
    const std::filesystem::path folder = std::filesystem::temp_directory_path() / "flying_scene_test";
    std::filesystem::create_directories(folder);
    const std::string missing = (folder / "no such scene.toml").string();
    CHECK(reason(missing) == missing + ": found no such file, expected a scene file\n");
    CHECK(reason(folder.string()) == folder.string() + ": found a directory, expected a scene file\n");
    if (std::filesystem::exists("/dev/zero"))
        CHECK(reason("/dev/zero").find("expected a smaller scene") != std::string::npos);

    const std::string bad = (folder / "bad.toml").string();
    std::ofstream(bad) << "until = \n";
    CHECK(reason(bad).starts_with(bad + ":1:9: this is no TOML: "));
    std::filesystem::remove_all(folder);
}

TEST_CASE("Bytes changed at random in scenes neither crash the reader nor hang it")
{
    // Thousands of texts near to scenes: flipped bits, cut, doubled and moved pieces, and characters that mean
    // something
    std::vector<std::string> seeds;
    for (const std::filesystem::path& file : scene_files()) seeds.push_back(content(file).substr(0, 3000));
    const std::string meaningful = "[]{}=.,\"'#\\\n\t 0123456789eE+-_infatrue\x80\xff\xc3";
    Random random(99);
    int refused = 0;
    for (int round = 0; round < 4000; ++round) {
        std::string text = seeds[static_cast<std::size_t>(random.below(static_cast<int>(seeds.size())))];
        const int changes = 1 + random.below(8);
        for (int k = 0; k < changes && !text.empty(); ++k) {
            const auto at = static_cast<std::size_t>(random.below(static_cast<int>(text.size())));
            const auto length = static_cast<std::size_t>(random.below(60));
            const int way = random.below(5);
            if (way == 0) text[at] = static_cast<char>(text[at] ^ (1 << random.below(8)));
            if (way == 1) text.erase(at, length);
            if (way == 2) text.insert(at, text.substr(at, length));
            if (way == 3)
                text.insert(at, 1 + length / 8,
                            meaningful[static_cast<std::size_t>(random.below(static_cast<int>(meaningful.size())))]);
            if (way == 4)
                text.insert(static_cast<std::size_t>(random.below(static_cast<int>(text.size()))),
                            text.substr(at, length));
        }
        const Expected<Scene> scene = read_scene_text(text, "scene.toml");
        if (!scene) {
            ++refused;
            CHECK(!scene.faults().empty());
        }
    }
    CHECK(refused > 1000);
}

TEST_CASE("Towers of tables and arrays are refused before they are built")
{
    const auto repeated = [](const std::string& piece, int count) {
        std::string text;
        for (int k = 0; k < count; ++k) text += piece;
        return text;
    };
    CHECK(!read_scene_text(repeated("a.", 300000) + "a = 1", "t"));
    CHECK(!read_scene_text("[" + repeated("a.", 300000) + "a]", "t"));
    CHECK(!read_scene_text("[" + repeated("'a' . ", 300000) + "a]", "t"));
    CHECK(!read_scene_text("a = " + repeated("[", 300000), "t"));
    CHECK(!read_scene_text("a = " + repeated("{a = ", 300000), "t"));
    CHECK(!read_scene_text("a = " + repeated("{a.a.a.a.a.a.a.a.a = ", 300000), "t"));
    CHECK(!read_scene_text(repeated("\"", 300001), "t"));
    CHECK(!read_scene_text(repeated("[[body]]\n", 20000), "t"));
}
