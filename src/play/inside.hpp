#pragma once

#include <vector>

#include "collide/separation.hpp"
#include "world/world.hpp"

namespace flying {

/// What the integrators know of a world's bodies, seen from outside: for layers that show it. Bodies after the scene's own
/// are the box's walls, then the core of a central field, as in the engine.
struct Inside
{
    std::vector<CollisionShape> shapes; ///< of all bodies
    double cell_size = 0.0;             ///< of the grid in which neighbours are found; 0 where there is none [m]
};

/// What resists a push of each of the scene's bodies, as the world weighs them; zeros for static ones.
[[nodiscard]] std::vector<Inertia> weigh_all(const World& world);

/// For a world that begins now.
[[nodiscard]] Inside look_inside(const World& world);

/// A point at which bodies that lean touch, as the last step left it.
struct LeaningContact
{
    int a = 0;
    int b = 0;
    Vec2 point = Vec2::Zero();  ///< [m]
    Vec2 normal = Vec2::Zero(); ///< from A to B
    double normal_force = 0.0;  ///< mean over the step [N]
    double tangent_force = 0.0; ///< along the normal turned a quarter counter-clockwise [N]
};
/// step  length of the resting integrator's  [s]
[[nodiscard]] std::vector<LeaningContact> leaning_contacts(const World& world, const Inside& inside, double step);

/// For each of the scene's bodies the lowest body of its island, those that contacts join; -1 where it is in none.
[[nodiscard]] std::vector<int> islands(const World& world, const std::vector<LeaningContact>& contacts);

/// An impact that will happen, if its bodies are left alone.
struct NextImpact
{
    double time = 0.0; ///< of the world [s]
    int a = 0;
    int b = 0;
    Vec2 place_a = Vec2::Zero(); ///< of A's centre then [m]
    Vec2 place_b = Vec2::Zero();
};
/// The first impacts of bodies that fly, in their order: of each body its first, at most so many, none later than `within`
/// from now. Asks the same function as the event engine.
[[nodiscard]] std::vector<NextImpact> next_impacts(const World& world, const Inside& inside, std::size_t most, double within);

} // namespace flying
