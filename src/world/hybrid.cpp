#include "world/hybrid.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "math/tolerance.hpp"

namespace flying {
namespace {

/// [steps] A step that would be shorter is joined to the next.
constexpr double k_shortest = 0x1p-20;

/// [roundings] A step that ends this little after a moment ends there.
constexpr double k_same_moment = 4.0;

/// [sizes] The way of a body in one step: no more, if few enough halvings of the step do it.
constexpr double k_way = 0x1p-2;
constexpr int k_most_halvings = 10;

/// [steps] A body that will touch nothing for so long may be let go.
constexpr double k_ahead = 2.0;
/// Steps in a row after which it must be so.
constexpr char k_clear_steps = 2;

[[nodiscard]] std::vector<RestBody> as_rest_bodies(const EventEngine& engine, const std::vector<Material>& materials,
                                                   const std::vector<char>& is_static, const Field& field)
{
    const Vec2 gravity = uniform_acceleration(field);
    std::vector<RestBody> bodies;
    for (int k = 0; k < engine.body_count(); ++k) {
        const bool moves = is_static[k] == 0;
        bodies.push_back({engine.shape(k), engine.flyer(k).state, engine.inertia(k), materials[k],
                          moves ? gravity : Vec2(Vec2::Zero()), !moves, !moves});
    }
    return bodies;
}

[[nodiscard]] RestOptions rest_options(const Hybrid::Setting& setting)
{
    RestOptions options;
    options.step = setting.step;
    if (const auto* central = std::get_if<CentralField>(&setting.field)) options.centre = *central;
    options.seconds = setting.seconds;
    return options;
}

} // namespace

// [hybrid.set_up]
Hybrid::Hybrid(const EventEngine& engine, const std::vector<Material>& materials, const std::vector<char>& is_static,
               const Setting& setting)
    : setting_(setting), rest_(as_rest_bodies(engine, materials, is_static, setting.field), rest_options(setting), engine.time())
{
    for (int k = 0; k < engine.body_count(); ++k) {
        radius_.push_back(bounding_radius(engine.shape(k)));
        hands_.push_back(is_static[k] ? Hands::none : Hands::events);
    }
    lies_.assign(hands_.size(), 0);
    clear_.assign(hands_.size(), 0);
}
// [hybrid.set_up]

// [hybrid.advance]
std::optional<EventFailure> Hybrid::advance(EventEngine& engine, double time, std::int64_t most)
{
    for (std::int64_t done = 0;;) {
        const double last = time + k_same_moment * tolerance::k_epsilon * std::abs(time);
        const bool steps = any_leans_ && step_ends_ <= last;

        // A step whose end the events have reached is made whatever the count says: the clock has got there
        const bool is_due = steps && engine.time() >= step_ends_;
        if (most >= 0 && done >= most && !is_due) return std::nullopt;

        // Handle what comes before, one impact at a time where it may throw a body among those that lean
        engine.notice_all(any_leans_);
        const std::int64_t before = engine.counts().events;
        const auto failure = engine.advance(steps ? step_ends_ : time, most < 0 || is_due ? -1 : most - done);
        done += engine.counts().events - before;
        if (failure && !takes(*failure)) return failure;
        if (failure) take(engine, *failure);
        else if (engine.noticed()) answer_impact(engine, engine.last_impact());
        else if (!steps) return std::nullopt;
        else if (engine.time() >= step_ends_) {
            finish_step(engine);
            ++done;
        }
    }
}

void Hybrid::finish_step(EventEngine& engine)
{
    const double from = rest_.time();
    const double count = std::round(from / setting_.step);
    const bool is_whole = from == count * setting_.step && step_ends_ == (count + 1.0) * setting_.step;
    step_by(is_whole ? setting_.step : step_ends_ - from, step_ends_);
    follow_sleep(engine);
    let_go_of_the_clear(engine);
    take_in_all_near(engine);
}
// [hybrid.advance]

// [hybrid.step]
/// Bring those that lean to a moment within their step.
void Hybrid::cut(EventEngine& engine, double time)
{
    if (any_leans_ && time > rest_.time()) {
        step_by(time - rest_.time(), time);
        follow_sleep(engine);
    }
    if (!any_leans_) rest_.set_time(time);
}

void Hybrid::step_by(double length, double end)
{
    glimpse_.reset();
    const double before = energy_of_leaning();
    rest_.step_by(length, end);
    energy_of_steps_ += energy_of_leaning() - before;
}

/// The first multiple of the step's length, halved so often, after a moment, but for one that is all but reached.
double Hybrid::next_end(double time, int halvings) const
{
    const double h = std::ldexp(setting_.step, -halvings);
    double count = std::floor(time / h) + 1.0;
    while (count * h - time < k_shortest * h) count += 1.0;
    return count * h;
}

/// How often the step must be halved for those that lean, and those near them, to stay within a small part of their size.
int Hybrid::halvings_for(const EventEngine& engine, const std::vector<int>& near) const
{
    const auto* central = std::get_if<CentralField>(&setting_.field);
    double fastest = 0.0; // [sizes/s]
    const auto look = [&](const BodyState& state, int k) {
        double size = radius_[k];
        if (central) size = std::min(size, (state.position - central->centre).norm()); // the field changes as fast
        fastest = std::max(fastest, state.velocity.norm() / size + std::abs(state.spin));
    };
    for (const int k : rests_) {
        if (leans(k)) look(rest_.state(k), k);
    }
    for (const int k : near) look(engine.flyer(k).state, k);
    int halvings = 0;
    for (double way = fastest * setting_.step; way > k_way && halvings < k_most_halvings; way *= 0.5) ++halvings;
    return halvings;
}
// [hybrid.step]

// [hybrid.impact]
void Hybrid::answer_impact(EventEngine& engine, const Event& impact)
{
    // A body that lay and was struck wakes, and all that it touches
    if (const std::vector<Blow> blows = blows_of(engine, impact.a, impact.b); !blows.empty()) {
        cut(engine, impact.time);
        for (const Blow& blow : blows) take_blow(blow);
        follow_sleep(engine);
        take_in_all_near(engine);
        return;
    }

    // A body that was thrown towards those that lean joins them
    for (const int body : {impact.a, impact.b}) {
        if (hands_[body] != Hands::events || !comes_near(engine, body)) continue;
        cut(engine, impact.time);
        take_in_all_near(engine);
        return;
    }
}

/// What the event engine has just given to those of a pair that lay.
std::vector<Hybrid::Blow> Hybrid::blows_of(const EventEngine& engine, int a, int b) const
{
    std::vector<Blow> blows;
    for (const int body : {a, b}) {
        if (lies_[body]) blows.push_back({body, engine.flyer(body).state});
    }
    return blows;
}

void Hybrid::take_blow(const Blow& blow)
{
    // The event engine took note of what it gave to a body that lay still; by now others may have moved it
    const int body = blow.body;
    BodyState resting = blow.state;
    resting.velocity = Vec2::Zero();
    resting.spin = 0.0;
    const double noted = energy(body, blow.state) - energy(body, resting);
    const BodyState old = rest_.state(body);
    BodyState state = old;
    state.velocity += blow.state.velocity;
    state.spin += blow.state.spin;
    energy_of_blows_ += (energy(body, state) - energy(body, old)) - noted;
    lies_[body] = 0;
    glimpse_.reset();
    rest_.set_state(body, state);
}
// [hybrid.impact]

// [hybrid.take]
bool Hybrid::takes(const EventFailure& failure) { return failure.kind != EventFailure::Kind::spun_out; }

void Hybrid::take_leaning(EventEngine& engine, const std::vector<int>& bodies)
{
    Change change;
    change.why = Change::Why::leaning;
    take_in(engine, bodies, change);
    take_in_all_near(engine);
}

void Hybrid::take(EventEngine& engine, const EventFailure& failure)
{
    const std::vector<Blow> blows = blows_of(engine, failure.a, failure.b);
    cut(engine, failure.time);
    for (const Blow& blow : blows) take_blow(blow);
    std::vector<int> bodies;
    for (const int body : {failure.a, failure.b}) {
        if (hands_[body] == Hands::events) bodies.push_back(body);
    }
    Change change;
    change.why = failure.kind == EventFailure::Kind::settled      ? Change::Why::settled
                 : failure.kind == EventFailure::Kind::unresolved ? Change::Why::unresolved
                                                                  : Change::Why::crowded;
    change.a = failure.a;
    change.b = failure.b;
    change.bounces_end = failure.bounces_end;
    take_in(engine, bodies, change);
    follow_sleep(engine);
    take_in_all_near(engine);
}

void Hybrid::take_in(EventEngine& engine, const std::vector<int>& bodies, Change change)
{
    const double time = rest_.time();
    change.time = time;
    change.bodies = bodies;
    for (const int body : bodies) {
        const BodyState state = state_at(engine.flyer(body), time);
        change.energy_before += energy(body, state);
        engine.place(body, EventEngine::Presence::away, state);
        rest_.set_active(body, true);
        rest_.set_state(body, state);
        change.energy_after += energy(body, rest_.state(body));
        hands_[body] = Hands::rest;
        rests_.insert(std::lower_bound(rests_.begin(), rests_.end(), body), body);
        clear_[body] = 0;
    }
    glimpse_.reset();
    if (!bodies.empty()) changes_.push_back(std::move(change));
}

/// Take in every body that may meet one that leans before the step ends, and again those that may meet these.
void Hybrid::take_in_all_near(EventEngine& engine)
{
    any_leans_ = std::any_of(rests_.begin(), rests_.end(), [&](int k) { return leans(k); });
    if (!any_leans_) return;
    int halvings = halvings_for(engine, {});
    find_islands();
    while (true) {
        step_ends_ = next_end(rest_.time(), halvings);
        find_reaches();
        std::vector<int> near;
        for (int k = 0; k < static_cast<int>(hands_.size()); ++k) {
            if (hands_[k] == Hands::events && comes_near(engine, k)) near.push_back(k);
        }
        if (near.empty()) return;

        // Those that come fast need short steps, in which fewer come near
        const int needed = halvings_for(engine, near);
        if (needed > halvings) {
            halvings = needed;
            continue;
        }
        Change change;
        change.why = Change::Why::near;
        take_in(engine, near, change);
        add_to_islands(near);
    }
}
// [hybrid.take]

// [hybrid.let_go]
void Hybrid::let_go_of_the_clear(EventEngine& engine)
{
    // Find who bears no load and stays alone, for the second time
    std::vector<char> may_go;
    rest_.find_clear(k_ahead * setting_.step, may_go);
    bool any = false;
    for (std::size_t k = 0; k < may_go.size(); ++k) {
        clear_[k] = may_go[k] ? std::min<char>(k_clear_steps, static_cast<char>(clear_[k] + 1)) : 0;
        may_go[k] = clear_[k] == k_clear_steps ? 1 : 0;
        any = any || may_go[k];
    }
    if (!any) return;

    // Whoever would be taken in again by one that stays, stays
    step_ends_ = next_end(rest_.time(), 0);
    find_islands();
    find_reaches();
    std::vector<int> going;
    for (bool changed = true; changed;) {
        changed = false;
        going.clear();
        for (const BoxCells::Entry& reach : reaches_.entries()) {
            if (!may_go[reach.body]) continue;
            if (has_leaning_near(reach.box, &may_go)) {
                may_go[reach.body] = 0;
                changed = true;
            } else going.push_back(reach.body);
        }
    }
    if (going.empty()) return;

    Change change;
    change.why = Change::Why::free;
    change.time = rest_.time();
    change.bodies = going;
    for (const int body : going) {
        const BodyState state = rest_.state(body);
        change.energy_before += energy(body, state);
        rest_.set_active(body, false);
        hands_[body] = Hands::events;
        rests_.erase(std::lower_bound(rests_.begin(), rests_.end(), body));
        clear_[body] = 0;
    }
    for (const int body : going) {
        engine.place(body, EventEngine::Presence::flies, rest_.state(body));
        change.energy_after += energy(body, engine.flyer(body).state);
    }
    changes_.push_back(std::move(change));
}
// [hybrid.let_go]

// [hybrid.sleep]
/// Tell the event engine who has fallen asleep, and who has woken.
void Hybrid::follow_sleep(EventEngine& engine)
{
    any_leans_ = false;
    for (const int k : rests_) {
        const bool asleep = rest_.is_asleep(k);
        const bool is_known = engine.presence(k) == (asleep ? EventEngine::Presence::lies : EventEngine::Presence::away);
        if (!is_known) {
            engine.place(k, asleep ? EventEngine::Presence::lies : EventEngine::Presence::away, rest_.state(k));
        }
        lies_[k] = asleep ? 1 : 0;
        any_leans_ = any_leans_ || !asleep;
    }
}
// [hybrid.sleep]

// [hybrid.state]
BodyState Hybrid::state(const EventEngine& engine, int body, double time) const
{
    if (hands_[body] == Hands::events) return state_at(engine.flyer(body), time);
    const double length = time - rest_.time();
    if (!leans(body) || !(length > k_same_moment * tolerance::k_epsilon * std::abs(time))) {
        BodyState state = rest_.state(body);
        state.time = time;
        return state;
    }

    // Part of a step, on a copy: what is asked changes nothing
    if (!glimpse_ || glimpse_->time() != time) {
        glimpse_ = rest_;
        glimpse_->step_by(length, time);
    }
    return glimpse_->state(body);
}
// [hybrid.state]

// [hybrid.energy]
double Hybrid::energy(int body, const BodyState& state) const
{
    const Inertia& inertia = rest_.body(body).inertia;
    if (inertia.inv_mass == 0.0) return 0.0;
    const double shift = state.velocity.squaredNorm() / inertia.inv_mass;
    const double turn = state.spin * state.spin / inertia.inv_moment_of_inertia;
    return 0.5 * (shift + turn) + potential_at(setting_.field, state.position) / inertia.inv_mass;
}

double Hybrid::energy_of_leaning() const
{
    double sum = 0.0;
    for (const int k : rests_) sum += energy(k, rest_.state(k));
    return sum;
}
// [hybrid.energy]

// [hybrid.memory]
Hybrid::Memory Hybrid::memory() const
{
    Memory memory{rest_.memory(), {}, clear_, step_ends_, energy_of_steps_, energy_of_blows_};
    for (const Hands hands : hands_) memory.rests.push_back(hands == Hands::rest ? 1 : 0);
    return memory;
}

void Hybrid::go_on_from(const EventEngine& engine, const Memory& memory)
{
    rest_.go_on_from(memory.rest);
    clear_ = memory.clear;
    energy_of_steps_ = memory.energy_of_steps;
    energy_of_blows_ = memory.energy_of_blows;
    any_leans_ = false;
    for (int k = 0; k < static_cast<int>(hands_.size()); ++k) {
        if (!memory.rests[k]) continue;
        hands_[k] = Hands::rest;
        rests_.push_back(k);
        lies_[k] = engine.presence(k) == EventEngine::Presence::lies ? 1 : 0;
        any_leans_ = any_leans_ || !lies_[k];
    }
    if (!any_leans_) return;
    step_ends_ = memory.step_ends;
    find_islands();
    find_reaches();
}
// [hybrid.memory]

} // namespace flying
