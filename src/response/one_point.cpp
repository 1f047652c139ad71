#include "response/one_point.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace flying {

PointResponse response_at(const PointFrame& frame, const PairInertia& inertia)
{
    const PushLine& n = frame.normal;
    const PushLine& t = frame.tangent;
    PointResponse response;
    response.w_n = inverse_mass(n, inertia);
    response.w_t = inverse_mass(t, inertia);
    response.w_nt = coupling(n, t, inertia);

    // Sum the determinant from positive terms; the difference w_n w_t - w_nt^2 would cancel
    const double inv_m = inertia.inv_mass();
    const double inv_i_a = inertia.a.inv_moment_of_inertia;
    const double inv_i_b = inertia.b.inv_moment_of_inertia;
    const double turn_a = inv_i_a * (n.arm_a * n.arm_a + t.arm_a * t.arm_a);
    const double turn_b = inv_i_b * (n.arm_b * n.arm_b + t.arm_b * t.arm_b);
    const double minor = n.arm_a * t.arm_b - t.arm_a * n.arm_b;
    response.determinant =
        inv_m * (inv_m + (turn_a + turn_b)) + inv_i_a * inv_i_b * (minor * minor);
    return response;
}

namespace {

// Friction that leaves the normal alone: stop the slip if the cone allows
PointImpulse uncoupled_impulse(const PointResponse& w, double v_n, double v_t, const Material& material)
{
    const double j = newton_impulse(v_n, w.w_n, material.restitution);
    const double most = material.friction * j;
    return {j, std::clamp(-v_t / w.w_t, -most, most)};
}

// The two stretches of a coupled impact, over the normal impulse: first slip as it came in,
// then what follows its end
struct Course
{
    double slip_sign; // of v_t in the first stretch; 0 where the point doesn't slip
    double slip_end; // normal impulse at its end, infinite if nothing ends it [N s]
    double rate_first; // d v_n / d j while slipping; may be negative: a jam [1/kg]
    double rate_then;  // d v_n / d j afterwards, > 0 [1/kg]
    double rate_step; // rate_first - rate_then, without cancellation where it sticks [1/kg]
    bool sticks;      // after the slip has ended; else it slips back
};

Course course_of(const PointResponse& w, double v_t, double mu)
{
    Course course{};
    course.slip_sign = v_t > 0.0 ? 1.0 : v_t < 0.0 ? -1.0 : 0.0;

    // Slip: q = -s mu j, so friction brakes the slip; the coupling drives or brakes it too
    const double s = course.slip_sign;
    const double brake = mu * w.w_t - s * w.w_nt;
    course.rate_first = w.w_n - s * mu * w.w_nt;
    course.slip_end = s == 0.0      ? 0.0
                      : brake > 0.0 ? std::abs(v_t) / brake
                                    : std::numeric_limits<double>::infinity();

    // [impulse.friction.then]
    // Stick if friction can hold what the coupling drives; else slip to where it drives
    course.sticks = std::abs(w.w_nt) <= mu * w.w_t;
    const double rate_stick = w.determinant / w.w_t;
    if (course.sticks) {
        course.rate_then = rate_stick;
        course.rate_step = w.w_nt * (w.w_nt / w.w_t - s * mu);
    } else {
        course.rate_then = std::max(w.w_n - mu * std::abs(w.w_nt), rate_stick);
        course.rate_step = course.rate_first - course.rate_then;
    }
    // [impulse.friction.then]
    return course;
}

// Normal impulse at which restitution has given back e^2 of the work that compression took
double final_impulse(const Course& course, double v_n, double e)
{
    // A slip that outlasts the impact: one rate throughout, Newton's law
    const double in = -v_n;
    const double j_s = course.slip_end;
    const double k = course.rate_first;
    const double newton = (1.0 + e) * in / k;
    if (k > 0.0 && newton <= j_s) return newton;

    const double v_s = v_n + k * j_s;
    const double k_then = course.rate_then;
    // [impulse.friction.late]
    // Slip ends at v_s, after compression: the rest of the work comes back at k_then
    if (v_s >= 0.0) {
        const double squared =
            (course.rate_step * (v_s * v_s) + k_then * (e * in) * (e * in)) / k;
        const double out = std::sqrt(std::max(squared, v_s * v_s));
        return j_s + (out - v_s) / k_then;
    }
    // [impulse.friction.late]

    // Slip ends during compression: the work so far is (v_n + v_s) j_s / 2, jam or not
    const double out = e * std::sqrt(v_s * v_s - k_then * (j_s * (v_n + v_s)));
    return j_s + (out - v_s) / k_then;
}

} // namespace

PointImpulse one_point_impulse(const PointResponse& w, double v_n, double v_t, const Material& material)
{
    // Leave separating points alone
    if (!(v_n < 0.0)) return {};

    // Without friction, or where it can't reach the normal, Newton's law is the whole answer
    const double mu = material.friction;
    if (mu == 0.0 || !(w.w_t > 0.0)) return {newton_impulse(v_n, w.w_n, material.restitution), 0.0};
    if (w.w_nt == 0.0) return uncoupled_impulse(w, v_n, v_t, material);

    // A body on a pivot may be unable to move along a sticking contact: it is stopped there
    const Course course = course_of(w, v_t, mu);
    const bool stuck_fast = !(course.rate_then > 0.0);
    const double j = stuck_fast ? course.slip_end : final_impulse(course, v_n, material.restitution);

    // Find friction: against the slip for as long as it lasted, then what holds the point, or against the slip back
    const double most = mu * j;
    if (j <= course.slip_end) return {j, -course.slip_sign * most};
    if (course.sticks) return {j, std::clamp(-(v_t + w.w_nt * j) / w.w_t, -most, most)};
    const double back_sign = w.w_nt > 0.0 ? 1.0 : -1.0;
    const double q_first = -course.slip_sign * (mu * course.slip_end);
    return {j, q_first - back_sign * (mu * (j - course.slip_end))};
}

} // namespace flying
