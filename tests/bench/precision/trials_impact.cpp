// One impact, or one motion under friction: closed forms.

#include <cmath>
#include <numbers>

#include "trial.hpp"
#include "truths.hpp"

namespace flying::bench {
namespace {

constexpr double k_g = 9.81;
constexpr double k_slope = 20.0 * std::numbers::pi / 180.0;
const Vec2 k_tilted = Vec2(k_g * std::sin(k_slope), -k_g* std::cos(k_slope));

/// Twelve squares that come down on a corner each, at as many angles.
Trial corner()
{
    constexpr double k_speed = 3.0;
    Trial trial;
    trial.name = "corner-impact";
    trial.title = "squares that land on a corner";
    trial.why = "half of the energy goes into spin; place and angle a second later show both velocities and the moment "
                "of the impact";
    trial.truth = "one impulse at the corner";
    trial.until = 1.0;
    trial.looks = {0.0, trial.until};
    Scene& scene = trial.scene;
    scene.world.box = BoxDef{Vec2(0.0, 0.0), Vec2(48.0, 12.0)};
    std::vector<Place> places;
    for (int k = 0; k < 12; ++k) {
        const double offset = 0.02 + 0.03 * k; // of the corner from below the centre, as an angle
        const double reach = std::sqrt(0.5);
        const Vec2 arm(reach * std::sin(offset), -reach * std::cos(offset));
        const double gap = 1.0 + 0.07 * k;
        BodyDef body;
        body.shape = SquareDef{1.0};
        body.angle = offset - 0.25 * std::numbers::pi;
        body.position = Vec2(2.0 + 4.0 * k, gap - arm.y());
        body.velocity = Vec2(0.0, -k_speed);
        scene.bodies.push_back(body);

        const Struck after = strike_floor(body.velocity, 0.0, arm, 1.0, 1.0 / 6.0, 1.0);
        const double left = trial.until - gap / k_speed;
        places.push_back(
            {Vec2(body.position.x(), -arm.y() + after.velocity.y() * left), body.angle + after.spin * left});
    }
    trial.measures = {median_distance(scene,
                                      [places, scene](int k, double t) {
                                          if (t > 0.0) return places[k];
                                          return Place{scene.bodies[k].position, scene.bodies[k].angle};
                                      }),
                      energy_drift(scene)};
    return trial;
}

/// Twelve discs that strike a rough floor, some of which stick and some of which slide.
Trial oblique()
{
    constexpr double k_e = 0.8;
    constexpr double k_mu = 0.2;
    constexpr double k_radius = 0.5;
    Trial trial;
    trial.name = "oblique-impact";
    trial.title = "discs that strike a rough floor at an angle";
    trial.why = "friction within the impact decides between sticking and sliding; place and angle afterwards show all "
                "three velocities";
    trial.truth = "Coulomb's cone in one impact";
    trial.until = 1.0;
    trial.looks = {0.0, trial.until};
    Scene& scene = trial.scene;
    scene.world.restitution = k_e;
    scene.world.friction = k_mu;
    scene.world.box = BoxDef{Vec2(-20.0, 0.0), Vec2(200.0, 12.0)};
    std::vector<Place> places;
    for (int k = 0; k < 12; ++k) {
        BodyDef body;
        body.shape = DiscDef{k_radius};
        const double gap = 1.0 + 0.07 * k;
        body.position = Vec2(16.0 * k, k_radius + gap);
        body.velocity = Vec2(-6.3 + 1.15 * k, -3.0);
        scene.bodies.push_back(body);
        const double before = gap / 3.0;
        const double left = trial.until - before;
        const Struck after = strike_floor_rough(body.velocity, k_radius, k_e, k_mu);
        places.push_back({Vec2(body.position.x() + body.velocity.x() * before + after.velocity.x() * left,
                               k_radius + after.velocity.y() * left),
                          after.spin * left});
    }
    trial.measures = {median_distance(scene, [places, scene](int k, double t) {
        return t > 0.0 ? places[k] : Place{scene.bodies[k].position, 0.0};
    })};
    return trial;
}

/// Two seconds on a slope, to be filled with bodies.
Scene& lay_on_slope(Trial& trial)
{
    trial.until = 2.0;
    trial.looks = looks_every(0.5, trial.until);
    trial.rests = true;
    Scene& scene = trial.scene;
    scene.world.field = UniformField{k_tilted};
    scene.world.restitution = 0.0;
    scene.world.friction = 0.5;
    scene.world.box = BoxDef{Vec2(-10.0, 0.0), Vec2(200.0, 20.0)};
    return scene;
}

/// Blocks on a slope, as gravity that is tilted: some slide, some stay.
Trial incline()
{
    Trial trial;
    trial.name = "incline";
    trial.title = "blocks on a slope of 20 degrees, friction 0 to 0.5";
    trial.why = "friction acts all the time: how far each block has slid after two seconds";
    trial.truth = "constant acceleration g (sin t - mu cos t), or none";
    Scene& scene = lay_on_slope(trial);
    std::vector<double> frictions;
    for (int k = 0; k < 8; ++k) {
        const double mu = 0.07 * k;
        frictions.push_back(mu);
        BodyDef body;
        body.shape = RectangleDef{1.0, 0.5};
        body.position = Vec2(20.0 * k, 0.25);
        body.friction = mu * mu / 0.5; // the pair's is the root of the product
        scene.bodies.push_back(body);
    }
    trial.measures = {
        median_distance(
            scene,
            [scene, frictions](int k, double t) {
                return Place{scene.bodies[k].position + Vec2(slid(k_g, k_slope, frictions[k], t), 0.0), 0.0};
            }),
        deepest_overlap(scene)};
    return trial;
}

Trial rolling()
{
    Trial trial;
    trial.name = "rolling";
    trial.title = "discs that roll down a slope";
    trial.why = "way and turn must fit each other while friction, not known beforehand, holds the point of contact";
    trial.truth = "two thirds of what a smooth slope would give";
    Scene& scene = lay_on_slope(trial);
    std::vector<double> radii;
    for (int k = 0; k < 8; ++k) {
        radii.push_back(0.25 + 0.05 * k);
        BodyDef body;
        body.shape = DiscDef{radii.back()};
        body.position = Vec2(20.0 * k, radii.back());
        scene.bodies.push_back(body);
    }
    trial.measures = {median_distance(scene,
                                      [scene, radii](int k, double t) {
                                          const double way = 0.5 * (2.0 / 3.0) * k_g * std::sin(k_slope) * t * t;
                                          return Place{scene.bodies[k].position + Vec2(way, 0.0), -way / radii[k]};
                                      }),
                      deepest_overlap(scene)};
    return trial;
}

Trial sliding_to_rolling()
{
    constexpr double k_radius = 0.5;
    constexpr double k_mu = 0.2;
    Trial trial;
    trial.name = "slide-to-roll";
    trial.title = "discs that are thrown along a floor, slide, then roll";
    trial.why = "friction changes its law at a moment of its own, in the midst of a step";
    trial.truth = "constant deceleration until the rim stands still, then two thirds of the speed";
    trial.until = 3.0;
    trial.looks = looks_every(0.5, trial.until);
    trial.rests = true;
    Scene& scene = trial.scene;
    scene.world.field = UniformField{Vec2(0.0, -k_g)};
    scene.world.restitution = 0.0;
    scene.world.friction = k_mu;
    scene.world.box = BoxDef{Vec2(-10.0, 0.0), Vec2(220.0, 20.0)};
    for (int k = 0; k < 8; ++k) {
        BodyDef body;
        body.shape = DiscDef{k_radius};
        body.position = Vec2(25.0 * k, k_radius);
        body.velocity = Vec2(1.0 + 0.83 * k, 0.0);
        scene.bodies.push_back(body);
    }
    trial.measures = {median_distance(scene,
                                      [scene](int k, double t) {
                                          const BodyDef& body = scene.bodies[k];
                                          const Rolled rolled = slid_to_roll(body.velocity.x(), k_mu, k_g, k_radius, t);
                                          return Place{body.position + Vec2(rolled.way, 0.0), rolled.angle};
                                      }),
                      deepest_overlap(scene)};
    return trial;
}

Trial rocking_block()
{
    static constexpr double k_b = 0.25;
    static constexpr double k_h = 1.0;
    Trial trial;
    trial.name = "rocking-block";
    trial.title = "a block that rocks from one edge to the other";
    trial.why = "long stretches on one corner, short impacts on the other: an impact that comes late or loses too much "
                "shifts all later ones";
    trial.truth = "the equation of motion by small steps, w+ / w- = 1 - 1.5 sin^2 a at each impact";
    trial.until = 3.0;
    trial.looks = looks_every(0.25, trial.until);
    trial.rests = true;
    Scene& scene = trial.scene;
    scene.world.field = UniformField{Vec2(0.0, -k_g)};
    scene.world.restitution = 0.0;
    scene.world.friction = 1.0;
    scene.world.box = BoxDef{Vec2(-10.0, 0.0), Vec2(10.0, 20.0)};
    const double start = 0.6 * std::atan(k_b / k_h);
    const auto place = [](double angle) {
        // About the corner that it stands on
        const Vec2 foot(angle >= 0.0 ? -k_b : k_b, 0.0);
        const Vec2 arm(-foot.x(), k_h);
        return Vec2(foot.x() + std::cos(angle) * arm.x() - std::sin(angle) * arm.y(),
                    std::sin(angle) * arm.x() + std::cos(angle) * arm.y());
    };
    BodyDef body;
    body.shape = RectangleDef{2.0 * k_b, 2.0 * k_h};
    body.angle = start;
    body.position = place(start);
    scene.bodies = {body};
    const std::vector<double> angles = rocking(k_b, k_h, k_g, start, trial.looks);
    const std::vector<double> looks = trial.looks;
    trial.measures = {median_distance(scene,
                                      [angles, looks, place](int, double t) {
                                          const auto k = static_cast<std::size_t>(std::lround(t / 0.25));
                                          return Place{place(angles.at(k)), angles.at(k)};
                                      }),
                      energy_gain(scene), deepest_overlap(scene)};
    return trial;
}

} // namespace

std::vector<TrialMaker> impact_trials()
{
    return {{"corner-impact", [](Coarseness) { return corner(); }},
            {"oblique-impact", [](Coarseness) { return oblique(); }},
            {"incline", [](Coarseness) { return incline(); }},
            {"rolling", [](Coarseness) { return rolling(); }},
            {"slide-to-roll", [](Coarseness) { return sliding_to_rolling(); }},
            {"rocking-block", [](Coarseness) { return rocking_block(); }}};
}

} // namespace flying::bench
