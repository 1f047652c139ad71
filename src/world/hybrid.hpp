#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "events/event_engine.hpp"
#include "rest/rest_engine.hpp"
#include "broadphase/box_cells.hpp"
#include "motion/field.hpp"
#include "world/report.hpp"

namespace flying {

/// Two integrators, one world. Every body that moves is in the hands of one of them:
///
///     flies  the event engine's: moved from impact to impact
///     leans  the resting integrator's, and awake: moved by steps, to whose ends both engines come
///     lies   the resting integrator's, and asleep: to the event engine a thing that stays where it is, until it is
///            struck; the impact is located and answered like any other, and its group wakes
///
/// Steps end at whole multiples of the step's length, and where a body changes hands between two of them. A body that
/// might meet one that leans before the step ends is taken in at its start; one that bears no load and will touch
/// nothing for two steps is let go. So the two never meet anywhere else, and what happens does not depend on when
/// somebody asks.
class Hybrid
{
public:
    /// What is the same for the whole run.
    struct Setting
    {
        double step = 1.0 / 60.0;      ///< [s]
        Field field = NoField{};
        double (*seconds)() = nullptr; ///< a clock, or null
    };

    /// A hand-over before the scene gives it its words.
    struct Change
    {
        enum class Why { leaning, crowded, settled, unresolved, near, free };
        Why why = Why::crowded;
        double time = 0.0;        ///< when it happened [s]
        std::vector<int> bodies;
        int a = -1; ///< the pair whose impact led to it, where one did
        int b = -1;
        double bounces_end = 0.0; ///< of bounces that died away [s]
        double energy_before = 0.0;
        double energy_after = 0.0;
    };

    /// engine     whose bodies all fly
    /// materials  of the same bodies
    /// is_static  of the same bodies
    Hybrid(const EventEngine& engine, const std::vector<Material>& materials, const std::vector<char>& is_static,
           const Setting& setting);

    /// Whether a failure is one that ends by giving the bodies to the resting integrator.
    [[nodiscard]] static bool takes(const EventFailure& failure);
    /// Take bodies that lean on something from the start, and those near them.
    void take_leaning(EventEngine& engine, const std::vector<int>& bodies);
    /// Take the two bodies of such a failure, and those near them.
    void take(EventEngine& engine, const EventFailure& failure);

    /// As EventEngine::advance; steps count as events.
    [[nodiscard]] std::optional<EventFailure> advance(EventEngine& engine, double time, std::int64_t most);

    /// A body at a moment: not before the last event or step, and before the next.  [s]
    [[nodiscard]] BodyState state(const EventEngine& engine, int body, double time) const;

    [[nodiscard]] bool leans(int body) const { return hands_[body] == Hands::rest && !lies_[body]; }
    [[nodiscard]] bool lies(int body) const { return lies_[body] != 0; }
    [[nodiscard]] const RestEngine& rest() const { return rest_; }
    void set_clock(double (*clock)()) { rest_.set_clock(clock); }
    /// Hand-overs since they were last fetched.
    [[nodiscard]] std::vector<Change> fetch_changes() { return std::exchange(changes_, {}); }
    /// What the resting integrator's steps have changed of the energy.  [J]
    [[nodiscard]] double energy_of_steps() const { return energy_of_steps_; }
    /// What blows to lying bodies changed of the energy beyond what the event engine took note of.  [J]
    [[nodiscard]] double energy_of_blows() const { return energy_of_blows_; }

    /// All that a later run needs to go on with the same bits, beside the event engine's.
    struct Memory
    {
        RestEngine::Memory rest;
        std::vector<char> rests; ///< of each body, whether the resting integrator has it
        std::vector<char> clear;
        double step_ends = 0.0;
        double energy_of_steps = 0.0;
        double energy_of_blows = 0.0;
    };
    [[nodiscard]] Memory memory() const;
    /// engine  resumed already
    void go_on_from(const EventEngine& engine, const Memory& memory);

private:
    enum class Hands : char { none, events, rest };

    /// Bodies that rest and that may be connected to each other within a step.
    struct Island
    {
        double top_speed = 0.0; ///< [m/s]
        bool is_awake = false;  ///< some of them
    };

    /// What an impact gave to a body that lay: its state, had nothing else moved it.
    struct Blow
    {
        int body = -1;
        BodyState state;
    };

    void cut(EventEngine& engine, double time);
    void step_by(double length, double end);
    void finish_step(EventEngine& engine);
    void answer_impact(EventEngine& engine, const Event& impact);
    [[nodiscard]] std::vector<Blow> blows_of(const EventEngine& engine, int a, int b) const;
    void take_blow(const Blow& blow);
    void take_in(EventEngine& engine, const std::vector<int>& bodies, Change change);
    void take_in_all_near(EventEngine& engine);
    void let_go_of_the_clear(EventEngine& engine);
    void follow_sleep(EventEngine& engine);
    void find_reaches();
    void find_islands();
    void add_to_islands(const std::vector<int>& bodies);
    [[nodiscard]] int island_of(int k);
    void join_islands(int one, int two);
    [[nodiscard]] Aabb way_of(int k) const;
    [[nodiscard]] double greatest_pull(const Vec2& place) const;
    [[nodiscard]] double bow_of(const Flyer& flyer, double from, double left) const;
    [[nodiscard]] bool comes_near(const EventEngine& engine, int body) const;
    [[nodiscard]] bool has_leaning_near(const Aabb& box, const std::vector<char>* but) const;
    [[nodiscard]] double energy(int body, const BodyState& state) const;
    [[nodiscard]] double energy_of_leaning() const;
    [[nodiscard]] double next_end(double time, int halvings) const;
    [[nodiscard]] int halvings_for(const EventEngine& engine, const std::vector<int>& near) const;

    Setting setting_;
    RestEngine rest_;
    std::vector<double> radius_;   // of bounding circles [m]
    std::vector<Hands> hands_;
    std::vector<char> lies_;
    std::vector<char> clear_;      // steps in a row after which a body was clear, no more than counts
    double step_ends_ = 0.0;       // the present step, where some body leans [s]
    bool any_leans_ = false;
    std::vector<int> rests_;       // bodies that the resting integrator has, ascending
    BoxCells reaches_;             // where those that lean may get before the step ends
    BoxCells ways_;                // where those that rest may get within a whole step
    std::vector<BoxCells::Entry> late_ways_; // the same, of those that have come since
    std::vector<int> island_;      // of each body that rests: towards the lowest that it may be connected to
    std::vector<Island> islands_;  // each in the place of its lowest body; workspace
    std::vector<Change> changes_;
    double energy_of_steps_ = 0.0;
    double energy_of_blows_ = 0.0;
    mutable std::optional<RestEngine> glimpse_; // the bodies that lean, between two steps
};

} // namespace flying
