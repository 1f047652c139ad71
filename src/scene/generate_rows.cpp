// Generators of few bodies, or of many in order: stack, pyramid, cradle, billiard.

#include <algorithm>
#include <cmath>

#include "scene/generators.hpp"
#include "scene/place.hpp"
#include "scene/write.hpp"

namespace flying {

namespace {

/// Scenes in which bodies stand: gravity, and friction that holds them.
Scene standing_scene(const std::string& title)
{
    Scene scene;
    scene.title = title;
    scene.until = 10.0;
    scene.world.field = UniformField{Vec2(0.0, -9.81)};
    scene.world.restitution = 0.0;
    scene.world.friction = 0.5;
    return scene;
}

BodyDef unit_box(double x, double y, const std::optional<double>& density)
{
    BodyDef body;
    body.shape = SquareDef{1.0};
    body.position = Vec2(x, y);
    body.density = density;
    return body;
}

/// Radius or speed where bodies have only one.
Expected<double> single(const char* name, const std::optional<Bounds>& bounds, double unless)
{
    if (!bounds) return unless;
    if (bounds->min == bounds->max) return bounds->min;
    return Fault{name, write_number(bounds->min) + " ... " + write_number(bounds->max), "one value: min = max"};
}

Expected<Scene> generate_pi_billiard(const GenerateOptions& options)
{
    Faults faults;
    if (options.radius) faults.push_back({"radius", "an option", "billiard rectangle, which has use for it"});
    if (options.box) faults.push_back({"box", "an option", "billiard rectangle, which has use for it"});
    const Expected<double> speed = single("speed", options.speed, 1.0);
    if (!speed) faults.insert(faults.end(), speed.faults().begin(), speed.faults().end());
    if (!faults.empty()) return faults;

    // Masses 1 and 100^k: collisions of the two and with the wall count the first k + 1 digits of pi
    const int exponent = options.exponent.value_or(2);
    double mass = 1.0;
    for (int k = 0; k < exponent; ++k) mass *= 100.0;

    // All lengths are powers of two or small sums of them, so that nothing is rounded before the first impact
    Scene scene;
    scene.title = "two balls and a wall that count the digits of pi, masses 1 and 100^" + std::to_string(exponent);
    scene.until = speed.value() > 0.0 ? options.until.value_or(8.0 / speed.value()) : options.until.value_or(8.0);
    BodyDef& wall = scene.bodies.emplace_back();
    wall.name = "wall";
    wall.shape = RectangleDef{0.5, 2.0};
    wall.position = Vec2(-0.25, 0.0);
    wall.is_static = true;

    BodyDef& light = scene.bodies.emplace_back();
    light.name = "light";
    light.shape = DiscDef{0.25};
    light.position = Vec2(1.0, 0.0);
    light.mass = 1.0;

    BodyDef& heavy = scene.bodies.emplace_back();
    heavy.name = "heavy";
    heavy.shape = DiscDef{0.5};
    heavy.position = Vec2(2.5, 0.0);
    heavy.velocity = Vec2(-speed.value(), 0.0);
    heavy.mass = mass;
    return scene;
}

Expected<Scene> generate_rectangle_billiard(const GenerateOptions& options)
{
    if (options.exponent) return Fault{"exponent", "an option", "billiard pi, which has use for it"};
    Random random(options.seed);
    const Bounds radii = options.radius.value_or(Bounds{0.25, 0.25});
    const Bounds speeds = options.speed.value_or(Bounds{1.0, 1.0});
    const double radius = random.uniform(radii.min, radii.max);
    const double speed = random.uniform(speeds.min, speeds.max);
    const Vec2 direction = random_direction(random);

    Scene scene;
    scene.title = "one ball in a box";
    scene.until = options.until.value_or(100.0);
    scene.world.box = options.box.value_or(BoxDef{Vec2(0.0, 0.0), Vec2(4.0, 3.0)});
    const std::optional<std::vector<Vec2>> places = place_apart(random, *scene.world.box, {radius});
    if (!places) return Fault{options.box ? "box" : "radius", "a ball wider than its box", "2 radius < width, height"};

    BodyDef& ball = scene.bodies.emplace_back();
    ball.name = "ball";
    ball.shape = DiscDef{radius};
    ball.position = places->front();
    ball.velocity = speed * direction;
    return scene;
}

} // namespace

Expected<Scene> generate_stack(const GenerateOptions& options)
{
    const int count = options.count.value_or(10);
    const double gap = options.gap.value_or(0.0);
    Scene scene = scene_from(options, standing_scene("stack of " + counted(count, "box", "boxes")));
    for (int k = 0; k < count; ++k) {
        scene.bodies.push_back(unit_box(0.0, 0.5 + k * (1.0 + gap), options.density));
    }
    const double height = count * (1.0 + gap);
    scene.world.box = BoxDef{Vec2(-0.5 * height - 2.0, 0.0), Vec2(0.5 * height + 2.0, height + 2.0)};

    // Make the top as heavy as asked for by its mass: all boxes keep their size
    if (options.mass_ratio) {
        BodyDef& top = scene.bodies.back();
        top.density.reset();
        top.mass = *options.mass_ratio * options.density.value_or(1.0);
    }
    return scene;
}

Expected<Scene> generate_pyramid(const GenerateOptions& options)
{
    const int base = options.count.value_or(10);
    const double gap = options.gap.value_or(0.125);
    if (gap >= 1.0) return Fault{"gap", write_number(gap), "less than the side of a box, 1 m"};
    Scene scene = scene_from(options, standing_scene("pyramid on " + counted(base, "box", "boxes")));
    const double pitch = 1.0 + gap;
    for (int row = 0; row < base; ++row) {
        const double start = -0.5 * pitch * (base - 1 - row);
        for (int k = 0; k < base - row; ++k) {
            scene.bodies.push_back(unit_box(start + k * pitch, 0.5 + row, options.density));
        }
    }
    const double half = 0.5 * pitch * base + 2.0;
    scene.world.box = BoxDef{Vec2(-half, 0.0), Vec2(half, base + 2.0)};
    return scene;
}

Expected<Scene> generate_cradle(const GenerateOptions& options)
{
    const Expected<double> radius = single("radius", options.radius, 0.25);
    const Expected<double> speed = single("speed", options.speed, 1.0);
    Faults faults;
    if (!radius) faults.insert(faults.end(), radius.faults().begin(), radius.faults().end());
    if (!speed) faults.insert(faults.end(), speed.faults().begin(), speed.faults().end());
    if (!faults.empty()) return faults;

    // The row stands about the origin; the first ball comes from the left, and both walls leave it that much room
    const int count = options.count.value_or(5);
    const double r = radius.value();
    const double gap = options.gap.value_or(r / 64.0);
    const double pitch = 2.0 * r + gap;
    const double run_up = 6.0 * r;

    Scene scene;
    scene.title = "cradle of " + counted(count, "ball", "balls");
    scene.until = options.until.value_or(20.0);
    scene.world.restitution = options.restitution.value_or(1.0);
    for (int k = 0; k < count; ++k) {
        BodyDef& body = scene.bodies.emplace_back();
        body.shape = DiscDef{r};
        const double x = (k - 0.5 * (count - 1)) * pitch;
        body.position = Vec2(k == 0 ? x - run_up : x, 0.0);
        body.density = options.density;
    }
    scene.bodies.front().velocity = Vec2(speed.value(), 0.0);
    const double half = 0.5 * (count - 1) * pitch + r + 2.0 * run_up;
    scene.world.box = BoxDef{Vec2(-half, -4.0 * r), Vec2(half, 4.0 * r)};
    return scene;
}

Expected<Scene> generate_billiard(const GenerateOptions& options)
{
    return options.billiard.value_or("pi") == "pi" ? generate_pi_billiard(options)
                                                   : generate_rectangle_billiard(options);
}

} // namespace flying
