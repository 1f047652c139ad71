#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "math/random.hpp"
#include "math/rotation.hpp"
#include "world/scene.hpp"

/// Scenes that people try on a simulator, each by its numbers. The same stand in chapters/scenes as texts.
namespace flying::gallery {

inline constexpr double k_g = 9.81; // [m/s^2]

inline Scene scene_in_gravity(const std::string& title, double until, double restitution, double friction)
{
    Scene scene;
    scene.title = title;
    scene.until = until;
    scene.world.field = UniformField{Vec2(0.0, -k_g)};
    scene.world.restitution = restitution;
    scene.world.friction = friction;
    return scene;
}

inline BodyDef block(double width, double height, const Vec2& position)
{
    BodyDef body;
    body.shape = RectangleDef{width, height};
    body.position = position;
    return body;
}

inline BodyDef fixed(BodyDef body)
{
    body.is_static = true;
    return body;
}

/// A polygon where its vertices are, which go round counter-clockwise.
inline BodyDef in_place(std::vector<Vec2> vertices)
{
    double area = 0.0; // twice
    Vec2 moment = Vec2::Zero();
    const Vec2 origin = vertices[0];
    for (std::size_t k = 0; k < vertices.size(); ++k) {
        const Vec2 p = vertices[k] - origin;
        const Vec2 q = vertices[(k + 1) % vertices.size()] - origin;
        area += cross(p, q);
        moment += cross(p, q) * (p + q);
    }
    BodyDef body;
    body.position = origin + moment / (3.0 * area);
    body.shape = PolygonDef{std::move(vertices), {}};
    return body;
}

/// Dominoes in a row, the first of which is tipped over.
struct Dominoes
{
    int count = 30;
    double height = 0.2;     ///< [m]
    double thickness = 0.03; ///< [m]
    double gap = 0.07;       ///< between one and the next [m]
    double friction = 0.3;
    double push = 4.0; ///< spin of the first about its foremost edge [rad/s]
};

inline Scene dominoes(const Dominoes& row)
{
    Scene scene = scene_in_gravity("dominoes", 3.0, 0.0, row.friction);
    const double pitch = row.thickness + row.gap;
    const double length = pitch * row.count + 4.0 * row.height;
    scene.bodies.push_back(fixed(block(length, row.height, {0.5 * length - 2.0 * row.height, -0.5 * row.height})));
    for (int k = 0; k < row.count; ++k)
        scene.bodies.push_back(block(row.thickness, row.height, {pitch * k, 0.5 * row.height}));
    BodyDef& first = scene.bodies[1];
    first.spin = -row.push;
    first.velocity = 0.5 * row.push * Vec2(row.height, row.thickness);
    return scene;
}

/// A half circle of wedges, without mortar.
struct Arch
{
    int stones = 15;
    double thickness = 0.115; ///< [mean radii], and the mean radius is 1 m
    double friction = 0.6;
};

inline Scene arch(const Arch& arch)
{
    Scene scene = scene_in_gravity("an arch without mortar", 6.0, 0.0, arch.friction);
    scene.bodies.push_back(fixed(block(4.0, 0.5, {0.0, -0.25})));
    const auto joint = [&](int k, double r) {
        const double angle = std::numbers::pi * k / arch.stones;
        if (k == 0 || k == arch.stones) return Vec2(k == 0 ? r : -r, 0.0); // the sine of pi is no zero
        return Vec2(r * std::cos(angle), r * std::sin(angle));
    };
    const double inside = 1.0 - 0.5 * arch.thickness;
    const double outside = 1.0 + 0.5 * arch.thickness;
    for (int k = 0; k < arch.stones; ++k)
        scene.bodies.push_back(in_place({joint(k, inside), joint(k, outside), joint(k + 1, outside), joint(k + 1, inside)}));
    return scene;
}

/// A house of cards: pairs of cards that lean on each other, a long card on each row of them, and one pair less on that.
/// The leaning ones are cut level at the foot and at the head, and upright where they meet.
struct Cards
{
    int levels = 3;
    double lean = 0.35; ///< of the cards from upright [rad]
    double friction = 0.4;
    double height = 1.0;     ///< of a level [m]
    double thickness = 0.02; ///< [m]
};

/// The left card of a pair: its foot stands at the origin, and the pair meets at the right end of its head.
inline std::vector<Vec2> left_card(const Cards& house)
{
    const double slope = std::tan(house.lean);
    const double foot = house.thickness / std::cos(house.lean);
    const double head = slope * house.height;
    const double middle = head + 0.5 * foot;
    return {{0.0, 0.0}, {foot, 0.0}, {middle, (middle - foot) / slope}, {middle, house.height}, {head, house.height}};
}

inline Scene cards(const Cards& house)
{
    Scene scene = scene_in_gravity("a house of cards", 6.0, 0.0, house.friction);
    const std::vector<Vec2> card = left_card(house);
    const double middle = card[3].x();
    const double pitch = 2.0 * middle + 2.0 * house.thickness; // of pairs
    scene.bodies.push_back(fixed(block(pitch * (house.levels + 2), 0.5, {0.0, -0.25})));
    double floor = 0.0;
    for (int pairs = house.levels; pairs > 0; --pairs) {
        for (int k = 0; k < pairs; ++k) {
            const double x = pitch * (k - 0.5 * (pairs - 1));
            for (const double hand : {1.0, -1.0}) {
                std::vector<Vec2> outline;
                for (const Vec2& v : card) outline.emplace_back(x + hand * (v.x() - middle), floor + v.y());
                if (hand < 0.0) std::reverse(outline.begin(), outline.end());
                scene.bodies.push_back(in_place(std::move(outline)));
            }
        }
        floor += house.height;
        if (pairs == 1) break;
        const double length = pitch * (pairs - 1) + 0.5 * house.height;
        scene.bodies.push_back(block(length, house.thickness, {0.0, floor + 0.5 * house.thickness}));
        floor += house.thickness;
    }
    return scene;
}

/// Discs and polygons in a funnel.
struct Hopper
{
    int count = 90;
    double opening = 0.9; ///< [m]
    double size = 0.09;   ///< radius of the largest; the smallest have two thirds of it [m]
    double friction = 0.3;
    bool polygons = true; ///< every other body
    std::uint64_t seed = 1;
};

inline Scene hopper(const Hopper& hopper)
{
    Scene scene = scene_in_gravity("a hopper", 5.0, 0.2, hopper.friction);
    const double edge = 0.5 * hopper.opening;
    scene.bodies.push_back(fixed(in_place({{edge, 0.0}, {2.0, 2.0 - edge}, {2.0, 2.2 - edge}, {edge, 0.2}})));
    scene.bodies.push_back(fixed(in_place({{-edge, 0.0}, {-edge, 0.2}, {-2.0, 2.2 - edge}, {-2.0, 2.0 - edge}})));
    Random random(hopper.seed);
    const double cell = 2.2 * hopper.size;
    const int columns = static_cast<int>(3.6 / cell);
    scene.world.box = BoxDef{{-2.0, -2.5}, {2.0, 2.8 + cell * (hopper.count / columns + 1)}};
    for (int k = 0; k < hopper.count; ++k) {
        const double radius = hopper.size * random.uniform(2.0 / 3.0, 1.0);
        BodyDef body;
        body.shape = DiscDef{radius};
        if (hopper.polygons && k % 2 == 1) body.shape = RegularDef{3 + random.below(5), radius};
        body.position = Vec2(cell * (k % columns - 0.5 * (columns - 1)), 2.6 + cell * (k / columns));
        body.position.x() += 0.04 * hopper.size * random.uniform(-1.0, 1.0);
        body.angle = random.uniform(0.0, 6.0);
        scene.bodies.push_back(body);
    }
    return scene;
}

/// Hooks that hang in each other, the first of them fixed: each is a square bracket, open to the left and to the right in
/// turn, whose upper bar lies on the lower one of the hook before.
struct Chain
{
    int links = 12;
    double friction = 0.3;
    double size = 0.4; ///< height of a hook [m]
    double bar = 0.05; ///< [m]
    double lean = 0.0; ///< of all from the vertical, as they are let go [rad]
};

/// hand  1 where the back of the hook lies to the right, -1 to the left
/// top   of its upper bar [m]
inline std::vector<Vec2> hook(const Chain& chain, double hand, double top)
{
    const double bar = chain.bar;
    const double low = top - chain.size;
    const double back = 0.35 * chain.size + 0.75 * bar; // its outer side, which stands out from the bars of the next
    const double end = -0.35 * chain.size + 0.75 * bar;
    std::vector<Vec2> vertices = {{end, low},       {back, low},       {back, top},       {end, top},
                                  {end, top - bar}, {back - bar, top - bar}, {back - bar, low + bar}, {end, low + bar}};
    if (hand < 0.0) {
        for (Vec2& v : vertices) v.x() = -v.x();
        std::reverse(vertices.begin(), vertices.end());
    }
    return vertices;
}

inline Scene chain(const Chain& chain)
{
    Scene scene = scene_in_gravity("a chain of hooks", 4.0, 0.0, chain.friction);
    const double pitch = chain.size - 2.0 * chain.bar; // the upper bar of each lies on the lower one of the last
    const Rotation lean = Rotation::of(chain.lean);
    for (int k = 0; k <= chain.links; ++k) {
        std::vector<Vec2> vertices = hook(chain, k % 2 == 0 ? 1.0 : -1.0, -pitch * k);
        for (Vec2& v : vertices) v = lean * v;
        BodyDef body = in_place(std::move(vertices));
        body.is_static = k == 0;
        scene.bodies.push_back(std::move(body));
    }
    return scene;
}

/// A see-saw on a flat top, at the limit of its balance.
struct Seesaw
{
    double top = 0.2;      ///< half the width of what it lies on [m]
    double left = 1.5;     ///< how far the left load is from the middle [m]
    double right = 1.8;    ///< the right one
    double beam = 10.0;    ///< masses [kg]
    double load = 20.0;    ///< the left one
    double heavier = -1e-6; ///< by which part the right load is heavier than the limit
};

/// The right load at which the beam is about to tip over the right edge of the top.  [kg]
inline double limit_of(const Seesaw& s)
{
    return (s.beam * s.top + s.load * (s.left + s.top)) / (s.right - s.top);
}

inline Scene seesaw(const Seesaw& s)
{
    Scene scene = scene_in_gravity("a see-saw at its limit", 4.0, 0.0, 0.5);
    scene.bodies.push_back(fixed(in_place({{-3.0 * s.top, -0.5}, {3.0 * s.top, -0.5}, {s.top, 0.0}, {-s.top, 0.0}})));
    BodyDef beam = block(2.0 * std::max(s.left, s.right) + 0.4, 0.1, {0.0, 0.05});
    beam.mass = s.beam;
    scene.bodies.push_back(beam);
    BodyDef load = block(0.3, 0.3, {-s.left, 0.25});
    load.mass = s.load;
    scene.bodies.push_back(load);
    load.position.x() = s.right;
    load.mass = limit_of(s) * (1.0 + s.heavier);
    scene.bodies.push_back(load);
    return scene;
}

/// A wall of bricks, every other row shifted by half a brick, and a ball that flies into it.
struct BrickWall
{
    int rows = 10;
    int columns = 6;
    double friction = 0.6;    ///< between bricks
    double floor = 0.6;       ///< of the floor; what two bodies have is the root of the product
    double restitution = 0.0;
    double mass = 50.0;       ///< of the ball; a brick has 8 kg [kg]
    double speed = 12.0;      ///< of the ball [m/s]
    double height = 0.55;     ///< at which it arrives, in heights of the wall
};

inline Scene brick_wall(const BrickWall& wall)
{
    Scene scene = scene_in_gravity("a wall hit by a ball", 1.0, wall.restitution, wall.friction);
    BodyDef ground = fixed(block(400.0, 1.0, {0.0, -0.5}));
    ground.friction = wall.floor;
    scene.bodies.push_back(ground);
    BodyDef brick;
    brick.density = 100.0;
    for (int row = 0; row < wall.rows; ++row) {
        const bool is_shifted = row % 2 == 1;
        for (int k = 0; k < wall.columns + (is_shifted ? 1 : 0); ++k) {
            const bool is_half = is_shifted && (k == 0 || k == wall.columns);
            double x = 0.4 * k + (is_shifted ? 0.0 : 0.2);
            if (is_half) x += k == 0 ? 0.1 : -0.1;
            brick.shape = RectangleDef{is_half ? 0.2 : 0.4, 0.2};
            brick.position = Vec2(x, 0.2 * row + 0.1);
            scene.bodies.push_back(brick);
        }
    }
    BodyDef ball;
    ball.shape = DiscDef{0.25};
    ball.mass = wall.mass;
    ball.position = Vec2(-2.0, std::max(0.3, 0.2 * wall.rows * wall.height));
    ball.velocity = Vec2(wall.speed, 0.0);
    scene.bodies.push_back(ball);
    return scene;
}

/// Shapes like an L, poured into a box.
struct Pour
{
    int count = 300;
    double arm = 0.24;       ///< length of the longer arm [m]
    double restitution = 0.1;
    double friction = 0.4;
    double width = 5.0; ///< of the box [m]
    std::uint64_t seed = 1;
};

inline Scene pour(const Pour& pour)
{
    Scene scene = scene_in_gravity("shapes like an L, poured out", 2.5, pour.restitution, pour.friction);
    const double arm = pour.arm;
    const double wide = arm / 3.0;
    const double cell = 1.35 * arm;
    const int columns = static_cast<int>((pour.width - 0.1) / cell);
    const int rows = (pour.count + columns - 1) / columns;
    scene.world.box = BoxDef{{0.0, 0.0}, {pour.width, cell * (rows + 2)}};
    Random random(pour.seed);
    for (int k = 0; k < pour.count; ++k) {
        BodyDef body;
        body.shape = PolygonDef{{{0.0, 0.0}, {0.8 * arm, 0.0}, {0.8 * arm, wide}, {wide, wide}, {wide, arm}, {0.0, arm}}, {}};
        body.position = Vec2(0.05 + cell * (k % columns + 0.5), cell * (k / columns + 0.6));
        body.angle = random.uniform(0.0, 2.0 * std::numbers::pi);
        body.velocity = Vec2(random.uniform(-1.0, 1.0), 0.0);
        body.spin = random.uniform(-3.0, 3.0);
        scene.bodies.push_back(body);
    }
    return scene;
}

} // namespace flying::gallery
