#include "world/start_overlaps.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "math/tolerance.hpp"

namespace flying {

namespace {

/// The coordinate along which the middles of the boxes spread further: 0 for x, 1 for y.
int longer_side(const std::vector<PlacedBody>& bodies)
{
    if (bodies.empty()) return 0;
    Vec2 low = bodies[0].pose.position;
    Vec2 high = low;
    for (const PlacedBody& body : bodies) {
        low = low.cwiseMin(body.pose.position);
        high = high.cwiseMax(body.pose.position);
    }
    return high.x() - low.x() >= high.y() - low.y() ? 0 : 1;
}

} // namespace

double start_overlap_allowed(double size, double reach)
{
    return tolerance::k_start_overlap * size + tolerance::k_coordinate_roundings * tolerance::k_epsilon * reach;
}

// [world.start_overlaps]
std::vector<StartOverlap> find_start_overlaps(const std::vector<PlacedBody>& bodies, std::size_t most)
{
    // Take the bodies in the order in which a line sweeping over the plane meets them
    const int axis = longer_side(bodies);
    std::vector<const PlacedBody*> order;
    for (const PlacedBody& body : bodies) order.push_back(&body);
    std::sort(order.begin(), order.end(), [axis](const PlacedBody* a, const PlacedBody* b) {
        return std::tuple(a->box.min[axis], a->index) < std::tuple(b->box.min[axis], b->index);
    });

    std::vector<StartOverlap> overlaps;
    std::vector<const PlacedBody*> under_line;
    for (const PlacedBody* body : order) {
        // Forget the bodies that the line has left behind
        std::erase_if(under_line, [&](const PlacedBody* other) { return other->box.max[axis] < body->box.min[axis]; });

        for (const PlacedBody* other : under_line) {
            if ((body->is_static && other->is_static) || !overlap(body->box, other->box)) continue;
            const double depth = -separation(other->shape, other->pose, body->shape, body->pose);
            const double reach = body->pose.position.norm() + other->pose.position.norm() + body->size + other->size;
            if (depth <= start_overlap_allowed(std::min(body->size, other->size), reach)) continue;
            overlaps.push_back({std::min(body->index, other->index), std::max(body->index, other->index), depth});
        }
        if (overlaps.size() > most) break;
        under_line.push_back(body);
    }

    std::sort(overlaps.begin(), overlaps.end(), [](const StartOverlap& a, const StartOverlap& b) {
        return std::tuple(a.second, a.first) < std::tuple(b.second, b.first);
    });
    if (overlaps.size() > most) overlaps.resize(most);
    return overlaps;
}
// [world.start_overlaps]

} // namespace flying
