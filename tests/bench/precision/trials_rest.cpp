// Bodies that lean on each other. What stands stands still; what falls leaves no overlap and gains no energy.

#include <cmath>

#include "scenes.hpp"
#include "trial.hpp"
#include "truths.hpp"

namespace flying::bench {
namespace {

constexpr double k_gravity = 9.81;

/// Largest error of a force between neighbours in a stack, as a share of the whole weight.
Measure force_error(const Scene& scene)
{
    const std::vector<WeighedBody> bodies = weigh(scene);
    return {"error of the forces, of the weight", [bodies](const Story& story) -> std::optional<double> {
                if (!story.knows_loads) return std::nullopt;
                const int count = static_cast<int>(bodies.size());
                std::vector<double> force(bodies.size(), 0.0); // from below
                for (const Load& load : story.loads) {
                    if (load.above == load.below + 1) force[load.above] += load.force;
                }
                double weight = 0.0;
                double worst = 0.0;
                for (int k = count - 1; k >= 0; --k) {
                    weight += bodies[k].mass * k_gravity;
                    worst = std::max(worst, std::abs(force[k] - weight));
                }
                return worst / weight;
            }};
}

Trial stack(const std::string& name, int count, double top)
{
    Trial trial;
    trial.name = name;
    trial.title = top == 1.0 ? "a stack of " + std::to_string(count) + " boxes, five seconds"
                             : "a box of ten thousand times the mass on a light one";
    trial.why = top == 1.0
                    ? "it stands still in truth: how far any box has gone from its place, and how far the forces are "
                      "from the weights above"
                    : "it stands still in truth; a light box between a heavy one and the floor is pressed through it";
    trial.truth = "nothing moves; each contact bears what stands above";
    trial.patience = count > 10 ? 4.0 : 1.0;
    trial.until = 5.0;
    trial.looks = {0.0, trial.until};
    trial.rests = true;
    trial.asks_loads = true;
    GenerateOptions options;
    options.count = count;
    options.restitution = 0.0;
    options.friction = 0.5;
    if (top != 1.0) options.mass_ratio = top;
    trial.scene = scene_of("stack", options);
    trial.scene.world.field = UniformField{Vec2(0.0, -k_gravity)};
    trial.measures = {largest_shift(), force_error(trial.scene), deepest_overlap(trial.scene)};
    return trial;
}

Trial pyramid(int base)
{
    Trial trial;
    trial.name = "pyramid";
    trial.title = "a pyramid on " + std::to_string(base) + " boxes, five seconds";
    trial.why = "it stands still in truth: how far any box has gone from its place";
    trial.truth = "nothing moves";
    trial.patience = base > 10 ? 10.0 : 1.0;
    trial.until = 5.0;
    trial.looks = {0.0, trial.until};
    trial.rests = true;
    GenerateOptions options;
    options.count = base;
    options.restitution = 0.0;
    options.friction = 0.5;
    trial.scene = scene_of("pyramid", options);
    trial.measures = {largest_shift(), deepest_overlap(trial.scene)};
    return trial;
}

Trial pile(int count)
{
    Trial trial;
    trial.name = "pile";
    trial.title = std::to_string(count) + " boxes that fall into a bin";
    trial.why = "where each box comes to lie is chaos, but no two may share a place, and nothing may give them energy";
    trial.truth = "solid bodies don't overlap";
    trial.patience = 12.0;
    trial.until = 5.0;
    trial.looks = looks_every(0.5, trial.until);
    trial.rests = true;
    GenerateOptions options;
    options.seed = 5;
    options.count = count;
    options.shape = "box";
    options.restitution = 0.0;
    options.friction = 0.5;
    trial.scene = scene_of("pile", options);
    trial.measures = {deepest_overlap(trial.scene), energy_gain(trial.scene)};
    return trial;
}

/// Elastic balls bounce beside a pyramid that stands.
Trial beside()
{
    constexpr double k_radius = 0.25;
    Trial trial;
    trial.name = "beside-a-pile";
    trial.title = "eight elastic balls that bounce beside a pyramid at rest";
    trial.why = "a pile needs steps and bouncing balls need moments; whoever has one method for all pays for it in one "
                "of the two";
    trial.truth = "parabolas from impact to impact; the pyramid stands";
    trial.until = 5.0;
    trial.looks = looks_every(0.25, trial.until);
    trial.rests = true;
    GenerateOptions options;
    options.count = 6;
    options.restitution = 0.0;
    options.friction = 0.5;
    trial.scene = scene_of("pyramid", options);
    Scene& scene = trial.scene;
    scene.world.field = UniformField{Vec2(0.0, -k_gravity)};
    const auto boxes = static_cast<int>(scene.bodies.size());
    const double first = scene.world.box->max.x() + 1.0;
    scene.world.box->max += Vec2(18.0, 4.0);
    for (int k = 0; k < 8; ++k) {
        BodyDef ball;
        ball.shape = DiscDef{k_radius};
        ball.position = Vec2(first + 2.0 * k, k_radius + 1.0 + 0.4 * k);
        ball.restitution = 1.0;
        ball.friction = 0.0;
        scene.bodies.push_back(ball);
    }
    const Scene whole = scene;
    trial.measures = {
        {"median distance of the balls from the truth [m]",
         [whole, boxes](const Story& story) -> std::optional<double> {
             Story balls;
             for (const Look& look : story.looks) {
                 balls.looks.push_back({look.time, {look.states.begin() + boxes, look.states.end()}});
             }
             Scene of_balls = whole;
             of_balls.bodies.erase(of_balls.bodies.begin(), of_balls.bodies.begin() + boxes);
             const Measure measure = median_distance(of_balls, [&](int k, double t) {
                 const Vec2 start = of_balls.bodies[k].position;
                 return Place{Vec2(start.x(), k_radius + bounce_height(start.y() - k_radius, k_gravity, 1.0, t)), {}};
             });
             return measure.of(balls);
         }},
        deepest_overlap(scene)};
    return trial;
}

} // namespace

std::vector<TrialMaker> rest_trials()
{
    const auto is_full = [](Coarseness coarseness) { return coarseness == Coarseness::full; };
    return {{"stack-10", [](Coarseness) { return stack("stack-10", 10, 1.0); }},
            {"stack-50", [](Coarseness) { return stack("stack-50", 50, 1.0); }},
            {"mass-ratio", [](Coarseness) { return stack("mass-ratio", 2, 1e4); }},
            {"pyramid", [=](Coarseness c) { return pyramid(is_full(c) ? 20 : 10); }},
            {"pile", [=](Coarseness c) { return pile(is_full(c) ? 100 : 50); }},
            {"beside-a-pile", [](Coarseness) { return beside(); }}};
}

} // namespace flying::bench
