#include <algorithm>
#include <utility>

#include "events/event_engine.hpp"

namespace flying {


// What was foreseen finds its place: in the queue, or beside a body.

/// p, q  in any order
void EventEngine::push_pair(double time, int p, int q, Event::Kind kind)
{
    const Row& row_p = rows_[p];
    const Row& row_q = rows_[q];
    const auto [a, b] = std::minmax(row_p.id, row_q.id);
    foreseen_.push_back({time, a, b, row_p.stamp + row_q.stamp, kind});
}



/// Put what was foreseen of a body where it belongs: the first of its events into the
/// queue, the others beside the body.
void EventEngine::await(int body)
{
    if (!options_.skips_search) call_all(); // with the skip off, all go into the queue
    const int id = rows_[body].id;
    Waiting& waiting = waiting_[body];
    std::size_t first = 0;
    for (std::size_t k = 0; k < foreseen_.size(); ++k) {
        foreseen_[k].owner = foreseen_[k].a == id ? Event::Owner::a : Event::Owner::b;
        if (happens_before(foreseen_[k], foreseen_[first])) first = k;
    }
    // [events.await.waited]
    // Ask only of the first that waited whether it was overtaken: the partner of each lies somewhere else in memory
    while (waiting.count > 0) {
        const int k = waiting.first(id);
        const Event event = waiting.event(k, id);
        if (!foreseen_.empty() && happens_before(foreseen_[first], event)) break;
        waiting.drop(k);
        if (is_current(event)) {
            foreseen_.push_back(event);
            first = foreseen_.size() - 1;
            break;
        }
        ++counts_.stale;
    }
    waiting.called = k_never;
    // [events.await.waited]
    if (foreseen_.empty()) return;
    // [events.await.others]
    for (std::size_t k = 0; k < foreseen_.size(); ++k) {
        Event& event = foreseen_[k];
        if (k == first || waiting.keep(event)) continue;
        event.owner = Event::Owner::none; // there is no more room beside the body
        queue_.push(event);
    }
    // [events.await.others]
    waiting.called = foreseen_[first].time;
    queue_.push(foreseen_[first]);
    foreseen_.clear();
}



/// Put events that belong to no one body into the queue.
void EventEngine::call_all()
{
    for (const Event& event : foreseen_) queue_.push(event);
    foreseen_.clear();
}




/// A body was pushed: what was foreseen of it is overtaken.
void EventEngine::forget(int body)
{
    Row& row = rows_[body];
    places_[row.id].stamp = ++row.stamp;
    waiting_[body].count = 0;
    waiting_[body].called = k_never;
}



void EventEngine::sweep_queue()
{
    queue_.keep_if([&](const Event& event) { return is_current(event) || is_called(event); });
    sweep_at_ = std::max<std::size_t>(2 * queue_.size(), 1024);
}


} // namespace flying
