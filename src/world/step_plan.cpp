#include "world/step_plan.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "rest/body_set.hpp"
#include "world/reach_in_step.hpp"
#include "world/step_length.hpp"

namespace flying {
namespace {

/// Those that fly as a step begins, and have not been taken in.
class Flights
{
public:
    explicit Flights(const StepStart& start) : start_(start), taken_(start.flying.body_count()) {}

    void take(std::span<const int> bodies) { taken_.insert(bodies); }

    /// All whose flights come near those that lean, or what these may wake; ascending.
    [[nodiscard]] std::vector<int> near(const HandOver& hand_over, double end)
    {
        has_boxes_ = false;
        std::vector<int> near;
        for (const int k : start_.movers.list(BodyMover::events)) {
            if (taken_.has(k)) continue;
            const Aabb box = box_of(k, end);
            if (!std::isfinite(box.max.x()) || hand_over.is_near(box)) near.push_back(k);
        }
        return near;
    }

    /// Those whose flights come near what reaches further than before; ascending.
    [[nodiscard]] std::vector<int> near_to(std::span<const BoxCells::Entry> reaches, double end)
    {
        if (!has_boxes_) sort_boxes(end);
        std::vector<int> near;
        for (const BoxCells::Entry& reach : reaches) {
            boxes_.visit_all_at(reach.box, [&](const BoxCells::Entry& flight) {
                if (!taken_.has(flight.body)) near.push_back(flight.body);
                return true;
            });
        }
        std::sort(near.begin(), near.end());
        near.erase(std::unique(near.begin(), near.end()), near.end());
        return near;
    }

private:
    [[nodiscard]] Aabb box_of(int body, double end) const
    {
        return flight_box(start_.flying.flyer(body), start_.radius[body], start_.flying.time(), end);
    }
    void sort_boxes(double end)
    {
        std::vector<BoxCells::Entry> boxes;
        for (const int k : start_.movers.list(BodyMover::events)) {
            if (!taken_.has(k)) boxes.push_back({box_of(k, end), k});
        }
        boxes_.sort(std::move(boxes));
        has_boxes_ = true;
    }

    const StepStart& start_;
    BodySet taken_;
    BoxCells boxes_; // until the step ends, of those that came near nothing at first
    bool has_boxes_ = false;
};

} // namespace

std::vector<Leaning> leaning_among(std::span<const int> bodies, const StepStart& start)
{
    std::vector<Leaning> all;
    for (const int k : bodies) {
        const RestBody& body = start.resting.body(k);
        all.push_back(leaning_of(k, body.shape, body.state, start.radius[k], start.field, start.step));
    }
    return all;
}

StepPlan plan_step(const StepStart& start, HandOver& hand_over)
{
    const double now = start.resting.time();
    const auto pace = [&](int k, const BodyState& state) {
        return pace_of(state, start.flying.shape(k), start.radius[k], start.field);
    };
    double fastest = 0.0;
    for (const int k : start.movers.list(BodyMover::rest)) fastest = std::max(fastest, pace(k, start.resting.state(k)));
    int halvings = halvings_for(start.step, fastest);
    StepPlan plan{next_end(start.step, now, halvings), {}};
    Flights flights(start);
    hand_over.reach(plan.end - now);
    std::vector<int> near = flights.near(hand_over, plan.end);
    while (!near.empty()) {
        // Those that come fast need short steps, in which fewer come near
        double fastest_near = fastest;
        for (const int k : near) fastest_near = std::max(fastest_near, pace(k, start.flying.flyer(k).state));
        if (const int needed = halvings_for(start.step, fastest_near); needed > halvings) {
            halvings = needed;
            plan.end = next_end(start.step, now, halvings);
            hand_over.reach(plan.end - now);
            near = flights.near(hand_over, plan.end);
            continue;
        }

        // Once taken in, they lean as well
        std::vector<Leaning> more;
        for (const int k : near) {
            const BodyState state = state_at(start.flying.flyer(k), now);
            fastest = std::max(fastest, pace(k, state));
            more.push_back(leaning_of(k, start.flying.shape(k), state, start.radius[k], start.field, start.step));
        }
        flights.take(near);
        plan.taken.push_back(std::move(near));
        near = flights.near_to(hand_over.add(more), plan.end);
    }
    hand_over.end();
    return plan;
}

} // namespace flying
