#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "events/body_rows.hpp"
#include "events/event_queue.hpp"
#include "events/waiting.hpp"

namespace flying {

/// All that is foreseen. Events are noted one after the other; then they find their places, in the queue or beside a
/// body.
class ForeseenEvents
{
public:
    /// bodies       how many there are
    /// lets_wait    only the first event of a body goes into the queue, and it is known which pairs will be looked at; else
    ///              all do, and it isn't
    explicit ForeseenEvents(int bodies, bool lets_wait)
        : waiting_(static_cast<std::size_t>(bodies)),
          struck_(static_cast<std::size_t>(bodies)),
          looks_(static_cast<std::size_t>(bodies)),
          lets_wait_(lets_wait)
    {
    }

    /// Note an impact of two bodies, or that they must be looked at again, for what comes next.
    /// p, q  in any order
    void note_pair(double time, const BodyRows::Row& p, const BodyRows::Row& q, Event::Kind kind)
    {
        noted_.push_back({time, p.id < q.id ? p.id : q.id, p.id < q.id ? q.id : p.id, p.stamp + q.stamp, kind});
        if (kind != Event::Kind::impact) remember_look(noted_.back());
    }
    /// The two will be looked at again, at this moment or later, whether they are near by then or not.  [s]
    [[nodiscard]] bool will_look(const BodyRows::Row& p, const BodyRows::Row& q, double time) const
    {
        const std::vector<NextLook>& looks = looks_[std::min(p.id, q.id)];
        if (looks.empty() || !lets_wait_) return false;
        const int with = std::max(p.id, q.id);
        return std::any_of(looks.begin(), looks.end(), [&](const NextLook& look) {
            return look.with == with && look.stamp == p.stamp + q.stamp && look.time >= time;
        });
    }
    /// Note an impact, and that both bodies fly no longer than until then.
    void note_impact(const BodyRows& bodies, double time, int p, int q)
    {
        note_pair(time, bodies[p], bodies[q], Event::Kind::impact);
        for (const int row : {p, q}) {
            if (time < end_of_flight(bodies, row)) struck_[bodies[row].id] = noted_.back();
        }
    }
    /// No later than this is a body struck, as far as is known: the time of an impact that still counts.  [s]
    [[nodiscard]] double end_of_flight(const BodyRows& bodies, int row) const
    {
        const Event& impact = struck_[bodies[row].id];
        return impact.a >= 0 && bodies.is_current(impact) ? impact.time : k_never;
    }
    /// Note that a body leaves its cell.
    void note_cell(double time, const BodyRows::Row& row, int side)
    {
        noted_.push_back({time, row.id, -1 - side, row.stamp, Event::Kind::cell});
    }
    /// Put what was noted of a body where it belongs: the first of its events into the queue, the others beside the
    /// body.
    ///
    /// Returns how many that waited have been overtaken, as far as was asked.
    std::int64_t await(const BodyRows& bodies, int row);
    /// Put what was noted into the queue, for it belongs to no one body.
    void call_all();
    /// A body was pushed: what was foreseen of it is overtaken.
    void forget(int row)
    {
        waiting_[row].count = 0;
        waiting_[row].called = k_never;
    }

    [[nodiscard]] bool is_empty() const { return queue_.empty(); }
    /// The first of all events; only where there is one.
    [[nodiscard]] const Event& next() { return queue_.next(); }
    void pop() { queue_.pop(); }
    /// What was taken out too early.
    void put_back(const Event& event) { queue_.push(event); }
    /// The event that comes so many places after the first, as far as it is known; else null.
    [[nodiscard]] const Event* upcoming(std::size_t places) const { return queue_.upcoming(places); }

    /// It is the first event of its owner: when it is over or overtaken, the next one's turn has come.
    [[nodiscard]] bool is_called(const BodyRows& bodies, const Event& event) const
    {
        return event.owner != Event::Owner::none && waiting_[owner_of(bodies, event)].called == event.time;
    }
    /// Row of the body whose event it is, of one that has an owner.
    [[nodiscard]] static int owner_of(const BodyRows& bodies, const Event& event)
    {
        return bodies.row_of(event.owner == Event::Owner::b ? event.b : event.a);
    }
    [[nodiscard]] const Waiting& waiting(int row) const { return waiting_[row]; }

    /// The queue has grown to twice what it was after it was swept.
    [[nodiscard]] bool has_grown() const { return queue_.size() > sweep_at_; }
    /// Drop the events that no longer count.
    void sweep(const BodyRows& bodies);
    void clear();
    /// As BodyRows::line_up.
    void line_up(std::span<const int> old_rows);

private:
    /// When two bodies will be looked at again.
    struct NextLook
    {
        int with = -1; ///< the higher id
        std::uint32_t stamp = 0;
        double time = 0.0; ///< [s]
    };
    void remember_look(const Event& look);

    EventQueue queue_;
    std::vector<Waiting> waiting_;             // by row
    std::vector<Event> struck_;                // by id: an impact that was foreseen of the body
    std::vector<std::vector<NextLook>> looks_; // by the lower id
    std::vector<Event> noted_;                 // since the last that found their places
    bool lets_wait_;
    std::size_t sweep_at_ = 0;
};

} // namespace flying
