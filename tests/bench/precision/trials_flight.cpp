// Bodies that fly, and meet walls or each other along a line: closed forms to the last bit.

#include <cmath>
#include <numbers>

#include "01-flying-balls/orbits.hpp"
#include "trial.hpp"
#include "truths.hpp"

namespace flying::bench {
namespace {

BodyDef disc(double radius, const Vec2& position, const Vec2& velocity)
{
    BodyDef body;
    body.shape = DiscDef{radius};
    body.position = position;
    body.velocity = velocity;
    return body;
}

/// A dozen balls that fall from different heights, side by side.
Trial bounce(double e)
{
    constexpr double k_g = 9.8;
    constexpr double k_radius = 0.25;
    Trial trial;
    trial.name = e == 1.0 ? "bounce-elastic" : "bounce-half";
    trial.title = e == 1.0 ? "balls that bounce without loss" : "balls that bounce at e = 0.5, and come to rest";
    trial.why = "where the ball is, is what an impact at the wrong moment spoils; the median of twelve heights, so "
                "that no engine "
                "has luck with its steps";
    trial.truth = "parabolas from impact to impact";
    trial.until = 5.0;
    Scene& scene = trial.scene;
    scene.world.field = UniformField{Vec2(0.0, -k_g)};
    scene.world.restitution = e;
    scene.world.box = BoxDef{Vec2(0.0, 0.0), Vec2(24.0, 12.0)};
    for (int k = 0; k < 12; ++k) {
        scene.bodies.push_back(disc(k_radius, Vec2(1.0 + 2.0 * k, k_radius + 1.0 + 0.3 * k), Vec2(0.0, 0.0)));
    }
    trial.looks = looks_every(0.25, trial.until);
    trial.measures = {median_distance(scene,
                                      [scene, e](int k, double t) {
                                          const Vec2 start = scene.bodies[k].position;
                                          const double h = start.y() - k_radius;
                                          return Place{Vec2(start.x(), k_radius + bounce_height(h, k_g, e, t)), {}};
                                      }),
                      energy_drift(scene), deepest_overlap(scene)};
    trial.rests = e < 1.0;
    return trial;
}

Trial billiard()
{
    constexpr double k_radius = 0.25;
    Trial trial;
    trial.name = "billiard";
    trial.title = "one ball in a rectangle";
    trial.why = "each wall that is met too late leaves the ball on another of the mirrored paths; after some sixty "
                "walls the place tells";
    trial.truth = "one straight line through mirrored rooms";
    trial.until = 30.0;
    Scene& scene = trial.scene;
    scene.world.box = BoxDef{Vec2(0.0, 0.0), Vec2(4.0, 3.0)};
    scene.bodies = {disc(k_radius, Vec2(1.0, 1.25), Vec2(4.1, 2.9))};
    trial.looks = looks_every(0.5, trial.until);
    const BodyDef ball = scene.bodies.front();
    trial.measures = {
        median_distance(scene,
                        [ball](int, double t) {
                            return Place{
                                Vec2(folded(ball.position.x(), ball.velocity.x(), t, k_radius, 4.0 - k_radius),
                                     folded(ball.position.y(), ball.velocity.y(), t, k_radius, 3.0 - k_radius)),
                                {}};
                        }),
        energy_drift(scene)};
    return trial;
}

Trial kepler()
{
    Trial trial;
    trial.name = "kepler";
    trial.title = "ten turns of an ellipse, eccentricity 0.5";
    trial.why = "a field that bends the path; a wrong period shows as a distance along the orbit";
    trial.truth = "Kepler's equation";
    trial.until = 10.0;
    const steps::Orbit orbit{4.0 * std::numbers::pi * std::numbers::pi, 1.0, 0.5}; // one turn a second
    const steps::Moving start = on_ellipse(orbit, 0.0);
    trial.scene.world.field = CentralField{Vec2(0.0, 0.0), orbit.mu, 0.0};
    trial.scene.bodies = {disc(0.01, start.x, start.v)};
    trial.looks = looks_every(0.25, trial.until);
    trial.measures = {median_distance(trial.scene, [orbit](int, double t) {
        return Place{on_ellipse(orbit, t).x, {}};
    })};
    return trial;
}

Trial galperin()
{
    constexpr double k_mass = 1e4;
    Trial trial;
    trial.name = "galperin";
    trial.title = "Galperin's two balls and a wall, masses 1 : 10,000";
    trial.why =
        "velocities after the last of 314 collisions, in units in which all of the energy is 1: one collision more or "
        "less turns them by a fiftieth";
    trial.truth = "the two conservation laws, one collision after the other";
    trial.until = 6.0;
    Scene& scene = trial.scene;
    BodyDef wall;
    wall.shape = RectangleDef{4.0, 4.0};
    wall.position = Vec2(-2.0, 0.0);
    wall.is_static = true;
    scene.bodies = {wall, disc(0.25, Vec2(1.0, 0.0), Vec2(0.0, 0.0)), disc(0.5, Vec2(2.5, 0.0), Vec2(-1.0, 0.0))};
    scene.bodies[1].mass = 1.0;
    scene.bodies[2].mass = k_mass;
    trial.looks = {0.0, trial.until};
    const Parted truth = parted(k_mass);
    trial.measures = {{"error of the velocities, of 1",
                       [truth](const Story& story) -> std::optional<double> {
                           const Look& last = story.looks.back();
                           const double heavy = last.states[2].velocity.x() - truth.heavy;
                           const double light = (last.states[1].velocity.x() - truth.light) / std::sqrt(k_mass);
                           const double error = std::hypot(heavy, light);
                           return std::isfinite(error) ? error : HUGE_VAL;
                       }},
                      energy_drift(scene),
                      deepest_overlap(scene)};
    return trial;
}

/// Balls on a line, at random but the same every time.
Trial row(int count)
{
    constexpr double k_radius = 0.25;
    Trial trial;
    trial.name = "row-" + std::to_string(count);
    trial.title = std::to_string(count) + " equal balls on a line between two walls";
    trial.why = "every collision hands a velocity on; one that comes late shifts all that follow";
    trial.truth = "points that go through each other, unfolded and sorted";
    trial.until = 5.0;
    std::vector<double> x;
    std::vector<double> v;
    for (int k = 0; k < count; ++k) {
        // Fractions of multiples of the golden section: spread evenly, in no order
        const double shuffled = 0.6180339887498949 * (k + 1) - std::floor(0.6180339887498949 * (k + 1));
        x.push_back(0.5 + k + 0.3 * shuffled);
        v.push_back(4.0 * shuffled - 2.0);
    }
    Scene& scene = trial.scene;
    const double high = count + 0.5;
    scene.world.box = BoxDef{Vec2(0.0, -1.0), Vec2(high, 1.0)};
    for (int k = 0; k < count; ++k) scene.bodies.push_back(disc(k_radius, Vec2(x[k], 0.0), Vec2(v[k], 0.0)));
    trial.looks = looks_every(1.0, trial.until);
    trial.measures = {median_distance(scene,
                                      [x, v, high](int k, double t) {
                                          return Place{Vec2(row_places(x, v, k_radius, 0.0, high, t)[k], 0.0), {}};
                                      }),
                      energy_drift(scene), deepest_overlap(scene)};
    return trial;
}

/// One ball runs into a row of four, which touch or have gaps.
Trial cradle(double gap)
{
    constexpr double k_radius = 0.25;
    constexpr double k_run_up = 1.0;
    constexpr double k_speed = 2.0;
    Trial trial;
    trial.name = gap == 0.0 ? "cradle-touching" : "cradle-gaps";
    trial.title = gap == 0.0 ? "a ball strikes four that touch" : "a ball strikes four that don't quite touch";
    trial.why = gap == 0.0
                    ? "the last leaves with everything, as of steel and as of gaps however small; laws that treat all "
                      "contacts at once say otherwise"
                    : "four impacts follow each other within a fraction of a step; the last leaves with everything";
    trial.truth = "each ball hands its velocity to the next";
    trial.until = 2.0;
    for (int k = 0; k < 5; ++k) {
        const double at = k == 0 ? -k_run_up : (k - 1) * gap;
        trial.scene.bodies.push_back(
            disc(k_radius, Vec2(2.0 * k_radius * k + at, 0.0), Vec2(k == 0 ? k_speed : 0.0, 0.0)));
    }
    trial.looks = {0.0, trial.until};
    const Scene scene = trial.scene;
    trial.measures = {{"worst distance from the truth [m]",
                       [scene, gap](const Story& story) -> std::optional<double> {
                           double worst = 0.0;
                           for (int k = 0; k < 5; ++k) {
                               // Each goes as far as its gap and stops; the last goes on for the rest of the way
                               const double way = k_speed * story.looks.back().time - k_run_up - 3.0 * gap;
                               const double own = k == 0 ? k_run_up : k == 4 ? way : gap;
                               const Vec2 place = scene.bodies[k].position + Vec2(own, 0.0);
                               worst = std::max(worst, (story.looks.back().states[k].position - place).norm());
                           }
                           return worst;
                       }},
                      energy_drift(scene)};
    return trial;
}

} // namespace

std::vector<TrialMaker> flight_trials()
{
    return {{"bounce-elastic", [](Coarseness) { return bounce(1.0); }},
            {"bounce-half", [](Coarseness) { return bounce(0.5); }},
            {"billiard", [](Coarseness) { return billiard(); }},
            {"kepler", [](Coarseness) { return kepler(); }},
            {"cradle-touching", [](Coarseness) { return cradle(0.0); }},
            {"cradle-gaps", [](Coarseness) { return cradle(1.0 / 256.0); }},
            {"galperin", [](Coarseness) { return galperin(); }},
            {"row-10", [](Coarseness) { return row(10); }},
            {"row-100", [](Coarseness) { return row(100); }}};
}

} // namespace flying::bench
