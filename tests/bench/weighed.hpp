#pragma once

#include <vector>

#include "collide/separation.hpp"
#include "geometry/shape.hpp"
#include "motion/body.hpp"
#include "world/scene.hpp"

namespace flying::bench {

/// A body of a scene as every engine gets it: the same shape, mass and start.
struct WeighedBody
{
    Shape shape;
    double radius = 0.0;            ///< of the circle that holds it [m]
    double mass = 0.0;              ///< [kg]
    double moment_of_inertia = 0.0; ///< [kg m^2]
    Material material;
    BodyState start;
    bool is_static = false;
};

/// The bodies of a valid scene, in its order.
[[nodiscard]] std::vector<WeighedBody> weigh(const Scene& scene);

/// Kinetic and potential energy of all that moves, from what an engine says of places and velocities.  [J]
[[nodiscard]] double total_energy(const std::vector<WeighedBody>& bodies, const std::vector<BodyState>& states,
                                  const Scene& scene);

/// Measures overlap: the same ruler for every engine.
class OverlapRuler
{
public:
    OverlapRuler(const Scene& scene, const std::vector<WeighedBody>& bodies);

    /// Depth of the deepest overlap of two bodies, or of a body and a wall of the box; 0 where there is none.  [m]
    [[nodiscard]] double deepest(const std::vector<BodyState>& states);

private:
    [[nodiscard]] int cell_of(double value, double low) const;

    std::vector<CollisionShape> shapes_;
    std::vector<CollisionShape> walls_;
    std::vector<double> radii_;
    std::vector<char> is_static_;
    Vec2 low_ = Vec2::Zero();
    double cell_ = 1.0;
    int side_ = 1; // cells a row
    std::vector<int> head_;
    std::vector<int> next_;
};

} // namespace flying::bench
