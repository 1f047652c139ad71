#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

#include "events/cell_exit.hpp"
#include "events/event_engine.hpp"
#include "events/stage_timer.hpp"
#include "motion/flight.hpp"
#include "toi/discs.hpp"

namespace flying {


// How the event engine keeps its queue filled: which pairs are looked at, and when.

void EventEngine::set_up_grid()
{
    grid_.reset();
    everywhere_.clear();
    if (options_.pair_finder != PairFinder::grid) return;
    if (central_) return; // when a curved flight leaves its cell is not foreseen: look at all pairs


    // Cells are no smaller than the largest mover
    double largest = 0.0;
    int movers = 0;
    Aabb extent{Vec2::Constant(k_never), Vec2::Constant(-k_never)};
    const auto place = [&](int body) { return state_at(flyer_of(body), now_).position; };
    for (int body = 0; body < body_count(); ++body) {
        if (is_fixed(body)) continue;
        const Vec2 here = place(body);
        largest = std::max(largest, rows_[body].radius);
        extent.min = extent.min.cwiseMin(here);
        extent.max = extent.max.cwiseMax(here);
        ++movers;
    }
    if (movers == 0) return;
    grid_ = make_grid(extent, largest, body_count(), movers);


    line_up(order_along_curve([&](int body) { return grid_->cell_at(place(body)); }));
    for (int body = 0; body < body_count(); ++body) {
        if (!is_fixed(body)) {
            grid_->insert(body, grid_->cell_at(place(body)));
            continue;
        }

        // A wall along an axis is met only near its surface: no body is ever behind it
        const auto* wall = std::get_if<HalfPlane>(&shape_of(body));
        if (!wall) {
            grid_->insert_static(body, bounding_box(shape_of(body), pose(body)), largest);
        } else if (wall->normal.x() == 0.0 || wall->normal.y() == 0.0) {
            const bool level = wall->normal.x() == 0.0;
            const double surface = wall->offset * (level ? wall->normal.y() : wall->normal.x());
            const Vec2 low = level ? Vec2(-k_never, surface) : Vec2(surface, -k_never);
            const Vec2 high = level ? Vec2(k_never, surface) : Vec2(surface, k_never);
            grid_->insert_static(body, {low, high}, largest);
        } else {
            everywhere_.push_back(body);
        }

    }
}



/// The order in which rows follow a curve through the cells; static bodies come last.
/// cell_of(row)  where a mover lies
template <typename CellOf>
std::vector<int> EventEngine::order_along_curve(const CellOf& cell_of) const
{
    constexpr std::uint64_t k_last = ~std::uint64_t{0};
    std::vector<std::pair<std::uint64_t, int>> keys;
    for (int row = 0; row < body_count(); ++row) {
        keys.emplace_back(never_moves(row) ? k_last : grid_->along_curve(cell_of(row)), row);
    }
    std::sort(keys.begin(), keys.end());
    std::vector<int> order;
    for (const auto& [key, row] : keys) order.push_back(row);
    return order;
}

/// Put the rows in another order: row k is the one that was row old_rows[k]. No result knows of it, for order comes
/// from ids.
void EventEngine::line_up(const std::vector<int>& old_rows)
{
    std::vector<Row> rows;
    std::vector<Sheet> sheets;
    std::vector<Waiting> waiting;
    rows.reserve(rows_.size());
    sheets.reserve(rows_.size());
    waiting.reserve(rows_.size());
    for (const int old : old_rows) {
        places_[rows_[old].id].row = static_cast<int>(rows.size());
        rows.push_back(rows_[old]);
        sheets.push_back(sheets_[old]);
        waiting.push_back(waiting_[old]);
    }
    rows_.swap(rows);
    sheets_.swap(sheets);
    waiting_.swap(waiting);

    // By the time bodies have crossed so many cells, neighbours are no longer the same
    constexpr std::int64_t k_cells_a_body = 16;
    line_up_at_ = counts_.cells + k_cells_a_body * body_count();
    constexpr int k_fast_rows = 4096;
    fetches_ahead_ = body_count() > k_fast_rows;
}

void EventEngine::line_up_again()
{
    const std::vector<int> order = order_along_curve([&](int row) { return grid_->cell_of(row); });
    line_up(order);
    const auto first_fixed = std::find_if(order.begin(), order.end(), [&](int row) { return never_moves(row); });
    grid_->renumber({order.begin(), first_fixed});
}



/// Ask the memory for what the events to come will read, so that it is there when they do: first the bodies' places,
/// then the rows of those that still count, then the cells about them, then the rows of the bodies in them.
void EventEngine::fetch_ahead()
{
    constexpr std::size_t k_places = 12; // events ahead
    constexpr std::size_t k_bodies = 9;
    constexpr std::size_t k_cells = 6;
    constexpr std::size_t k_neighbours = 3;
    if (const Event* event = queue_.upcoming(k_places)) {
        __builtin_prefetch(&places_[event->a]);
        if (event->b >= 0) __builtin_prefetch(&places_[event->b]);
    }
    if (const Event* event = queue_.upcoming(k_bodies)) {
        if (!is_current(*event)) {
            if (event->owner != Event::Owner::none) __builtin_prefetch(&waiting_[owner_of(*event)]);
        } else {
            for (const int body : {event->a, event->b}) {
                if (body < 0) continue;
                const int row = row_of(body);
                __builtin_prefetch(&rows_[row]);
                __builtin_prefetch(&waiting_[row]);
                if (event->kind == Event::Kind::impact) __builtin_prefetch(&sheets_[row]);
                grid_->fetch_cell_of(row);
            }
        }
    }
    if (const Event* event = queue_.upcoming(k_cells)) {
        if (is_current(*event)) {
            const Cell& cell = grid_->cell_of(row_of(event->a));
            const Cell step = event->b < 0 ? step_over(-1 - event->b) : Cell{0, 0};
            grid_->fetch_near({cell.column + step.column, cell.row + step.row});
            if (event->b >= 0 && !is_static(event->b)) {
                const Cell& other_cell = grid_->cell_of(row_of(event->b));
                if (other_cell != cell) grid_->fetch_near(other_cell);
            }
        }
        if ((event->b < 0 || !is_current(*event)) && is_called(*event)) {
            const Waiting& waiting = waiting_[owner_of(*event)];
            for (int k = 0; k < waiting.count; ++k) {
                if (waiting.entries[k].with >= 0) __builtin_prefetch(&places_[waiting.entries[k].with]);
            }
        }
    }
    if (const Event* event = queue_.upcoming(k_neighbours); event && is_current(*event)) {
        // Without the count, g++ takes a loop of mere hints for one without effect, and drops it
        const auto fetch = [&](int other) {
            __builtin_prefetch(&rows_[other]);
            ++counts_.fetched;
        };
        const Cell& cell = grid_->cell_of(row_of(event->a));
        if (event->b < 0) {
            for (const Cell& ahead : cells_ahead(cell, step_over(-1 - event->b))) grid_->for_each_in(ahead, fetch);
            return;
        }
        grid_->for_each_near(cell, fetch);
        const Cell& other_cell = grid_->cell_of(row_of(event->b));
        if (other_cell != cell && !is_static(event->b)) grid_->for_each_near(other_cell, fetch);
    }
}



/// Two bodies under one acceleration: discs meet when their circles do; others are looked at when their bounding
/// circles do. The same numbers as `predict`, straight from the rows: in every product both signs turn with the order
/// of the two.
inline void EventEngine::predict_movers(int a, int b)
{

    const Row& row_a = rows_[a];
    const Row& row_b = rows_[b];
    const double start = std::max(row_a.time, row_b.time);
    const double t_a = start - row_a.time;
    const double t_b = start - row_b.time;
    Vec2 offset = (row_a.position + t_a * row_a.velocity) - (row_b.position + t_b * row_b.velocity);
    Vec2 rate = row_a.velocity - row_b.velocity;
    if (falls_) {
        offset = position_after(row_a.position, row_a.velocity, acceleration_, t_a) -
                 position_after(row_b.position, row_b.velocity, acceleration_, t_b);
        rate = (row_a.velocity + t_a * acceleration_) - (row_b.velocity + t_b * acceleration_);
    }
    const double reach = row_a.radius + row_b.radius;


    // [events.predict_movers.kinds]
    double time = k_never;
    auto kind = Event::Kind::impact;
    if (row_a.kind == Kind::disc && row_b.kind == Kind::disc) {
        time = start + time_to_meet(offset, rate, reach);
    } else if (options_.skips_far_features) {
        // [events.predict_movers.circles]
        const double radius = bounding_reach(reach);
        const bool parts = offset.dot(rate) >= 0.0 && offset.squaredNorm() > radius * radius; // seen without a root
        const Passage passage = parts ? Passage{} : passage_through_circle(offset, rate, radius);
        if (!(passage.leave > 0.0)) {
            ++counts_.far_features_skipped;
            return;
        }
        if (passage.enter <= 0.0) {
            predict_general(a, b, start, 1); // the circles meet already
            return;
        }
        time = start + passage.enter;
        kind = Event::Kind::look;
        // [events.predict_movers.circles]
    } else {
        predict_general(a, b, start, 1);
        return;
    }
    if (time != k_never) push_pair(time, a, b, kind);
    // [events.predict_movers.kinds]
}



/// Foresee the impact of two bodies, named in any order, as their flights are now.
void EventEngine::predict_pair(int p, int q)
{
    ++counts_.predictions;
    if (is_fixed(p) || is_fixed(q) || searches_all_) predict_general(p, q, std::max(rows_[p].time, rows_[q].time), 0);
    else predict_movers(p, q);
}



void EventEngine::predict_all()
{
    const StageTimer timer(options_.seconds, seconds_.predict);
    falls_ = acceleration_ != Vec2::Zero() || !options_.skips_absent_field;
    searches_all_ = central_ || !options_.skips_search;
    is_plain_ = !falls_ && !searches_all_;
    for (int a = 0; a < body_count(); ++a) {
        if (!is_fixed(a)) {
            predict_cell(a, std::max(now_, rows_[a].time));
            predict_partners(a, [&](int other) { return other > a || is_fixed(other); });
            await(a);
            continue;
        }
        // Two static bodies never meet; with the skip off, look all the same
        for (int b = a + 1; b < body_count(); ++b) {
            if (!is_fixed(b)) continue;
            if (options_.skips_static_pairs) ++counts_.static_pairs_skipped;
            else predict_pair(a, b);
        }
        call_all();
    }
    sweep_queue();
}



void EventEngine::predict_after_impact(int body, int partner)
{
    if (is_fixed(body)) return;
    const StageTimer timer(options_.seconds, seconds_.predict);
    predict_cell(body, rows_[body].time);
    if (grid_ && is_plain_ && rows_[body].kind == Kind::disc) predict_near(body, partner);
    else predict_partners(body, [&](int other) { return other != partner; });
    await(body);
}



/// Foresee all of a body that has just been put where it is.
void EventEngine::predict_anew(int body)
{
    const StageTimer timer(options_.seconds, seconds_.predict);
    if (!is_fixed(body)) predict_cell(body, now_);
    predict_partners(body, [](int) { return true; });
    await(body);
}



/// Foresee the next impact of a mover with every body that it may meet before either
/// changes its cell.
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



void EventEngine::handle_look(const Event& event)
{
    const StageTimer timer(options_.seconds, seconds_.look);
    ++counts_.looks;
    predict_general(row_of(event.a), row_of(event.b), event.time, 1);
    if (event.owner == Event::Owner::none) call_all();
    else await(owner_of(event));
}



void EventEngine::handle_cell(const Event& event)
{
    const StageTimer timer(options_.seconds, seconds_.cells);
    ++counts_.cells;
    const int body = row_of(event.a);
    const Cell from = grid_->cell_of(body);
    const Cell step = step_over(-1 - event.b);
    const Cell to{from.column + step.column, from.row + step.row};
    grid_->move(body, to);

    // [events.handle_cell.new]
    // Look at the bodies that were too far away until now, in the three cells ahead
    const auto look = [&](int other) {
        if (other != body) predict_pair(body, other);
    };
    for (const Cell& cell : cells_ahead(from, step)) grid_->for_each_in(cell, look);
    const std::span<const int> known = grid_->statics_near(from);
    for (const int other : grid_->statics_near(to)) {
        if (std::find(known.begin(), known.end(), other) == known.end()) look(other);
    }
    predict_cell(body, event.time);
    await(body);
    // [events.handle_cell.new]
}



void EventEngine::predict_cell(int body, double now)
{
    if (!grid_) return;
    const Row& row = rows_[body];
    const Cell& cell = grid_->cell_of(body);
    const CellExit exit = falls_ ? next_cell_exit(flyer_of(body), cell, grid_->cell_size(), now)
                                 : straight_exit(row.position, row.velocity, row.time, cell, grid_->cell_size(), now);
    if (exit.time != k_never) foreseen_.push_back({exit.time, row.id, -1 - exit.side, row.stamp, Event::Kind::cell});
}



/// Any two bodies, looked at through no more than so many windows: what happens later may never come to be, for one of
/// them may be struck before.
void EventEngine::predict_general(int p, int q, double from, int windows)
{
    if (!can_meet(p, q)) return;
    const bool in_order = rows_[p].id < rows_[q].id;
    const int a = in_order ? p : q;
    const int b = in_order ? q : p;
    PredictOptions options;
    options.windows = windows;
    options.skips_far_features = options_.skips_far_features;
    options.skips_apart_rings = options_.skips_apart_rings;
    options.skips_far_vertices = options_.skips_far_vertices;
    options.seams_a = seams_[rows_[a].id];
    options.seams_b = seams_[rows_[b].id];
    ++counts_.searches;
    const Prediction prediction = predict(shape_of(a), flyer_of(a), shape_of(b), flyer_of(b), from, options);
    if (prediction.kind == Prediction::Kind::never) {
        ++counts_.far_features_skipped;
        return;
    }
    const auto kind = prediction.kind == Prediction::Kind::impact ? Event::Kind::impact : Event::Kind::look;
    push_pair(prediction.time, a, b, kind);
}


} // namespace flying
