#include <doctest/doctest.h>

#include <algorithm>
#include <vector>

#include "response/impacts_at_once.hpp"
#include "response/push_line.hpp"

// Bricks of a wall that a ball hits push each other all at once. Their pushes were looked for by a thousand sweeps, in
// which each met only its share of a brick: of the groups of more than eight points most kept some of their approach,
// up to a thirtieth of their speed, and the sweeps were most of the time of the step in which the ball arrives.

using namespace flying;

namespace {

/// Bricks in courses, every other one shifted by half a brick, on a floor. All of them come nearer to one place in it.
struct Wall
{
    std::vector<ImpactBody> bodies{{}};
    std::vector<ImpactPair> pairs;
    std::vector<ImpactPoint> points;

    Wall(int courses, int bricks, double friction)
    {
        std::vector<Vec2> places{Vec2::Zero()};
        for (int k = 0; k < courses * bricks; ++k) {
            const int course = k / bricks;
            places.emplace_back(0.4 * (k % bricks) + 0.2 * (course % 2), 0.2 * course + 0.1);
            const Vec2& place = places.back();
            const Vec2 way = place - Vec2(0.17 * bricks, 0.0);
            bodies.push_back({-way, 0.1 * way.x(), {0.125, 7.5}});
            const int own = k + 1;
            const auto touch = [&](int other, const Vec2& normal, const Vec2& first, const Vec2& last) {
                pairs.push_back({other, own, points.size(), points.size() + 2, {0.0, friction}});
                for (const Vec2& at : {first, last}) {
                    const Vec2 r_a = other == 0 ? at : Vec2(at - places[other]);
                    points.push_back({r_a, at - place, normal});
                }
            };
            if (k % bricks > 0) touch(k, {1.0, 0.0}, place + Vec2(-0.2, -0.1), place + Vec2(-0.2, 0.1));
            if (course == 0) touch(0, {0.0, 1.0}, place + Vec2(-0.2, -0.1), place + Vec2(0.2, -0.1));
            for (int below = 1; below < own && course > 0; ++below) {
                const Vec2 gap = place - places[below];
                if (gap.y() < 0.15 || gap.y() > 0.25 || gap.x() < -0.3 || gap.x() > 0.3) continue;
                const double left = std::max(place.x(), places[below].x()) - 0.2;
                const double right = std::min(place.x(), places[below].x()) + 0.2;
                touch(below, {0.0, 1.0}, {left, place.y() - 0.1}, {right, place.y() - 0.1});
            }
        }
    }
    /// The fastest approach.  [m/s]
    [[nodiscard]] double approach() const
    {
        double worst = 0.0;
        for (const ImpactPair& pair : pairs) {
            const ImpactBody& a = bodies[pair.a];
            const ImpactBody& b = bodies[pair.b];
            for (std::size_t k = pair.first; k < pair.end; ++k) {
                const PairMotion motion{a.velocity, b.velocity, a.spin, b.spin};
                worst = std::max(worst, -speed_along(frame_at(points[k]).normal, motion));
            }
        }
        return worst;
    }
};

} // namespace

TEST_CASE("what pushes together without rebound no longer approaches after one round, to rounding")
{
    for (const int courses : {2, 3, 5}) {
        for (const double friction : {0.0, 0.3, 0.6}) {
            Wall wall(courses, 4, friction);
            CAPTURE(courses);
            CAPTURE(friction);
            CHECK(wall.approach() > 0.3);
            const std::vector<double> slowest(wall.points.size(), 1e-12);
            CHECK(resolve_impacts(wall.bodies, wall.pairs, wall.points, slowest, 1) >= 3 * courses);
            CHECK(wall.approach() < 1e-13);
        }
    }
}
