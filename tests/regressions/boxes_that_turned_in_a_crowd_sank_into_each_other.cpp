#include <doctest/doctest.h>

#include <cmath>
#include <vector>

#include "collide/separation.hpp"
#include "math/random.hpp"
#include "rest/rest_engine.hpp"
#include "support/effort.hpp"
#include "world/make_shape.hpp"

// Of two bodies of a heap that both turn in a step, what their turns take from the gap between them was counted as if
// each turned alone. A box whose corner left another's side sank into it where that side turned after it, and was taken
// for fair: the step of a whole pile was made again eight times to the same end.

using namespace flying;
using namespace flying::testing;

namespace {

RestBody smooth_body(const Shape& shape, const Vec2& position, double angle, double moment)
{
    RestBody body{shape, {}, {1.0, 1.0 / moment}, {0.0, 0.0}};
    body.state.position = position;
    body.state.angle = angle;
    return body;
}

} // namespace

TEST_CASE("boxes of a heap that turn as they part don't end in each other")
{
    Random random(1);
    for (int k = 0; k < tried(400); ++k) {
        const double half_width = random.uniform(0.3, 0.5);
        const double half_height = random.uniform(0.2, half_width);
        const Shape box = make_shape(RectangleDef{2.0 * half_width, 2.0 * half_height}).value();
        const double size = std::hypot(half_width, half_height);
        const double moment = size * size / 3.0;

        // The lower right corner of a box that is tilted touches the left side of one that isn't
        const double tilt = random.uniform(0.6, 1.2);
        const Vec2 side(-half_width - 1e-6, random.uniform(-0.5, 0.5) * half_height);
        const Vec2 corner = Rotation::of(tilt) * Vec2(half_width, -half_height);
        std::vector<RestBody> bodies = {smooth_body(box, side - corner, tilt, moment),
                                        smooth_body(box, Vec2::Zero(), 0.0, moment)};
        bodies[0].state.velocity = Vec2(random.uniform(-1.0, 0.0), random.uniform(0.0, 2.5));
        bodies[0].state.spin = random.uniform(6.0, 16.0);
        bodies[1].state.spin = random.uniform(15.0, 25.0);
        // A row of discs beyond it makes the two part of a large heap
        for (int disc = 0; disc < 70; ++disc)
            bodies.push_back(smooth_body(Disc{0.2}, Vec2(half_width + 0.2005 + 0.4 * disc, 0.0), 0.0, 0.02));
        RestEngine engine(bodies);
        engine.step();
        CAPTURE(k);
        const CollisionShape shape = make_collision_shape(box);
        CHECK(separation(shape, pose_of(engine.state(0)), shape, pose_of(engine.state(1))) >= -0.0078 * size);
    }
}
