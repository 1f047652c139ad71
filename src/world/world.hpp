#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "math/expected.hpp"
#include "motion/body.hpp"
#include "geometry/shape.hpp"
#include "world/plan.hpp"
#include "world/policy.hpp"
#include "world/report.hpp"
#include "world/scene.hpp"

/// Rigid bodies in the plane. Begin with `World`: it is made of a `Scene`, runs it, and says how the bodies move. All
/// quantities are in SI units, angles in radians counter-clockwise, y upwards.
namespace flying {

/// Why a run can't go on.
struct RunFailure
{
    double time = 0.0;        ///< [s]
    std::vector<int> bodies;  ///< scene indices of those involved; the box's walls are not among them
    std::string message;      ///< one sentence: which bodies, when, what happened
};

struct EngineMemory;

/// Everything that a run needs to go on with the same bits: the bodies at their own moments, and the counts so far.
struct Snapshot
{
    double time = 0.0;             ///< [s]
    std::vector<BodyState> bodies; ///< the scene's, each at the time of its last event
    std::int64_t events = 0;
    std::int64_t collisions = 0;
    double max_overlap = 0.0;      ///< [m]
    double initial_total = 0.0;    ///< [J]
    std::shared_ptr<const EngineMemory> engines; ///< what the integrators know beside
    EnergyLedger ledger;
    std::vector<Handover> handovers;
};

/// How to run a scene.
struct WorldOptions
{
    std::vector<std::string> without; ///< skips to leave inactive, of `skip_names`
    EngineChoice engine = EngineChoice::automatic;
    double step = 1.0 / 60.0;         ///< of the resting integrator, > 0 [s]
};

/// A scene in motion. Moves forward only. What it answers at a moment doesn't depend, to the bit, on how often it was asked
/// before. Between the ends of a step, bodies that lean on others are on the ways on which it leads them.
///
///     flying::World world = flying::World::make(scene).value();
///     while (world.time() < 10.0)
///         if (const auto failure = world.advance(world.time() + 0.1)) break;
///     const flying::BodyState first = world.state(0);
///
/// A world belongs to one thread at a time; two of them share nothing. An `index` is a body's place in the scene, from 0,
/// and is not checked. References hold as long as the world is neither moved nor destroyed.
class World
{
public:
    /// A world of the scene at time 0, or every fault of the scene, as `validate` finds them.
    [[nodiscard]] static Expected<World> make(const Scene& scene, const WorldOptions& options = {});

    World(World&&) noexcept;
    World& operator=(World&&) noexcept;
    ~World();

    /// Handle every event up to `time` [s] (included), or make every whole step, and set the clock there. Earlier times do
    /// nothing.
    /// max_events  stop early after that many events or steps more, so that the caller can show progress; the clock then
    ///             stands at the last one
    /// Returns the failure that stopped the run, if any; the clock then stands at its time, and the world can still be
    /// asked and reported but moves no more.
    [[nodiscard]] std::optional<RunFailure> advance(double time, std::int64_t max_events = -1);

    [[nodiscard]] double time() const;    ///< the clock [s]
    [[nodiscard]] int body_count() const; ///< the scene's bodies, without the box's walls

    /// Body `index` of the scene at the clock.
    [[nodiscard]] BodyState state(int index) const;
    /// Its shape about its centre of mass.
    [[nodiscard]] const Shape& shape(int index) const;
    [[nodiscard]] bool is_static(int index) const; ///< it never moves
    [[nodiscard]] const Scene& scene() const;      ///< of which the world was made

    [[nodiscard]] std::int64_t events() const; ///< handled, steps of the resting integrator among them
    [[nodiscard]] std::int64_t collisions() const; ///< impacts, in flight and in steps
    [[nodiscard]] const std::vector<Handover>& handovers() const; ///< between the integrators, so far
    /// What moves a body at the clock.
    using Mover = BodyMover;
    [[nodiscard]] Mover mover(int index) const;
    /// The end of the step that the clock stands within, where bodies that lean are asked on the way to it; none where
    /// no step is under way. A world made anew from the bodies' states does best to begin there.  [s]
    [[nodiscard]] std::optional<double> step_end() const;
    [[nodiscard]] std::uint64_t log_hash() const; ///< hash of the log of all events so far
    [[nodiscard]] Report report();                ///< the account of the run at the clock; measures overlap anew

    /// Measure the time of each stage from now on. The engine has no clock of its own.
    /// seconds  a clock that only goes forward [s]; null to stop measuring
    void set_stopwatch(double (*seconds)());

    /// What `resume` needs to go on from the clock.
    [[nodiscard]] Snapshot snapshot() const;
    /// A world that goes on from a snapshot of a run of the same scene, with the same bits as if it had never stopped.
    /// Faults: those of the scene, and a snapshot that holds another number of bodies.
    [[nodiscard]] static Expected<World> resume(const Scene& scene, const Snapshot& snapshot,
                                                const WorldOptions& options = {});

private:
    struct Parts;
    [[nodiscard]] static Expected<World> set_up(const Scene& scene, const WorldOptions& options);
    explicit World(std::unique_ptr<Parts> parts);
    std::unique_ptr<Parts> parts_;
};

} // namespace flying
