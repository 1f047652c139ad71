#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "math/expected.hpp"
#include "world/scene.hpp"

namespace flying {

/// Bounds between which numbers are drawn, both possible; equal bounds fix the number.
struct Bounds
{
    double min = 0.0;
    double max = 0.0;
};

/// What to generate. Everything is optional: each kind has its own defaults, and names in a fault each option that it
/// doesn't know. The names of options on a command line are those of the members, with hyphens for underscores.
struct GenerateOptions
{
    std::uint64_t seed = 1;              ///< same seed and options, same scene, on every machine
    std::optional<int> count;            ///< bodies that move; pyramid: boxes in the lowest row; >= 1
    std::optional<Bounds> radius;        ///< of discs, or of the circle round a polygon; 0 < min <= max [m]
    std::optional<Bounds> speed;         ///< 0 <= min <= max, in any direction; not with rms_speed [m/s]
    std::optional<double> rms_speed;     ///< of all bodies together; velocities nearly as Maxwell has them [m/s]
    std::optional<double> max_spin;      ///< spins are drawn between -max_spin and max_spin; >= 0 [rad/s]
    std::optional<double> packing;       ///< area of the bodies over that of the box, which it sizes; not with box
    std::optional<BoxDef> box;           ///< four walls
    std::optional<Vec2> gravity;         ///< uniform field; (0, 0) for none [m/s^2]
    std::optional<double> restitution;   ///< 0 ... 1
    std::optional<double> friction;      ///< >= 0
    std::optional<double> density;       ///< > 0 [kg/m^2]
    std::optional<double> until;         ///< >= 0 [s]
    std::optional<int> min_sides;        ///< of polygons, >= 3
    std::optional<int> max_sides;        ///< of polygons, >= min_sides
    std::optional<std::string> shape;    ///< gas: disc, polygon, dumbbell; pile: disc, box, polygon
    std::optional<double> mass_ratio;    ///< stack: mass of the top box over that of the others; > 0
    std::optional<double> gap;           ///< between neighbours: cradle, stack, pyramid (sideways); >= 0 [m]
    std::optional<std::string> billiard; ///< billiard: pi, rectangle
    std::optional<int> exponent;         ///< billiard pi: masses 1 and 100^exponent; 0 ... 8
};

/// One kind of scene that can be generated.
struct GeneratorKind
{
    std::string name;                 ///< as `flying generate` takes it
    std::string summary;              ///< one line
    std::vector<std::string> options; ///< names of the members of GenerateOptions that it knows, `seed` included
};

/// balls gas polygons pile stack pyramid cradle billiard, in this order.
[[nodiscard]] const std::vector<GeneratorKind>& generator_kinds();

/// A scene of a kind: valid, with a title, no two bodies overlapping.
///
/// kind     one of generator_kinds()
/// options  any values
///
/// Faults, all together, placed at the option's name (`packing`, `radius`): values out of range, options that the kind
/// doesn't know or that exclude each other, bodies that don't fit. Draws end after a fixed number of tries; what random
/// places can't hold is put on a lattice and shaken.
[[nodiscard]] Expected<Scene> generate(const std::string& kind, const GenerateOptions& options);

} // namespace flying
