#pragma once

#include <cmath>

#include "collide/separation.hpp"
#include "geometry/polygon.hpp"
#include "math/random.hpp"
#include "motion/flight.hpp"
#include "support/random_polygons.hpp"
#include "toi/predict.hpp"

/// Random pairs on their way to each other, and when they first touch.
namespace flying::testing {

inline constexpr double k_pi = 3.14159265358979323846;

/// Star-shaped about the origin, so that it is simple; concave more often than not. Its centroid is not the origin, which
/// prediction doesn't mind.
inline Polygon star(Random& random, int corners, double inner)
{
    std::vector<Vec2> ring;
    for (int k = 0; k < corners; ++k) {
        const double radius = random.uniform(inner, 1.0);
        const SineCosine sc = sine_cosine(2.0 * k_pi * (k + random.uniform(0.0, 0.8)) / corners);
        ring.emplace_back(radius * sc.cosine, radius * sc.sine);
    }
    return Polygon({ring});
}

inline Shape random_shape(Random& random)
{
    const int kind = random.below(4);
    if (kind == 0) return Disc{random.uniform(0.3, 1.0)};
    if (kind == 1) {
        const double width = random.uniform(0.1, 2.0);
        return box(width, random.uniform(0.1, 2.0));
    }
    return star(random, 3 + random.below(6), 0.3);
}

inline Flyer random_flyer(Random& random, const Vec2& position)
{
    Flyer flyer;
    flyer.state.position = position;
    // Towards the other, more or less
    const double towards = position.x() < 0.0 ? 1.0 : -1.0;
    flyer.state.velocity = Vec2{towards * random.uniform(-0.2, 3.0), random.uniform(-1.0, 1.0)};
    flyer.state.angle = random.uniform(-3.0, 3.0);
    flyer.state.spin = random.uniform(-6.0, 6.0);
    flyer.state.time = random.uniform(0.0, 0.1);
    return flyer;
}

inline Pose pose_at(const Flyer& flyer, double time) { return pose_of(flight(flyer.state, flyer.acceleration, time)); }

inline double gap_at(const Shape& a, const Flyer& fa, const Shape& b, const Flyer& fb, double time)
{
    return separation(a, pose_at(fa, time), b, pose_at(fb, time));
}

/// Ask until there is an answer up to `horizon`.
inline Prediction predict_until(const Shape& a, const Flyer& fa, const Shape& b, const Flyer& fb, double horizon,
                         const PredictOptions& options = {})
{
    Prediction answer = predict(a, fa, b, fb, common_start(fa, fb), options);
    while (answer.kind == Prediction::Kind::not_before && answer.time < horizon) {
        answer = predict(a, fa, b, fb, answer.time, options);
    }
    return answer;
}

} // namespace flying::testing
