#include "resting.hpp"

#include "geometry/half_plane.hpp"
#include "weighed.hpp"

namespace flying::bench {

Resting::Resting(const Scene& scene, double hertz, bool sleeps)
{
    std::vector<RestBody> bodies;
    for (const WeighedBody& from : weigh(scene)) {
        RestBody body{from.shape, from.start, {}, from.material};
        body.is_static = from.is_static;
        if (!from.is_static) body.inertia = {1.0 / from.mass, 1.0 / from.moment_of_inertia};
        if (!from.is_static) body.acceleration = uniform_acceleration(scene.world.field);
        bodies.push_back(std::move(body));
    }
    count_ = bodies.size();
    if (scene.world.box) {
        const Material material{scene.world.restitution, scene.world.friction};
        const auto add = [&](const Vec2& normal, double offset) {
            RestBody wall{HalfPlane{normal, offset}, {}, {}, material};
            wall.is_static = true;
            bodies.push_back(wall);
        };
        add({1.0, 0.0}, scene.world.box->min.x());
        add({-1.0, 0.0}, -scene.world.box->max.x());
        add({0.0, 1.0}, scene.world.box->min.y());
        add({0.0, -1.0}, -scene.world.box->max.y());
    }
    RestOptions options;
    options.step = 1.0 / hertz;
    options.sleeps = sleeps;
    engine_.emplace(std::move(bodies), options);
}

void Resting::step() { engine_->step(); }

std::vector<BodyState> Resting::states() const
{
    std::vector<BodyState> states;
    for (std::size_t k = 0; k < count_; ++k) states.push_back(engine_->state(static_cast<int>(k)));
    return states;
}

} // namespace flying::bench
