#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "math/safe_step.hpp"
#include "support/flying_pairs.hpp"
#include "support/receipts.hpp"

using namespace flying;
using namespace flying::testing;

TEST_CASE("no first touch is missed or late, against dense sampling of the distance, over random pairs")
{
    // Sampled every 1/512 s with speeds below 20 m/s and arms below 1.5 m, a gap falls by less than 0.05 between samples;
    // overlaps deeper than that can't hide, and shallower ones are looked at by the impact's own time
    Random random(7);
    int impacts = 0;
    double worst_gap = 0.0;
    for (int k = 0; k < 1500; ++k) {
        const Shape a = random_shape(random);
        const Shape b = random_shape(random);
        Flyer fa = random_flyer(random, Vec2(-2.2, random.uniform(-1.0, 1.0)));
        Flyer fb = random_flyer(random, Vec2(2.2, random.uniform(-1.0, 1.0)));
        if (random.below(3) == 0) {
            fb.state.velocity = Vec2::Zero();
            fb.state.spin = 0.0;
            fa.acceleration = Vec2(0.0, -3.0);
        }
        const double horizon = 3.0;
        const Prediction answer = predict_until(a, fa, b, fb, horizon);
        double first_overlap = k_never;
        const CollisionShape cut_a = make_collision_shape(a);
        const CollisionShape cut_b = make_collision_shape(b);
        const double start = common_start(fa, fb);
        for (double t = start; t < horizon; t += 1.0 / 512.0) {
            if (separation(cut_a, pose_at(fa, t), cut_b, pose_at(fb, t)) < -1e-9) {
                first_overlap = t;
                break;
            }
        }
        INFO("case " << k << ", first sampled overlap at " << first_overlap << ", predicted " << answer.time);
        if (first_overlap < k_never) {
            REQUIRE(answer.kind == Prediction::Kind::impact);
            CHECK(answer.time <= first_overlap);
        }
        if (answer.kind == Prediction::Kind::impact && answer.time < horizon) {
            ++impacts;
            const double gap = separation(cut_a, pose_at(fa, answer.time), cut_b, pose_at(fb, answer.time));
            worst_gap = std::max(worst_gap, std::abs(gap));
        }
    }
    CHECK(impacts > 500);
    CHECK(worst_gap <= 1e-13); // of bodies of size 1
    RECORD_VALUE("toi.dense.impacts", impacts);
    RECORD_VALUE("toi.dense.gap", worst_gap);
}

TEST_CASE("a safe step never passes a root of a function whose bend is bounded")
{
    // f = cos(w t + p) + b, so that |f''| <= w^2; its first root by the arc cosine
    Random random(10);
    for (int k = 0; k < 100000; ++k) {
        const double w = random.uniform(0.1, 10.0);
        const double p = random.uniform(-k_pi, k_pi);
        const double b = random.uniform(-0.99, 0.99);
        const double f = std::cos(p) + b;
        if (f <= 0.0) continue;
        // First t > 0 with cos(w t + p) = -b, from above: w t + p = acos(-b) (mod 2 pi)
        double root = (std::acos(-b) - p) / w;
        while (root < 0.0) root += 2.0 * k_pi / w;
        CHECK(safe_step(f, -w * std::sin(p), w * w) <= root * (1.0 + 1e-12) + 1e-12);
    }
}

