// Parts of the event engine by themselves, against the plainest thing that does the same.

#include <doctest/doctest.h>

#include <cmath>
#include <set>
#include <vector>

#include "broadphase/grid.hpp"
#include "events/event_queue.hpp"
#include "math/random.hpp"

using namespace flying;

namespace {

struct InOrder
{
    [[nodiscard]] bool operator()(const Event& p, const Event& q) const { return happens_before(p, q); }
};

/// Let the queue and a sorted set take and give the same events. Every time the first goes, another comes.
/// wait(random)  how long after the first the other is due  [s]
template <typename Wait>
void compare(int count, std::uint64_t seed, const Wait& wait)
{
    Random random(seed);
    EventQueue queue;
    std::multiset<Event, InOrder> oracle;
    const auto push = [&](double time, int name) {
        Event event;
        event.time = time;
        event.a = name;
        event.b = name + 1;
        if (random.below(3) == 0) event.kind = Event::Kind::cell;
        queue.push(event);
        oracle.insert(event);
    };
    for (int k = 0; k < count; ++k) push(wait(random), k);
    queue.keep_if([](const Event&) { return true; }); // lays out the days
    bool all_equal = true;
    for (int k = 0; k < 4 * count; ++k) {
        const Event first = queue.next();
        all_equal = all_equal && first.time == oracle.begin()->time && first.a == oracle.begin()->a;
        queue.pop();
        oracle.erase(oracle.begin());
        push(first.time + wait(random), count + k);
    }
    CHECK(all_equal);
    CHECK(queue.size() == oracle.size());
}

} // namespace

TEST_CASE("the queue gives events in their order, whatever days and hours they fall into")
{
    for (const int count : {1, 10, 600, 5000}) {
        CAPTURE(count);
        compare(count, 1, [](Random& random) { return random.uniform(); });
        compare(count, 2, [](Random& random) { return -std::log(1.0 - random.uniform()); });
        // Many at one moment
        compare(count, 3, [](Random& random) { return 0.25 * random.below(5); });
        // Moments that hardly differ, among others that do
        compare(count, 4, [](Random& random) {
            const bool is_late = random.below(2) == 0;
            return is_late ? 1.0 + 0x1p-50 * random.below(1000) : random.uniform();
        });
    }
}

TEST_CASE("bodies about a cell, written down without a guess, are those that a visit meets, in its order")
{
    Random random(5);
    constexpr int k_bodies = 300;
    Grid grid(1.0, 8, 8, k_bodies); // about five in a cell
    const auto any_cell = [&] {
        const int column = random.below(20) - 10;
        const int row = random.below(20) - 10;
        return Cell{column, row};
    };
    for (int k = 0; k < k_bodies; ++k) grid.insert(k, any_cell());
    for (int k = 0; k < 1000; ++k) {
        grid.move(random.below(k_bodies), any_cell());
        const Cell cell = any_cell();
        std::vector<int> visited;
        grid.for_each_near(cell, [&](int other) { visited.push_back(other); });
        std::vector<int> gathered(k_bodies + 1);
        gathered.resize(static_cast<std::size_t>(grid.gather_near(cell, gathered.data()) - gathered.data()));
        REQUIRE(gathered == visited);
    }
}
