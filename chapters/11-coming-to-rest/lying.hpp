#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "../support/lying_bodies.hpp"

/// Bodies that come to rest, and the limits at which they don't.
namespace flying::test {


/// A ball of radius 1/2 m let go with its lowest point at height h.
inline RestEngine zeno_ball(double h, double e, double step)
{
    RestOptions options;
    options.step = step;
    const Material material{e, 0.0};
    return RestEngine({wall(Vec2(0.0, 1.0), 0.0, material),
                       disc(0.5, Vec2(0.0, 0.5 + h), 1.0, material)},
                      options);
}



/// Moment at which nothing is left of the ball's velocity.  [s]
inline double time_to_rest(RestEngine& ball)
{
    do ball.step();
    while (ball.state(1).velocity.y() != 0.0);
    return ball.time();
}


/// The end of all its hops.  [s]
inline double end_of_hops(double h, double e)
{
    return std::sqrt(2.0 * h / k_gravity) * (1.0 + e) / (1.0 - e);
}

/// Height of the lowest point by the closed form.  [m]
inline double hop_height(double h, double e, double time)
{
    const double first = std::sqrt(2.0 * h / k_gravity);
    if (time < first) return h - 0.5 * k_gravity * time * time;
    double speed = e * k_gravity * first;
    double since = time - first;
    for (int k = 0; k < 200; ++k) {
        const double hop = 2.0 * speed / k_gravity;
        if (since < hop) return since * (speed - 0.5 * k_gravity * since);
        since -= hop;
        speed *= e;
    }
    return 0.0;
}


/// Two seconds, or less if the last body moves.
enum class Fate
{
    lies,
    slides,
    tips
};

inline Fate left_alone(RestEngine& engine)
{
    const int last = engine.body_count() - 1;
    const BodyState start = engine.state(last);
    while (engine.time() < 2.0) {
        engine.step();
        const BodyState now = engine.state(last);
        if (std::abs(now.angle - start.angle) > 1e-10) return Fate::tips;
        if ((now.position - start.position).norm() > 1e-10) return Fate::slides;
    }
    return Fate::lies;
}



/// A block of 1 m height on a slope.
inline Fate left_on_slope(double tangent, double mu, double width = 0.7)
{
    const Slope slope{std::atan(tangent)};
    const RestBody block = box(width, 1.0, Vec2::Zero(), 1.0, {0.0, mu});
    RestEngine engine = on_slope(slope, block, 0.5);
    return left_alone(engine);
}



/// The value between `low`, where something holds, and `high`, where it doesn't, at
/// which that changes: by halving.
template <typename Holds>
double limit_of(double low, double high, int halvings, const Holds& holds)
{
    for (int k = 0; k < halvings; ++k) {
        const double middle = 0.5 * (low + high);
        (holds(middle) ? low : high) = middle;
    }
    return low;
}



/// A ledge that ends at x = 0, and planks of 2 m, each with its centre of mass by
/// `part` as far out as it can lie over the one below.
inline std::vector<RestBody> planks(int count, double part)
{
    const Material material{0.0, 1.0};
    RestBody ledge{rectangle(4.0, 1.0), {}, {}, material};
    ledge.state.position = Vec2(-2.0, -0.5);
    ledge.is_static = true;
    std::vector<RestBody> bodies = {ledge};
    double end = 0.0;
    for (int k = count; k > 0; --k) {
        end += part / k;
        const Vec2 centre(end - 1.0, 0.125 + 0.25 * (count - k));
        bodies.push_back(box(2.0, 0.25, centre, 1.0, material));
    }
    return bodies;
}



inline bool planks_stand(int count, double part)
{
    RestEngine engine(planks(count, part));
    return left_alone(engine) == Fate::lies;
}


/// How far the uppermost of some planks reaches beyond the ledge before all fall.  [m]
inline double greatest_overhang(int count)
{
    const double part =
        limit_of(0.999, 1.001, 10, [&](double p) { return planks_stand(count, p); });
    double reach = 0.0;
    for (int k = count; k > 0; --k) reach += part / k;
    return reach;
}

/// A disc of 1/2 m thrown along the floor at v without spin.
inline RestEngine thrown_disc(double v, double mu, double step = 1.0 / 60.0)
{
    RestOptions options;
    options.step = step;
    RestBody body = disc(0.5, Vec2(0.0, 0.5), 1.0, {0.0, mu});
    body.state.velocity = Vec2(v, 0.0);
    return RestEngine({wall(Vec2(0.0, 1.0), 0.0, {0.0, mu}), body}, options);
}


/// A disc let go on a smooth cylinder, from `start` radians beside its top: the cosine
/// at which it flew off, as what is left of its speed sideways tells, and what part of
/// its energy has changed.
struct SlideOff
{
    double cosine = 0.0;
    double energy_change = 0.0;
};

inline SlideOff slide_off(double start, double step)
{
    const double way = 3.5; // of the disc's centre from the cylinder's [m]
    const Material smooth{0.0, 0.0};
    RestBody cylinder{Disc{3.0}, {}, {}, smooth};
    cylinder.is_static = true;
    const Vec2 from(way * std::sin(start), way * std::cos(start));
    RestOptions options;
    options.step = step;
    RestEngine engine({cylinder, disc(0.5, from, 1.0, smooth)}, options);
    const double before = energy(engine);
    engine.advance(3.0);
    const double sideways = engine.state(1).velocity.x();
    return {std::cbrt(sideways * sideways / (k_gravity * way)),
            energy(engine) / before - 1.0};
}



/// A pyramid after a second of sweeps.
struct SweptPyramid
{
    double sunk = 0.0;       ///< its uppermost box [m]
    std::int64_t sweeps = 0; ///< that it took
};

/// A pyramid stands for a second, and the engine sweeps it as it does a heap.
inline SweptPyramid sweep_pyramid(int base, bool is_warm)
{
    const Material material{0.0, 0.5};
    std::vector<RestBody> bodies = {wall(Vec2(0.0, 1.0), 0.0, material)};
    for (int row = 0; row < base; ++row) {
        for (int k = 0; k < base - row; ++k) {
            const Vec2 centre(1.125 * (k + 0.5 * row), 0.5 + row);
            bodies.push_back(box(1.0, 1.0, centre, 1.0, material));
        }
    }
    RestOptions options;
    options.most_solved = 0;
    RestEngine engine(bodies, options);
    for (int k = 0; k < 60; ++k) {
        engine.step();
        if (is_warm) continue;
        RestEngine::Memory memory = engine.memory();
        for (RestPair& pair : memory.pairs) {
            std::fill_n(pair.normal, 2, 0.0);
            std::fill_n(pair.tangent, 2, 0.0);
        }
        engine.go_on_from(memory);
    }
    const int top = static_cast<int>(bodies.size()) - 1;
    return {bodies[top].state.position.y() - engine.state(top).position.y(),
            engine.solve_counts().sweeps};
}



/// Share of its spin that a block keeps when it rocks from one corner to the other.
inline double kept_by_stroke(double width, double height, double step)
{
    const double tilt = 0.02;
    const Rotation turn = Rotation::of(tilt);
    RestBody body = box(width, height, Vec2::Zero(), 1.0, {0.0, 3.0});
    body.state.angle = tilt;
    body.state.position.x() = (turn * Vec2(0.5 * width, 0.5 * height)).x();
    body.state.position.y() = -(turn * Vec2(-0.5 * width, -0.5 * height)).y();
    RestOptions options;
    options.step = step;
    RestEngine engine({wall(Vec2(0.0, 1.0), 0.0, {0.0, 3.0}), body}, options);

    // Upright, all energy above that of standing is turning
    const double standing = 0.5 * k_gravity * height;
    double before = 0.0;
    while (engine.state(1).angle > 0.0) {
        before = energy(engine) - standing;
        engine.step();
    }
    return std::sqrt((energy(engine) - standing) / before);
}


} // namespace flying::test
