#include <doctest/doctest.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "events/foreseen.hpp"
#include "math/random.hpp"

using namespace flying;

namespace {

/// Discs of which nothing matters but their ids and how often they were pushed.
BodyRows some_bodies(int count)
{
    std::vector<EventBody> bodies(static_cast<std::size_t>(count));
    for (EventBody& body : bodies) {
        body.shape = Disc{1.0};
        body.inertia = {1.0, 1.0};
    }
    return BodyRows(std::move(bodies));
}

/// Looks that are handled, in their order: each one's owner then has its next turn, and pushes come between.
struct Told
{
    std::vector<double> handled;
    std::vector<double> expected; ///< those that were noted and not overtaken, by time
};

Told tell(std::uint64_t seed, bool lets_wait)
{
    constexpr int k_bodies = 12;
    Random random(seed);
    BodyRows bodies = some_bodies(k_bodies);
    ForeseenEvents foreseen(k_bodies, lets_wait);
    std::vector<Event> noted;
    const auto foresee = [&](int body, double now) {
        // More than find room beside a body
        for (int k = 0; k < 6; ++k) {
            const int other = (body + 1 + static_cast<int>(random.uniform(0.0, k_bodies - 1.0))) % k_bodies;
            if (other == body) continue;
            const double time = now + random.uniform(0.01, 3.0);
            foreseen.note_pair(time, bodies[body], bodies[other], Event::Kind::look);
            noted.push_back(
                {time, std::min(body, other), std::max(body, other), bodies[body].stamp + bodies[other].stamp});
        }
        (void)foreseen.await(bodies, body);
    };
    for (int body = 0; body < k_bodies; ++body) foresee(body, 0.0);

    Told told;
    const auto expect_until = [&](double now) {
        // Whatever is due by now and counts, before a push overtakes it
        for (const Event& event : noted) {
            if (event.time <= now && bodies.is_current(event)) told.expected.push_back(event.time);
        }
        std::erase_if(noted, [&](const Event& event) { return event.time <= now; });
    };
    for (int k = 0; !foreseen.is_empty() && k < 400; ++k) {
        const Event event = foreseen.next();
        foreseen.pop();
        const bool is_called = foreseen.is_called(bodies, event);
        const bool counts = bodies.is_current(event);
        if (counts) {
            told.handled.push_back(event.time);
            expect_until(event.time);
        }
        if (is_called) (void)foreseen.await(bodies, ForeseenEvents::owner_of(bodies, event));
        if (counts && k % 5 == 0) {
            bodies.set_motion(event.a, Vec2::Zero(), 0.0);
            foreseen.forget(event.a);
            foresee(event.a, event.time);
        }
        if (foreseen.has_grown()) foreseen.sweep(bodies);
    }
    std::sort(told.expected.begin(), told.expected.end());
    return told;
}

} // namespace

TEST_CASE(
    "what is foreseen comes up in the order of its times, none is lost and none overtaken, whether or not it waits")
{
    for (const bool lets_wait : {true, false}) {
        for (std::uint64_t seed = 1; seed <= 20; ++seed) {
            const Told told = tell(seed, lets_wait);
            CAPTURE(seed);
            CHECK(told.handled.size() > 50);
            CHECK(told.handled == told.expected);
        }
    }
}
