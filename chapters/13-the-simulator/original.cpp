#include <cmath>
#include <cstdio>

#include "../02-rectangle/wrong_triangle.hpp"
#include "runs.hpp"
#include "weighing.hpp"

using namespace flying;

namespace {

// [simulator.original.shapes]
/// What the original took the shapes of its own scene for.
void compare_shapes(const Scene& scene)
{
    std::printf("%-12s %10s %10s %12s %14s\n", "shape", "area", "its area", "centre off",
                "its inertia");
    for (const BodyDef& def : scene.bodies) {
        if (def.is_static) continue;
        const Shape shape = make_shape(def.shape).value();
        const Polygon& polygon = std::get<Polygon>(shape);
        const AreaMoments ours = moments_by(Scales::right, def.shape, polygon);
        const AreaMoments its = moments_by(Scales::original, def.shape, polygon);
        std::printf("%-12s %7.4f m2 %7.4f m2 %10.4f m %12.4f x\n", def.name.c_str(),
                    ours.area, its.area, (its.centroid - ours.centroid).norm(),
                    its.second_moment / ours.second_moment);
    }
    const double legs = 200.0; // of the fixed wedges [pixels]
    std::printf("%-12s %58.0f x\n", "wedges",
                wrong_half_square_mass(legs, 0.1).moment_of_inertia /
                    half_square_mass(legs, 0.1).moment_of_inertia);
}
// [simulator.original.shapes]

// [simulator.original.runs]
/// The scene with both kinds of scales: the first impact that differs, and energy.
void compare_runs(const Scene& scene)
{
    EventEngine ours(weigh_in_box(scene, Scales::right), {});
    EventEngine its(weigh_in_box(scene, Scales::original), {});
    const double energy_ours = kinetic_energy(ours);
    const double energy_its = kinetic_energy(its);
    const auto right = meetings_of(ours, 60.0);
    const auto wrong = meetings_of(its, 60.0);
    std::size_t k = 0;
    while (std::abs(right[k].time - wrong[k].time) < 1e-9) ++k;
    const auto name = [&](int body) {
        return body < static_cast<int>(scene.bodies.size())
                   ? scene.bodies[body].name.c_str()
                   : "a wall";
    };
    std::printf("\n%zu impacts with the right masses, %zu with its own\n", right.size(),
                wrong.size());
    std::printf("impacts that agree = %zu\n", k);
    std::printf("the next: %s and %s at %.4f s, or %s and %s at %.4f s\n",
                name(right[k].a), name(right[k].b), right[k].time, name(wrong[k].a),
                name(wrong[k].b), wrong[k].time);
    std::printf("energy gained: %.0e J of %.0f J, and %.0e J of %.0f J\n",
                kinetic_energy(ours) - energy_ours, energy_ours,
                kinetic_energy(its) - energy_its, energy_its);
}
// [simulator.original.runs]

} // namespace

// [simulator.original]
int main()
{
    const Scene scene = scene_of_course(FLYING_SCENES, "original-polygons");
    compare_shapes(scene);
    compare_runs(scene);
}
// [simulator.original]
