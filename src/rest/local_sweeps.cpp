#include "rest/local_sweeps.hpp"

#include <numeric>

#include "rest/sweeps.hpp"

namespace flying {

/// Finds the pairs, and which of them each body belongs to. What can't move makes nothing miss.
void LocalSweeps::list_runs(std::span<const Mover> movers, std::span<const ContactPoint> points)
{
    runs_.clear();
    first_of_.assign(movers.size() + 2, 0);
    for (std::size_t k = 0; k < points.size();) {
        const ContactPoint& c = points[k];
        const std::size_t from = k;
        while (k < points.size() && points[k].pair == c.pair) ++k;
        runs_.push_back({static_cast<int>(from), static_cast<int>(k - from)});
        for (const int body : {c.a, c.b}) first_of_[body + 2] += movers[body].inv_mass > 0.0 ? 1 : 0;
    }
    std::partial_sum(first_of_.begin(), first_of_.end(), first_of_.begin());
    of_body_.resize(first_of_.back());
    for (std::size_t k = 0; k < runs_.size(); ++k) {
        const ContactPoint& c = points[runs_[k].first];
        for (const int body : {c.a, c.b}) {
            if (movers[body].inv_mass > 0.0) of_body_[first_of_[body + 1]++] = static_cast<int>(k);
        }
    }
}

void LocalSweeps::look_at(int run, std::span<const Mover> movers, std::span<const ContactPoint> points,
                          std::span<const double> allowed)
{
    Run& own = runs_[run];
    for (int k = own.first; k < own.first + own.count && !own.waits; ++k) {
        const ContactPoint& c = points[k];
        own.waits = c.bound - normal_speed(c, movers[c.a], movers[c.b]) > allowed[k];
        if (own.waits) queue_.push_back(run);
    }
}

bool LocalSweeps::sweep(std::span<Mover> movers, std::span<ContactPoint> points, std::span<const double> allowed,
                        int most)
{
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
            for (int k = first_of_[body]; k < first_of_[body + 1]; ++k) look_at(of_body_[k], movers, points, allowed);
        }
    }
    return next == queue_.size();
    // [rest.sweep.local]
}

} // namespace flying
