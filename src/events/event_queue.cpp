#include "events/event_queue.hpp"

#include <algorithm>
#include <cmath>

namespace flying {
namespace {

/// The standard heap keeps the largest in front. A type rather than a function, so that heaps compile it in.
struct HappensAfter
{
    [[nodiscard]] bool operator()(const Event& p, const Event& q) const { return happens_before(q, p); }
};

/// Least events of one day, and most days in half a calendar: days are few enough for the ends of all their lists to
/// stay in the fast memory, into which new events are written, and no longer than that asks, for each is sorted.
constexpr std::size_t k_events_a_day = 256;
constexpr std::size_t k_days = 128;

} // namespace

void EventQueue::push_today(const Event& event)
{
    late_.push_back(event);
    std::push_heap(late_.begin(), late_.end(), HappensAfter{});
}

void EventQueue::pop()
{
    if (today_.empty() && late_.empty()) turn_page();
    if (late_is_next()) {
        std::pop_heap(late_.begin(), late_.end(), HappensAfter{});
        late_.pop_back();
    } else {
        today_.pop_back();
    }
    --size_;
}

void EventQueue::push_later(const Event& event)
{
    const double day = day_of(event.time);
    if (day < static_cast<double>(day_count_)) days_[static_cast<std::size_t>(day)].push_back(event);
    else far_.push_back(event);
}

/// Make the next day that holds anything today. Only where not empty.
void EventQueue::turn_page()
{
    while (today_.empty()) {
        if (next_day_ == day_count_) {
            gather_all();
            lay_out();
            return;
        }
        today_.swap(days_[next_day_]);
        ++next_day_;
    }
    sort_today();
}

/// Put today in order, the last first. The hours of a day are as many as its events, which find theirs by their times,
/// so that few comparisons are left: each would be a guess, wrong every other time.
void EventQueue::sort_today()
{
    const std::size_t count = today_.size();
    const double today = static_cast<double>(next_day_ - 1);
    const double hours = static_cast<double>(count);
    const auto hour_of = [&](const Event& event) {
        // Backwards, and never out of the day by rounding
        const auto passed = static_cast<std::size_t>((day_of(event.time) - today) * hours);
        return count - 1 - std::min(passed, count - 1);
    };
    hour_ends_.assign(count + 1, 0);
    std::uint32_t busiest = 0;
    for (const Event& event : today_) busiest = std::max(busiest, ++hour_ends_[hour_of(event) + 1]);

    // Where many share an hour, guess after all
    constexpr std::uint32_t k_most = 16;
    if (busiest > k_most) {
        std::sort(today_.begin(), today_.end(), HappensAfter{});
        return;
    }

    for (std::size_t hour = 1; hour <= count; ++hour) hour_ends_[hour] += hour_ends_[hour - 1];
    sorted_.resize(count);
    for (const Event& event : today_) sorted_[hour_ends_[hour_of(event)]++] = event;
    today_.swap(sorted_);
    for (std::size_t k = 1; k < count; ++k) {
        const Event event = today_[k];
        std::size_t place = k;
        for (; place > 0 && happens_before(today_[place - 1], event); --place) today_[place] = today_[place - 1];
        if (place != k) today_[place] = event;
    }
}

void EventQueue::gather_all()
{
    today_.insert(today_.end(), late_.begin(), late_.end());
    late_.clear();
    for (std::size_t day = next_day_; day < day_count_; ++day) {
        today_.insert(today_.end(), days_[day].begin(), days_[day].end());
        days_[day].clear();
    }
    today_.insert(today_.end(), far_.begin(), far_.end());
    far_.clear();
    next_day_ = day_count_;
}

/// Spread what `today_` holds, all of it, over days of about equal weight.
void EventQueue::lay_out()
{
    size_ = today_.size();
    day_count_ = 0;
    next_day_ = 0;
    if (size_ >= 2 * k_events_a_day) {
        // The median tells how dense the near half lies
        std::vector<Event> all;
        all.swap(today_);
        const auto middle = all.begin() + static_cast<std::ptrdiff_t>(all.size() / 2);
        const auto earlier = [](const Event& p, const Event& q) { return p.time < q.time; };
        std::nth_element(all.begin(), middle, all.end(), earlier);
        const double start = std::min_element(all.begin(), middle, earlier)->time;
        const double half = middle->time - start;
        const std::size_t events_a_day = std::max(k_events_a_day, all.size() / 2 / k_days);
        const double days_in_half = static_cast<double>(all.size() / 2) / static_cast<double>(events_a_day);
        days_a_second_ = days_in_half / half;

        if (std::isfinite(days_a_second_) && days_a_second_ > 0.0) {
            first_day_starts_ = start;
            day_count_ = static_cast<std::size_t>(4.0 * days_in_half) + 1;
            if (days_.size() < day_count_) days_.resize(day_count_);
            for (const Event& event : all) push_later(event);
            turn_page();
            return;
        }
        today_.swap(all);
    }

    // Too few for days
    late_.swap(today_);
    std::make_heap(late_.begin(), late_.end(), HappensAfter{});
}

void EventQueue::clear()
{
    today_.clear();
    late_.clear();
    for (std::vector<Event>& day : days_) day.clear();
    day_count_ = 0;
    far_.clear();
    next_day_ = 0;
    size_ = 0;
}

} // namespace flying
