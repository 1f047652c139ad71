#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "math/expected.hpp"
#include "math/vec2.hpp"
#include "motion/field.hpp"

namespace flying {

struct DiscDef
{
    double radius = 1.0; ///< positive [m]
};

struct RectangleDef
{
    double width = 1.0;  ///< along x, positive [m]
    double height = 1.0; ///< along y, positive [m]
};

struct SquareDef
{
    double side = 1.0; ///< positive [m]
};

/// Two sides and the angle between them; the first side lies along x.
struct TriangleDef
{
    double sides[2] = {1.0, 1.0}; ///< positive [m]
    double angle = 1.0;           ///< between the sides, in (0, pi) [rad]
};

/// Regular polygon; one vertex lies on the positive x axis.
struct RegularDef
{
    int sides = 3;       ///< >= 3
    double radius = 1.0; ///< of the circle through the vertices, positive [m]
};

/// Any simple polygon, given anywhere: it is recentred.
struct PolygonDef
{
    std::vector<Vec2> vertices;           ///< either way round [m]
    std::vector<std::vector<Vec2>> holes; ///< either way round [m]
};

using ShapeDef = std::variant<DiscDef, RectangleDef, SquareDef, TriangleDef, RegularDef, PolygonDef>;

struct BodyDef
{
    std::string name;
    ShapeDef shape = DiscDef{};
    Vec2 position = Vec2::Zero(); ///< of the centre of mass [m]
    double angle = 0.0;           ///< [rad]
    Vec2 velocity = Vec2::Zero(); ///< [m/s]
    double spin = 0.0;            ///< [rad/s]
    bool is_static = false;       ///< never moves; its velocity, spin and mass must be absent or zero
    std::optional<double> density;     ///< positive; 1 where neither density nor mass is given [kg/m^2]
    std::optional<double> mass;        ///< positive; at most one of density and mass [kg]
    std::optional<double> restitution; ///< 0 ... 1; the world's where absent
    std::optional<double> friction;    ///< >= 0; the world's where absent
};

struct BoxDef
{
    Vec2 min = Vec2::Zero(); ///< [m]
    Vec2 max = Vec2::Zero(); ///< greater than min in both coordinates [m]
};

struct WorldDef
{
    Field field = NoField{};
    double restitution = 1.0; ///< 0 ... 1
    double friction = 0.0;    ///< >= 0
    std::optional<BoxDef> box; ///< four static walls around everything
};

/// Everything that a run starts from, as plain values. Nothing here is checked yet: `validate` does.
struct Scene
{
    std::string title;
    double until = 10.0; ///< end of the run, >= 0 [s]
    WorldDef world;
    std::vector<BodyDef> bodies;
};

/// Everything that is wrong with a scene, in one go; empty where the scene is fit to run. Places are paths such as
/// `world.restitution` or `body[3].shape.vertices[2]`; `found` and `expected` name the bodies by name and number.
/// Checked: every number finite and in range; shapes (geometry/make_polygon.hpp); names unique where given; static bodies
/// at rest; every body that moves inside the box, outside the core of a central field and off its centre; no two bodies
/// overlapping beyond rounding.
[[nodiscard]] Faults validate(const Scene& scene);

/// What to call body number `index` in a message: its name, or "body 3" where it has none.
[[nodiscard]] std::string body_label(const Scene& scene, int index);

/// The same with a name in quotes, also of what bounds the world: the four walls of a box, left, right, floor and
/// ceiling, are numbered after the bodies, and the core of a central field after these.
[[nodiscard]] std::string quoted_label(const Scene& scene, int index);

} // namespace flying
