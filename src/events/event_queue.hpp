#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace flying {

/// Something that will happen, if its bodies are left alone until then.
struct Event
{
    enum class Kind : std::uint8_t
    {
        cell,   ///< body a leaves its cell
        look,   ///< the pair must be looked at again
        later,  ///< the pair was looked at for as long as both were thought to fly: ask the same for more
        impact, ///< the pair meets
    };
    enum class Owner : std::uint8_t
    {
        none,
        a,
        b
    }; ///< whose first event it is

    double time = 0.0;       ///< [s]
    int a = -1;              ///< lower id
    int b = -1;              ///< higher id; below 0 for a cell: -1 - its side
    std::uint32_t stamp = 0; ///< how often both had been pushed when this was foreseen
    Kind kind = Kind::impact;
    Owner owner = Owner::none;
};

/// The order in which events happen: by time; at one time, what may foresee more
/// impacts before the impacts; then by the lower id, then by the higher. Events that count are equal in all of these
/// only where both bodies of an impact foresaw it; the first of the two overtakes the other.
[[nodiscard]] inline bool happens_before(const Event& p, const Event& q)
{
    if (p.time != q.time) return p.time < q.time;
    const bool p_strikes = p.kind == Event::Kind::impact;
    const bool q_strikes = q.kind == Event::Kind::impact;
    if (p_strikes != q_strikes) return q_strikes;
    if (p.a != q.a) return p.a < q.a;
    return p.b < q.b;
}

/// Until when another event may belong to the same moment: so near are times that may differ by rounding alone. Whether
/// it does must be seen from the bodies.  [s]
[[nodiscard]] inline double end_of_moment(double time)
{
    return time + 0x1p-30 * std::abs(time);
}

/// Events by the order in which they happen. What lies farther off waits in days, unordered, until its day comes (a
/// calendar: Paul, "A complexity O(1) priority queue for event driven molecular dynamics simulations", 2007). Then the
/// day is put in order, once; what is foreseen for today while it lasts goes to a heap beside it. Events that are
/// overtaken stay until they come up, or until `keep_if` sweeps them out.
class EventQueue
{
public:
    void push(const Event& event)
    {
        // Every event finds its day by the same rounding, so that no two change their
        // order over a midnight
        const double tomorrow = static_cast<double>(next_day_);
        if (day_count_ == 0 || day_of(event.time) < tomorrow) push_today(event);
        else push_later(event);
        ++size_;
    }

    /// The first event; only where not empty.
    [[nodiscard]] const Event& next()
    {
        if (today_.empty() && late_.empty()) turn_page();
        return late_is_next() ? late_.front() : today_.back();
    }
    void pop();

    /// The event that comes so many places after the first, as far as today's order is known; null where it isn't.
    [[nodiscard]] const Event* upcoming(std::size_t places) const
    {
        return places < today_.size() ? &today_[today_.size() - 1 - places] : nullptr;
    }

    [[nodiscard]] bool empty() const { return size_ == 0; }
    [[nodiscard]] std::size_t size() const { return size_; }
    void clear();

    /// Drop all events for which keep(event) is false, and fit the days to what is left.
    template <typename Keep>
    void keep_if(Keep&& keep)
    {
        gather_all();
        std::size_t kept = 0;
        for (const Event& event : today_) {
            if (keep(event)) today_[kept++] = event;
        }
        today_.resize(kept);
        lay_out();
    }

private:
    /// Days since the first one, never decreasing with time.
    [[nodiscard]] double day_of(double time) const { return (time - first_day_starts_) * days_a_second_; }
    [[nodiscard]] bool late_is_next() const
    {
        return today_.empty() || (!late_.empty() && happens_before(late_.front(), today_.back()));
    }
    void push_today(const Event& event);
    void push_later(const Event& event);
    void turn_page();
    void sort_today();
    void gather_all();
    void lay_out();

    std::vector<Event> today_;             // the last comes first
    std::vector<Event> late_;              // of today, or of all days where there are none: heap
    std::vector<std::vector<Event>> days_; // all of one length; those that are over keep their memory for others
    std::size_t day_count_ = 0;            // of them in use; none while there is only today
    std::vector<Event> far_;               // after the last day
    std::size_t next_day_ = 0;             // tomorrow, in days_
    double first_day_starts_ = 0.0;        // [s]
    double days_a_second_ = 0.0;           // [1/s]
    std::size_t size_ = 0;
    std::vector<std::uint32_t> hour_ends_; // workspace of sorting
    std::vector<Event> sorted_;            // workspace of sorting
};

} // namespace flying
