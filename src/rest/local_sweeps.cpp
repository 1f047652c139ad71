#include "rest/local_sweeps.hpp"

#include <numeric>

#include "rest/sweeps.hpp"

namespace flying {

namespace {

[[nodiscard]] bool misses(const ContactPoint& c, std::span<const Mover> movers, double allowed)
{
    return c.bound - normal_speed(c, movers[c.a], movers[c.b]) > allowed;
}

} // namespace

/// Finds the pairs, and which of them each body belongs to. Bodies are numbered as they come, so that it costs nothing
/// how many others there are. What can't move makes nothing miss: it has the number 0, and no pairs.
void LocalSweeps::list_runs(std::span<const Mover> movers, std::span<const ContactPoint> points)
{
    runs_.clear();
    number_.resize(movers.size());
    for (const ContactPoint& c : points) number_[c.a] = number_[c.b] = 0;
    first_of_.assign(3, 0);
    for (std::size_t k = 0; k < points.size();) {
        const ContactPoint& c = points[k];
        const std::size_t from = k;
        while (k < points.size() && points[k].pair == c.pair) ++k;
        runs_.push_back({static_cast<int>(from), static_cast<int>(k - from)});
        for (const int body : {c.a, c.b}) {
            if (!(movers[body].inv_mass > 0.0)) continue;
            if (number_[body] == 0) {
                number_[body] = static_cast<int>(first_of_.size()) - 2;
                first_of_.push_back(0);
            }
            ++first_of_[number_[body] + 2];
        }
    }
    std::partial_sum(first_of_.begin(), first_of_.end(), first_of_.begin());
    of_body_.resize(first_of_.back());
    for (std::size_t k = 0; k < runs_.size(); ++k) {
        const ContactPoint& c = points[runs_[k].first];
        for (const int body : {c.a, c.b}) {
            if (number_[body] > 0) of_body_[first_of_[number_[body] + 1]++] = static_cast<int>(k);
        }
    }
}

void LocalSweeps::look_at(int run, std::span<const Mover> movers, std::span<const ContactPoint> points,
                          std::span<const double> allowed)
{
    Run& own = runs_[run];
    for (int k = own.first; k < own.first + own.count && !own.waits; ++k) {
        own.waits = misses(points[k], movers, allowed[k]);
        if (own.waits) queue_.push_back(run);
    }
}

bool LocalSweeps::sweep(std::span<Mover> movers, std::span<ContactPoint> points, std::span<const double> allowed,
                        int most)
{
    std::size_t content = 0;
    while (content < points.size() && !misses(points[content], movers, allowed[content])) ++content;
    if (content == points.size()) return true;
    list_runs(movers, points);
    // [rest.sweep.local]
    queue_.clear();
    for (std::size_t run = 0; run < runs_.size(); ++run) look_at(static_cast<int>(run), movers, points, allowed);
    std::size_t next = 0;
    for (; next < queue_.size() && static_cast<int>(next) < most; ++next) {
        Run& run = runs_[queue_[next]];
        run.waits = false;
        const std::span<ContactPoint> own = points.subspan(run.first, run.count);
        flying::sweep(own, movers);
        for (const int body : {own.front().a, own.front().b}) {
            const int number = number_[body];
            for (int k = first_of_[number]; k < first_of_[number + 1]; ++k)
                look_at(of_body_[k], movers, points, allowed);
        }
    }
    return next == queue_.size();
    // [rest.sweep.local]
}

} // namespace flying
