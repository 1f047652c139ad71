#include <algorithm>
#include <utility>

#include "events/event_engine.hpp"

namespace flying {

// [events.push_pair]
// What was foreseen finds its place: in the queue, or beside a body.

/// p, q  in any order
void EventEngine::push_pair(double time, int p, int q, Event::Kind kind)
{
    const Row& row_p = rows_[p];
    const Row& row_q = rows_[q];
    const auto [a, b] = std::minmax(row_p.id, row_q.id);
    foreseen_.push_back({time, a, b, row_p.stamp + row_q.stamp, kind});
}
// [events.push_pair]

// [events.await]
/// Put what was foreseen of a body where it belongs: the first of its events into the
/// queue, the others beside the body.
void EventEngine::await(int body)
{
    const int id = rows_[body].id;
    Waiting& waiting = waiting_[body];
    // [events.await.waited]
    while (waiting.count > 0) {
        const Event event = waiting.take(waiting.count - 1, id);
        if (is_current(event)) foreseen_.push_back(event);
        else ++counts_.stale;
    }
    waiting.called = k_never;
    // [events.await.waited]
    if (!options_.skips_search) call_all(); // with the skip off, all go into the queue
    if (foreseen_.empty()) return;

    // Find the first, by the order of the queue
    std::size_t first = 0;
    for (std::size_t k = 1; k < foreseen_.size(); ++k) {
        if (happens_before(foreseen_[k], foreseen_[first])) first = k;
    }
    // [events.await.others]
    for (std::size_t k = 0; k < foreseen_.size(); ++k) {
        Event& event = foreseen_[k];
        event.owner = event.a == id ? Event::Owner::a : Event::Owner::b;
        if (k == first || waiting.keep(event)) continue;
        event.owner = Event::Owner::nobody; // there is no more room beside the body
        queue_.push(event);
    }
    // [events.await.others]
    waiting.called = foreseen_[first].time;
    queue_.push(foreseen_[first]);
    foreseen_.clear();
}
// [events.await]

// [events.call_all]
/// Put what was foreseen of nobody in particular into the queue.
void EventEngine::call_all()
{
    for (const Event& event : foreseen_) queue_.push(event);
    foreseen_.clear();
}

// [events.call_all]

// [events.forget]
/// A body was pushed: what was foreseen of it is overtaken.
void EventEngine::forget(int body)
{
    ++rows_[body].stamp;
    waiting_[body].count = 0;
    waiting_[body].called = k_never;
}
// [events.forget]

// [events.sweep_queue]
void EventEngine::sweep_queue()
{
    queue_.keep_if([&](const Event& event) { return is_current(event) || is_called(event); });
    sweep_at_ = std::max<std::size_t>(2 * queue_.size(), 1024);
}
// [events.sweep_queue]

} // namespace flying
