#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "rest/rest_engine.hpp"
#include "world/report.hpp"

/// Random scenes for the resting integrator, and what a run of one showed.
namespace flying::stress {

/// One scene that a seed fixes: discs, convex and concave polygons, slivers, static blocks, in a box of four walls; no
/// two overlap.
struct RestScene
{
    std::vector<RestBody> bodies; ///< the walls first
    Vec2 low = Vec2::Zero();      ///< corners of the box [m]
    Vec2 high = Vec2::Zero();
    double step = 1.0 / 60.0; ///< [s]
    int steps = 0;
    std::string label; ///< what the seed has drawn
};

[[nodiscard]] RestScene make_rest_scene(std::uint64_t seed);

/// What a run showed, worst over all steps.
struct RestFindings
{
    double rise = 0.0;        ///< of the energy above the least before it, over what the scene has to give
    int rise_step = -1;       ///< in which step
    double overlap = 0.0;     ///< deepest, over the smaller one's bounding radius
    int overlap_step = -1;    ///< in which step
    int overlap_a = -1;       ///< which bodies
    int overlap_b = -1;
    double end_overlap = 0.0; ///< the same, at the end
    int lost = 0;             ///< bodies whose centre has left the box
    bool finite = true;       ///< no number that is none, and the run came to its end
    RestAccount rest;         ///< how the steps were made; only of a world that hands bodies to and fro
};

/// What moves the bodies of a scene.
enum class Integrator
{
    rest,     ///< the resting integrator alone
    automatic ///< a world that hands bodies to and fro
};

/// look_every  steps between measurements of overlap, which cost more than the steps themselves
[[nodiscard]] RestFindings run_rest_scene(const RestScene& scene, int look_every = 1,
                                          Integrator integrator = Integrator::rest);

/// [energies] A rise that rounding explains: each step rounds sums of the energies of all bodies.
inline constexpr double k_rise_allowed = 1e-9;
/// [bounding radii] Overlap that is allowed.
inline constexpr double k_overlap_allowed = 0.01;

/// True where the findings break no promise: no body lost, no energy won, all numbers finite, no overlap at the end.
[[nodiscard]] bool ends_well(const RestFindings& findings);
/// The same, and no overlap at any step.
[[nodiscard]] bool passes(const RestFindings& findings);

} // namespace flying::stress
