#include "response/impact.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "math/exact.hpp"
#include "response/one_point.hpp"
#include "response/several_points.hpp"

namespace flying {

Material combine(const Material& a, const Material& b)
{
    return {std::max(a.restitution, b.restitution), std::sqrt(a.friction * b.friction)};
}

namespace {

// After this many rounds the points are stopped instead of thrown back. Two frictionless corners need pi over the angle
// between their normals, measured with the masses: a handful for any body that isn't a needle
constexpr int k_rounds = 64;
constexpr int k_closing_rounds = 16;

// All speeds at hand, of which rounding takes its share [m/s]
double speed_at_hand(std::span<const PointFrame> points, const PairMotion& motion)
{
    double arm_a = 0.0;
    double arm_b = 0.0;
    for (const PointFrame& point : points) {
        arm_a = std::max(arm_a, std::abs(point.normal.arm_a) + std::abs(point.tangent.arm_a));
        arm_b = std::max(arm_b, std::abs(point.normal.arm_b) + std::abs(point.tangent.arm_b));
    }
    const double shift = motion.velocity_a.cwiseAbs().sum() + motion.velocity_b.cwiseAbs().sum();
    return shift + (std::abs(motion.spin_a) * arm_a + std::abs(motion.spin_b) * arm_b);
}

// The push at one point that approaches
PairPush push_at_one(const PointFrame& point, const PairMotion& motion, const PairInertia& inertia,
                     const Material& material)
{
    const PointResponse response = response_at(point, inertia);
    const double v_n = speed_along(point.normal, motion);
    const double v_t = speed_along(point.tangent, motion);
    const PointImpulse impulse = one_point_impulse(response, v_n, v_t, material);
    PairPush push;
    if (impulse.normal == 0.0) return push;

    // Allow for the length of the normal, which rounding has left beside 1: a push along it buys that much more speed
    const Vec2& n = point.normal.direction;
    const double surplus = excess_of_unit(n.x(), n.y()) * (inertia.inv_mass() / response.w_n);
    push.add(point.normal, impulse.normal - impulse.normal * surplus);
    if (impulse.tangent != 0.0) push.add(point.tangent, impulse.tangent);
    return push;
}

ImpactResult result_of(const PairMotion& motion, bool any_push, bool ended)
{
    return {motion.velocity_a, motion.velocity_b, motion.spin_a, motion.spin_b, any_push, ended};
}

ImpactResult resolve_rounds(std::span<const PointFrame> points, PairMotion motion, const PairInertia& inertia,
                            const Material& material, double rests)
{
    double speed = speed_at_hand(points, motion);
    double threshold = 0.0;
    std::vector<int> chosen;
    std::vector<PointFrame> bearing;
    for (int round = 0; round < k_rounds + k_closing_rounds; ++round) {
        // Find the points that approach, and those that rest; in the end all of them, so that none is left out
        const bool closing = round >= k_rounds;
        const double slow = std::max(tolerance::k_approach * speed, rests);
        bool any_approach = false;
        chosen.clear();
        for (int i = 0; i < static_cast<int>(points.size()); ++i) {
            const double v_n = speed_along(points[i].normal, motion);
            any_approach = any_approach || v_n < -threshold;
            if (v_n <= slow || closing) chosen.push_back(i);
        }
        if (!any_approach) return result_of(motion, round > 0, true);

        // Push at those that bear the rest
        bearing.clear();
        for (const int i : outermost(points, chosen)) bearing.push_back(points[i]);
        const Rebound rebound = closing ? Rebound::none : Rebound::by_restitution;
        const Material rule = closing ? Material{0.0, 0.0} : material;
        const PairPush push = bearing.size() == 1 ? push_at_one(bearing.front(), motion, inertia, rule)
                                                  : push_at_several(bearing, motion, inertia, rule, speed, rebound);
        motion = pushed(motion, push, inertia);

        // From now on only approaches that are more than rounding count
        speed = std::max(speed, speed_at_hand(points, motion));
        threshold = tolerance::k_approach * speed;
    }
    const auto approaches = [&](const PointFrame& point) { return speed_along(point.normal, motion) < -threshold; };
    return result_of(motion, true, std::none_of(points.begin(), points.end(), approaches));
}

ImpactResult resolve_single(const PointFrame& point, const PairMotion& motion, const PairInertia& inertia,
                            const Material& material)
{
    // Leave a separating pair alone, to the bit; and two that nothing moves
    const bool approaches = speed_along(point.normal, motion) < 0.0;
    if (!approaches || !(inverse_mass(point.normal, inertia) > 0.0)) return result_of(motion, false, !approaches);

    const PairMotion after = pushed(motion, push_at_one(point, motion, inertia, material), inertia);
    const double speed = std::max(speed_at_hand({&point, 1}, motion), speed_at_hand({&point, 1}, after));
    if (speed_along(point.normal, after) >= -tolerance::k_approach * speed) return result_of(after, true, true);

    // A jam of extreme proportions may leave more than rounding: end it as other impacts are
    return resolve_rounds({&point, 1}, after, inertia, material, 0.0);
}

} // namespace

ImpactResult resolve_impact(const ImpactBody& a, const ImpactBody& b, std::span<const ImpactPoint> points,
                            const Material& material, double rests)
{
    const PairMotion motion{a.velocity, b.velocity, a.spin, b.spin};
    const PairInertia inertia{a.inertia, b.inertia};
    if (points.size() == 1) return resolve_single(frame_at(points.front()), motion, inertia, material);

    std::vector<PointFrame> frames;
    frames.reserve(points.size());
    for (const ImpactPoint& point : points) frames.push_back(frame_at(point));
    return resolve_rounds(frames, motion, inertia, material, rests);
}

} // namespace flying
