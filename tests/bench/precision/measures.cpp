#include <algorithm>
#include <cmath>
#include <memory>

#include "14-time-against-error/spread.hpp"
#include "trial.hpp"

namespace flying::bench {

std::vector<TrialMaker> trial_makers()
{
    std::vector<TrialMaker> all;
    for (const auto part : {flight_trials, impact_trials, gas_trials, rest_trials}) {
        for (TrialMaker& one : part()) all.push_back(std::move(one));
    }
    return all;
}

Measure median_distance(const Scene& scene, std::function<Place(int, double)> truth)
{
    const std::vector<WeighedBody> bodies = weigh(scene);
    return {"distance from the truth [m]",
            [bodies, truth = std::move(truth)](const Story& story) -> std::optional<double> {
                std::vector<double> worst;
                for (int k = 0; k < static_cast<int>(bodies.size()); ++k) {
                    if (bodies[k].is_static) continue;
                    double& distance = worst.emplace_back(0.0);
                    for (const Look& look : story.looks) {
                        const Place place = truth(k, look.time);
                        const BodyState& state = look.states[k];
                        double now = (state.position - place.position).norm();
                        if (place.angle) now += bodies[k].radius * std::abs(state.angle - *place.angle);
                        // What is no number is as far off as can be
                        distance = std::isfinite(now) ? std::max(distance, now) : HUGE_VAL;
                    }
                }
                return work::spread_of(std::move(worst)).median;
            }};
}

Measure energy_drift(const Scene& scene)
{
    const std::vector<WeighedBody> bodies = weigh(scene);
    return {"energy drift, relative", [bodies, scene](const Story& story) -> std::optional<double> {
                const double before = total_energy(bodies, story.looks.front().states, scene);
                const double after = total_energy(bodies, story.looks.back().states, scene);
                return std::abs(after / before - 1.0);
            }};
}

Measure energy_gain(const Scene& scene)
{
    const std::vector<WeighedBody> bodies = weigh(scene);
    return {"energy gained, relative", [bodies, scene](const Story& story) -> std::optional<double> {
                double least = HUGE_VAL;
                double gain = 0.0;
                double first = 0.0;
                for (const Look& look : story.looks) {
                    const double now = total_energy(bodies, look.states, scene);
                    if (least == HUGE_VAL) first = std::abs(now);
                    least = std::min(least, now);
                    gain = std::max(gain, now - least);
                }
                return first > 0.0 ? gain / first : gain;
            }};
}

Measure deepest_overlap(const Scene& scene)
{
    const auto ruler = std::make_shared<OverlapRuler>(scene, weigh(scene));
    return {"deepest overlap [m]", [ruler](const Story& story) -> std::optional<double> {
                double deepest = 0.0;
                for (const Look& look : story.looks) deepest = std::max(deepest, ruler->deepest(look.states));
                return deepest;
            }};
}

Measure largest_shift()
{
    return {"largest shift from where it stood [m]", [](const Story& story) -> std::optional<double> {
                double largest = 0.0;
                const Look& first = story.looks.front();
                const Look& last = story.looks.back();
                for (std::size_t k = 0; k < first.states.size(); ++k) {
                    largest = std::max(largest, (last.states[k].position - first.states[k].position).norm());
                }
                return largest;
            }};
}

std::vector<double> looks_every(double every, double until)
{
    std::vector<double> looks;
    const long count = std::lround(until / every);
    for (long k = 0; k <= count; ++k) looks.push_back(static_cast<double>(k) * every);
    return looks;
}

} // namespace flying::bench
