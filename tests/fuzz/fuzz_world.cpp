#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <variant>

#include "fuzz/promise.hpp"
#include "fuzz/scene_from_bytes.hpp"
#include "scene/fault.hpp"
#include "scene/write.hpp"
#include "json/saved_run.hpp"

// Scenes made of bytes, and what every run of a valid one owes whatever the scene: an end, finite numbers, no energy
// from nowhere, no body through a wall, the same bits whoever asks, however often, with whatever work skipped, stopped
// or not.

namespace flying::fuzz {

namespace {

constexpr std::int64_t k_most_events = 2000; ///< of a run: what takes longer is left there
constexpr int k_looks = 6;
constexpr double k_rise_allowed = 1e-8;    ///< of the energies that were there: rounding of thousands of impacts
constexpr double k_overlap_allowed = 1e-9; ///< [m], of bodies of centimetres to metres: rounding of where an impact is

/// Where a run went.
struct Outcome
{
    bool failed = false;
    bool is_whole = false; ///< it came to the end within the events that it was given
    std::uint64_t hash = 0;
    std::int64_t events = 0;
};

std::string text(double value)
{
    char digits[32];
    std::snprintf(digits, sizeof digits, "%.17g", value);
    return digits;
}

/// What must hold at any moment.
/// most  the largest sum of energies without their signs so far  [J]
void look(World& world, double& most)
{
    const Report report = world.report();
    for (const BodyReport& body : report.bodies) {
        const BodyState& s = body.state;
        const bool is_finite =
            std::isfinite(s.position.x() + s.position.y() + s.velocity.x() + s.velocity.y() + s.angle + s.spin);
        promise(is_finite, "every number of a state is finite");
    }
    promise(std::isfinite(report.energy.total()), "energies are finite");

    const Scene& scene = world.scene();
    double energies = report.energy.kinetic + std::abs(report.energy.potential);
    for (const BodyReport& body : report.bodies)
        energies += body.mass * std::abs(potential_at(scene.world.field, body.state.position));
    most = std::fmax(most, energies);
    const double rise = report.energy.total() - report.initial_total;
    promise(rise <= k_rise_allowed * most, "no impact adds energy",
            text(report.initial_total) + " J before, " + text(report.energy.total()) + " J at " + text(report.time) +
                " s");

    if (!scene.world.box) return;
    for (int k = 0; k < world.body_count(); ++k) {
        if (world.is_static(k)) continue;
        const Vec2 place = world.state(k).position;
        const bool is_inside =
            (place - scene.world.box->min).minCoeff() >= 0.0 && (scene.world.box->max - place).minCoeff() >= 0.0;
        promise(is_inside, "no body leaves the box",
                "body " + std::to_string(k) + " at (" + text(place.x()) + ", " + text(place.y()) + ") at " +
                    text(report.time) + " s");
    }
}

/// looks  moments at which the world is asked, the end among them
Outcome run(World& world, int looks, bool is_judged)
{
    Outcome outcome;
    double most = 0.0;
    const double until = world.scene().until;
    for (int k = 1; k <= looks; ++k) {
        const double time = until * k / looks;
        const std::int64_t left = k_most_events - world.events();
        if (left <= 0) return outcome;
        if (const auto failure = world.advance(time, left)) {
            // Impacts may crowd without end where nothing can take them over, and only there
            outcome.failed = true;
            return outcome;
        }
        if (world.time() < time || world.events() >= k_most_events) return outcome;
        if (is_judged) look(world, most);
    }
    const Report report = world.report();
    // How deep steps may press bodies into each other is a matter of speed and step: ./course stress rest judges it
    if (is_judged && report.engine == "events")
        promise(report.max_overlap <= k_overlap_allowed, "no two bodies overlap", text(report.max_overlap) + " m");
    outcome.is_whole = true;
    outcome.hash = report.hash;
    outcome.events = report.events;
    return outcome;
}

/// Two whole runs of one scene. Without skips there are more events, and a run may have to be left on its way.
bool agrees(const Outcome& other, const Outcome& first)
{
    return other.failed == first.failed && (!other.is_whole || other.hash == first.hash);
}

void try_trial(const Trial& trial)
{
    Expected<World> made = World::make(trial.scene, trial.options);
    if (!made) {
        promise(!made.faults().empty() && !format_faults(made.faults()).empty(), "what is no scene has faults");
        return;
    }
    // Steps alone, asked to move what flies at a hundred of its sizes a step, owe less: ./course stress rest judges them
    const bool is_steps_alone = trial.options.engine == EngineChoice::rest;
    const Outcome first = run(made.value(), k_looks, !is_steps_alone);
    if (!first.is_whole) return;

    // However often it was asked
    World second = World::make(trial.scene, trial.options).value();
    promise(agrees(run(second, 1, false), first), "what happens doesn't depend on when somebody asks");

    // With nothing skipped that may be done without a bit's change
    WorldOptions bare = trial.options;
    // Round a centre, pairs whose features are all followed take minutes for a close passage
    const bool is_central = std::holds_alternative<CentralField>(trial.scene.world.field);
    for (const Skip& skip : second.report().plan.skips)
        if (skip.kind != SkipClass::altering && !(is_central && skip.name == "far-features"))
            bare.without.push_back(skip.name);
    World third = World::make(trial.scene, bare).value();
    promise(agrees(run(third, 1, false), first), "neutral skips change no bit");

    if (is_steps_alone) return;

    // Stopped on the way and gone on with
    World half = World::make(trial.scene, trial.options).value();
    if (half.advance(0.37 * trial.scene.until, k_most_events)) return;
    const std::string saved = write_saved_run(trial.scene, trial.options, half.snapshot());
    Expected<SavedRun> read = read_saved_run_text(saved, "saved", trial.scene);
    promise(read.has_value(), "a saved run can be read");
    Expected<World> again = World::resume(trial.scene, read.value().snapshot, read.value().options);
    promise(again.has_value(), "a saved run can be gone on with");
    promise(agrees(run(again.value(), 1, false), first), "a run that was stopped goes on with the same bits");
}

} // namespace

} // namespace flying::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    using namespace flying;
    const fuzz::Trial trial = fuzz::trial_from_bytes({data, size});
    if (std::getenv("FLYING_PRINT_SCENE") != nullptr) {
        const char* names[] = {"auto", "events", "rest"};
        std::printf("%s",
                    write_scene(trial.scene, "--engine " + std::string(names[static_cast<int>(trial.options.engine)]) +
                                                 " --step " + std::to_string(trial.options.step))
                        .c_str());
        std::fflush(stdout);
    }
    fuzz::try_trial(trial);
    return 0;
}
