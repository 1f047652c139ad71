#include "draw/trail_path.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "math/vec2.hpp"

namespace flying {

namespace {

constexpr double k_farthest = 1e5; ///< a way that is longer is a leap, not a way [pixels]
constexpr double k_straight =
    0.1;                        ///< a point that is no farther from the way between its neighbours is left out [pixels]
constexpr double k_bend = 0.87; ///< cosine of the turn beyond which two ways are joined by a disc

struct Knot
{
    Vec2 at = Vec2::Zero(); ///< [pixels]
    double half = 0.0;      ///< of the width there [pixels]
};

/// The trail's points on the surface, without those between which it goes straight on.
std::vector<Knot> knots_of(const Trail& trail, const ViewMap& map)
{
    const std::size_t count = trail.points.size();
    std::vector<Knot> knots;
    std::size_t skipped = 0;
    for (std::size_t k = 0; k < count; ++k) {
        const Knot knot{map(trail.points[k]),
                        0.5 * trail.width * map.scale * static_cast<double>(k) / static_cast<double>(count - 1)};
        if (!knots.empty() && knot.at == knots.back().at) continue;

        // Where the last knot lies on the way from the one before it to this one, this one takes its place
        if (skipped < 6 && knots.size() > 1) {
            const Vec2 from = knots[knots.size() - 2].at;
            const Vec2 way = knot.at - from;
            const Vec2 last = knots.back().at - from;
            const double length = way.norm();
            const bool is_between = last.dot(way) > 0.0 && last.squaredNorm() < way.squaredNorm();
            if (is_between && std::abs(cross(way, last)) <= k_straight * length) {
                knots.back() = knot;
                ++skipped;
                continue;
            }
        }
        skipped = 0;
        knots.push_back(knot);
    }
    return knots;
}

void add_disc(cairo_t* cairo, const Knot& knot)
{
    cairo_new_sub_path(cairo);
    cairo_arc(cairo, knot.at.x(), knot.at.y(), knot.half, 0.0, 2.0 * std::numbers::pi);
    cairo_close_path(cairo);
}

/// A ribbon along knots, turning the same way as the discs: the winding rule would cut the others out.
void add_ribbon(cairo_t* cairo, const std::vector<Knot>& knots, std::size_t first, std::size_t last)
{
    if (last == first) return;
    const auto across = [&](std::size_t k) -> Vec2 {
        const Vec2 before = k > first ? Vec2(knots[k].at - knots[k - 1].at) : Vec2(knots[k + 1].at - knots[k].at);
        const Vec2 after = k < last ? Vec2(knots[k + 1].at - knots[k].at) : before;
        const Vec2 along = before.normalized() + after.normalized();
        return knots[k].half / along.norm() * perp(along);
    };
    cairo_new_sub_path(cairo);
    for (std::size_t k = first; k <= last; ++k) {
        const Vec2 side = knots[k].at - across(k);
        cairo_line_to(cairo, side.x(), side.y());
    }
    for (std::size_t k = last + 1; k-- > first;) {
        const Vec2 side = knots[k].at + across(k);
        cairo_line_to(cairo, side.x(), side.y());
    }
    cairo_close_path(cairo);
}

} // namespace

void add_trail_path(cairo_t* cairo, const Trail& trail, const ViewMap& map)
{
    if (trail.points.size() < 2) return;
    const std::vector<Knot> knots = knots_of(trail, map);
    std::size_t first = 0;
    for (std::size_t k = 1; k < knots.size(); ++k) {
        const Vec2 before = knots[k].at - knots[k - 1].at;
        if (before.norm() > k_farthest) {
            first = k;
            continue;
        }
        const bool is_last = k + 1 == knots.size();
        if (!is_last) {
            const Vec2 after = knots[k + 1].at - knots[k].at;
            const double turn = before.normalized().dot(after.normalized());
            // A gentle bend needs no joint, unless the ribbon is wider than its ways are long
            const bool is_gentle =
                turn > k_bend && knots[k].half * (1.0 - turn) < 0.25 * std::min(before.norm(), after.norm());
            if (is_gentle && after.norm() <= k_farthest) continue;
        }
        add_ribbon(cairo, knots, first, k);
        add_disc(cairo, knots[k]);
        first = k;
    }
}

} // namespace flying
