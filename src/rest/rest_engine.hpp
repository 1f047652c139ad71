#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "rest/body_set.hpp"
#include "rest/island_step.hpp"
#include "rest/islands.hpp"
#include "rest/meetings.hpp"
#include "rest/rest_data.hpp"
#include "rest/rest_way.hpp"
#include "rest/sleepers.hpp"

namespace flying {

/// One point of contact as the last step left it.
struct RestContact
{
    int a = 0;
    int b = 0;
    Vec2 normal = Vec2::Zero(); ///< from A to B
    double gap = 0.0;           ///< at the start of the step [m]
    double normal_force = 0.0;  ///< mean over the step [N]
    double tangent_force = 0.0; ///< mean over the step, along the normal turned a quarter counter-clockwise [N]
};

/// Moves bodies that lean on each other, by steps of one length. What happens depends on the bodies and the step alone:
/// not on who looks, when, or where the bodies lie in memory.
///
/// Between changes of contact, motion under constant forces is exact whatever the step: places move by the mean of
/// the velocities before and after. An impact acts at its own moment within the step. Pushes end an approach or hold a
/// load and never do work, so that energy doesn't rise; overlap that the turning of bodies brings is taken off by
/// moving them apart, which adds no velocity.
///
/// A `body` is a place in the list that the engine was made of, from 0, and is not checked. An engine belongs to one
/// thread at a time.
class RestEngine
{
public:
    /// An engine whose next step begins at `time`.
    /// bodies   with finite states and masses, as `World` makes them; not checked
    /// options  lengths and limits, as `RestOptions` explains them
    /// time     of the bodies' states [s]
    explicit RestEngine(std::vector<RestBody> bodies, const RestOptions& options = {}, double time = 0.0);

    /// Make steps as long as whole ones fit before `time` [s].
    void advance(double time);
    /// Make one step of the length that the options say.
    void step();

    /// Make one step of another length.
    /// length  > 0 [s]
    /// end     the moment at which it ends, which the caller knows better than as a sum [s]
    void step_by(double length, double end);
    /// Where bodies are, and how they move, a time after such a step begins: of each body, if it is awake. Nothing is
    /// changed by it.
    /// since  0 ... length [s]
    [[nodiscard]] std::vector<std::optional<BodyState>> foresee(double length, double end, double since);
    /// Let the next step begin at `time` [s]; for an engine in which all bodies sleep.
    void set_time(double time);

    /// The moment that the steps have reached [s].
    [[nodiscard]] double time() const { return start_ + static_cast<double>(steps_) * data_.options.step; }

    /// Those that the engine was made of, active or not.
    [[nodiscard]] int body_count() const { return data_.bodies.count(); }
    /// Its shape, mass, material and motion as the last step has left them.
    [[nodiscard]] const RestBody& body(int body) const { return data_.bodies.list[data_.bodies.place[body]]; }
    /// Where it is and how it moves at `time()`.
    [[nodiscard]] BodyState state(int body) const
    {
        BodyState state = data_.bodies.list[data_.bodies.place[body]].state;
        state.time = time();
        return state;
    }

    /// Put a body elsewhere, or give it another motion; it wakes, and whatever touches it.
    void set_state(int body, const BodyState& state);
    /// Take a body out, or put it back where its state says.
    void set_active(int body, bool active);

    /// The bodies that are awake, bear no load, and that nothing will touch for the time `within` [s] if all goes on as
    /// it does; ascending.
    [[nodiscard]] std::vector<int> find_clear(double within);

    /// What the engine knows beside shapes and inertia: all that the next step depends on.
    struct Memory
    {
        struct Body
        {
            BodyState state;
            Vec2 pull = Vec2::Zero();
            double expected_angular_acceleration = 0.0;
            double reach = 0.0;
            int sleep_island = -1; ///< -1 where awake
            bool is_active = true;
            bool in_large_island = false;
        };
        double time = 0.0;
        std::vector<int> order; ///< which body each of `bodies` is; all numbers in here are places in that list
        std::vector<Body> bodies;
        std::vector<RestPair> pairs;
        double max_overlap = 0.0;
    };
    /// What `go_on_from` needs.
    [[nodiscard]] Memory memory() const;
    /// Put back what `memory` of an engine of the same bodies and options has said: the next step has the same bits as
    /// it would have had there.
    void go_on_from(const Memory& memory);

    /// Contacts of the last step, in the order of (a, b); those of sleeping islands included.
    [[nodiscard]] std::vector<RestContact> contacts() const;
    /// For each body, the number of its island: bodies that touch, by whatever chain of moving bodies, share one, which
    /// is its lowest body. -1 for static bodies and those not active.
    [[nodiscard]] std::vector<int> islands() const;
    /// A whole step has changed nothing of its island, and nothing has touched that since: steps leave it out, unless
    /// the options say that they don't, which shows that it changes nothing.
    [[nodiscard]] bool is_asleep(int body) const { return sleepers_.is_asleep(data_.bodies.place[body]); }
    /// The others that can move, as they lie in memory.
    template <typename Visit>
    void for_each_awake(Visit&& visit)
    {
        list_stepped();
        for (const int k : stepped_.list()) {
            if (!sleepers_.is_asleep(k)) visit(data_.bodies.order[k]);
        }
    }
    /// Call visit(body, before) for every body that the last step had to move, with its state as the step began.
    template <typename Visit>
    void for_each_moved(Visit&& visit) const
    {
        for (const int k : moved_) visit(data_.bodies.order[k], before_[k].state);
    }

    /// The work done so far.
    [[nodiscard]] const RestCounts& counts() const { return data_.counts; }
    /// How the searches for impulses have ended so far.
    [[nodiscard]] const SolveCounts& solve_counts() const { return data_.solver.counts(); }
    /// The time spent in each stage, where a clock was lent.
    [[nodiscard]] const RestSeconds& seconds() const { return seconds_; }
    /// clock  only goes forward [s]; null to stop measuring
    void set_clock(double (*clock)()) { data_.options.seconds = clock; }
    /// The deepest overlap that any step has begun with [m].
    [[nodiscard]] double max_overlap() const { return data_.max_overlap; }
    /// Fingerprint of all states.
    [[nodiscard]] std::uint64_t hash() const;

private:
    RestEngine(std::vector<RestBody> bodies, const RestOptions& options, double time, std::vector<int> order);

    /// An island whose step, or part of one, ends early: what it takes to make that in parts.
    struct CutIsland
    {
        std::vector<int> members;
        std::vector<int> pairs;
        std::vector<double> ends; ///< of its parts, the last first, since what was cut began [s]
        double begun = 0.0;       ///< what is made of it [s]
        double after = 0.0;       ///< of the step, after what was cut [s]
        int depth = 0;            ///< of parts within parts
    };

    /// Steps that are made in parts.
    struct Parts
    {
        int bodies = 1;         ///< of the island whose step is made in parts
        int made = 0;           ///< of its step
        int looks = 0;          ///< in these, at pairs that both move
        bool are_again = false; ///< of a whole step that is made again
        std::vector<int> of;    ///< of each body: the cut island that it is of, while pairs are sorted out; else -1
    };

    void leave_out_sleepers(bool are_left_out);
    void list_stepped();
    void begin_stepped();
    void begin(std::span<const int> bodies);
    void measure_reach(std::span<const int> bodies);
    [[nodiscard]] bool list_pairs();
    [[nodiscard]] bool list_what_impacts_reach();
    [[nodiscard]] bool wake_touched();
    void wake_all_with(int body);
    void solve_islands();
    [[nodiscard]] std::vector<CutIsland> finish_islands(int depth, std::span<const int> pairs);
    [[nodiscard]] bool may_be_parted(const Island& island) const;
    [[nodiscard]] bool may_be_halved(const Island& island, int depth) const;
    void find_pairs_of(std::span<CutIsland> islands, std::span<const int> pairs);
    void make_parts(std::vector<CutIsland> islands);
    [[nodiscard]] std::vector<CutIsland> make_part(CutIsland& island);
    void begin_part(std::span<const int> bodies, int depth);
    [[nodiscard]] std::vector<CutIsland> go_back(Meetings& met);
    void wake_met(Meetings& met);
    [[nodiscard]] bool stood_alike(int member) const;
    void move_island(const Island& island);
    [[nodiscard]] bool bounces(const RestPair& pair, double load) const;
    [[nodiscard]] bool stays_apart(const RestPair& pair, double within) const;

    RestData data_;
    double start_ = 0.0; // [s]
    std::int64_t steps_ = 0;

    std::vector<ContactPoint> found_; // in the order of the pairs
    std::vector<double> farthest_;    // that each body may get in the step, thrown or not [m]
    Islands islands_;
    IslandStep island_step_;

    Sleepers sleepers_;
    bool may_fall_asleep_ = true;    // in steps of this length
    BodySet stepped_;                // can move, and aren't left out
    std::vector<int> stirred_;       // came or went since that list was made
    std::vector<int> moved_;         // those that the last step was for, ascending
    std::vector<BodyBefore> before_; // of those
    std::vector<char> marks_;        // of each body, while some are marked; else 0
    Parts parts_;
    RestSeconds seconds_;
    WithinStep* within_ = nullptr; // while a step is looked into
};

} // namespace flying
