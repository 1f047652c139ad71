#include "world/start_overlaps.hpp"

#include <algorithm>
#include <tuple>

#include "broadphase/sweep.hpp"
#include "math/tolerance.hpp"

namespace flying {

double start_overlap_allowed(double size, double reach)
{
    return tolerance::k_start_overlap * size + tolerance::k_coordinate_roundings * tolerance::k_epsilon * reach;
}

// [world.start_overlaps]
std::vector<StartOverlap> find_start_overlaps(const std::vector<PlacedBody>& bodies, std::size_t most)
{
    std::vector<BoxedBody> boxed;
    for (int k = 0; k < static_cast<int>(bodies.size()); ++k) boxed.push_back({k, bodies[k].is_static, bodies[k].box});
    Sweep sweep;
    sweep.line_up(boxed);

    // Look at each pair of boxes that overlap, until there are too many to name
    std::vector<StartOverlap> overlaps;
    sweep.for_each_pair([&](int j, int k) {
        const PlacedBody& a = bodies[j];
        const PlacedBody& b = bodies[k];
        const double depth = -separation(a.shape, a.pose, b.shape, b.pose);
        const double reach = a.pose.position.norm() + b.pose.position.norm() + a.size + b.size;
        if (depth > start_overlap_allowed(std::min(a.size, b.size), reach)) {
            overlaps.push_back({std::min(a.index, b.index), std::max(a.index, b.index), depth});
        }
        return overlaps.size() <= most;
    });

    std::sort(overlaps.begin(), overlaps.end(), [](const StartOverlap& a, const StartOverlap& b) {
        return std::tuple(a.second, a.first) < std::tuple(b.second, b.first);
    });
    if (overlaps.size() > most) overlaps.resize(most);
    return overlaps;
}
// [world.start_overlaps]

} // namespace flying
