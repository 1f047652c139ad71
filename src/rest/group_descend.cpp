#include <algorithm>
#include <cmath>

#include "rest/group_solver.hpp"
#include "rest/push_lines.hpp"

namespace flying {
namespace {

// [rest.group.descend.limits]
/// Steps of the descent, and halvings of one.
constexpr int k_descents = 40;
constexpr int k_halvings = 40;
// [rest.group.descend.limits]

} // namespace

// [rest.group.descend]
bool GroupSolver::descend(std::span<const Mover> movers, std::span<const ContactPoint> points)
{
    std::fill(delta_.begin(), delta_.end(), 0.0);
    step_.resize(delta_.size());
    bool settled = false;
    for (int step = 0; step < k_descents; ++step) {
        // Where the cone is frozen, the conditions are those of the least of a convex function, quadratic in pieces
        for (std::size_t k = 0; k < points.size(); ++k)
            mode_[k] = frozen_mode(points[k], slips_after(k, points[k], delta_), k);
        if (!assemble(movers, points, Cone::frozen)) return false;
        frozen_force(movers, points);
        system_.solve(step_);

        // Go down along Newton's way to the least of the function, whole or in part
        double low = 0.0;
        double high = 1.0;
        if (slope(movers, points, 1.0) > 0.0) {
            for (int k = 0; k < k_halvings; ++k) {
                const double middle = 0.5 * (low + high);
                (slope(movers, points, middle) > 0.0 ? high : low) = middle;
            }
            high = low > 0.0 ? low : high;
        }
        for (std::size_t i = 0; i < delta_.size(); ++i) delta_[i] += high * step_[i];
        if (high < 1.0) continue;
        bool same = true;
        for (std::size_t k = 0; k < points.size() && same; ++k) {
            same = mode_[k] == frozen_mode(points[k], slips_after(k, points[k], delta_), k);
        }
        if (same) {
            settled = true;
            break;
        }
    }
    for (std::size_t k = 0; k < points.size(); ++k) {
        const FrozenImpulse impulse = frozen_impulse(points[k], slips_after(k, points[k], delta_));
        impulse_[2 * k] = impulse.normal;
        impulse_[2 * k + 1] = impulse.tangent;
    }
    return settled;
}

GroupSolver::Slips GroupSolver::slips_after(std::size_t k, const ContactPoint& c, std::span<const double> delta) const
{
    static constexpr double k_still[3] = {0.0, 0.0, 0.0};
    const double* of_a = local_[c.a] >= 0 ? &delta[3 * local_[c.a]] : k_still;
    const double* of_b = local_[c.b] >= 0 ? &delta[3 * local_[c.b]] : k_still;
    const Line n = normal_line(c);
    const Line t = tangent_line(c);
    return {slip_[2 * k] + (along(n.a, of_a) + along(n.b, of_b)),
            slip_[2 * k + 1] + (along(t.a, of_a) + along(t.b, of_b))};
}

GroupSolver::FrozenImpulse GroupSolver::frozen_impulse(const ContactPoint& c, const Slips& slips) const
{
    const double most = c.friction * c.normal;
    const double tangent = c.tangent - (stiffness_ * c.tangent_mass) * slips.tangent;
    return {std::max(0.0, c.normal - (stiffness_ * c.normal_mass) * slips.normal), std::clamp(tangent, -most, most)};
}

GroupSolver::Mode GroupSolver::frozen_mode(const ContactPoint& c, const Slips& slips, std::size_t k)
{
    const double most = c.friction * c.normal;
    const double tangent = c.tangent - (stiffness_ * c.tangent_mass) * slips.tangent;
    grips_[k] = std::abs(tangent) <= most && most > 0.0 ? 1 : 0;
    const double normal = c.normal - (stiffness_ * c.normal_mass) * slips.normal;
    return normal > 0.0 ? (grips_[k] ? Mode::stuck : Mode::slips_forwards) : Mode::apart;
}

void GroupSolver::frozen_force(std::span<const Mover> movers, std::span<const ContactPoint> points)
{
    for (std::size_t k = 0; k < members_.size(); ++k) {
        const Mover& mover = movers[members_[k]];
        step_[3 * k] = -delta_[3 * k] / mover.inv_mass;
        step_[3 * k + 1] = -delta_[3 * k + 1] / mover.inv_mass;
        step_[3 * k + 2] = -delta_[3 * k + 2] / mover.inv_moment;
    }
    for (std::size_t k = 0; k < points.size(); ++k) {
        const ContactPoint& c = points[k];
        const FrozenImpulse impulse = frozen_impulse(c, slips_after(k, c, delta_));
        push_members(c, impulse.normal - c.normal, impulse.tangent - c.tangent, step_);
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
    for (std::size_t k = 0; k < points.size(); ++k) {
        const ContactPoint& c = points[k];
        const FrozenImpulse impulse = frozen_impulse(c, slips_after(k, c, trial_));
        const Slips change = slips_after(k, c, step_);
        sum -= (impulse.normal - c.normal) * (change.normal - slip_[2 * k]);
        sum -= (impulse.tangent - c.tangent) * (change.tangent - slip_[2 * k + 1]);
    }
    return sum;
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
