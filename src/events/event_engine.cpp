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
    noticed_ = false;
    for (std::int64_t handled = 0; !foreseen_.is_empty();) {
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
        ++counts_.events;
        ++handled;
        if (auto failure = handle(event)) return failure;
        if (noticed_) return std::nullopt;
    }
    now_ = std::max(now_, time);
    return std::nullopt;
}

std::optional<EventFailure> EventEngine::handle(const Event& event)
{
    switch (event.kind) {
    case Event::Kind::impact:
        return handle_impact(event);
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

std::optional<EventFailure> EventEngine::handle_impact(const Event& event)
{
    using Kind = BodyRows::Kind;
    const int a = bodies_.row_of(event.a);
    const int b = bodies_.row_of(event.b);
    noticed_ = notices_all_ || bodies_[a].kind == Kind::lies || bodies_[b].kind == Kind::lies;
    if (!strike_discs(event, a, b)) {
        if (auto failure = strike(event, a, b)) return failure;
    }

    // [events.impact.foresee]
    Predictor predictor = this->predictor();
    predict_after_impact(predictor, a, -1);
    predict_after_impact(predictor, b, bodies_.is_fixed(a) ? -1 : a);
    if (foreseen_.has_grown()) foreseen_.sweep(bodies_);
    if (neighbours_.has_cells() && counts_.cells > line_up_at_) line_up_again();
    // [events.impact.foresee]
    return std::nullopt;
}

/// Let two plain discs strike each other. False, and nothing done, where they are anything else.
bool EventEngine::strike_discs(const Event& event, int a, int b)
{
    if (!rules_.is_plain) return false;
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

/// Let any two bodies strike each other.
std::optional<EventFailure> EventEngine::strike(const Event& event, int a, int b)
{
    bool ended = true;
    bool stays_on = false;
    bool sinks = false;
    bool has_room = false;
    std::optional<double> bounces_end;
    {
        const StageTimer timer(options_.seconds, seconds_.impact);

        // [events.impact.meet]
        // Bring the two bodies, and no other, to the moment of the impact
        const TimeSinceImpact since = time_since_impact(bodies_, a, b, event.time);
        const bool a_moved = bodies_.move_to(a, event.time);
        const bool b_moved = bodies_.move_to(b, event.time);
        if (bodies_.has_spun_out(a) || bodies_.has_spun_out(b)) {
            return EventFailure{EventFailure::Kind::spun_out, event.time, event.a, event.b};
        }
        find_meeting(bodies_, surfaces_, a, b, event.time, meeting_);
        max_overlap_ = std::max(max_overlap_, meeting_.overlap);
        // [events.impact.meet]

        // [events.impact.crowding]
        // Where neither went anywhere since its last impact, or next to nowhere, or they creep
        // into each other, both are being crowded; a heavy body that hardly moves between the
        // blows of a light one is not
        const bool is_held = since.last() < options_.shortest_bounce && is_cramped(bodies_, a, b, meeting_, since);
        const bool creeps = is_creeping(bodies_, a, b, meeting_);
        has_room = !creeps && (a_moved || b_moved);
        count_crowding(a, has_room && !is_held);
        count_crowding(b, has_room && !is_held);
        // [events.impact.crowding]

        // Each of many impacts at one moment may come late by a rounding. Beyond the tolerance of touching, what has
        // come behind a side would be lost to the search
        const auto is_polygon = [&](int body) { return std::holds_alternative<Polygon>(bodies_.shape_of(body)); };
        const auto is_wall = [&](int body) { return std::holds_alternative<HalfPlane>(bodies_.shape_of(body)); };
        const bool has_sides = (is_polygon(a) && !is_wall(b)) || (is_polygon(b) && !is_wall(a));
        const auto is_deep = [&](const Touch& point) { return point.separation < -0.5 * meeting_.touch; };
        sinks = !has_room && has_sides && std::any_of(meeting_.touches.begin(), meeting_.touches.end(), is_deep);

        // [events.impact.push]
        // Push them apart
        const ImpactResult result =
            resolve_impact({bodies_[a].velocity, bodies_.sheet(a).spin, bodies_.sheet(a).inertia},
                           {bodies_[b].velocity, bodies_.sheet(b).spin, bodies_.sheet(b).inertia}, meeting_.points,
                           combine(bodies_.sheet(a).material, bodies_.sheet(b).material));
        energy_lost_ -= bodies_.energy_change(a, result.velocity_a, result.spin_a);
        energy_lost_ -= bodies_.energy_change(b, result.velocity_b, result.spin_b);
        set_motion(a, result.velocity_a, result.spin_a);
        set_motion(b, result.velocity_b, result.spin_b);
        ended = result.ended;
        if (result.any_push) ++counts_.impacts;
        log_impact(event, a, b);
        // [events.impact.push]
        if (options_.ends_bounces) {
            if (rules_.falls) bounces_end = end_of_bounces(bodies_, a, b, meeting_, event.time, bounces_);
            stays_on = stays(bodies_, a, b, meeting_);
        }
    }
    if (!ended) return EventFailure{EventFailure::Kind::unresolved, event.time, event.a, event.b};
    if (bounces_end) return EventFailure{EventFailure::Kind::settled, event.time, event.a, event.b, *bounces_end};
    if (stays_on) return EventFailure{EventFailure::Kind::stays, event.time, event.a, event.b};

    const int crowding_a = bodies_.is_fixed(a) ? 0 : bodies_.sheet(a).crowding;
    const int crowding_b = bodies_.is_fixed(b) ? 0 : bodies_.sheet(b).crowding;
    const int crowding = std::max(crowding_a, crowding_b);
    const int most = sinks ? k_sinking : options_.most_crowded;
    if (crowding <= most) return std::nullopt;
    if (has_room && !sinks && crowding - most <= bounces_by_masses(bodies_)) return std::nullopt;
    return EventFailure{EventFailure::Kind::crowded, event.time, event.a, event.b};
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
    last_impact_ = event;
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
        if (other != body) predictor.predict_pair(body, other);
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
