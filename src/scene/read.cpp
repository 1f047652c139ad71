#include "scene/read.hpp"

#include <algorithm>
#include <cmath>

#include "scene/fault.hpp"
#include "scene/table_reader.hpp"

namespace flying {

namespace {

/// More points than this in one dotted key are no scene, but a tower of tables that would take a stack to tear down.
constexpr int k_longest_dotted_key = 16;

/// Where the text first has a dotted key of too many parts, if it has. Strings and comments may hold any points. What
/// follows a fault of TOML may be misread here; the parser won't get that far.
std::optional<toml::source_position> endless_key(std::string_view text)
{
    toml::source_position at{1, 1};
    int points = 0;
    std::size_t k = text.starts_with("\xef\xbb\xbf") ? 3 : 0;
    const auto advance = [&](std::size_t count) {
        for (; count > 0 && k < text.size(); --count, ++k) {
            if (text[k] == '\n') {
                ++at.line;
                at.column = 0;
            }
            if ((static_cast<unsigned char>(text[k]) & 0xc0) != 0x80) ++at.column;
        }
    };
    const auto skip_string = [&](char quote) {
        const std::string three(3, quote);
        const bool many_lines = text.substr(k, 3) == three;
        advance(many_lines ? 3 : 1);
        while (k < text.size()) {
            if (quote == '"' && text[k] == '\\') {
                advance(2);
            } else if (many_lines ? text.substr(k, 3) == three : text[k] == quote) {
                advance(many_lines ? 3 : 1);

                // One or two quotation marks may stand right before the three that end a string of many lines
                for (int extra = 0; many_lines && extra < 2 && k < text.size() && text[k] == quote; ++extra) advance(1);
                return;
            } else if (!many_lines && text[k] == '\n') {
                return;
            } else {
                advance(1);
            }
        }
    };

    while (k < text.size()) {
        const char c = text[k];
        if (c == '"' || c == '\'') {
            skip_string(c);
            continue;
        }
        if (c == '#') {
            while (k < text.size() && text[k] != '\n') advance(1);
            continue;
        }
        if (c == '.' && ++points > k_longest_dotted_key) return at;
        if (c == ',' || c == '=' || c == '\n' || c == '[' || c == ']' || c == '{' || c == '}') points = 0;
        advance(1);
    }
    return std::nullopt;
}

/// What to call body number `index` in a message.
std::string label_of_body(const std::string& name, std::size_t index)
{
    return name.empty() ? "body " + std::to_string(index) : "body " + in_quotes(name);
}

ShapeDef read_shape(TableReader shape)
{
    constexpr const char* k_length = "a positive length [m]";
    const std::vector<std::string> kinds = {"disc", "rectangle", "square", "triangle", "regular", "polygon"};
    const std::string kind = shape.word("kind", kinds);

    ShapeDef def = DiscDef{};
    if (kind == "disc") {
        DiscDef disc;
        shape.number("radius", disc.radius, k_length, Need::required);
        def = disc;
    } else if (kind == "rectangle") {
        RectangleDef rectangle;
        shape.number("width", rectangle.width, k_length, Need::required);
        shape.number("height", rectangle.height, k_length, Need::required);
        def = rectangle;
    } else if (kind == "square") {
        SquareDef square;
        shape.number("side", square.side, k_length, Need::required);
        def = square;
    } else if (kind == "triangle") {
        TriangleDef triangle;
        Vec2 sides = Vec2::Ones();
        shape.vector("sides", sides, "two positive lengths [a, b] [m]", Need::required);
        shape.number("angle", triangle.angle, "an angle between 0 and pi [rad]", Need::required);
        triangle.sides[0] = sides.x();
        triangle.sides[1] = sides.y();
        def = triangle;
    } else if (kind == "regular") {
        RegularDef regular;
        shape.integer("sides", regular.sides, "a whole number of 3 or more", Need::required);
        shape.number("radius", regular.radius, k_length, Need::required);
        def = regular;
    } else if (kind == "polygon") {
        PolygonDef polygon;
        shape.points("vertices", polygon.vertices, "a list of points [[x, y], ...] [m]", Need::required);
        shape.rings("holes", polygon.holes, "a list of rings [[[x, y], ...], ...] [m]");
        def = polygon;
    }

    // Which keys a shape may have is known only where its kind is
    if (!kind.empty()) shape.refuse_unknown_keys();
    return def;
}

BodyDef read_body(FaultList& faults, const toml::table& table, std::size_t index)
{
    BodyDef def;
    if (const auto* name = table["name"].as_string()) def.name = name->get();
    TableReader body(faults, table, label_of_body(def.name, index), ", ");

    body.text("name", def.name, "a name between quotation marks");
    std::optional<TableReader> shape = body.table("shape", "a shape { kind = ... }", Need::required);
    if (shape) def.shape = read_shape(*shape);
    body.vector("position", def.position, "two numbers [x, y] [m]", Need::required);
    body.number("angle", def.angle, "a number [rad]", Need::optional);
    body.vector("velocity", def.velocity, "two numbers [x, y] [m/s]", Need::optional);
    body.number("spin", def.spin, "a number [rad/s]", Need::optional);
    body.flag("static", def.is_static);
    body.number("density", def.density, "a positive number [kg/m^2]");
    body.number("mass", def.mass, "a positive number [kg]");
    body.number("restitution", def.restitution, "a number, 0 ... 1");
    body.number("friction", def.friction, "a number of 0 or more");
    body.refuse_unknown_keys();
    return def;
}

Field read_field(TableReader& world)
{
    const char* expected = "\"none\", { kind = \"uniform\", gravity = [x, y] } or { kind = \"central\", centre = [x, y], "
                           "mu = m, radius = r }";
    const toml::node* node = world.find("field");
    if (!node) return NoField{};
    if (const auto* word = node->as_string()) {
        if (word->get() != "none") world.fault(*node, world.label_of("field"), expected);
        return NoField{};
    }
    std::optional<TableReader> field = world.table("field", expected, Need::required);
    if (!field) return NoField{};

    const std::string kind = field->word("kind", {"none", "uniform", "central"});
    if (kind.empty()) return NoField{};

    // Without its centre there is no core to compare bodies with
    CentralField central;
    if (kind == "central") {
        central.centre = Vec2::Constant(std::nan(""));
        field->vector("centre", central.centre, "two numbers [x, y] [m]", Need::required);
        field->number("mu", central.mu, "a positive number [m^3/s^2]", Need::required);
        field->number("radius", central.radius, "a number of 0 or more [m]", Need::optional);
    }
    UniformField uniform;
    if (kind == "uniform") {
        field->vector("gravity", uniform.gravity, "two numbers [x, y] [m/s^2]", Need::required);
    }
    field->refuse_unknown_keys();
    if (kind == "none") return NoField{};
    if (kind == "central") return central;
    return uniform;
}

WorldDef read_world(TableReader world)
{
    WorldDef def;
    def.field = read_field(world);
    world.number("restitution", def.restitution, "a number, 0 ... 1", Need::optional);
    world.number("friction", def.friction, "a number of 0 or more", Need::optional);
    std::optional<TableReader> box = world.table("box", "a table { min = [x, y], max = [x, y] } [m]", Need::optional);
    if (box) {
        // Without both corners there is no box to compare bodies with
        BoxDef corners{Vec2::Constant(std::nan("")), Vec2::Constant(std::nan(""))};
        box->vector("min", corners.min, "two numbers [x, y] [m]", Need::required);
        box->vector("max", corners.max, "two numbers [x, y] [m]", Need::required);
        box->refuse_unknown_keys();
        def.box = corners;
    }
    world.refuse_unknown_keys();
    return def;
}

/// A scene as far as it could be read.
struct Reading
{
    /// The faults that a part of it gave, by their numbers.
    struct Part
    {
        std::size_t first_fault = 0;
        std::size_t end = 0;
        [[nodiscard]] bool is_whole() const { return first_fault == end; }
    };
    Scene scene;
    Part world;
    std::vector<Part> bodies;
};

Reading read_all(FaultList& faults, const toml::table& root)
{
    Reading reading;
    TableReader top(faults, root, "");
    top.text("title", reading.scene.title, "a title between quotation marks");
    top.number("until", reading.scene.until, "a time of 0 or more [s]", Need::optional);

    reading.world.first_fault = faults.size();
    std::optional<TableReader> world = top.table("world", "a table", Need::optional);
    if (world) reading.scene.world = read_world(*world);
    reading.world.end = faults.size();

    const toml::node* bodies = top.find("body");
    const toml::array* list = bodies ? bodies->as_array() : nullptr;
    if (bodies && !list) top.fault(*bodies, "body", "a list of bodies, each under its own [[body]]");
    for (std::size_t k = 0; list && k < list->size(); ++k) {
        const std::size_t faults_before = faults.size();
        const toml::table* table = list->get(k)->as_table();
        if (!table) top.fault(*list->get(k), label_of_body("", k), "a table");
        reading.scene.bodies.push_back(table ? read_body(faults, *table, k) : BodyDef{});
        reading.bodies.push_back({faults_before, faults.size()});
    }
    top.refuse_unknown_keys();
    return reading;
}

/// A place in a scene, such as `body[3].shape.vertices[2]`, and where it stands in the text.
struct Located
{
    toml::source_position at{1, 1};
    std::string label;
    std::optional<std::size_t> body; ///< the number of the body that it is a part of
};

/// Follow a path through the tables and arrays as far as the text has it.
Located locate(const toml::table& root, const Scene& scene, const std::string& path)
{
    Located located;
    const toml::node* node = &root;
    located.at = root.source().begin;
    std::size_t k = 0;
    bool lost = false;
    while (k < path.size()) {
        const toml::node* next = nullptr;
        if (path[k] == '[') {
            const std::size_t end = std::min(path.find(']', k), path.size());
            std::size_t index = 0;
            for (std::size_t d = k + 1; d < end; ++d) index = 10 * index + static_cast<std::size_t>(path[d] - '0');
            if (const toml::array* array = node->as_array()) next = array->get(index);
            k = std::min(end + 1, path.size());
            if (located.label == "body" && index < scene.bodies.size()) {
                located.body = index;
                located.label = label_of_body(scene.bodies[index].name, index);
                if (k < path.size()) located.label += ", ";
            } else {
                located.label += "[" + std::to_string(index) + "]";
            }
        } else {
            if (path[k] == '.') ++k;
            const std::size_t end = std::min(path.find_first_of(".[", k), path.size());
            const std::string key = path.substr(k, end - k);
            if (const toml::table* table = node->as_table()) next = table->get(key);
            const bool joins = !located.label.empty() && !located.label.ends_with(", ");
            located.label += (joins ? "." : "") + key;
            k = end;
        }

        // Stay with the last part that the text has
        lost = lost || !next;
        if (!lost) {
            node = next;
            located.at = node->source().begin;
        }
    }
    return located;
}

/// Whether a fault of body k is one of what could not be read, or hangs on it.
bool hangs_on_lost(const FaultList& faults, const Reading& reading, std::size_t k, const std::string& label)
{
    const Reading::Part& part = reading.bodies[k];
    const std::string body = label_of_body(reading.scene.bodies[k].name, k);
    const auto is_lost = [&](const std::string& key) {
        return faults.is_lost(body + ", " + key, part.first_fault, part.end);
    };
    if (faults.is_lost(label, part.first_fault, part.end)) return true;

    // Which numbers a shape has is said by its kind; a ring makes sense as a whole; and a wall may not do what others may
    const std::string key = label.substr(std::min(body.size() + 2, label.size()));
    if (key.starts_with("shape")) return is_lost("shape.kind") || is_lost("shape.vertices") || is_lost("shape.holes");
    if (key.starts_with("velocity") || key == "spin") return is_lost("static");
    if (key == "mass" || key == "density") return is_lost("static") || is_lost("mass") || is_lost("shape");
    return false;
}

/// A body that was not read whole, judged by itself.
void check_alone(FaultList& faults, const toml::table& root, const Reading& reading, std::size_t k)
{
    Scene alone;
    alone.until = reading.scene.until;
    alone.bodies = {reading.scene.bodies[k]};
    const std::string place = "body[0]";
    for (Fault& fault : validate(alone)) {
        if (!fault.place.starts_with(place)) continue;
        const std::string path = "body[" + std::to_string(k) + "]" + fault.place.substr(place.size());
        const Located located = locate(root, reading.scene, path);
        if (hangs_on_lost(faults, reading, k, located.label)) continue;
        faults.add(located.at, located.label, std::move(fault.found), std::move(fault.expected));
    }
}

/// The world's own faults with the parts that could be read: nothing is reported of numbers that the file doesn't have.
void check(FaultList& faults, const toml::table& root, const Reading& reading)
{
    // What was not read whole may be elsewhere, or larger: it is in no other's way, and all others keep their numbers
    Scene whole = reading.scene;
    for (std::size_t k = 0; k < whole.bodies.size(); ++k) {
        if (reading.bodies[k].is_whole()) continue;
        const std::string name = whole.bodies[k].name;
        whole.bodies[k] = BodyDef{};
        whole.bodies[k].name = name;
        whole.bodies[k].shape = DiscDef{std::nan("")};
    }
    for (Fault& fault : validate(whole)) {
        const Located located = locate(root, reading.scene, fault.place);
        const bool is_stand_in = located.body && !reading.bodies[*located.body].is_whole();
        if (is_stand_in && !fault.place.ends_with(".name")) continue;
        if (faults.is_lost(located.label, reading.world.first_fault, reading.world.end)) continue;
        faults.add(located.at, located.label, std::move(fault.found), std::move(fault.expected));
    }
    for (std::size_t k = 0; k < reading.bodies.size(); ++k) {
        if (!reading.bodies[k].is_whole()) check_alone(faults, root, reading, k);
    }
}

} // namespace

Expected<Scene> read_scene_text(std::string_view text, const std::string& filename, SceneMender mend)
{
    if (text.size() > k_largest_scene) {
        return Fault{filename, "more than " + std::to_string(k_largest_scene) + " bytes", "a smaller scene"};
    }
    FaultList faults(filename);
    if (const std::optional<toml::source_position> at = endless_key(text)) {
        faults.add(*at, "", "a key of more than " + std::to_string(k_longest_dotted_key) + " parts",
                   "a key of a scene");
        return faults.in_order();
    }

    const toml::parse_result parsed = toml::parse(text);
    if (!parsed) {
        std::string told = on_one_line(parsed.error().description());
        if (told.ends_with("could not determine value type")) told += " (a word stands between quotation marks)";
        faults.add(parsed.error().source().begin, "", "this is no TOML: " + told, "");
        return faults.in_order();
    }

    Reading reading = read_all(faults, parsed.table());
    const bool is_whole = faults.size() == 0;
    check(faults, parsed.table(), reading);
    if (faults.size() > 0 && !(is_whole && mend && mend(reading.scene))) return faults.in_order();
    return std::move(reading.scene);
}

} // namespace flying
