#include "world/hybrid.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "math/tolerance.hpp"
#include "rest/stopwatch.hpp"
#include "world/leaning.hpp"
#include "world/reach_in_step.hpp"
#include "world/step_length.hpp"

namespace flying {
namespace {

/// [roundings] A step that ends this little after a moment ends there.
constexpr double k_same_moment = 4.0;

/// [steps] A body that will touch nothing for so long may be let go.
constexpr double k_ahead = 2.0;
/// Steps in a row after which it must be so.
constexpr char k_clear_steps = 2;

/// Whether a failure is one that ends by giving the bodies to the resting integrator.
[[nodiscard]] bool is_taken(const EventFailure& failure)
{
    return failure.kind != EventFailure::Kind::spun_out;
}

[[nodiscard]] Hybrid::Change::Why reason_of(EventFailure::Kind kind)
{
    switch (kind) {
    case EventFailure::Kind::settled:
        return Hybrid::Change::Why::settled;
    case EventFailure::Kind::unresolved:
        return Hybrid::Change::Why::unresolved;
    case EventFailure::Kind::stays:
        return Hybrid::Change::Why::stays;
    default:
        return Hybrid::Change::Why::crowded;
    }
}

} // namespace

Hybrid::Hybrid(EventEngine engine, std::vector<Material> materials, const Setting& setting)
    : setting_(setting), flying_(std::move(engine)), materials_(std::move(materials))
{
    std::vector<BodyMover> movers;
    for (int k = 0; k < flying_.body_count(); ++k) {
        radius_.push_back(bounding_radius(flying_.shape(k)));
        movers.push_back(flying_.is_static(k) ? BodyMover::none : BodyMover::events);
    }
    clear_.assign(movers.size(), 0);
    movers_ = Movers(std::move(movers));
}

void Hybrid::begin()
{
    const bool is_central = std::holds_alternative<CentralField>(setting_.field);
    const bool any_field = is_central || uniform_acceleration(setting_.field) != Vec2::Zero();
    std::vector<int> first;
    if (setting_.policy == EngineChoice::rest) {
        const std::span<const int> all = movers_.list(BodyMover::events);
        first.assign(all.begin(), all.end());
    } else if (setting_.policy == EngineChoice::automatic && any_field) first = find_leaning(flying_, setting_.field);
    if (first.empty()) return;
    set_up_resting();
    Change change;
    change.why = Change::Why::leaning;
    take_in(first, change);
    if (setting_.policy == EngineChoice::rest) changes_.clear(); // none was there before
    take_in_all_near();
}

/// The resting integrator, from now on beside the other: it has no body yet.
void Hybrid::set_up_resting()
{
    if (resting_) return;
    RestOptions options;
    options.step = setting_.step;
    options.sleeps = setting_.sleeps;
    options.warm_starts = setting_.warm_starts;
    options.seconds = seconds_;
    if (const auto* central = std::get_if<CentralField>(&setting_.field)) options.centre = *central;
    std::vector<RestBody> bodies;
    for (int k = 0; k < flying_.body_count(); ++k) {
        const bool moves = movers_.of(k) != BodyMover::none;
        const Vec2 gravity = moves ? uniform_acceleration(setting_.field) : Vec2(Vec2::Zero());
        bodies.push_back(
            {flying_.shape(k), flying_.flyer(k).state, flying_.inertia(k), materials_[k], gravity, !moves, !moves});
    }
    resting_.emplace(std::move(bodies), options, flying_.time());
}

void Hybrid::set_stopwatch(double (*seconds)())
{
    seconds_ = seconds;
    flying_.set_clock(seconds);
    if (resting_) resting_->set_clock(seconds);
}

std::optional<EventFailure> Hybrid::advance(double time, std::int64_t most)
{
    for (std::int64_t done = 0;;) {
        const double last = time + k_same_moment * tolerance::k_epsilon * std::abs(time);
        const bool steps = step_ends_ && *step_ends_ <= last;

        // A step whose end the events have reached is made whatever the count says: the clock has got there
        const bool is_due = steps && flying_.time() >= *step_ends_;
        if (most >= 0 && done >= most && !is_due) break;

        // Handle what comes before, one impact at a time where it may throw a body among those that lean
        flying_.notice_all(step_ends_.has_value());
        const std::int64_t before = flying_.counts().events;
        const auto failure = flying_.advance(steps ? *step_ends_ : time, most < 0 || is_due ? -1 : most - done);
        done += flying_.counts().events - before;
        if (failure && (setting_.policy != EngineChoice::automatic || !is_taken(*failure))) {
            clock_ = failure->time;
            return failure;
        }
        if (failure) take(*failure);
        else if (flying_.noticed()) answer_impacts(flying_.last_impacts());
        else if (!steps) break;
        else if (flying_.time() >= *step_ends_) {
            finish_step();
            ++done;
        }
    }
    clock_ = std::max(clock_, most < 0 ? time : std::min(time, flying_.time()));
    return std::nullopt;
}

void Hybrid::finish_step()
{
    step_by(step_length(), *step_ends_);
    Stopwatch watch(seconds_);
    follow_sleep();
    if (ends_whole_step(setting_.step, *step_ends_)) let_go_of_the_clear();
    take_in_all_near();
    watch.stop(seconds_between_steps_);
}

/// Bring those that lean to a moment within their step.
void Hybrid::cut(double time)
{
    if (step_ends_ && time > resting_->time()) {
        step_by(time - resting_->time(), time);
        follow_sleep();
    }
    if (!step_ends_) resting_->set_time(time);
}

void Hybrid::step_by(double length, double end)
{
    within_.clear();
    resting_->step_by(length, end);
    double change = 0.0;
    resting_->for_each_moved([&](int body, const BodyState& before) {
        change += energy(body, resting_->state(body)) - energy(body, before);
    });
    energy_of_steps_ += change;
}

/// Of the present step.  [s]
double Hybrid::step_length() const
{
    return length_of_step(setting_.step, resting_->time(), *step_ends_);
}

void Hybrid::answer_impacts(std::span<const Event> impacts)
{
    // A body that slept and was struck wakes, and all that it touches
    const double time = impacts.front().time;
    if (const std::vector<Blow> blows = blows_of(impacts); !blows.empty()) {
        cut(time);
        for (const Blow& blow : blows) take_blow(blow);
        follow_sleep();
        take_in_all_near();
        return;
    }

    // A body that was thrown towards those that lean joins them
    for (const Event& impact : impacts) {
        for (const int body : {impact.a, impact.b}) {
            if (movers_.of(body) != BodyMover::events || !comes_near(body)) continue;
            cut(time);
            take_in_all_near();
            return;
        }
    }
}

// [hybrid.blows_of]
/// What the event engine has just given to those that slept, of all that impacts struck at one moment.
std::vector<Hybrid::Blow> Hybrid::blows_of(std::span<const Event> impacts) const
{
    std::vector<Blow> blows;
    for (const Event& impact : impacts) {
        for (const int body : {impact.a, impact.b}) {
            const auto is_same = [&](const Blow& blow) { return blow.body == body; };
            if (movers_.of(body) != BodyMover::asleep || std::any_of(blows.begin(), blows.end(), is_same)) continue;
            blows.push_back({body, flying_.flyer(body).state});
        }
    }
    return blows;
}
// [hybrid.blows_of]

void Hybrid::take_blow(const Blow& blow)
{
    // The event engine took note of what it gave to a body that lay still; by now others may have moved it
    const int body = blow.body;
    BodyState still = blow.state;
    still.velocity = Vec2::Zero();
    still.spin = 0.0;
    const double noted = energy(body, blow.state) - energy(body, still);
    const BodyState old = resting_->state(body);
    BodyState state = old;
    state.velocity += blow.state.velocity;
    state.spin += blow.state.spin;
    energy_of_blows_ += (energy(body, state) - energy(body, old)) - noted;
    movers_.give(std::span(&body, 1), BodyMover::rest);
    others_sleep_ = true;
    within_.clear();
    resting_->set_state(body, state);
}

/// Take the two bodies of a failure, and those near them.
void Hybrid::take(const EventFailure& failure)
{
    set_up_resting();
    const std::vector<Blow> blows = blows_of(flying_.last_impacts());
    cut(failure.time);
    for (const Blow& blow : blows) take_blow(blow);
    std::vector<int> bodies;
    for (const int body : {failure.a, failure.b}) {
        if (movers_.of(body) == BodyMover::events) bodies.push_back(body);
    }
    Change change;
    change.why = reason_of(failure.kind);
    change.a = failure.a;
    change.b = failure.b;
    change.bounces_end = failure.bounces_end;
    take_in(bodies, change);
    follow_sleep();
    take_in_all_near();
}

void Hybrid::take_in(const std::vector<int>& bodies, Change change)
{
    if (bodies.empty()) return;
    const double time = resting_->time();
    change.time = time;
    change.bodies = bodies;
    for (const int body : bodies) {
        const BodyState state = state_at(flying_.flyer(body), time);
        change.energy_before += energy(body, state);
        flying_.place(body, EventEngine::Presence::away, state);
        resting_->set_active(body, true);
        resting_->set_state(body, state);
        change.energy_after += energy(body, resting_->state(body));
        clear_[body] = 0;
    }
    movers_.give(bodies, BodyMover::rest);
    within_.clear();
    changes_.push_back(std::move(change));
}

/// Take in every body that may meet one that leans before the step ends, and say when that is.
void Hybrid::take_in_all_near()
{
    step_ends_.reset();
    if (!any_leans()) return;
    if (setting_.policy == EngineChoice::rest) {
        step_ends_ = next_end(setting_.step, resting_->time(), 0);
        return;
    }
    begin_hand_over();
    const StepPlan plan = plan_step(start_of_step(), hand_over_);
    step_ends_ = plan.end;
    for (const std::vector<int>& near : plan.taken) {
        Change change;
        change.why = Change::Why::near;
        take_in(near, change);
    }
}

StepStart Hybrid::start_of_step() const
{
    return {flying_, *resting_, movers_, radius_, setting_.field, setting_.step};
}

/// Tell the rules of handing over of those that lean; of those that sleep only where others slept before.
void Hybrid::begin_hand_over()
{
    const StepStart start = start_of_step();
    if (others_sleep_) hand_over_.set_asleep(leaning_among(movers_.list(BodyMover::asleep), start));
    others_sleep_ = false;
    hand_over_.begin(leaning_among(movers_.list(BodyMover::rest), start));
}

/// A flight leads, before the step ends, to where a body that leans may be.
bool Hybrid::comes_near(int body) const
{
    if (!step_ends_ || setting_.policy == EngineChoice::rest) return false;
    const Aabb box = flight_box(flying_.flyer(body), radius_[body], flying_.time(), *step_ends_);
    return !std::isfinite(box.max.x()) || hand_over_.is_near(box);
}

/// There is a body that steps are for.
bool Hybrid::any_leans() const
{
    return !movers_.list(BodyMover::rest).empty() || (!setting_.sleeps && !movers_.list(BodyMover::asleep).empty());
}

void Hybrid::let_go_of_the_clear()
{
    if (setting_.policy == EngineChoice::rest) return;

    // Find what bears no load and stays alone, for the second time
    const std::vector<int> clear = resting_->find_clear(k_ahead * setting_.step);
    std::vector<int> may_go;
    for (const int k : movers_.list(BodyMover::rest)) {
        const bool is_clear = std::binary_search(clear.begin(), clear.end(), k);
        clear_[k] = is_clear ? std::min<char>(k_clear_steps, static_cast<char>(clear_[k] + 1)) : 0;
        if (clear_[k] == k_clear_steps) may_go.push_back(k);
    }
    if (may_go.empty()) return;

    // What would be taken in again by one that stays, stays
    begin_hand_over();
    hand_over_.reach(next_end(setting_.step, resting_->time(), 0) - resting_->time());
    const std::vector<int> going = hand_over_.may_leave(may_go);
    if (going.empty()) return;

    Change change;
    change.why = Change::Why::free;
    change.time = resting_->time();
    change.bodies = going;
    for (const int body : going) {
        const BodyState state = resting_->state(body);
        change.energy_before += energy(body, state);
        resting_->set_active(body, false);
        clear_[body] = 0;
    }
    movers_.give(going, BodyMover::events);
    for (const int body : going) {
        flying_.place(body, EventEngine::Presence::flies, resting_->state(body));
        change.energy_after += energy(body, flying_.flyer(body).state);
    }
    changes_.push_back(std::move(change));
}

/// Tell the event engine what has fallen asleep, and what has woken.
void Hybrid::follow_sleep()
{
    // Find them among those that were awake, and those that are
    std::vector<int> bodies;
    std::vector<int> asleep;
    std::vector<int> woken;
    for (const int k : movers_.list(BodyMover::rest)) {
        bodies.push_back(k);
        if (resting_->is_asleep(k)) asleep.push_back(k);
    }
    resting_->for_each_awake([&](int k) {
        if (movers_.of(k) == BodyMover::asleep) woken.push_back(k);
    });
    bodies.insert(bodies.end(), woken.begin(), woken.end());
    std::sort(bodies.begin(), bodies.end());
    for (const int k : bodies) {
        const auto presence = resting_->is_asleep(k) ? EventEngine::Presence::lies : EventEngine::Presence::away;
        if (flying_.presence(k) != presence) flying_.place(k, presence, resting_->state(k));
    }
    for (const int k : asleep) clear_[k] = 0;
    movers_.give(asleep, BodyMover::asleep);
    movers_.give(woken, BodyMover::rest);
    others_sleep_ = others_sleep_ || !asleep.empty() || !woken.empty();
    if (!any_leans()) step_ends_.reset();
}

bool Hybrid::is_within_step(int body) const
{
    const BodyMover mover = movers_.of(body);
    const bool leans = mover == BodyMover::rest || mover == BodyMover::asleep; // a step may wake it
    return leans && step_end().has_value();
}

std::optional<double> Hybrid::step_end() const
{
    const bool is_under_way =
        step_ends_ && clock_ - resting_->time() > k_same_moment * tolerance::k_epsilon * std::abs(clock_);
    return is_under_way ? step_ends_ : std::nullopt;
}

BodyState Hybrid::state(int body)
{
    if (movers_.of(body) == BodyMover::none || movers_.of(body) == BodyMover::events) {
        return state_at(flying_.flyer(body), clock_);
    }
    const double since = clock_ - resting_->time();
    const bool is_within = is_within_step(body);
    if (is_within && (within_.empty() || since != within_at_)) {
        within_ = resting_->foresee(step_length(), *step_ends_, since);
        within_at_ = since;
    }
    BodyState state = is_within && within_[body] ? *within_[body] : resting_->state(body);
    state.time = clock_;
    return state;
}

Hybrid::Memory Hybrid::memory() const
{
    Memory memory{flying_.resume(), {}, movers_.all(), clear_, step_ends_.value_or(0.0), energy_of_steps_,
                  energy_of_blows_};
    if (resting_) memory.resting = resting_->memory();
    return memory;
}

void Hybrid::go_on_from(const Memory& memory, const std::vector<BodyState>& flights, double clock)
{
    flying_.go_on_from(memory.flying, flights);
    clock_ = clock;
    energy_of_steps_ = memory.energy_of_steps;
    energy_of_blows_ = memory.energy_of_blows;
    if (!memory.resting) return;
    movers_ = Movers(memory.movers);
    others_sleep_ = true;
    clear_ = memory.clear;
    set_up_resting();
    resting_->go_on_from(*memory.resting);
    if (!any_leans()) return;
    step_ends_ = memory.step_ends;
    begin_hand_over();
    hand_over_.reach(*step_ends_ - resting_->time());
}

double Hybrid::energy(int body, const BodyState& state) const
{
    const Inertia& inertia = flying_.inertia(body);
    if (inertia.inv_mass == 0.0) return 0.0;
    const double shift = state.velocity.squaredNorm() / inertia.inv_mass;
    const double turn = state.spin * state.spin / inertia.inv_moment_of_inertia;
    return 0.5 * (shift + turn) + potential_at(setting_.field, state.position) / inertia.inv_mass;
}

} // namespace flying
