// What is wrong with a scene, all of it, before anything is built.

#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <optional>
#include <utility>

#include "geometry/moments.hpp"
#include "math/number_text.hpp"
#include "math/rotation.hpp"
#include "world/checks.hpp"
#include "world/make_shape.hpp"
#include "world/scene.hpp"
#include "world/start_overlaps.hpp"

namespace flying {

namespace {

/// Overlapping pairs that are listed one by one.
constexpr std::size_t k_most_overlaps = 1000;

std::string body_place(int index)
{
    return "body[" + std::to_string(index) + "]";
}

/// The world's own numbers.
void check_world(const WorldDef& world, Faults& faults)
{
    Checks checks(faults, "world.");
    if (const auto* uniform = std::get_if<UniformField>(&world.field)) {
        checks.vector("field.gravity", uniform->gravity, "acceleration in m/s^2");
    }
    if (const auto* central = std::get_if<CentralField>(&world.field)) {
        checks.vector("field.centre", central->centre, "coordinate in m");
        checks.positive("field.mu", central->mu, "strength in m^3/s^2");
        checks.not_negative("field.radius", central->radius, "length in m");
    }
    checks.fraction("restitution", world.restitution, "coefficient of restitution");
    checks.not_negative("friction", world.friction, "coefficient of friction");
    if (!world.box) return;

    const bool min_fits = checks.vector("box.min", world.box->min, "coordinate in m");
    const bool max_fits = checks.vector("box.max", world.box->max, "coordinate in m");
    if (!min_fits || !max_fits) return;
    for (int k = 0; k < 2; ++k) {
        if (world.box->min[k] < world.box->max[k]) continue;
        const std::string side = "[" + std::to_string(k) + "]";
        checks.fault("box.max" + side, number_text(world.box->max[k]),
                     "more than box.min" + side + ", which is " + number_text(world.box->min[k]));
    }
}

/// Area of a shape that `make_shape` made.  [m^2]
double area_of(const Shape& shape)
{
    if (const auto* disc = std::get_if<Disc>(&shape)) return std::numbers::pi * disc->radius * disc->radius;
    if (const auto* polygon = std::get_if<Polygon>(&shape)) return moments_of(*polygon).area;
    return 0.0;
}

/// What a body weighs, and that a static one doesn't.
///
/// shape  null where the definition makes none
void check_mass(const BodyDef& body, const Shape* shape, Checks& checks)
{
    if (body.is_static) {
        if (body.mass && *body.mass != 0.0) {
            checks.fault("mass", number_text(*body.mass), "no mass: the body is static");
        }
        if (body.density) checks.positive("density", *body.density, "density in kg/m^2");
        return;
    }
    const bool mass_fits = !body.mass || checks.positive("mass", *body.mass, "mass in kg");
    const bool density_fits = !body.density || checks.positive("density", *body.density, "density in kg/m^2");
    if (body.mass && body.density) checks.fault("density", "a density and a mass", "only one of the two");
    if (!mass_fits || !density_fits || body.mass || !shape) return;

    // A density that is in range can still give a mass that is not
    const double density = body.density.value_or(1.0);
    const double mass = density * area_of(*shape);
    if (mass >= k_least_number && mass <= k_greatest_number) return;
    checks.fault("density", number_text(density) + ", which makes a mass of " + rounded_text(mass) + " kg",
                 "a mass of " + number_text(k_least_number) + " to " + number_text(k_greatest_number) + " kg");
}

/// One body by itself. Returns it placed in the world where its shape, position and angle are sound.
std::optional<PlacedBody> check_body(const Scene& scene, int index, Faults& faults)
{
    const BodyDef& body = scene.bodies[index];
    Checks checks(faults, body_place(index) + ".");
    const Expected<Shape> shape = make_shape(body.shape);
    if (!shape) {
        for (const Fault& fault : shape.faults()) {
            checks.fault(fault.place.empty() ? "shape" : "shape." + fault.place, fault.found, fault.expected);
        }
    }
    const bool position_fits = checks.vector("position", body.position, "coordinate in m");
    const bool angle_fits = checks.angle("angle", body.angle);

    const bool velocity_fits = checks.vector("velocity", body.velocity, "speed in m/s");
    const bool spin_fits = checks.any("spin", body.spin, "spin in rad/s");
    if (body.is_static && velocity_fits && body.velocity != Vec2::Zero()) {
        checks.fault("velocity", "[" + number_text(body.velocity.x()) + ", " + number_text(body.velocity.y()) + "]",
                     "no velocity: the body is static");
    }
    if (body.is_static && spin_fits && body.spin != 0.0) {
        checks.fault("spin", number_text(body.spin), "no spin: the body is static");
    }

    if (spin_fits && !body.is_static && std::abs(body.spin) * scene.until > k_greatest_angle) {
        checks.fault("spin", number_text(body.spin) + " rad/s for " + number_text(scene.until) + " s",
                     "an angle that stays below " + number_text(k_greatest_angle) + " rad until the end of the run");
    }

    check_mass(body, shape ? &shape.value() : nullptr, checks);
    if (body.restitution) checks.fraction("restitution", *body.restitution, "coefficient of restitution");
    if (body.friction) checks.not_negative("friction", *body.friction, "coefficient of friction");

    if (!shape || !position_fits || !angle_fits) return std::nullopt;
    PlacedBody placed;
    placed.index = index;
    placed.is_static = body.is_static;
    placed.pose = {body.position, Rotation::of(body.angle)};
    placed.size = bounding_radius(shape.value());
    placed.box = bounding_box(shape.value(), placed.pose);
    placed.shape = make_collision_shape(shape.value());
    return placed;
}

/// Names are there to tell bodies apart.
void check_names(const Scene& scene, Faults& faults)
{
    std::map<std::string, int> first_of_name;
    for (int k = 0; k < static_cast<int>(scene.bodies.size()); ++k) {
        const std::string& name = scene.bodies[k].name;
        if (name.empty()) continue;
        const auto [entry, is_new] = first_of_name.try_emplace(name, k);
        if (is_new) continue;
        faults.push_back({body_place(k) + ".name",
                          '"' + name + "\", as body " + std::to_string(entry->second) + " is called",
                          "a name of its own"});
    }
}

/// Bodies that move start inside the box.
void check_inside_box(const Scene& scene, const std::vector<PlacedBody>& bodies, Faults& faults)
{
    if (!scene.world.box) return;
    const Vec2& min = scene.world.box->min;
    const Vec2& max = scene.world.box->max;
    if (!(min.x() < max.x() && min.y() < max.y() && is_finite(min) && is_finite(max))) return;

    const std::pair<const char*, HalfPlane> walls[] = {
        {"left", {Vec2(1.0, 0.0), min.x()}},
        {"right", {Vec2(-1.0, 0.0), -max.x()}},
        {"lower", {Vec2(0.0, 1.0), min.y()}},
        {"upper", {Vec2(0.0, -1.0), -max.y()}},
    };
    for (const PlacedBody& body : bodies) {
        if (body.is_static) continue;
        for (const auto& [side, wall] : walls) {
            CollisionShape wall_shape;
            wall_shape.parts.push_back({wall, Vec2::Zero(), std::numeric_limits<double>::infinity()});
            const double depth = -separation(wall_shape, Pose(), body.shape, body.pose);
            const double reach = body.pose.position.norm() + body.size + std::abs(wall.offset);
            if (depth <= start_overlap_allowed(body.size, reach)) continue;
            faults.push_back({body_place(body.index) + ".position",
                              quoted_label(scene, body.index) + " reaches through the " + side +
                                  " side of the box by " + rounded_text(depth) + " m",
                              "a body inside the box"});
        }
    }
}

/// Bodies that move start off the centre of a central field, where its pull has no end, and outside its core.
void check_outside_core(const Scene& scene, const std::vector<PlacedBody>& bodies, Faults& faults)
{
    const auto* central = std::get_if<CentralField>(&scene.world.field);
    if (!central || !is_finite(central->centre) || !(central->radius >= 0.0)) return;
    const CollisionShape core = make_collision_shape(Shape(Disc{central->radius}));
    const Pose core_pose{central->centre, Rotation()};
    for (const PlacedBody& body : bodies) {
        if (body.is_static) continue;
        if (body.pose.position == central->centre) {
            faults.push_back({body_place(body.index) + ".position",
                              quoted_label(scene, body.index) + " stands at the centre of the field",
                              "a place away from the centre"});
        } else if (central->radius > 0.0) {
            const double depth = -separation(core, core_pose, body.shape, body.pose);
            const double reach = body.pose.position.norm() + body.size + central->centre.norm() + central->radius;
            if (depth <= start_overlap_allowed(std::min(body.size, central->radius), reach)) continue;
            faults.push_back({body_place(body.index) + ".position",
                              quoted_label(scene, body.index) + " reaches into the core by " + rounded_text(depth) + " m",
                              "a body outside the core"});
        }
    }
}

/// Bodies may touch at the start, but not overlap.
void check_overlaps(const Scene& scene, const std::vector<PlacedBody>& bodies, Faults& faults)
{
    const std::vector<StartOverlap> overlaps = find_start_overlaps(bodies, k_most_overlaps);
    for (const StartOverlap& pair : overlaps) {
        faults.push_back({body_place(pair.second) + ".position",
                          quoted_label(scene, pair.second) + " overlaps " + quoted_label(scene, pair.first) + " by " +
                              rounded_text(pair.depth) + " m",
                          "bodies that at most touch"});
    }
    if (overlaps.size() < k_most_overlaps) return;
    faults.push_back({"body", "at least " + std::to_string(k_most_overlaps) + " pairs of bodies that overlap",
                      "bodies that at most touch; further pairs are not listed"});
}

} // namespace

std::string body_label(const Scene& scene, int index)
{
    const std::string& name = scene.bodies[index].name;
    return name.empty() ? "body " + std::to_string(index) : name;
}

std::string quoted_label(const Scene& scene, int index)
{
    const int walls_start = static_cast<int>(scene.bodies.size());
    if (index >= walls_start + (scene.world.box ? 4 : 0)) return "the core";
    if (index >= walls_start) {
        constexpr std::array<const char*, 4> k_walls = {"the left wall", "the right wall", "the floor", "the ceiling"};
        return k_walls[static_cast<std::size_t>(index - walls_start)];
    }
    const std::string& name = scene.bodies[index].name;
    return name.empty() ? body_label(scene, index) : '"' + name + '"';
}

Faults validate(const Scene& scene)
{
    Faults faults;
    Checks(faults).not_negative("until", scene.until, "time in s");
    check_world(scene.world, faults);
    check_names(scene, faults);

    std::vector<PlacedBody> placed;
    for (int k = 0; k < static_cast<int>(scene.bodies.size()); ++k) {
        std::optional<PlacedBody> body = check_body(scene, k, faults);
        if (body) placed.push_back(std::move(*body));
    }

    check_inside_box(scene, placed, faults);
    check_outside_core(scene, placed, faults);
    check_overlaps(scene, placed, faults);
    return faults;
}

} // namespace flying
