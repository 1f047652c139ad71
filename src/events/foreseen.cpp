#include "events/foreseen.hpp"

#include <algorithm>

namespace flying {

std::int64_t ForeseenEvents::await(const BodyRows& bodies, int row)
{
    if (!lets_wait_) call_all(); // with the skip off, all go into the queue
    const int id = bodies[row].id;
    Waiting& waiting = waiting_[row];
    std::int64_t stale = 0;
    std::size_t first = 0;
    for (std::size_t k = 0; k < noted_.size(); ++k) {
        noted_[k].owner = noted_[k].a == id ? Event::Owner::a : Event::Owner::b;
        if (happens_before(noted_[k], noted_[first])) first = k;
    }
    // [events.await.waited]
    // Ask only of the first that waited whether it was overtaken: the partner of each lies somewhere else in memory
    while (waiting.count > 0) {
        const int k = waiting.first(id);
        const Event event = waiting.event(k, id);
        if (!noted_.empty() && happens_before(noted_[first], event)) break;
        waiting.drop(k);
        if (bodies.is_current(event)) {
            noted_.push_back(event);
            first = noted_.size() - 1;
            break;
        }
        ++stale;
    }
    waiting.called = k_never;
    // [events.await.waited]
    if (noted_.empty()) return stale;
    // [events.await.others]
    for (std::size_t k = 0; k < noted_.size(); ++k) {
        Event& event = noted_[k];
        if (k == first || waiting.keep(event)) continue;
        event.owner = Event::Owner::none; // there is no more room beside the body
        queue_.push(event);
    }
    // [events.await.others]
    waiting.called = noted_[first].time;
    queue_.push(noted_[first]);
    noted_.clear();
    return stale;
}

void ForeseenEvents::remember_look(const Event& look)
{
    std::vector<NextLook>& looks = looks_[look.a];
    const auto is_theirs = [&](const NextLook& one) { return one.with == look.b; };
    const auto found = std::find_if(looks.begin(), looks.end(), is_theirs);
    const NextLook next{look.b, look.stamp, look.time};
    if (found != looks.end()) *found = next;
    else looks.push_back(next);
}

void ForeseenEvents::call_all()
{
    for (const Event& event : noted_) queue_.push(event);
    noted_.clear();
}

void ForeseenEvents::sweep(const BodyRows& bodies)
{
    queue_.keep_if([&](const Event& event) { return bodies.is_current(event) || is_called(bodies, event); });
    sweep_at_ = std::max<std::size_t>(2 * queue_.size(), 1024);
    for (std::size_t id = 0; id < looks_.size(); ++id) {
        if (looks_[id].empty()) continue;
        const std::uint32_t own = bodies[bodies.row_of(static_cast<int>(id))].stamp;
        std::erase_if(looks_[id],
                      [&](const NextLook& look) { return look.stamp != own + bodies[bodies.row_of(look.with)].stamp; });
    }
}

void ForeseenEvents::clear()
{
    queue_.clear();
    for (Waiting& waiting : waiting_) waiting = {};
    for (Event& impact : struck_) impact = {};
    for (std::vector<NextLook>& looks : looks_) looks.clear();
}

void ForeseenEvents::line_up(std::span<const int> old_rows)
{
    std::vector<Waiting> waiting;
    waiting.reserve(waiting_.size());
    for (const int old : old_rows) waiting.push_back(waiting_[old]);
    waiting_.swap(waiting);
}

} // namespace flying
