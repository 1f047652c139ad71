#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "events/cell_exit.hpp"
#include "events/event_engine.hpp"
#include "events/stage_timer.hpp"
#include "motion/flight.hpp"
#include "toi/discs.hpp"

namespace flying {

// [events.set_up_grid]
// How the event engine keeps its queue filled: which pairs are looked at, and when.

void EventEngine::set_up_grid()
{
    grid_.reset();
    everywhere_.clear();
    if (options_.pair_finder != PairFinder::grid) return;
    if (central_) return; // when a curved flight leaves its cell is not foreseen: look at all pairs

    // [events.set_up_grid.cells]
    // Cells are no smaller than the largest mover
    double largest = 0.0;
    int movers = 0;
    Aabb extent{Vec2::Constant(k_never), Vec2::Constant(-k_never)};
    std::vector<Vec2> places(rows_.size(), Vec2::Zero());
    for (int body = 0; body < body_count(); ++body) {
        if (is_static(body)) continue;
        const Flyer flying_body = flyer(body);
        places[body] = state_at(flying_body, now_).position;
        largest = std::max(largest, rows_[body].radius);
        extent.min = extent.min.cwiseMin(places[body]);
        extent.max = extent.max.cwiseMax(places[body]);
        ++movers;
    }
    if (movers == 0) return;
    grid_ = make_grid(extent, largest, body_count(), movers);
    // [events.set_up_grid.cells]

    for (int body = 0; body < body_count(); ++body) {
        if (!is_static(body)) {
            grid_->insert(body, grid_->cell_at(places[body]));
            continue;
        }
        // [events.set_up_grid.statics]
        // A wall along an axis is met only near its surface: nobody is ever behind it
        const auto* wall = std::get_if<HalfPlane>(&shapes_[body]);
        if (!wall) {
            grid_->insert_static(body, bounding_box(shapes_[body], pose(body)), largest);
        } else if (wall->normal.x() == 0.0 || wall->normal.y() == 0.0) {
            const bool level = wall->normal.x() == 0.0;
            const double surface = wall->offset * (level ? wall->normal.y() : wall->normal.x());
            const Vec2 low = level ? Vec2(-k_never, surface) : Vec2(surface, -k_never);
            const Vec2 high = level ? Vec2(k_never, surface) : Vec2(surface, k_never);
            grid_->insert_static(body, {low, high}, largest);
        } else {
            everywhere_.push_back(body);
        }
        // [events.set_up_grid.statics]
    }
}
// [events.set_up_grid]

// [events.predict_all]
void EventEngine::predict_all()
{
    const StageTimer timer(options_.seconds, seconds_.predict);
    for (int a = 0; a < body_count(); ++a) {
        if (!is_static(a)) {
            predict_cell(a, std::max(now_, rows_[a].time));
            predict_partners(a, [&](int other) { return other > a || is_static(other); });
            continue;
        }
        // Two static bodies never meet; with the skip off, look all the same
        for (int b = a + 1; b < body_count(); ++b) {
            if (!is_static(b)) continue;
            if (options_.skips_static_pairs) ++counts_.static_pairs_skipped;
            else predict_pair(a, b);
        }
    }
    sweep_queue();
}
// [events.predict_all]

// [events.predict_after_impact]
void EventEngine::predict_after_impact(int body, int partner)
{
    if (is_static(body)) return;
    const StageTimer timer(options_.seconds, seconds_.predict);
    predict_cell(body, rows_[body].time);
    predict_partners(body, [&](int other) { return other != partner; });
}
// [events.predict_after_impact]

// [events.predict_partners]
/// Foresee the next impact of a mover with every body that it may meet before either changes its cell.
/// wants(other)  false for those that are looked at from the other side
template <typename Wants>
void EventEngine::predict_partners(int body, const Wants& wants)
{
    const auto look = [&](int other) {
        if (other != body && wants(other)) predict_pair(body, other);
    };
    if (!grid_) {
        for (int other = 0; other < body_count(); ++other) look(other);
        return;
    }
    const std::int64_t before = counts_.predictions;
    const Cell& cell = grid_->cell_of(body);
    grid_->for_each_near(cell, look);
    for (const int other : grid_->statics_near(cell)) look(other);
    for (const int other : everywhere_) look(other);
    counts_.far_pairs_skipped += body_count() - 1 - (counts_.predictions - before);
}
// [events.predict_partners]

// [events.handle_look]
void EventEngine::handle_look(const Event& event)
{
    const StageTimer timer(options_.seconds, seconds_.look);
    ++counts_.looks;
    predict_general(event.a, event.b, event.time, 1);
}
// [events.handle_look]

// [events.handle_cell]
void EventEngine::handle_cell(const Event& event)
{
    const StageTimer timer(options_.seconds, seconds_.cells);
    ++counts_.cells;
    const int body = event.a;
    const Cell from = grid_->cell_of(body);
    const Cell to = next_cell_exit(flyer(body), from, grid_->cell_size(), event.time).to;
    grid_->move(body, to);

    // [events.handle_cell.new]
    // Look at those who were too far away until now
    const auto look = [&](int other) {
        if (other != body) predict_pair(body, other);
    };
    for (std::int64_t row = to.row - 1; row <= to.row + 1; ++row) {
        for (std::int64_t column = to.column - 1; column <= to.column + 1; ++column) {
            const bool is_new = std::abs(column - from.column) > 1 || std::abs(row - from.row) > 1;
            if (is_new) grid_->for_each_in({column, row}, look);
        }
    }
    const std::span<const int> known = grid_->statics_near(from);
    for (const int other : grid_->statics_near(to)) {
        if (std::find(known.begin(), known.end(), other) == known.end()) look(other);
    }
    predict_cell(body, event.time);
    // [events.handle_cell.new]
}
// [events.handle_cell]

// [events.predict_cell]
void EventEngine::predict_cell(int body, double now)
{
    if (!grid_) return;
    const CellExit exit = next_cell_exit(flyer(body), grid_->cell_of(body), grid_->cell_size(), now);
    if (exit.time != k_never) queue_.push({exit.time, body, -1, rows_[body].stamp, 0, Event::Kind::cell});
}
// [events.predict_cell]

// [events.predict_pair]
/// Foresee the impact of two bodies, named in any order, as their flights are now.
void EventEngine::predict_pair(int p, int q)
{
    const int a = std::min(p, q);
    const int b = std::max(p, q);
    ++counts_.predictions;
    if (is_static(a) || is_static(b) || central_) predict_general(a, b, std::max(rows_[a].time, rows_[b].time), 0);
    else predict_movers(a, b);
}
// [events.predict_pair]

// [events.predict_movers]
/// Two bodies under one acceleration: discs meet when their circles do; others are looked at when their bounding circles
/// do. The same numbers as `predict`, straight from the rows.
void EventEngine::predict_movers(int a, int b)
{
    // [events.predict_movers.start]
    const Row& row_a = rows_[a];
    const Row& row_b = rows_[b];
    const double start = std::max(row_a.time, row_b.time);
    const double t_a = start - row_a.time;
    const double t_b = start - row_b.time;
    const Vec2 position_a = position_after(row_a.position, row_a.velocity, acceleration_, t_a);
    const Vec2 position_b = position_after(row_b.position, row_b.velocity, acceleration_, t_b);
    const Vec2 velocity_a = row_a.velocity + t_a * acceleration_;
    const Vec2 velocity_b = row_b.velocity + t_b * acceleration_;
    const Vec2 offset = position_a - position_b;
    const Vec2 rate = velocity_a - velocity_b;
    const double reach = row_a.radius + row_b.radius;
    // [events.predict_movers.start]

    // [events.predict_movers.kinds]
    Event event{k_never, a, b, row_a.stamp, row_b.stamp, Event::Kind::impact};
    if (row_a.kind == Kind::disc && row_b.kind == Kind::disc) {
        event.time = start + time_to_meet(offset, rate, reach);
    } else if (options_.skips_far_features) {
        const Passage passage = passage_through_circle(offset, rate, bounding_reach(reach));
        if (!(passage.leave > 0.0)) {
            ++counts_.far_features_skipped;
            return;
        }
        event.time = start + std::max(passage.enter, 0.0);
        event.kind = Event::Kind::look;
    } else {
        predict_general(a, b, start, 1);
        return;
    }
    if (event.time != k_never) queue_.push(event);
    // [events.predict_movers.kinds]
}
// [events.predict_movers]

// [events.predict_general]
/// Any two bodies, looked at through no more than so many windows: what happens later may never come to be, for one of
/// them may be struck before.
void EventEngine::predict_general(int a, int b, double from, int windows)
{
    PredictOptions options;
    options.windows = windows;
    options.skips_far_features = options_.skips_far_features;
    const Prediction prediction = predict(shapes_[a], flyer(a), shapes_[b], flyer(b), from, options);
    if (prediction.kind == Prediction::Kind::never) {
        ++counts_.far_features_skipped;
        return;
    }
    const auto kind = prediction.kind == Prediction::Kind::impact ? Event::Kind::impact : Event::Kind::look;
    queue_.push({prediction.time, a, b, rows_[a].stamp, rows_[b].stamp, kind});
}
// [events.predict_general]

// [events.sweep_queue]
void EventEngine::sweep_queue()
{
    queue_.keep_if([&](const Event& event) { return is_current(event); });
    sweep_at_ = std::max<std::size_t>(2 * queue_.size(), 1024);
}
// [events.sweep_queue]

} // namespace flying
