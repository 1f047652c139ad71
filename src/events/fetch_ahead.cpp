#include "events/fetch_ahead.hpp"

#include "events/cell_exit.hpp"
#include "math/fetch.hpp"

namespace flying {
namespace {

/// [events ahead]
constexpr std::size_t k_places = 12;
constexpr std::size_t k_bodies = 9;
constexpr std::size_t k_cells = 6;
constexpr std::size_t k_neighbours = 3;

void fetch_bodies(const Event& event, const ForeseenEvents& foreseen, const BodyRows& bodies, const Grid& cells)
{
    if (!bodies.is_current(event)) {
        if (event.owner == Event::Owner::none) return;
        fetch(&foreseen.waiting(ForeseenEvents::owner_of(bodies, event)));
        return;
    }
    for (const int id : {event.a, event.b}) {
        if (id < 0) continue;
        const int row = bodies.row_of(id);
        bodies.fetch_row(row);
        fetch(&foreseen.waiting(row));
        if (event.kind == Event::Kind::impact) bodies.fetch_sheet(row);
        cells.fetch_cell_of(row);
    }
}

void fetch_cells(const Event& event, const ForeseenEvents& foreseen, const BodyRows& bodies, const Grid& cells)
{
    const bool is_current = bodies.is_current(event);
    if (is_current) {
        const Cell& cell = cells.cell_of(bodies.row_of(event.a));
        const Cell step = event.b < 0 ? step_over(-1 - event.b) : Cell{0, 0};
        cells.fetch_near({cell.column + step.column, cell.row + step.row});
        if (event.b >= 0 && !bodies.is_fixed(bodies.row_of(event.b))) {
            const Cell& other_cell = cells.cell_of(bodies.row_of(event.b));
            if (other_cell != cell) cells.fetch_near(other_cell);
        }
    }
    if ((event.b < 0 || !is_current) && foreseen.is_called(bodies, event)) {
        const Waiting& waiting = foreseen.waiting(ForeseenEvents::owner_of(bodies, event));
        for (int k = 0; k < waiting.count; ++k) {
            if (waiting.entries[k].with >= 0) bodies.fetch_place(waiting.entries[k].with);
        }
    }
}

void fetch_neighbours(const Event& event, const BodyRows& bodies, const Grid& cells)
{
    const auto fetch_row = [&](int other) { bodies.fetch_row(other); };
    const Cell& cell = cells.cell_of(bodies.row_of(event.a));
    if (event.b < 0) {
        for (const Cell& ahead : cells_ahead(cell, step_over(-1 - event.b))) cells.for_each_in(ahead, fetch_row);
        return;
    }
    cells.for_each_near(cell, fetch_row);
    const int row_b = bodies.row_of(event.b);
    const Cell& other_cell = cells.cell_of(row_b);
    if (other_cell != cell && !bodies.is_fixed(row_b)) cells.for_each_near(other_cell, fetch_row);
}

} // namespace

void fetch_ahead(const ForeseenEvents& foreseen, const BodyRows& bodies, const Grid& cells)
{
    if (const Event* event = foreseen.upcoming(k_places)) {
        bodies.fetch_place(event->a);
        if (event->b >= 0) bodies.fetch_place(event->b);
    }
    if (const Event* event = foreseen.upcoming(k_bodies)) fetch_bodies(*event, foreseen, bodies, cells);
    if (const Event* event = foreseen.upcoming(k_cells)) fetch_cells(*event, foreseen, bodies, cells);
    const Event* const event = foreseen.upcoming(k_neighbours);
    if (event && bodies.is_current(*event)) fetch_neighbours(*event, bodies, cells);
}

} // namespace flying
