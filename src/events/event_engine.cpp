#include "events/event_engine.hpp"

#include <algorithm>
#include <array>
#include <span>
#include <utility>

#include "events/cell_exit.hpp"
#include "events/disc_blow.hpp"
#include "events/fetch_ahead.hpp"
#include "events/stage_timer.hpp"

namespace flying {

EventEngine::EventEngine(std::vector<EventBody> bodies, const EventEngineOptions& options)
    : options_(options),
      bodies_(std::move(bodies)),
      surfaces_(bodies_),
      rules_(options, bodies_),
      foreseen_(bodies_.count(), options.skips_search)
{
    bounces_.resize(static_cast<std::size_t>(bodies_.count()));
    near_.resize(static_cast<std::size_t>(bodies_.count()) + 1);
    set_up_cells();
    predict_all();
}

EventEngine::Resume EventEngine::resume() const
{
    Resume resume{now_, log_.value(), max_overlap_, {}, energy_lost_, {}, bounces_};
    for (int body = 0; body < body_count(); ++body) {
        resume.crowding.push_back(bodies_.sheet(bodies_.row_of(body)).crowding);
        resume.presence.push_back(presence(body));
    }
    return resume;
}

void EventEngine::go_on_from(const Resume& resume, const std::vector<BodyState>& states)
{
    now_ = resume.time;
    log_ = Hash(resume.log_hash);
    max_overlap_ = resume.max_overlap;
    energy_lost_ = resume.energy_lost;
    bounces_ = resume.bounces;
    for (std::size_t k = 0; k < states.size(); ++k) {
        const int row = bodies_.row_of(static_cast<int>(k));
        if (!bodies_.never_moves(row)) bodies_.put(row, resume.presence[k], states[k]);
    }
    for (int body = 0; body < body_count(); ++body) bodies_.set_crowding(bodies_.row_of(body), resume.crowding[body]);

    // Put the bodies into the cells in which they are by now, and foresee all anew
    foreseen_.clear();
    at_once_.clear();
    set_up_cells();
    predict_all();
}

void EventEngine::place(int body, Presence presence, const BodyState& state)
{
    const int row = bodies_.row_of(body);
    bodies_.put(row, presence, state);
    foreseen_.forget(row);
    bounces_[body] = {};
    if (presence == Presence::away) return;

    // Enter the cells where others look, and look at the bodies there
    if (neighbours_.has_cells()) neighbours_.move(row, neighbours_.cells().cell_at(state.position));
    predict_anew(row);
    if (foreseen_.has_grown()) foreseen_.sweep(bodies_);
}

std::optional<EventFailure> EventEngine::advance(double time, std::int64_t most)
{
    constexpr int k_fast_rows = 4096; // as many as the fast memory holds
    const bool fetches_ahead = neighbours_.has_cells() && body_count() > k_fast_rows;
    noticed_.now = false;
    for (std::int64_t handled = 0; !at_once_.is_empty() || !foreseen_.is_empty();) {
        if (!at_once_.is_empty()) {
            if (handled == most) return std::nullopt;
            const std::vector<Event> impacts = at_once_.take(bodies_);
            if (impacts.empty()) continue;
            ++counts_.events;
            ++handled;
            if (auto failure = handle_impacts(impacts)) return failure;
            if (noticed_.now) return std::nullopt;
            continue;
        }
        const Event event = foreseen_.next();
        if (!(event.time <= time)) break;
        if (handled == most) return std::nullopt;
        foreseen_.pop();
        if (fetches_ahead) fetch_ahead(foreseen_, bodies_, neighbours_.cells());
        // [events.advance.stale]
        if (!bodies_.is_current(event)) {
            ++counts_.stale;
            if (foreseen_.is_called(bodies_, event)) await(ForeseenEvents::owner_of(bodies_, event));
            continue;
        }
        // [events.advance.stale]
        now_ = std::max(now_, event.time);
        if (event.kind == Event::Kind::impact && may_have_company(event)) {
            gather_at_once(event);
            continue;
        }
        ++counts_.events;
        ++handled;
        if (auto failure = handle(event)) return failure;
        if (noticed_.now) return std::nullopt;
    }
    now_ = std::max(now_, time);
    return std::nullopt;
}

std::optional<EventFailure> EventEngine::handle(const Event& event)
{
    switch (event.kind) {
    case Event::Kind::impact:
        return handle_impacts({&event, 1});
    case Event::Kind::look:
    case Event::Kind::later:
        handle_look(event);
        return std::nullopt;
    case Event::Kind::cell:
        handle_cell(event);
        return std::nullopt;
    }
    return std::nullopt;
}

/// Another impact may come at the same moment.
bool EventEngine::may_have_company(const Event& impact)
{
    const double end = end_of_moment(impact.time);
    if (!foreseen_.is_empty() && foreseen_.next().time <= end) return true;
    return impact.owner != Event::Owner::none &&
           foreseen_.waiting(ForeseenEvents::owner_of(bodies_, impact)).has_by(end);
}

/// Take all impacts of the moment of the first one out of the queue. What isn't one goes back.
void EventEngine::gather_at_once(const Event& first)
{
    const double end = end_of_moment(first.time);
    std::vector<Event> impacts{first};
    std::vector<Event> others;
    if (first.owner != Event::Owner::none) await(ForeseenEvents::owner_of(bodies_, first));
    while (!foreseen_.is_empty() && foreseen_.next().time <= end) {
        const Event event = foreseen_.next();
        foreseen_.pop();
        const bool is_called = foreseen_.is_called(bodies_, event);
        if (!bodies_.is_current(event)) {
            ++counts_.stale;
            if (is_called) await(ForeseenEvents::owner_of(bodies_, event));
        } else if (event.kind == Event::Kind::look) {
            ++counts_.events;
            handle_look(event);
        } else if (event.kind == Event::Kind::impact && is_at_once(bodies_, event, first.time)) {
            impacts.insert(std::upper_bound(impacts.begin(), impacts.end(), event, happens_before), event);
            if (is_called) await(ForeseenEvents::owner_of(bodies_, event));
        } else others.push_back(event);
    }
    for (const Event& event : at_once_.put(bodies_, surfaces_, std::move(impacts))) foreseen_.put_back(event);
    for (const Event& event : others) foreseen_.put_back(event);
}

/// One impact, or a group of them that push together.
std::optional<EventFailure> EventEngine::handle_impacts(std::span<const Event> impacts)
{
    using Kind = BodyRows::Kind;
    noticed_.now = noticed_.all;
    for (const Event& impact : impacts) {
        const bool lies = bodies_[bodies_.row_of(impact.a)].kind == Kind::lies ||
                          bodies_[bodies_.row_of(impact.b)].kind == Kind::lies;
        noticed_.now = noticed_.now || lies;
    }
    noticed_.impacts.assign(impacts.begin(), impacts.end());
    const bool is_alone = impacts.size() == 1;
    std::optional<EventFailure> failure;
    if (!is_alone || !strike_discs(impacts[0])) failure = strike(impacts);
    if (failure && is_alone) return failure;

    // [events.impact.foresee]
    Predictor predictor = this->predictor();
    if (is_alone) {
        const int a = bodies_.row_of(impacts[0].a);
        const int b = bodies_.row_of(impacts[0].b);
        predict_after_impact(predictor, a, -1);
        predict_after_impact(predictor, b, bodies_.is_fixed(a) ? -1 : a);
    } else predict_after_impacts(predictor, impacts);
    if (foreseen_.has_grown()) foreseen_.sweep(bodies_);
    if (neighbours_.has_cells() && counts_.cells > line_up_at_) line_up_again();
    // [events.impact.foresee]
    return failure;
}

/// Let two plain discs strike each other. False, and nothing done, where they are anything else.
bool EventEngine::strike_discs(const Event& event)
{
    if (!rules_.is_plain) return false;
    const int a = bodies_.row_of(event.a);
    const int b = bodies_.row_of(event.b);
    const StageTimer timer(options_.seconds, seconds_.impact);
    const std::optional<DiscBlow> blow = blow_of_discs(bodies_, a, b, event.time);
    if (!blow) return false;
    const auto write = [&](int body, const Vec2& position, const Vec2& velocity) {
        const Vec2& before = bodies_[body].velocity;
        energy_lost_ -= 0.5 * ((velocity - before).dot(velocity + before) / bodies_.sheet(body).inertia.inv_mass);
        bodies_.set_motion(body, position, event.time, velocity);
        bodies_.set_crowding(body, 0);
        foreseen_.forget(body);
    };
    write(a, blow->position_a, blow->velocity_a);
    write(b, blow->position_b, blow->velocity_b);
    max_overlap_ = std::max(max_overlap_, blow->overlap);
    ++counts_.impacts;
    log_impact(event, a, b);
    return true;
}

/// Impacts in a row, without room between them, after which a pair that sinks is crowded.
constexpr int k_sinking = 16;

/// Let any bodies strike each other.
std::optional<EventFailure> EventEngine::strike(std::span<const Event> impacts)
{
    if (encounters_.size() < impacts.size()) encounters_.resize(impacts.size());
    const std::span<Encounter> encounters(encounters_.data(), impacts.size());
    bool ended = true;
    {
        const StageTimer timer(options_.seconds, seconds_.impact);
        if (const Event* lost = meet(bodies_, surfaces_, impacts, encounters)) {
            return EventFailure{EventFailure::Kind::spun_out, lost->time, lost->a, lost->b};
        }
        for (Encounter& one : encounters) {
            max_overlap_ = std::max(max_overlap_, one.meeting.overlap);
            const bool has_room = judge_room(bodies_, options_.shortest_bounce, one);
            count_crowding(one.a, has_room);
            count_crowding(one.b, has_room);
        }
        push_apart(bodies_, encounters, push_);
        for (const Push::Motion& after : push_.motions) {
            energy_lost_ -= bodies_.energy_change(after.row, after.velocity, after.spin);
            set_motion(after.row, after.velocity, after.spin);
        }
        counts_.impacts += push_.impacts;
        ended = push_.ended;
        for (Encounter& one : encounters) {
            log_impact(one.impact, one.a, one.b);
            if (!options_.ends_bounces) continue;
            if (rules_.falls) {
                one.bounces_end = end_of_bounces(bodies_, one.a, one.b, one.meeting, one.impact.time, bounces_);
            }
            one.stays = stays(bodies_, one.a, one.b, one.meeting);
        }
    }
    for (const Encounter& one : encounters) {
        if (auto failure = failure_of(one, ended)) return failure;
    }
    return std::nullopt;
}

/// Where an impact ends what can be told by impacts.
/// ended  its bodies no longer approach
std::optional<EventFailure> EventEngine::failure_of(const Encounter& one, bool ended) const
{
    const auto fail = [&](EventFailure::Kind kind) {
        return EventFailure{kind, one.impact.time, one.impact.a, one.impact.b, one.bounces_end.value_or(0.0)};
    };
    if (!ended) return fail(EventFailure::Kind::unresolved);
    if (one.bounces_end) return fail(EventFailure::Kind::settled);
    if (one.stays) return fail(EventFailure::Kind::stays);

    const int crowding_a = bodies_.is_fixed(one.a) ? 0 : bodies_.sheet(one.a).crowding;
    const int crowding_b = bodies_.is_fixed(one.b) ? 0 : bodies_.sheet(one.b).crowding;
    const int crowding = std::max(crowding_a, crowding_b);
    const int most = one.sinks ? k_sinking : options_.most_crowded;
    if (crowding <= most) return std::nullopt;
    if (one.has_room && !one.sinks && crowding - most <= bounces_by_masses(bodies_)) return std::nullopt;
    return fail(EventFailure::Kind::crowded);
}

void EventEngine::count_crowding(int body, bool has_room)
{
    bodies_.set_crowding(body, has_room ? 0 : bodies_.sheet(body).crowding + 1);
}

/// New velocities, which make all that was foreseen of the body stale.
void EventEngine::set_motion(int body, const Vec2& velocity, double spin)
{
    bodies_.set_motion(body, velocity, spin);
    foreseen_.forget(body);
}

void EventEngine::log_impact(const Event& event, int row_a, int row_b)
{
    log_.add(static_cast<std::uint64_t>(event.a) << 32 | static_cast<std::uint32_t>(event.b));
    const BodyRows::Row& a = bodies_[row_a];
    const BodyRows::Row& b = bodies_[row_b];
    const BodyRows::Sheet& more_a = bodies_.sheet(row_a);
    const BodyRows::Sheet& more_b = bodies_.sheet(row_b);
    log_.add(std::array{event.time, a.position.x(), a.position.y(), a.velocity.x(), a.velocity.y(), more_a.angle,
                        more_a.spin, b.position.x(), b.position.y(), b.velocity.x(), b.velocity.y(), more_b.angle,
                        more_b.spin});
}

void EventEngine::handle_look(const Event& event)
{
    const StageTimer timer(options_.seconds, seconds_.look);
    ++counts_.looks;
    const int a = bodies_.row_of(event.a);
    const int b = bodies_.row_of(event.b);
    if (event.kind == Event::Kind::later) predictor().look_later(a, b);
    else predictor().look(a, b, event.time);
    if (event.owner == Event::Owner::none) foreseen_.call_all();
    else await(ForeseenEvents::owner_of(bodies_, event));
}

void EventEngine::handle_cell(const Event& event)
{
    const StageTimer timer(options_.seconds, seconds_.cells);
    ++counts_.cells;
    const int body = bodies_.row_of(event.a);
    const Cell from = neighbours_.cells().cell_of(body);
    const Cell step = step_over(-1 - event.b);
    const Cell to{from.column + step.column, from.row + step.row};
    neighbours_.move(body, to);

    // [events.handle_cell.new]
    // Look at the bodies that were too far away until now, in the three cells ahead
    Predictor predictor = this->predictor();
    const Grid& cells = neighbours_.cells();
    const auto look = [&](int other) {
        if (other == body || foreseen_.will_look(bodies_[body], bodies_[other], event.time)) return;
        predictor.predict_pair(body, other);
    };
    for (const Cell& cell : cells_ahead(from, step)) cells.for_each_in(cell, look);
    const std::span<const int> known = cells.statics_near(from);
    for (const int other : cells.statics_near(to)) {
        if (std::find(known.begin(), known.end(), other) == known.end()) look(other);
    }
    predictor.predict_cell(body, event.time);
    await(body);
    // [events.handle_cell.new]
}

/// Cells for the bodies as they are now, and the rows in their order.
void EventEngine::set_up_cells()
{
    neighbours_ = {};
    if (options_.pair_finder != PairFinder::grid) return;
    if (bodies_.is_central()) return; // when a curved flight leaves its cell is not foreseen: look at all pairs
    neighbours_ = Neighbours(bodies_, now_);
    if (!neighbours_.has_cells()) return;
    line_up(neighbours_.order_along_curve(bodies_, now_));
    neighbours_.enter(bodies_, now_);
}

/// As BodyRows::line_up.
void EventEngine::line_up(const std::vector<int>& old_rows)
{
    bodies_.line_up(old_rows);
    foreseen_.line_up(old_rows);

    // By the time bodies have crossed so many cells, neighbours are no longer the same
    constexpr std::int64_t k_cells_a_body = 16;
    line_up_at_ = counts_.cells + k_cells_a_body * body_count();
}

void EventEngine::line_up_again()
{
    const std::vector<int> order = neighbours_.order_along_curve(bodies_);
    line_up(order);
    neighbours_.line_up(bodies_, order);
}

Predictor EventEngine::predictor()
{
    return {{rules_, bodies_, neighbours_, surfaces_}, near_, foreseen_, counts_};
}

void EventEngine::predict_all()
{
    const StageTimer timer(options_.seconds, seconds_.predict);
    Predictor predictor = this->predictor();
    for (int a = 0; a < body_count(); ++a) {
        if (bodies_.is_fixed(a)) {
            predictor.predict_static(a);
            foreseen_.call_all();
            continue;
        }
        predictor.predict_cell(a, std::max(now_, bodies_[a].time));
        predictor.predict_partners(a, [&](int other) { return other > a || bodies_.is_fixed(other); });
        await(a);
    }
    foreseen_.sweep(bodies_);
}

void EventEngine::predict_after_impact(Predictor& predictor, int body, int partner)
{
    if (bodies_.is_fixed(body)) return;
    const StageTimer timer(options_.seconds, seconds_.predict);
    predictor.predict_cell(body, bodies_[body].time);
    predictor.predict_struck(body, partner);
    await(body);
}

/// The same for all bodies of a group, each pair of them once.
void EventEngine::predict_after_impacts(Predictor& predictor, std::span<const Event> impacts)
{
    const StageTimer timer(options_.seconds, seconds_.predict);
    std::vector<int> struck;
    for (const Event& impact : impacts) {
        for (const int body : {bodies_.row_of(impact.a), bodies_.row_of(impact.b)}) {
            if (!bodies_.is_fixed(body)) struck.push_back(body);
        }
    }
    std::sort(struck.begin(), struck.end());
    struck.erase(std::unique(struck.begin(), struck.end()), struck.end());
    for (const int body : struck) {
        const auto is_left = [&](int other) {
            return other > body || !std::binary_search(struck.begin(), struck.end(), other);
        };
        predictor.predict_cell(body, bodies_[body].time);
        predictor.predict_partners(body, is_left);
        await(body);
    }
}

/// Foresee all of a body that has just been put where it is.
void EventEngine::predict_anew(int body)
{
    const StageTimer timer(options_.seconds, seconds_.predict);
    Predictor predictor = this->predictor();
    if (!bodies_.is_fixed(body)) predictor.predict_cell(body, now_);
    predictor.predict_partners(body, [](int) { return true; });
    await(body);
}

} // namespace flying
