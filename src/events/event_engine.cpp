#include "events/event_engine.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "events/stage_timer.hpp"
#include "math/tolerance.hpp"
#include "motion/flight.hpp"
#include "toi/gap_tolerance.hpp"

namespace flying {

EventEngine::EventEngine(std::vector<EventBody> bodies, const EventEngineOptions& options) : options_(options)
{
    for (EventBody& body : bodies) {
        const BodyState& state = body.flyer.state;
        const bool is_disc = std::holds_alternative<Disc>(body.shape);
        const Kind kind = body.is_static ? Kind::is_static : is_disc ? Kind::disc : Kind::polygon;
        const int id = static_cast<int>(rows_.size());
        rows_.push_back({state.position, state.velocity, state.time, bounding_radius(body.shape), 0, kind, id});
        places_.push_back({id, 0});
        sheets_.push_back({state.angle, state.spin, body.inertia, body.material, 0});
        if (!body.is_static) acceleration_ = body.flyer.acceleration;
        if (body.flyer.central) central_ = *body.flyer.central;
        shapes_.push_back(std::move(body.shape));
    }
    bounces_.resize(rows_.size());
    waiting_.resize(rows_.size());
    near_.resize(rows_.size() + 1);
    find_seams_of_statics();
    set_up_grid();
    predict_all();
}

Pose EventEngine::pose(int body) const { return {rows_[body].position, Rotation::of(sheets_[body].angle)}; }

/// Bound on the speed of any point of a body.  [m/s]
double EventEngine::top_speed(int body) const
{
    const double spin = sheets_[body].spin;
    return rows_[body].velocity.norm() + (spin == 0.0 ? 0.0 : std::abs(spin) * rows_[body].radius);
}

EventEngine::Resume EventEngine::resume() const
{
    Resume resume{now_, log_.value(), max_overlap_, {}, energy_lost_, {}, bounces_};
    for (const Place& place : places_) resume.crowding.push_back(sheets_[place.row].crowding);
    for (int body = 0; body < body_count(); ++body) resume.presence.push_back(presence(body));
    return resume;
}

void EventEngine::go_on_from(const Resume& resume, const std::vector<BodyState>& states)
{
    now_ = resume.time;
    log_ = Hash(resume.log_hash);
    max_overlap_ = resume.max_overlap;
    energy_lost_ = resume.energy_lost;
    bounces_ = resume.bounces;
    for (std::size_t k = 0; k < places_.size(); ++k) sheets_[places_[k].row].crowding = resume.crowding[k];
    for (std::size_t k = 0; k < states.size(); ++k) {
        const int row = places_[k].row;
        rows_[row].position = states[k].position;
        rows_[row].time = states[k].time;
        set_motion(row, states[k].velocity, states[k].spin);
        sheets_[row].angle = states[k].angle;
        if (resume.presence[k] != Presence::flies) rows_[row].time = now_; // it has a cell, and doesn't leave it
    }

    // Put the bodies into the cells in which they are by now, and foresee all anew
    queue_.clear();
    for (Waiting& waiting : waiting_) waiting = {};
    set_up_grid();
    for (std::size_t k = 0; k < states.size(); ++k) {
        if (resume.presence[k] == Presence::flies) continue;
        const int row = places_[k].row;
        rows_[row].time = states[k].time;
        rows_[row].velocity = Vec2::Zero();
        sheets_[row].spin = 0.0;
        rows_[row].kind = kind_of(row, resume.presence[k]);
    }
    predict_all();
}

std::optional<EventFailure> EventEngine::advance(double time, std::int64_t most)
{
    noticed_ = false;
    for (std::int64_t handled = 0; !queue_.empty();) {
        const Event event = queue_.next();
        if (!(event.time <= time)) break;
        if (handled == most) return std::nullopt;
        queue_.pop();
        if (fetches_ahead_) fetch_ahead();
        // [events.advance.stale]
        if (!is_current(event)) {
            ++counts_.stale;
            if (is_called(event)) await(owner_of(event));
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
    case Event::Kind::impact: return handle_impact(event);
    case Event::Kind::look: handle_look(event); return std::nullopt;
    case Event::Kind::cell: handle_cell(event); return std::nullopt;
    }
    return std::nullopt;
}

std::optional<EventFailure> EventEngine::handle_impact(const Event& event)
{
    const int a = row_of(event.a);
    const int b = row_of(event.b);
    noticed_ = notices_all_ || rows_[a].kind == Kind::lies || rows_[b].kind == Kind::lies;
    if (!strike_discs(event, a, b)) {
        if (auto failure = strike(event, a, b)) return failure;
    }

    // [events.impact.foresee]
    predict_after_impact(a, -1);
    predict_after_impact(b, is_fixed(a) ? -1 : a);
    if (queue_.size() > sweep_at_) sweep_queue();
    if (grid_ && counts_.cells > line_up_at_) line_up_again();
    // [events.impact.foresee]
    return std::nullopt;
}

/// Impacts in a row, without room between them, after which a pair that sinks is crowded.
constexpr int k_sinking = 16;

/// Let any two bodies strike each other.
std::optional<EventFailure> EventEngine::strike(const Event& event, int a, int b)
{
    bool ended = true;
    bool stays_on = false;
    bool sinks = false;
    std::optional<double> bounces_end;
    {
        const StageTimer timer(options_.seconds, seconds_.impact);

        // [events.impact.meet]
        // Bring the two bodies, and no other, to the moment of the impact
        const bool a_moved = move_to(a, event.time);
        const bool b_moved = move_to(b, event.time);
        if (has_spun_out(a) || has_spun_out(b)) {
            return EventFailure{EventFailure::Kind::spun_out, event.time, event.a, event.b};
        }
        const double touch = find_points(a, b, event.time);
        // [events.impact.meet]

        // [events.impact.crowding]
        // Where neither went anywhere since its last impact, or they creep into each other,
        // both are being crowded; a heavy body that hardly moves between the blows of a
        // light one is not
        const bool creeps = is_creeping(a, b, touch);
        const bool has_room = !creeps && (a_moved || b_moved);
        sheets_[a].crowding = has_room ? 0 : sheets_[a].crowding + 1;
        sheets_[b].crowding = has_room ? 0 : sheets_[b].crowding + 1;
        // [events.impact.crowding]

        // Each of many impacts at one moment may come late by a rounding. Beyond the tolerance of touching, what has come
        // behind a side would be lost to the search
        const auto is_polygon = [&](int body) { return std::holds_alternative<Polygon>(shape_of(body)); };
        const auto is_wall = [&](int body) { return std::holds_alternative<HalfPlane>(shape_of(body)); };
        const bool has_sides = (is_polygon(a) && !is_wall(b)) || (is_polygon(b) && !is_wall(a));
        const auto is_deep = [&](const Touch& point) { return point.separation < -0.5 * touch; };
        sinks = !has_room && has_sides && std::any_of(touches_.begin(), touches_.end(), is_deep);

        // [events.impact.push]
        // Push them apart
        const ImpactResult result =
            resolve_impact({rows_[a].velocity, sheets_[a].spin, sheets_[a].inertia},
                           {rows_[b].velocity, sheets_[b].spin, sheets_[b].inertia}, points_,
                           combine(sheets_[a].material, sheets_[b].material));
        energy_lost_ -= energy_change(a, result.velocity_a, result.spin_a);
        energy_lost_ -= energy_change(b, result.velocity_b, result.spin_b);
        set_motion(a, result.velocity_a, result.spin_a);
        set_motion(b, result.velocity_b, result.spin_b);
        ended = result.ended;
        if (result.any_push) ++counts_.impacts;
        log_impact(event, a, b);
        // [events.impact.push]
        if (options_.ends_bounces) {
            if (falls_) bounces_end = end_of_bounces(a, b, event.time, touch);
            stays_on = stays(a, b, touch);
        }
    }
    if (!ended) return EventFailure{EventFailure::Kind::unresolved, event.time, event.a, event.b};
    if (bounces_end) return EventFailure{EventFailure::Kind::settled, event.time, event.a, event.b, *bounces_end};
    if (stays_on) return EventFailure{EventFailure::Kind::stays, event.time, event.a, event.b};

    const int crowding_a = is_fixed(a) ? 0 : sheets_[a].crowding;
    const int crowding_b = is_fixed(b) ? 0 : sheets_[b].crowding;
    if (std::max(crowding_a, crowding_b) > (sinks ? k_sinking : options_.most_crowded)) {
        return EventFailure{EventFailure::Kind::crowded, event.time, event.a, event.b};
    }

    return std::nullopt;
}

/// Bring a body to a moment; tells whether it went anywhere since its last impact.
bool EventEngine::move_to(int body, double time)
{
    Row& row = rows_[body];
    if (is_fixed(body)) return false;
    const double way = top_speed(body) * (time - row.time);

    const BodyState after = state_at(flyer_of(body), time);
    row.position = after.position;
    row.velocity = after.velocity;
    row.time = time;
    sheets_[body].angle = after.angle;
    return way > tolerance::k_touch * row.radius;
}

/// The pair approaches no faster than what presses it together brings about within the tolerance of touching: its hops
/// can't be told from contact that lasts, however fast it slides or rolls.
bool EventEngine::is_creeping(int a, int b, double touch) const
{
    double press = std::max(pull_on(a).norm(), pull_on(b).norm());
    for (const int body : {a, b}) {
        const double spin = sheets_[body].spin;
        if (spin != 0.0 && !is_fixed(body)) press += spin * spin * rows_[body].radius;
    }
    double approach = 0.0;
    for (const ImpactPoint& point : points_) {
        const Vec2 velocity_a = rows_[a].velocity + cross(sheets_[a].spin, point.r_a);
        const Vec2 velocity_b = rows_[b].velocity + cross(sheets_[b].spin, point.r_b);
        approach = std::max(approach, point.normal.dot(velocity_a - velocity_b));
    }
    constexpr double k_hop = 16.0; // tolerances of touching
    return approach * approach <= 2.0 * press * (k_hop * touch);
}

/// New velocities, which make all that was foreseen of the body stale.
void EventEngine::set_motion(int body, const Vec2& velocity, double spin)
{
    Row& row = rows_[body];
    if (row.kind == Kind::is_static) return;
    if (row.kind == Kind::lies) row.kind = Kind::away;
    row.velocity = velocity;
    sheets_[body].spin = spin;
    forget(body);
}

void EventEngine::log_impact(const Event& event, int row_a, int row_b)
{
    last_impact_ = event;
    log_.add(static_cast<std::uint64_t>(event.a) << 32 | static_cast<std::uint32_t>(event.b));
    const Row& a = rows_[row_a];
    const Row& b = rows_[row_b];
    log_.add(std::array{event.time, a.position.x(), a.position.y(), a.velocity.x(), a.velocity.y(), sheets_[row_a].angle,
                        sheets_[row_a].spin, b.position.x(), b.position.y(), b.velocity.x(), b.velocity.y(),
                        sheets_[row_b].angle, sheets_[row_b].spin});
}

/// All points at which a pair touches at the time of its impact; where rounding hides even the one that was foreseen, the
/// search is widened until it shows.
/// Returns the tolerance of touching.  [m]
double EventEngine::find_points(int a, int b, double time)
{

    const double radius_a = std::isinf(rows_[a].radius) ? rows_[b].radius : rows_[a].radius;
    const double radius_b = std::isinf(rows_[b].radius) ? rows_[a].radius : rows_[b].radius;
    const double reach = std::max(rows_[a].position.norm(), rows_[b].position.norm());
    const GapTolerance tolerance = gap_tolerance(std::min(radius_a, radius_b), std::max(radius_a, radius_b), reach,
                                                 top_speed(a) + top_speed(b), time);

    const Shape& shape_a = shape_from_row(a, disc_a_);
    const Shape& shape_b = shape_from_row(b, disc_b_);
    const Pose pose_a = pose(a);
    const Pose pose_b = pose(b);

    constexpr double k_gather = 16.0; // the depth that a prediction accepts, and rounding on either side of it
    constexpr double k_widen = 16.0;
    constexpr int k_most_tries = 8;
    double slack = k_gather * tolerance.touch;
    for (int k = 0; k < k_most_tries; ++k, slack *= k_widen) {
        find_touches(shape_a, pose_a, shape_b, pose_b, slack, touches_);
        if (!touches_.empty()) break;
    }

    points_.clear();
    if (has_seams(a) || has_seams(b)) {
        touch_surface(a, b, slack);
        return tolerance.touch;
    }
    add_points();
    return tolerance.touch;
}

void EventEngine::add_points()
{
    for (const Touch& touch : touches_) {
        points_.push_back({touch.r_a, touch.r_b, touch.normal});
        max_overlap_ = std::max(max_overlap_, -touch.separation);
    }
}

} // namespace flying
