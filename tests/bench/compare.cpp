#include "compare.hpp"

#include <algorithm>
#include <cmath>

#include "machine.hpp"
#include "reference_discs.hpp"
#include "weighed.hpp"

namespace flying::bench {
namespace {

constexpr double k_path_time = 1.0; // [s]

double median_distance(const std::vector<BodyState>& a, const std::vector<BodyState>& b)
{
    std::vector<double> distances;
    for (std::size_t k = 0; k < a.size(); ++k) distances.push_back((a[k].position - b[k].position).norm());
    return median(std::move(distances));
}

/// The scene somewhere else: the same motion, with other roundings.
Scene moved(Scene scene, const Vec2& offset)
{
    scene.world.box->min += offset;
    scene.world.box->max += offset;
    for (BodyDef& body : scene.bodies) body.position += offset;
    return scene;
}

std::vector<BodyState> run_exact(const Scene& scene, double time)
{
    Exact engine(scene);
    engine.advance(time);
    return engine.states();
}

/// Where the bodies really are after a second, and how well that is known.
struct ExactPath
{
    std::string source;
    std::vector<BodyState> states;
    double error = 0.0; ///< [m]
    bool is_own = false;
};

ExactPath exact_path(const Scene& scene)
{
    ExactPath path;
    if (has_reference(scene)) {
        path.source = "impact by impact in long doubles, by a program of its own";
        path.states = reference_discs(scene, k_path_time);
        path.error = median_distance(path.states, reference_discs(scene, k_path_time, 1.0 / 3.0));
        return path;
    }
    // No oracle: the engine itself, and for its own error the same scene elsewhere
    path.source = "this engine; its own error: against the same scene moved elsewhere";
    path.states = run_exact(scene, k_path_time);
    const Vec2 offset(0.1, 0.7);
    std::vector<BodyState> elsewhere = run_exact(moved(scene, offset), k_path_time);
    for (BodyState& state : elsewhere) state.position -= offset;
    path.error = median_distance(path.states, elsewhere);
    path.is_own = true;
    return path;
}

/// Step by step, so that a peer that takes for ever can be given up.
void advance_peer(Showing& showing, Simulator& simulator, double until, double most)
{
    const double start = cpu_seconds();
    const double hertz = showing.engine.hertz;
    for (long k = 1; k <= steps_until(until, hertz); ++k) {
        const double time = static_cast<double>(k) / hertz;
        advance(simulator, time);
        if (k == steps_until(until, hertz) || cpu_seconds() - start <= most) continue;
        showing.stopped_at = time;
        return;
    }
}

void time_once(Showing& showing, const Scene& scene, double until, double most)
{
    const double start = cpu_seconds();
    Simulator simulator = make_simulator(showing.engine, scene);
    const double made = cpu_seconds();
    const double wall = wall_seconds();
    if (showing.engine.kind == EngineChoice::Kind::exact) advance(simulator, until);
    else advance_peer(showing, simulator, until, most);
    showing.wall_seconds.push_back(wall_seconds() - wall);
    showing.seconds.push_back(cpu_seconds() - made);
    if (showing.seconds.size() == 1) showing.setup_seconds = made - start;
    showing.collisions = collisions_of(simulator);
    showing.failure = failure_of(simulator).value_or("");
}

/// The same run once more, not timed: look at it as it goes.
void look_at(Showing& showing, const Scene& scene, double until, double samples_hertz, const ExactPath* path)
{
    const std::vector<WeighedBody> bodies = weigh(scene);
    OverlapRuler ruler(scene, bodies);
    Simulator simulator = make_simulator(showing.engine, scene);
    const double before = total_energy(bodies, states_of(simulator), scene);
    std::vector<BodyState> states;
    const long samples = std::lround(until * samples_hertz);
    for (long k = 1; k <= samples; ++k) {
        const double time = static_cast<double>(k) / samples_hertz;
        advance(simulator, time);
        states = states_of(simulator);
        showing.overlap = std::max(showing.overlap, ruler.deepest(states));
        if (!path || time != k_path_time) continue;
        const bool is_own = path->is_own && showing.engine.kind == EngineChoice::Kind::exact;
        showing.path_error = is_own ? path->error : median_distance(states, path->states);
    }
    showing.drift = total_energy(bodies, states, scene) / before - 1.0;
}

} // namespace

Comparison compare(const BenchCase& bench_case, double until, int repeats, double hertz, double most,
                   const std::function<void(const std::string&)>& tell)
{
    tell(bench_case.name + ": scene");
    const Scene scene = scene_of(bench_case.kind, bench_case.options);
    Comparison comparison{
        bench_case.name, bench_case.aim, static_cast<int>(scene.bodies.size()), until, 0.0, {}, 0.0, {}};
    comparison.showings.emplace_back();
    if (bench_case.has_peers) {
        for (const auto kind : {EngineChoice::Kind::chipmunk, EngineChoice::Kind::box2d}) {
            comparison.showings.emplace_back().engine = {kind, hertz};
        }
    }

    // In turn, so that whatever else the machine does falls on all alike
    for (int repeat = 0; repeat < repeats; ++repeat) {
        for (Showing& showing : comparison.showings) {
            if (showing.stopped_at) continue; // it won't be faster the next time
            tell(bench_case.name + ": " + name_of(showing.engine.kind) + ", repeat " + std::to_string(repeat + 1));
            time_once(showing, scene, until, most);
        }
    }

    // Look where they are
    const bool is_huge = comparison.bodies > 100000;
    std::optional<ExactPath> path;
    if (until >= k_path_time && !is_huge) {
        tell(bench_case.name + ": exact path");
        path = exact_path(scene);
        comparison.exact_path = path->source;
        comparison.exact_path_error = path->error;
    }
    comparison.samples_hertz = is_huge ? 4.0 / until : comparison.bodies > 2000 ? 6.0 : 60.0;
    for (Showing& showing : comparison.showings) {
        if (showing.stopped_at) continue;
        tell(bench_case.name + ": " + name_of(showing.engine.kind) + ", energy, overlap, path");
        look_at(showing, scene, until, comparison.samples_hertz, path ? &*path : nullptr);
    }
    return comparison;
}

} // namespace flying::bench
