#include "weighed.hpp"

#include <algorithm>
#include <cmath>

#include "mass/polygon.hpp"
#include "world/make_shape.hpp"

namespace flying::bench {

std::vector<WeighedBody> weigh(const Scene& scene)
{
    std::vector<WeighedBody> bodies;
    for (const BodyDef& def : scene.bodies) {
        WeighedBody body{make_shape(def.shape).value(), 0.0, 0.0, 0.0, {}, {}, def.is_static};
        const MassProperties at_unit_density = mass_of(body.shape, 1.0);
        const double density = def.mass ? *def.mass / at_unit_density.mass : def.density.value_or(1.0);
        body.radius = bounding_radius(body.shape);
        body.mass = density * at_unit_density.mass;
        body.moment_of_inertia = density * at_unit_density.moment_of_inertia;
        body.material = {def.restitution.value_or(scene.world.restitution),
                         def.friction.value_or(scene.world.friction)};
        body.start = {def.position, def.velocity, def.angle, def.spin, 0.0};
        bodies.push_back(std::move(body));
    }
    return bodies;
}

double total_energy(const std::vector<WeighedBody>& bodies, const std::vector<BodyState>& states, const Scene& scene)
{
    // In more digits than any engine has: the sum is not to show as drift
    const Vec2 g = uniform_acceleration(scene.world.field);
    long double sum = 0.0L;
    for (std::size_t k = 0; k < bodies.size(); ++k) {
        if (bodies[k].is_static) continue;
        const BodyState& state = states[k];
        const long double vx = state.velocity.x();
        const long double vy = state.velocity.y();
        const long double spin = state.spin;
        sum += 0.5L * bodies[k].mass * (vx * vx + vy * vy) + 0.5L * bodies[k].moment_of_inertia * spin * spin;
        sum -= static_cast<long double>(bodies[k].mass) * g.dot(state.position);
    }
    return static_cast<double>(sum);
}

OverlapRuler::OverlapRuler(const Scene& scene, const std::vector<WeighedBody>& bodies)
{
    double widest = 0.0;
    Vec2 low = Vec2::Constant(1e300);
    Vec2 high = Vec2::Constant(-1e300);
    for (const WeighedBody& body : bodies) {
        shapes_.push_back(make_collision_shape(body.shape));
        radii_.push_back(body.radius);
        is_static_.push_back(body.is_static ? 1 : 0);
        widest = std::max(widest, body.radius);
        low = low.cwiseMin(body.start.position);
        high = high.cwiseMax(body.start.position);
    }
    if (scene.world.box) {
        low = scene.world.box->min;
        high = scene.world.box->max;
        walls_ = {make_collision_shape(HalfPlane{Vec2(1.0, 0.0), low.x()}),
                  make_collision_shape(HalfPlane{Vec2(-1.0, 0.0), -high.x()}),
                  make_collision_shape(HalfPlane{Vec2(0.0, 1.0), low.y()}),
                  make_collision_shape(HalfPlane{Vec2(0.0, -1.0), -high.y()})};
    }
    low_ = low;
    const double extent = (high - low).maxCoeff();
    cell_ = std::max(2.0 * widest, extent / 2000.0);
    side_ = std::max(1, static_cast<int>(std::ceil(extent / cell_)));
    head_.resize(static_cast<std::size_t>(side_) * side_);
    next_.resize(bodies.size());
}

int OverlapRuler::cell_of(double value, double low) const
{
    // Those that have left the box are counted to its border: neighbours stay neighbours
    return static_cast<int>(std::clamp(std::floor((value - low) / cell_), 0.0, side_ - 1.0));
}

double OverlapRuler::deepest(const std::vector<BodyState>& states)
{
    double deepest = 0.0;
    std::fill(head_.begin(), head_.end(), -1);
    for (int a = 0; a < static_cast<int>(states.size()); ++a) {
        const Vec2 at = states[a].position;
        const Pose pose_a = pose_of(states[a]);
        for (const CollisionShape& wall : walls_) {
            if (!is_static_[a]) deepest = std::max(deepest, -separation(shapes_[a], pose_a, wall, Pose{}));
        }
        const int column = cell_of(at.x(), low_.x());
        const int row = cell_of(at.y(), low_.y());
        for (int j = std::max(row - 1, 0); j <= std::min(row + 1, side_ - 1); ++j) {
            for (int i = std::max(column - 1, 0); i <= std::min(column + 1, side_ - 1); ++i) {
                for (int b = head_[static_cast<std::size_t>(j) * side_ + i]; b >= 0; b = next_[b]) {
                    if ((states[b].position - at).norm() >= radii_[a] + radii_[b] - deepest) continue;
                    if (is_static_[a] && is_static_[b]) continue;
                    deepest = std::max(deepest, -separation(shapes_[a], pose_a, shapes_[b], pose_of(states[b])));
                }
            }
        }
        int& head = head_[static_cast<std::size_t>(row) * side_ + column];
        next_[a] = head;
        head = a;
    }
    return deepest;
}

} // namespace flying::bench
