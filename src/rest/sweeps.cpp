#include "rest/sweeps.hpp"

#include <algorithm>
#include <cmath>

namespace flying {
namespace {

void solve_point(ContactPoint& c, std::span<Mover> movers)
{
    Mover& a = movers[c.a];
    Mover& b = movers[c.b];

    // [rest.sweep.normal]
    // Push as much as ends the approach in all, and never pull
    double v_x = b.v_x - a.v_x;
    double v_y = b.v_y - a.v_y;
    const double u_n = (c.n_x * v_x + c.n_y * v_y) + (b.spin * c.normal_arm_b - a.spin * c.normal_arm_a);
    const double normal = std::max(0.0, c.normal - c.normal_mass * (u_n - c.bound));
    const double j = normal - c.normal;
    c.normal = normal;
    // [rest.sweep.normal]

    // [rest.sweep.tangent]
    // Know what that does to the slip, and end it as far as the cone allows
    const double w = a.inv_mass + b.inv_mass;
    const double spin_a = a.spin - a.inv_moment * (j * c.normal_arm_a);
    const double spin_b = b.spin + b.inv_moment * (j * c.normal_arm_b);
    v_x += j * (w * c.n_x);
    v_y += j * (w * c.n_y);
    const double u_t = (c.n_x * v_y - c.n_y * v_x) + (spin_b * c.tangent_arm_b - spin_a * c.tangent_arm_a);
    const double most = c.friction * normal;
    const double tangent = std::clamp(c.tangent - c.tangent_mass * u_t, -most, most);
    const double q = tangent - c.tangent;
    c.tangent = tangent;
    // [rest.sweep.tangent]

    const double p_x = j * c.n_x - q * c.n_y;
    const double p_y = j * c.n_y + q * c.n_x;
    a.v_x -= a.inv_mass * p_x;
    a.v_y -= a.inv_mass * p_y;
    a.spin = spin_a - a.inv_moment * (q * c.tangent_arm_a);
    b.v_x += b.inv_mass * p_x;
    b.v_y += b.inv_mass * p_y;
    b.spin = spin_b + b.inv_moment * (q * c.tangent_arm_b);
}

} // namespace

void warm_start(std::span<const ContactPoint> points, std::span<Mover> movers)
{
    for (const ContactPoint& c : points) push(c, c.normal, c.tangent, movers[c.a], movers[c.b]);
}

void sweep(std::span<ContactPoint> points, std::span<Mover> movers)
{
    for (ContactPoint& c : points) solve_point(c, movers);
}

// [rest.residual]
namespace {

double residual(const ContactPoint& c, const Mover& a, const Mover& b)
{
    const double excess = normal_speed(c, a, b) - c.bound;
    const double normal = std::max(0.0, c.normal - c.normal_mass * excess);
    const double along_normal = std::abs(normal - c.normal) / c.normal_mass;

    const double most = c.friction * c.normal;
    const double slip = tangent_speed(c, a, b);
    const double tangent = std::clamp(c.tangent - c.tangent_mass * slip, -most, most);
    return std::max(along_normal, std::abs(tangent - c.tangent) / c.tangent_mass);
}

} // namespace

void forget_impulses(std::span<ContactPoint> points)
{
    for (ContactPoint& c : points) c.normal = c.tangent = 0.0;
}

double worst_residual(std::span<const ContactPoint> points, std::span<const Mover> movers)
{
    double worst = 0.0;
    for (const ContactPoint& c : points) worst = std::max(worst, residual(c, movers[c.a], movers[c.b]));
    return worst;
}

bool are_satisfied(std::span<const ContactPoint> points, std::span<const Mover> movers, double tolerance)
{
    return std::none_of(points.begin(), points.end(),
                        [&](const ContactPoint& c) { return residual(c, movers[c.a], movers[c.b]) > tolerance; });
}
// [rest.residual]

double worst_residual_of_none(std::span<const ContactPoint> points, std::span<const Mover> movers)
{
    double worst = 0.0;
    for (ContactPoint c : points) {
        c.normal = c.tangent = 0.0;
        worst = std::max(worst, residual(c, movers[c.a], movers[c.b]));
    }
    return worst;
}

} // namespace flying
