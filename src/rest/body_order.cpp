#include "rest/body_order.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <numeric>
#include <utility>

#include "geometry/aabb.hpp"

namespace flying {
namespace {

/// Columns, and rows, into which all that there is is divided.
constexpr std::uint32_t k_divisions = 1u << 16;

/// The 16 lower bits, each with a free place before it.
[[nodiscard]] std::uint32_t spread(std::uint32_t bits)
{
    bits = (bits | bits << 8) & 0x00ff00ffu;
    bits = (bits | bits << 4) & 0x0f0f0f0fu;
    bits = (bits | bits << 2) & 0x33333333u;
    return (bits | bits << 1) & 0x55555555u;
}

/// How far along the curve a point lies: the bits of its row and its column, in turn.
[[nodiscard]] std::uint32_t along_curve(const Vec2& point, const Aabb& all)
{
    const auto division = [](double part) {
        return static_cast<std::uint32_t>(std::clamp(part * k_divisions, 0.0, k_divisions - 1.0));
    };
    const Vec2 size = (all.max - all.min).cwiseMax(Vec2(1e-300, 1e-300));
    const Vec2 part = (point - all.min).cwiseQuotient(size);
    return spread(division(part.x())) | spread(division(part.y())) << 1;
}

} // namespace

std::vector<int> order_in_memory(std::span<const RestBody> bodies, int few)
{
    std::vector<int> order(bodies.size());
    std::iota(order.begin(), order.end(), 0);
    const auto moving =
        std::count_if(bodies.begin(), bodies.end(), [](const RestBody& body) { return !body.is_static; });
    if (moving <= few) return order;

    const auto is_finite = [&](int k) { return !std::holds_alternative<HalfPlane>(bodies[k].shape); };
    std::vector<Vec2> centres(bodies.size(), Vec2::Zero());
    constexpr double k_far = std::numeric_limits<double>::infinity();
    Aabb all{Vec2(k_far, k_far), Vec2(-k_far, -k_far)};
    for (const int k : order) {
        if (!is_finite(k)) continue;
        const Aabb box = bounding_box(bodies[k].shape, pose_of(bodies[k].state));
        centres[k] = 0.5 * (box.min + box.max);
        all = {all.min.cwiseMin(centres[k]), all.max.cwiseMax(centres[k])};
    }
    std::vector<std::pair<bool, std::uint32_t>> places; // half-planes come first
    for (const int k : order) places.emplace_back(is_finite(k), is_finite(k) ? along_curve(centres[k], all) : 0);
    std::stable_sort(order.begin(), order.end(), [&](int one, int two) { return places[one] < places[two]; });
    return order;
}

} // namespace flying
