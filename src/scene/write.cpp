#include "scene/write.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <string_view>

#include "math/number_text.hpp"

namespace flying {

namespace {

/// Lists of vertices longer than this go on in the next line.  [characters]
constexpr std::size_t k_line = 110;

std::string write_string(std::string_view text)
{
    constexpr char k_digits[] = "0123456789abcdef";
    std::string quoted = "\"";
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        if (c == '"' || c == '\\') {
            quoted += '\\';
            quoted += c;
        } else if (c == '\n') {
            quoted += "\\n";
        } else if (c == '\t') {
            quoted += "\\t";
        } else if (byte < 0x20 || byte == 0x7f) {
            quoted += "\\u00";
            quoted += k_digits[byte >> 4];
            quoted += k_digits[byte & 15];
        } else {
            quoted += c;
        }
    }
    return quoted + "\"";
}

std::string write_vector(const Vec2& a)
{
    const std::string x = write_number(a.x());
    const std::string y = write_number(a.y());
    return "[" + x + ", " + y + "]";
}

/// A list of points, over several lines where it is long. Between the brackets of an array TOML allows line ends, even
/// within an inline table.
std::string write_ring(const std::vector<Vec2>& ring, std::size_t column)
{
    std::string text = "[";
    for (std::size_t k = 0; k < ring.size(); ++k) {
        const std::string point = write_vector(ring[k]);
        const bool full = column + point.size() + 2 > k_line;
        if (k > 0) text += full ? ",\n    " : ", ";
        column = (k > 0 && full ? 4 : column) + point.size() + 2;
        text += point;
    }
    return text + "]";
}

struct ShapeWriter
{
    std::string operator()(const DiscDef& def) const { return "kind = \"disc\", radius = " + write_number(def.radius); }

    std::string operator()(const RectangleDef& def) const
    {
        return "kind = \"rectangle\", width = " + write_number(def.width) + ", height = " + write_number(def.height);
    }

    std::string operator()(const SquareDef& def) const { return "kind = \"square\", side = " + write_number(def.side); }

    std::string operator()(const TriangleDef& def) const
    {
        return "kind = \"triangle\", sides = " + write_vector(Vec2(def.sides[0], def.sides[1])) +
               ", angle = " + write_number(def.angle);
    }

    std::string operator()(const RegularDef& def) const
    {
        return "kind = \"regular\", sides = " + std::to_string(def.sides) + ", radius = " + write_number(def.radius);
    }

    std::string operator()(const PolygonDef& def) const
    {
        std::string text = "kind = \"polygon\", vertices = " + write_ring(def.vertices, 40);
        if (def.holes.empty()) return text;
        text += ", holes = [";
        for (std::size_t k = 0; k < def.holes.size(); ++k) {
            text += k == 0 ? "\n    " : ",\n    ";
            text += write_ring(def.holes[k], 6);
        }
        return text + "]";
    }
};

void write_line(std::string& text, const char* key, const std::string& value)
{
    text += key;
    text += " = ";
    text += value;
    text += '\n';
}

/// Left out only where reading gives the same bits: -0 is written.
void write_unless_zero(std::string& text, const char* key, double value)
{
    if (std::bit_cast<std::uint64_t>(value) != 0) write_line(text, key, write_number(value));
}

void write_if_given(std::string& text, const char* key, const std::optional<double>& value)
{
    if (value) write_line(text, key, write_number(*value));
}

[[nodiscard]] std::string write_field(const Field& field)
{
    if (const auto* uniform = std::get_if<UniformField>(&field)) {
        return "{ kind = \"uniform\", gravity = " + write_vector(uniform->gravity) + " }";
    }
    if (const auto* central = std::get_if<CentralField>(&field)) {
        const std::string centre = write_vector(central->centre);
        const std::string mu = write_number(central->mu);
        const std::string radius = write_number(central->radius);
        return "{ kind = \"central\", centre = " + centre + ", mu = " + mu + ", radius = " + radius + " }";
    }
    return "\"none\"";
}

void write_world(std::string& text, const WorldDef& world)
{
    text += "\n[world]\n";
    write_line(text, "field", write_field(world.field));
    write_line(text, "restitution", write_number(world.restitution));
    write_line(text, "friction", write_number(world.friction));
    if (world.box) {
        const std::string min = write_vector(world.box->min);
        const std::string max = write_vector(world.box->max);
        write_line(text, "box", "{ min = " + min + ", max = " + max + " }");
    }
}

void write_body(std::string& text, const BodyDef& body)
{
    text += "\n[[body]]\n";
    if (!body.name.empty()) write_line(text, "name", write_string(body.name));
    write_line(text, "shape", "{ " + std::visit(ShapeWriter{}, body.shape) + " }");
    write_line(text, "position", write_vector(body.position));
    write_unless_zero(text, "angle", body.angle);
    const bool moves =
        std::bit_cast<std::uint64_t>(body.velocity.x()) != 0 || std::bit_cast<std::uint64_t>(body.velocity.y()) != 0;
    if (moves) write_line(text, "velocity", write_vector(body.velocity));
    write_unless_zero(text, "spin", body.spin);
    if (body.is_static) write_line(text, "static", "true");
    write_if_given(text, "density", body.density);
    write_if_given(text, "mass", body.mass);
    write_if_given(text, "restitution", body.restitution);
    write_if_given(text, "friction", body.friction);
}

} // namespace

std::string write_number(double value)
{
    if (std::isnan(value)) return "nan";
    if (std::isinf(value)) return value > 0.0 ? "inf" : "-inf";

    // Numbers of everyday size without an exponent, the others as it is shorter
    const double size = std::abs(value);
    const bool plain = size == 0.0 || (size >= 1e-4 && size < 1e16);
    std::string text = plain ? plain_number_text(value) : number_text(value);

    // TOML tells a float from an integer by its point or exponent
    if (text.find_first_of(".e") == std::string::npos) text += ".0";
    return text;
}

std::string write_scene(const Scene& scene, const std::string& comment)
{
    std::string text;

    // Put the comment above everything, line by line
    for (std::size_t start = 0; start < comment.size();) {
        const std::size_t end = std::min(comment.find('\n', start), comment.size());
        const std::string line = comment.substr(start, end - start);
        text += line.empty() ? "#\n" : "# " + line + "\n";
        start = end + 1;
    }
    if (!comment.empty()) text += '\n';

    if (!scene.title.empty()) write_line(text, "title", write_string(scene.title));
    write_line(text, "until", write_number(scene.until));
    write_world(text, scene.world);
    for (const BodyDef& body : scene.bodies) write_body(text, body);
    return text;
}

} // namespace flying
