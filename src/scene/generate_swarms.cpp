// Generators of many bodies at random: balls, gas, polygons, pile.

#include <algorithm>
#include <cmath>
#include <utility>

#include "mass/polygon.hpp"
#include "math/number_text.hpp"
#include "math/sine_cosine.hpp"
#include "scene/generators.hpp"
#include "scene/place.hpp"
#include "scene/write.hpp"
#include "world/make_shape.hpp"

namespace flying {

namespace {

constexpr double k_pi = 3.141592653589793;

/// A shape to be placed.
struct Piece
{
    ShapeDef def;
    double radius = 1.0; ///< of the circle about the centre of mass that holds it [m]
    double area = 1.0;   ///< [m^2]
};

Expected<Piece> piece_of(const ShapeDef& def)
{
    const Expected<Shape> shape = make_shape(def);
    if (!shape) return shape.faults();
    return Piece{def, bounding_radius(shape.value()), mass_of(shape.value(), 1.0).mass};
}

/// The ring stretched so that the circle about its centre of mass gets this radius.
Expected<ShapeDef> stretched(std::vector<Vec2> ring, double radius)
{
    const Expected<Piece> piece = piece_of(PolygonDef{ring, {}});
    if (!piece) return piece.faults();
    const double factor = radius / piece.value().radius;
    for (Vec2& vertex : ring) vertex *= factor;
    return ShapeDef(PolygonDef{std::move(ring), {}});
}

/// Two squares joined by a bar, in a circle of this radius: the original program's dumbbell.
ShapeDef dumbbell(double radius)
{
    // Twenty of its pixels; its corners lie at 80, 40
    const double a = 0.25 * radius / std::sqrt(1.25);
    const double coordinates[12][2] = {{2, 1},   {2, 2},   {4, 2},   {4, -2}, {2, -2}, {2, -1},
                                       {-2, -1}, {-2, -2}, {-4, -2}, {-4, 2}, {-2, 2}, {-2, 1}};
    PolygonDef def;
    for (const auto& corner : coordinates) def.vertices.push_back(Vec2(a * corner[0], a * corner[1]));
    return def;
}

/// The shape of this name in a circle of this radius; polygons are regular.
ShapeDef equal_shape(Random& random, const std::string& shape, int min_sides, int max_sides, double radius)
{
    if (shape == "polygon") return RegularDef{min_sides + random.below(max_sides - min_sides + 1), radius};
    if (shape == "dumbbell") return dumbbell(radius);
    if (shape == "box") return SquareDef{radius * std::sqrt(2.0)};
    return DiscDef{radius};
}

/// A polygon with corners at random distances round a middle that sees all of them; often not convex.
Expected<ShapeDef> ragged_polygon(Random& random, int sides, double radius)
{
    // Corners stay within their own sector by a margin: no two meet, and no gap is half a turn
    std::vector<Vec2> ring;
    for (int k = 0; k < sides; ++k) {
        const double angle = 2.0 * k_pi * (k + random.uniform(-0.15, 0.15)) / sides;
        const double distance = random.uniform(0.5, 1.0);
        const SineCosine direction = sine_cosine(angle);
        ring.push_back(Vec2(distance * direction.cosine, distance * direction.sine));
    }
    return stretched(std::move(ring), radius);
}

/// A polygon of one of several sorts.
Expected<ShapeDef> any_polygon(Random& random, int min_sides, int max_sides, double radius)
{
    const int sides = min_sides + random.below(max_sides - min_sides + 1);
    const int sort = random.below(4);
    if (sort <= 1) return ShapeDef(RegularDef{sides, radius});
    if (sort == 2 && sides == 4) {
        const Vec2 half = Vec2(1.0, random.uniform(0.3, 1.0));
        const double factor = 2.0 * radius / std::sqrt(half.x() * half.x() + half.y() * half.y());
        return ShapeDef(RectangleDef{factor * half.x(), factor * half.y()});
    }
    return ragged_polygon(random, sides, radius);
}

/// Where the bodies go: the box asked for, or the one that the packing asks for.
/// unless  the kind's box where neither is asked for; none: packed to `packing`
BoxDef box_for(const GenerateOptions& options, const std::vector<Piece>& pieces, const std::optional<BoxDef>& unless,
               double packing)
{
    if (options.box) return *options.box;
    if (unless && !options.packing) return *unless;
    double area = 0.0;
    for (const Piece& piece : pieces) area += piece.area;
    const double side = std::sqrt(area / options.packing.value_or(packing));
    return BoxDef{Vec2::Zero(), Vec2(side, side)};
}

/// Velocities of `count` bodies as the options have them.
std::vector<Vec2> draw_velocities(Random& random, const GenerateOptions& options, int count, const Bounds& speeds,
                                  std::optional<double> rms_speed)
{
    if (options.speed) rms_speed.reset();
    if (options.rms_speed) rms_speed = options.rms_speed;
    std::vector<Vec2> velocities;
    if (!rms_speed) {
        const Bounds bounds = options.speed.value_or(speeds);
        for (int k = 0; k < count; ++k) {
            const Vec2 direction = random_direction(random);
            velocities.push_back(random.uniform(bounds.min, bounds.max) * direction);
        }
        return velocities;
    }

    // Draw both components from nearly the bell curve, then stretch all to the speed asked for
    double sum = 0.0;
    for (int k = 0; k < count; ++k) {
        const double x = random_normal(random);
        const double y = random_normal(random);
        velocities.push_back(Vec2(x, y));
        sum += x * x + y * y;
    }
    const double factor = sum > 0.0 ? *rms_speed * std::sqrt(count / sum) : 0.0;
    for (Vec2& velocity : velocities) velocity *= factor;
    return velocities;
}

Fault too_dense(const GenerateOptions& options, const BoxDef& box, const std::vector<Piece>& pieces)
{
    double area = 0.0;
    double widest = 0.0;
    for (const Piece& piece : pieces) {
        area += k_pi * piece.radius * piece.radius;
        widest = std::max(widest, piece.radius);
    }
    const Vec2 size = box.max - box.min;
    const std::string found = std::to_string(pieces.size()) + (pieces.size() == 1 ? " body" : " bodies") +
                              " in circles of up to " + rounded_text(widest, 4) + " m that take " +
                              rounded_text(area / (size.x() * size.y()), 4) + " of a box of " +
                              rounded_text(size.x(), 4) + " m x " + rounded_text(size.y(), 4) + " m";
    const char* place = options.packing ? "packing" : options.box ? "box" : "count";
    return {place, found, "room to place them apart: fewer or smaller bodies, a lower packing, or a larger box"};
}

/// Everything that the swarms have in common: a box, places, velocities.
Expected<Scene> swarm(Random& random, const GenerateOptions& options, Scene scene, const std::vector<Piece>& pieces,
                      const BoxDef& box, const std::vector<Vec2>& velocities, double max_spin)
{
    std::vector<double> radii;
    for (const Piece& piece : pieces) radii.push_back(piece.radius);
    const std::optional<std::vector<Vec2>> places = place_apart(random, box, radii);
    if (!places) return too_dense(options, box, pieces);

    scene.world.box = box;
    for (std::size_t k = 0; k < pieces.size(); ++k) {
        BodyDef& body = scene.bodies.emplace_back();
        const bool is_disc = std::holds_alternative<DiscDef>(pieces[k].def);
        body.shape = pieces[k].def;
        body.position = (*places)[k];
        body.velocity = velocities[k];
        body.angle = is_disc ? 0.0 : random.uniform(0.0, 2.0 * k_pi);
        body.spin = max_spin > 0.0 ? random.uniform(-max_spin, max_spin) : 0.0;
        body.density = options.density;
    }
    return scene;
}

/// The bounds on the number of sides, or what is wrong with them.
Expected<std::pair<int, int>> sides_of(const GenerateOptions& options, int min_sides, int max_sides)
{
    // An option that is given alone pushes the other's default along
    const int least = options.min_sides.value_or(std::min(min_sides, options.max_sides.value_or(min_sides)));
    const int most = options.max_sides.value_or(std::max(max_sides, least));
    if (least <= most) return std::pair(least, most);
    return Fault{"min_sides", std::to_string(least), "at most max_sides, " + std::to_string(most)};
}

double draw_radius(Random& random, const GenerateOptions& options, const Bounds& unless)
{
    const Bounds bounds = options.radius.value_or(unless);
    return random.uniform(bounds.min, bounds.max);
}

} // namespace

Field field_of(const Vec2& gravity)
{
    if (gravity == Vec2(0.0, 0.0)) return NoField{};
    return UniformField{gravity};
}

std::string counted(int count, const std::string& singular, const std::string& plural)
{
    return std::to_string(count) + " " + (count == 1 ? singular : plural);
}

Scene scene_from(const GenerateOptions& options, const Scene& defaults)
{
    Scene scene = defaults;
    scene.until = options.until.value_or(defaults.until);
    if (options.gravity) scene.world.field = field_of(*options.gravity);
    scene.world.restitution = options.restitution.value_or(defaults.world.restitution);
    scene.world.friction = options.friction.value_or(defaults.world.friction);
    return scene;
}

Expected<Scene> generate_balls(const GenerateOptions& options)
{
    Random random(options.seed);
    const int count = options.count.value_or(100);
    Scene defaults;
    defaults.title = counted(count, "ball", "balls");
    defaults.until = 20.0;
    defaults.world.field = UniformField{Vec2(0.0, -0.2)};

    std::vector<Piece> pieces;
    for (int k = 0; k < count; ++k) {
        const double radius = draw_radius(random, options, {0.1, 0.3});
        pieces.push_back({DiscDef{radius}, radius, k_pi * radius * radius});
    }
    const BoxDef box = box_for(options, pieces, BoxDef{Vec2::Zero(), Vec2(8.0, 8.0)}, 0.3);
    const std::vector<Vec2> velocities = draw_velocities(random, options, count, {0.5, 2.0}, std::nullopt);
    return swarm(random, options, scene_from(options, defaults), pieces, box, velocities,
                 options.max_spin.value_or(0.0));
}

Expected<Scene> generate_gas(const GenerateOptions& options)
{
    Random random(options.seed);
    const int count = options.count.value_or(1000);
    const std::string shape = options.shape.value_or("disc");
    const Expected<std::pair<int, int>> sides = sides_of(options, 3, 6);
    if (!sides) return sides.faults();
    if (shape != "polygon" && (options.min_sides || options.max_sides)) {
        return Fault{options.min_sides ? "min_sides" : "max_sides", "a gas of shape " + shape, "shape polygon"};
    }
    Scene defaults;
    defaults.title = "gas of " + counted(count, shape, shape + "s");
    defaults.until = 10.0;

    std::vector<Piece> pieces;
    for (int k = 0; k < count; ++k) {
        const double radius = draw_radius(random, options, {0.5, 0.5});
        const auto [least, most] = sides.value();
        Expected<Piece> piece = piece_of(equal_shape(random, shape, least, most, radius));
        if (!piece) return piece.faults();
        pieces.push_back(std::move(piece.value()));
    }
    const BoxDef box = box_for(options, pieces, std::nullopt, 0.1);
    const std::vector<Vec2> velocities = draw_velocities(random, options, count, {}, 5.0);
    return swarm(random, options, scene_from(options, defaults), pieces, box, velocities,
                 options.max_spin.value_or(0.0));
}

Expected<Scene> generate_polygons(const GenerateOptions& options)
{
    Random random(options.seed);
    const int count = options.count.value_or(40);
    const Expected<std::pair<int, int>> sides = sides_of(options, 3, 8);
    if (!sides) return sides.faults();
    Scene defaults;
    defaults.title = counted(count, "polygon", "polygons");
    defaults.until = 20.0;

    std::vector<Piece> pieces;
    for (int k = 0; k < count; ++k) {
        const double radius = draw_radius(random, options, {0.2, 0.5});
        const Expected<ShapeDef> def = any_polygon(random, sides.value().first, sides.value().second, radius);
        if (!def) return def.faults();
        Expected<Piece> piece = piece_of(def.value());
        if (!piece) return piece.faults();
        pieces.push_back(std::move(piece.value()));
    }
    const BoxDef box = box_for(options, pieces, BoxDef{Vec2::Zero(), Vec2(8.0, 8.0)}, 0.2);
    const std::vector<Vec2> velocities = draw_velocities(random, options, count, {0.5, 2.0}, std::nullopt);
    return swarm(random, options, scene_from(options, defaults), pieces, box, velocities,
                 options.max_spin.value_or(1.0));
}

Expected<Scene> generate_pile(const GenerateOptions& options)
{
    Random random(options.seed);
    const int count = options.count.value_or(100);
    const std::string shape = options.shape.value_or("box");
    const Expected<std::pair<int, int>> sides = sides_of(options, 3, 6);
    if (!sides) return sides.faults();
    if (shape != "polygon" && (options.min_sides || options.max_sides)) {
        return Fault{options.min_sides ? "min_sides" : "max_sides", "a pile of shape " + shape, "shape polygon"};
    }
    Scene defaults;
    defaults.title = "pile of " + counted(count, shape, shape == "box" ? "boxes" : shape + "s");
    defaults.until = 20.0;
    defaults.world.field = UniformField{Vec2(0.0, -9.81)};
    defaults.world.restitution = 0.2;
    defaults.world.friction = 0.5;

    std::vector<Piece> pieces;
    for (int k = 0; k < count; ++k) {
        const double radius = draw_radius(random, options, {0.3, 0.5});
        const auto [least, most] = sides.value();
        Expected<Piece> piece = piece_of(equal_shape(random, shape, least, most, radius));
        if (!piece) return piece.faults();
        pieces.push_back(std::move(piece.value()));
    }
    const BoxDef box = box_for(options, pieces, std::nullopt, 0.25);
    const std::vector<Vec2> velocities(pieces.size(), Vec2(0.0, 0.0));
    return swarm(random, options, scene_from(options, defaults), pieces, box, velocities, 0.0);
}

} // namespace flying
