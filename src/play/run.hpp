#pragma once

#include <cstdint>
#include <deque>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "world/world.hpp"

namespace flying {

/// What a changed scene does about bodies that overlap.
enum class Crowding
{
    refuse,   ///< only what a moment's rounding has brought is put right
    make_room ///< bodies are moved apart
};

/// A scene that is played with: it moves on, is changed while it does, and goes back. Time counts from the scene's start
/// through all changes. Between changes the run is that of `World`, to the bit; a change starts a new world from the
/// bodies as they are, so that counts of the world start anew while those of the run go on.
class PlayRun
{
public:
    /// scene    as `validate` wants it; faults otherwise
    [[nodiscard]] static Expected<PlayRun> start(Scene scene, const WorldOptions& options);

    [[nodiscard]] const World& world() const { return world_; }
    [[nodiscard]] World& world() { return world_; }
    /// The scene of the present world, with the bodies as they were when it began.
    [[nodiscard]] const Scene& scene() const { return world_.scene(); }
    [[nodiscard]] const Scene& first_scene() const { return *first_; }
    [[nodiscard]] const WorldOptions& options() const { return options_; }

    [[nodiscard]] double time() const { return origin_ + world_.time(); } ///< [s]
    [[nodiscard]] std::int64_t events() const { return earlier_events_ + world_.events(); }
    [[nodiscard]] std::int64_t collisions() const { return earlier_collisions_ + world_.collisions(); }
    /// Number of worlds so far: it changes whenever bodies may have other numbers or masses.
    [[nodiscard]] int generation() const { return generation_; }

    /// What resists a push of a body of the scene; zeros for a static one.
    [[nodiscard]] const Inertia& inertia(int body) const { return inertia_[static_cast<std::size_t>(body)]; }

    /// How far an advance got.
    struct Advance
    {
        bool arrived = false; ///< at the time that was asked for
        std::optional<RunFailure> failure;
    };
    /// Move on to a time.  most  events or steps at once  [s]
    [[nodiscard]] Advance advance(double time, std::int64_t most);

    /// Take a snapshot to come back to, where the last one is long ago.  apart  [s]
    void remember(double apart);

    /// The scene with all bodies where they are now: to change, and to give to `change`. The run may move on a little, to
    /// the end of the step that it is in.
    [[nodiscard]] Scene scene_now();

    /// Go on with another scene. Faults, and nothing is changed, where it can't be run.
    /// label  what is done, for undo; the same label again within one stroke (`begin_stroke`) makes one change with it
    [[nodiscard]] Faults change(Scene scene, const std::string& label, Crowding crowding);

    /// From here on changes are not joined with earlier ones.
    void begin_stroke() { stroke_.clear(); }

    /// Back to before the last change, and what was undone; empty where there is nothing left.
    [[nodiscard]] std::string undo();
    [[nodiscard]] bool can_undo() const;
    /// Forward again to the moment from which was undone, with the same bits, and what is done again; empty where nothing
    /// was undone since the last change.
    [[nodiscard]] std::string redo();
    [[nodiscard]] bool can_redo() const { return !undone_.empty(); }
    /// Back to the start of the first scene.
    void reset();
    /// Back to the last moment that is remembered and not after another, or the earliest.  [s]
    /// Until when the run may go on from there towards the other: a change may lie between.  [s]
    [[nodiscard]] double rewind(double time);
    /// Back to an earlier moment, as far as is remembered. True where that was reached.  [s]
    bool go_back(double time);
    /// Earliest moment that can be gone back to.  [s]
    [[nodiscard]] double earliest() const;

private:
    /// A moment of the run to which it can return with the same bits.
    struct Moment
    {
        std::shared_ptr<const Scene> scene;
        std::shared_ptr<const Snapshot> snapshot;
        double origin = 0.0;
        std::int64_t events = 0;
        std::int64_t collisions = 0;
        std::string undoes; ///< label of the change that followed; empty where none did
        double holds_until = std::numeric_limits<double>::infinity(); ///< from here on a change leads elsewhere [s]
        [[nodiscard]] double time() const { return origin + snapshot->time; }
    };

    /// What an undo took back.
    struct Undone
    {
        Moment before;                ///< as it was, with the change's label
        std::vector<Moment> followed; ///< up to the moment from which was undone
    };

    PlayRun(World world, std::shared_ptr<const Scene> scene, const WorldOptions& options);
    [[nodiscard]] Moment moment() const;
    void restore(const Moment& moment);
    void forget_some();

    World world_;
    std::shared_ptr<const Scene> first_;
    std::shared_ptr<const Scene> scene_;
    WorldOptions options_;
    double origin_ = 0.0;
    std::int64_t earlier_events_ = 0;
    std::int64_t earlier_collisions_ = 0;
    int generation_ = 0;
    std::vector<Inertia> inertia_;
    std::deque<Moment> moments_; // in the order of time
    std::vector<Undone> undone_; // the latest last
    std::string stroke_;         // label of the change that goes on
};

} // namespace flying
