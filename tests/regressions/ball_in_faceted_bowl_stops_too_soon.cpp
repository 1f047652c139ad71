#include "support/effort.hpp"
#include "support/worlds.hpp"

#include <cmath>
#include <numbers>

using namespace flying;
using namespace flying::testing;

// A ball in a bowl of flat facets lost its energy ten times too fast, the faster the finer the facets were.
//
// What a kink takes: the ball, at speed v, meets the next facet at an angle d, and its velocity along that facet's
// normal, v sin d, ends there. Its bounces die away before the next kink, whatever e < 1. Sliding, it keeps v cos d,
// and loses v^2 d^2 / 2 of each kilogram's energy. Rolling, it keeps its angular momentum about the new point of
// contact: with I = m r^2 / 2, v' = v (2 cos d + 1) / 3, and it loses the same v^2 d^2 / 2 of 3 v^2 / 4. At an angle a
// from the bottom, swinging to b, v^2 = 2 g R (cos a - cos b) / c with c = 1 sliding and 3/2 rolling. With a kink every
// d, one swing from -b to b takes
//
//     (d^2 / 2) (1 / d) (integral of v^2 from -b to b) = 2 d g R (sin b - b cos b) / c
//
// of the energy g R (1 - cos b).

namespace {

struct Bowl
{
    int facets = 90;
    bool is_one_polygon = false;
    double friction = 0.0;
    double restitution = 0.0;
    double step = 1.0 / 60.0;
    double radius = 1.0;  ///< [m]
    double density = 1.0; ///< of the ball [kg/m^2]

    [[nodiscard]] double ball() const { return 0.1 * radius; } ///< its radius [m]
};

constexpr double k_span = 162.0 * std::numbers::pi / 180.0;
constexpr double k_start = 29.0 * std::numbers::pi / 180.0;
constexpr double k_pull = 9.81;

Scene scene_of(const Bowl& bowl)
{
    Scene scene;
    scene.world.field = UniformField{Vec2(0.0, -k_pull)};
    scene.world.friction = bowl.friction;
    scene.world.restitution = bowl.restitution;
    std::vector<Vec2> rim;
    const double first = -0.5 * (std::numbers::pi + k_span);
    for (int k = 0; k <= bowl.facets; ++k) {
        const double angle = first + k * (k_span / bowl.facets);
        rim.emplace_back(bowl.radius * std::cos(angle), bowl.radius * std::sin(angle));
    }
    const auto normal_of = [&](int k) { return perp(Vec2((rim[k + 1] - rim[k]).normalized())); };
    if (bowl.is_one_polygon) {
        const double side = rim.back().x() + 0.2 * bowl.radius;
        std::vector<Vec2> ring = {Vec2(-side, -1.2 * bowl.radius), Vec2(side, -1.2 * bowl.radius),
                                  Vec2(side, rim.back().y())};
        ring.insert(ring.end(), rim.rbegin(), rim.rend());
        ring.emplace_back(-side, rim.front().y());
        double area = 0.0;
        Vec2 moment = Vec2::Zero();
        for (std::size_t k = 0; k < ring.size(); ++k) {
            const Vec2& next = ring[(k + 1) % ring.size()];
            area += 0.5 * cross(ring[k], next);
            moment += cross(ring[k], next) * (ring[k] + next) / 6.0;
        }
        BodyDef body;
        body.shape = PolygonDef{ring, {}};
        body.position = moment / area;
        scene.bodies.push_back(still(body));
    } else {
        const double thick = 0.05 * bowl.radius;
        for (int k = 0; k < bowl.facets; ++k) {
            const Vec2 along = rim[k + 1] - rim[k];
            BodyDef facet =
                rectangle(along.norm(), thick, Vec2(0.5 * (rim[k] + rim[k + 1]) - 0.5 * thick * normal_of(k)));
            facet.angle = std::atan2(along.y(), along.x());
            scene.bodies.push_back(still(facet));
        }
    }
    const int k = static_cast<int>((0.5 * k_span - k_start) / k_span * bowl.facets);
    scene.bodies.push_back(disc(bowl.ball(), Vec2(0.5 * (rim[k] + rim[k + 1]) + bowl.ball() * normal_of(k))));
    scene.bodies.back().density = bowl.density;
    return scene;
}

/// Share of its energy above the bottom that the ball has lost.
double lost_share(const Bowl& bowl, double until)
{
    const Scene scene = scene_of(bowl);
    World world = with_step(scene, bowl.step);
    const auto energy = [&] {
        const BodyState state = world.state(static_cast<int>(scene.bodies.size()) - 1);
        const double turn = 0.25 * (state.spin * bowl.ball()) * (state.spin * bowl.ball());
        return 0.5 * state.velocity.squaredNorm() + turn + k_pull * (state.position.y() + bowl.radius - bowl.ball());
    };
    const double before = energy();
    run(world, until);
    return 1.0 - energy() / before;
}

/// The same by what the kinks take: swings of a pendulum of length R - r, one after another.
double kinks_take(const Bowl& bowl, double until)
{
    const double c = bowl.friction > 0.0 ? 1.5 : 1.0;
    const double d = k_span / bowl.facets;
    const double length = bowl.radius - bowl.ball();
    double height = 1.0 - std::cos(k_start); // [g R]
    const double first = height;
    for (double time = 0.0; time < until;) {
        const double b = std::acos(1.0 - height);
        // Half the period, to the fourth power of the angle
        const double swing =
            std::numbers::pi * std::sqrt(c * length / k_pull) * (1.0 + b * b / 16.0 + 11.0 * std::pow(b, 4) / 3072.0);
        const double part = std::min(1.0, (until - time) / swing);
        height -= part * 2.0 * d * (std::sin(b) - b * std::cos(b)) / c;
        time += swing;
    }
    return 1.0 - height / first;
}

} // namespace

TEST_CASE("a ball in a bowl of facets loses what kinks take, whatever bounces and however fine the facets are")
{
    // The count of kinks in a swing is whole, and the last swing part of one: a tenth of the loss. Kinks met slower
    // than a step of the field cost less
    constexpr double k_bound = 0.15;
    for (const int facets : {90, 360, 1440}) {
        for (const double friction : {0.0, 1.0}) {
            for (const double restitution : {0.0, 0.1, 0.5}) {
                if (facets == 1440 && restitution == 0.1) continue;
                const Bowl bowl{facets, false, friction, restitution};
                const double until = facets == 1440 ? 8.0 : 20.0;
                const double expected = kinks_take(bowl, until);
                CAPTURE(facets);
                CAPTURE(friction);
                CAPTURE(restitution);
                CHECK(lost_share(bowl, until) == doctest::Approx(expected).epsilon(k_bound));
            }
        }
    }
}

TEST_CASE(
    "a ball that passes dozens of kinks in a step loses what they take, whatever the bowl's size and its own mass")
{
    // At 3000 facets in the bowl of a metre, or 1440 in one of a tenth, 40 kinks a step where the ball is fastest
    struct Case
    {
        int facets;
        double friction, restitution, radius, density;
    };
    for (const Case& c :
         tried({Case{720, 0.3, 0.3, 0.1, 10.0}, Case{1000, 0.3, 0.0, 1.0, 0.01}, Case{1440, 0.0, 0.3, 0.1, 1.0},
                Case{1440, 1.0, 0.5, 10.0, 1.0}, Case{3000, 0.0, 0.5, 1.0, 1.0}, Case{3000, 1.0, 0.0, 1.0, 100.0},
                Case{5000, 0.3, 0.0, 1.0, 1.0}})) {
        const Bowl bowl{c.facets, false, c.friction, c.restitution, 1.0 / 60.0, c.radius, c.density};
        const double until = (c.facets < 3000 ? 6.0 : 2.0) * std::sqrt(c.radius);
        CAPTURE(c.facets);
        CAPTURE(c.friction);
        CAPTURE(c.radius);
        CHECK(lost_share(bowl, until) == doctest::Approx(kinks_take(bowl, until)).epsilon(0.15));
    }
}

TEST_CASE("one concave polygon is as good a bowl as its facets")
{
    for (const int facets : {90, 720}) {
        for (const double friction : {0.0, 1.0}) {
            for (const double restitution : {0.0, 0.5}) {
                const Bowl bowl{facets, true, friction, restitution};
                const double until = facets == 720 ? 8.0 : 20.0;
                CAPTURE(facets);
                CAPTURE(friction);
                CAPTURE(restitution);
                CHECK(lost_share(bowl, until) == doctest::Approx(kinks_take(bowl, until)).epsilon(0.15));
            }
        }
    }
}

TEST_CASE("a kink between two slabs takes the same wherever in a step it comes")
{
    for (const double angle : {0.03, 0.008}) {
        for (const double restitution : {0.0, 0.1}) {
            for (int k = 0; k < 10; ++k) {
                Scene scene;
                scene.world.field = UniformField{Vec2(0.0, -k_pull)};
                scene.world.restitution = restitution;
                scene.bodies.push_back(still(rectangle(2.0, 0.2, Vec2(-1.0, -0.1))));
                BodyDef ramp = rectangle(
                    2.0, 0.2, Vec2(std::cos(angle) + 0.1 * std::sin(angle), std::sin(angle) - 0.1 * std::cos(angle)));
                ramp.angle = angle;
                scene.bodies.push_back(still(ramp));
                scene.bodies.push_back(disc(0.1, Vec2(-0.2 - 0.0023 * k, 0.1), Vec2(1.5, 0.0)));
                World world = world_of(scene);
                run(world, 0.25);
                const BodyState end = world.state(2);
                const double lost =
                    0.5 * 1.5 * 1.5 - 0.5 * end.velocity.squaredNorm() - k_pull * (end.position.y() - 0.1);
                const double expected = 0.5 * std::pow(1.5 * std::sin(angle), 2);
                CAPTURE(k);
                CAPTURE(angle);
                CHECK(lost == doctest::Approx(expected).epsilon(0.02));
            }
        }
    }
}
