#include <algorithm>
#include <cmath>

#include "rest/group_solver.hpp"
#include "rest/push_lines.hpp"

namespace flying {
namespace {

// [rest.group.descend.limits]
/// Steps of the descent, of which the first go all the way, and halvings of one that goes too far.
constexpr int k_descents = 40;
constexpr int k_whole_steps = 20;
constexpr int k_halvings = 40;
// [rest.group.descend.limits]

} // namespace

// [rest.group.descend]
void GroupSolver::measure_rays(std::span<const ContactPoint> points)
{
    // Coulomb's cone is the sum of two rays, the normal leant to either side. Were each to be content for itself, what
    // slips would have to part; asking for as much less as it slips now makes up for that
    for (std::size_t k = 0; k < points.size(); ++k) {
        const ContactPoint& c = points[k];
        const double lift = c.friction * std::abs(slip_[2 * k + 1]);
        for (int side = 0; side < 2; ++side) {
            Ray& ray = rays_[2 * k + side];
            const double share = side == 0 ? c.friction : -c.friction;
            const double part = share != 0.0 ? c.tangent / share : 0.0;
            ray.share = share;
            ray.impulse = 0.5 * std::max(0.0, c.normal + part);
            ray.speed = slip_[2 * k] + share * slip_[2 * k + 1] + lift;
            ray.stiffness = stiffness_ * c.normal_mass;
        }
    }
}

bool GroupSolver::descend(std::span<const Mover> movers, std::span<const ContactPoint> points)
{
    std::fill(delta_.begin(), delta_.end(), 0.0);
    step_.resize(delta_.size());
    measure_rays(points);
    bool settled = false;
    for (int step = 0; step < k_descents; ++step) {
        // The conditions on rays are those of the least of a convex function, quadratic in pieces
        for (std::size_t k = 0; k < rays_.size(); ++k) rays_[k].bears = ray_impulse(k, points[k / 2], delta_) > 0.0;
        if (!assemble_rays(movers, points)) return false;
        ray_force(movers, points);
        system_.solve(step_);

        // Go down along Newton's way to the least of the function, whole or in part
        double low = 0.0;
        double high = 1.0;
        if (step >= k_whole_steps && slope(movers, points, 1.0) > 0.0) {
            for (int k = 0; k < k_halvings; ++k) {
                const double middle = 0.5 * (low + high);
                (slope(movers, points, middle) > 0.0 ? high : low) = middle;
            }
            high = low > 0.0 ? low : high;
        }
        for (std::size_t i = 0; i < delta_.size(); ++i) delta_[i] += high * step_[i];
        bool same = true;
        for (std::size_t k = 0; k < rays_.size() && same; ++k) {
            same = rays_[k].bears == (ray_impulse(k, points[k / 2], delta_) > 0.0);
        }
        if (same && high == 1.0) {
            settled = true;
            break;
        }
    }
    for (std::size_t k = 0; k < points.size(); ++k) {
        const double one = ray_impulse(2 * k, points[k], delta_);
        const double two = ray_impulse(2 * k + 1, points[k], delta_);
        impulse_[2 * k] = one + two;
        impulse_[2 * k + 1] = points[k].friction * (one - two);
    }
    return settled;
}

Line GroupSolver::ray_line(std::size_t ray, const ContactPoint& c) const
{
    Line line = normal_line(c);
    const Line t = tangent_line(c);
    add(line.a, rays_[ray].share, t.a);
    add(line.b, rays_[ray].share, t.b);
    return line;
}

double GroupSolver::along_ray(const Line& line, const ContactPoint& c, std::span<const double> delta) const
{
    static constexpr double k_still[3] = {0.0, 0.0, 0.0};
    const double* of_a = local_[c.a] >= 0 ? &delta[3 * local_[c.a]] : k_still;
    const double* of_b = local_[c.b] >= 0 ? &delta[3 * local_[c.b]] : k_still;
    return along(line.a, of_a) + along(line.b, of_b);
}

double GroupSolver::ray_impulse(std::size_t k, const ContactPoint& c, std::span<const double> delta) const
{
    const Ray& ray = rays_[k];
    return std::max(0.0, ray.impulse - ray.stiffness * (ray.speed + along_ray(ray_line(k, c), c, delta)));
}

void GroupSolver::ray_force(std::span<const Mover> movers, std::span<const ContactPoint> points)
{
    for (std::size_t k = 0; k < members_.size(); ++k) {
        const Mover& mover = movers[members_[k]];
        step_[3 * k] = -delta_[3 * k] / mover.inv_mass;
        step_[3 * k + 1] = -delta_[3 * k + 1] / mover.inv_mass;
        step_[3 * k + 2] = -delta_[3 * k + 2] / mover.inv_moment;
    }
    for (std::size_t k = 0; k < rays_.size(); ++k) {
        const ContactPoint& c = points[k / 2];
        const double change = ray_impulse(k, c, delta_) - rays_[k].impulse;
        push_members(c, change, rays_[k].share * change, step_);
    }
}

double GroupSolver::slope(std::span<const Mover> movers, std::span<const ContactPoint> points, double part)
{
    double sum = 0.0;
    trial_.resize(delta_.size());
    for (std::size_t i = 0; i < delta_.size(); ++i) trial_[i] = delta_[i] + part * step_[i];
    for (std::size_t k = 0; k < members_.size(); ++k) {
        const Mover& mover = movers[members_[k]];
        const double shift = trial_[3 * k] * step_[3 * k] + trial_[3 * k + 1] * step_[3 * k + 1];
        sum += shift / mover.inv_mass + (trial_[3 * k + 2] * step_[3 * k + 2]) / mover.inv_moment;
    }
    for (std::size_t k = 0; k < rays_.size(); ++k) {
        const ContactPoint& c = points[k / 2];
        const double change = ray_impulse(k, c, trial_) - rays_[k].impulse;
        if (change != 0.0) sum -= change * along_ray(ray_line(k, c), c, step_);
    }
    return sum;
}

bool GroupSolver::assemble_rays(std::span<const Mover> movers, std::span<const ContactPoint> points)
{
    assemble_masses(movers);
    for (std::size_t k = 0; k < rays_.size(); ++k) {
        if (!rays_[k].bears) continue;
        const ContactPoint& c = points[k / 2];
        const Line f = ray_line(k, c);
        const double stiffness = rays_[k].stiffness;
        const int a = local_[c.a];
        const int b = local_[c.b];
        if (a >= 0) add_product(system_.diagonal(a), stiffness, f.a, f.a);
        if (b >= 0) add_product(system_.diagonal(b), stiffness, f.b, f.b);
        if (edge_of_[k / 2] < 0) continue;
        const BlockSystem::Place& place = system_.place(edge_of_[k / 2]);
        add_product(system_.block(place.first_second), stiffness, f.a, f.b);
        add_product(system_.block(place.second_first), stiffness, f.b, f.a);
    }
    ++counts_.factorisations;
    factorised_ = false;
    return system_.factorise();
}
// [rest.group.descend]

// [rest.group.members]
void GroupSolver::push_members(const ContactPoint& c, double normal, double tangent, std::span<double> force) const
{
    const Line n = normal_line(c);
    const Line t = tangent_line(c);
    const int a = local_[c.a];
    const int b = local_[c.b];
    if (a >= 0) {
        add(&force[3 * a], normal, n.a);
        add(&force[3 * a], tangent, t.a);
    }
    if (b >= 0) {
        add(&force[3 * b], normal, n.b);
        add(&force[3 * b], tangent, t.b);
    }
}
// [rest.group.members]

} // namespace flying
