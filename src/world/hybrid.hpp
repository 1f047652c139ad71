#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "events/event_engine.hpp"
#include "motion/field.hpp"
#include "rest/rest_engine.hpp"
#include "world/hand_over.hpp"
#include "world/movers.hpp"
#include "world/policy.hpp"
#include "world/report.hpp"
#include "world/step_plan.hpp"

namespace flying {

/// Two integrators, one world. Every body that moves is in the hands of one of them (BodyMover):
///
///     events  the event engine's: moved from impact to impact
///     rest    the resting integrator's, and awake: moved by steps, to whose ends both engines come
///     asleep  the resting integrator's, and asleep: to the event engine a thing that stays where it is, until it is
///             struck; the impact is located and answered like any other, and its group wakes
///
/// Steps end at whole multiples of the step's length, and where a body changes hands between two of them. A body that
/// might meet one that leans before the step ends is taken in at its start; one that bears no load and will touch
/// nothing for two steps is let go. So the two never meet anywhere else, and what happens does not depend on when
/// it is looked at. Where the user chose one integrator for all, no body ever changes hands.
class Hybrid
{
public:
    /// What is the same for the whole run.
    struct Setting
    {
        EngineChoice policy = EngineChoice::automatic;
        double step = 1.0 / 60.0; ///< [s]
        Field field = NoField{};
        bool sleeps = true;
        bool warm_starts = true;
    };

    /// A hand-over before the scene gives it its words.
    struct Change
    {
        enum class Why
        {
            leaning,
            crowded,
            settled,
            stays,
            unresolved,
            near,
            free
        };
        Why why = Why::crowded;
        double time = 0.0; ///< when it happened [s]
        std::vector<int> bodies;
        int a = -1; ///< the pair whose impact led to it, where one did
        int b = -1;
        double bounces_end = 0.0; ///< of bounces that died away [s]
        double energy_before = 0.0;
        double energy_after = 0.0;
    };

    /// engine     whose bodies all fly
    /// materials  of the same bodies
    Hybrid(EventEngine engine, std::vector<Material> materials, const Setting& setting);

    /// Give to the resting integrator what is its from the start.
    void begin();

    /// As EventEngine::advance; steps count as events.
    [[nodiscard]] std::optional<EventFailure> advance(double time, std::int64_t most);

    /// The moment last asked for, or at which a run stopped early.  [s]
    [[nodiscard]] double clock() const { return clock_; }
    /// A body at the clock. Between the ends of a step, a body that leans is asked on the way on which the step leads
    /// it; should a blow end the step before, after the clock, it will have gone the way of the shorter step.
    [[nodiscard]] BodyState state(int body);
    [[nodiscard]] BodyMover mover(int body) const { return movers_.of(body); }
    /// The clock stands between the ends of a step that moves the body.
    [[nodiscard]] bool is_within_step(int body) const;
    /// The end of the step that the clock stands within; none where no step is under way.  [s]
    [[nodiscard]] std::optional<double> step_end() const;

    [[nodiscard]] const EventEngine& flying() const { return flying_; }
    /// Null as long as no body ever leant on anything.
    [[nodiscard]] const RestEngine* resting() const { return resting_ ? &*resting_ : nullptr; }
    [[nodiscard]] const Setting& setting() const { return setting_; }
    void set_stopwatch(double (*seconds)());
    /// Spent between steps to find out which bodies change hands, where a clock was lent.
    [[nodiscard]] double seconds_between_steps() const { return seconds_between_steps_; }
    /// Hand-overs since they were last fetched.
    [[nodiscard]] std::vector<Change> fetch_changes() { return std::exchange(changes_, {}); }
    /// What the resting integrator's steps have changed of the energy.  [J]
    [[nodiscard]] double energy_of_steps() const { return energy_of_steps_; }
    /// What blows to sleeping bodies changed of the energy beyond what the event engine took note of.  [J]
    [[nodiscard]] double energy_of_blows() const { return energy_of_blows_; }

    /// All that a later run needs to go on with the same bits, beside the event engine's states of bodies.
    struct Memory
    {
        EventEngine::Resume flying;
        std::optional<RestEngine::Memory> resting; ///< where any body ever leant on anything
        std::vector<BodyMover> movers;
        std::vector<char> clear;
        double step_ends = 0.0;
        double energy_of_steps = 0.0;
        double energy_of_blows = 0.0;
    };
    [[nodiscard]] Memory memory() const;
    /// flights  of the first bodies, those that the event engine last knew of
    void go_on_from(const Memory& memory, const std::vector<BodyState>& flights, double clock);

private:
    /// What an impact gave to a body that slept: its state, had nothing else moved it.
    struct Blow
    {
        int body = -1;
        BodyState state;
    };

    void set_up_resting();
    void cut(double time);
    void step_by(double length, double end);
    void finish_step();
    void answer_impacts(std::span<const Event> impacts);
    [[nodiscard]] std::vector<Blow> blows_of(std::span<const Event> impacts) const;
    void take_blow(const Blow& blow);
    void take(const EventFailure& failure);
    void take_in(const std::vector<int>& bodies, Change change);
    void take_in_all_near();
    void let_go_of_the_clear();
    void follow_sleep();
    [[nodiscard]] bool any_leans() const;
    [[nodiscard]] StepStart start_of_step() const;
    void begin_hand_over();
    [[nodiscard]] bool comes_near(int body) const;
    [[nodiscard]] double energy(int body, const BodyState& state) const;
    [[nodiscard]] double step_length() const;

    Setting setting_;
    double (*seconds_)() = nullptr;      // a clock, lent; or null
    double seconds_between_steps_ = 0.0; // spent on which integrator has which body
    double clock_ = 0.0;                 // [s]
    EventEngine flying_;
    std::optional<RestEngine> resting_;
    std::vector<Material> materials_;
    std::vector<double> radius_; // of bounding circles [m]
    Movers movers_;
    std::vector<char> clear_;         // steps in a row after which a body was clear, no more than counts
    std::optional<double> step_ends_; // the present step, where some body leans that is awake [s]
    HandOver hand_over_;
    bool others_sleep_ = true; // than it knows
    std::vector<Change> changes_;
    double energy_of_steps_ = 0.0;
    double energy_of_blows_ = 0.0;
    std::vector<std::optional<BodyState>> within_; // the present step, where it was looked into; else empty
    double within_at_ = 0.0;                       // since it began [s]
};

} // namespace flying
