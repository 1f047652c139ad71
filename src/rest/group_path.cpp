#include <algorithm>
#include <cmath>

#include "rest/group_solver.hpp"
#include "rest/push_lines.hpp"
#include "rest/rest_tolerance.hpp"

namespace flying {
namespace {

using rest_tolerance::k_stiffness;

/// 2^32 over the golden section: multiples of it, modulo 2^32, lie far from each other.
constexpr std::uint32_t k_golden = 2654435769U;

} // namespace

/// Shifts of speeds with which the impulses that are there are right; or, from none, with which no point closes.
/// Returns how many times those shifts the path begins with.
double GroupSolver::shift_speeds(std::span<const ContactPoint> points, PathStart start)
{
    shift_.assign(2 * points.size(), 0.0);
    if (start == PathStart::nothing) {
        double top = 0.0; // [m/s]
        for (std::size_t k = 0; k < points.size(); ++k) {
            const std::uint32_t mixed = static_cast<std::uint32_t>(k + 1) * k_golden;
            shift_[2 * k] = 1.0 + rest_tolerance::k_path_apart * (static_cast<double>(mixed) * 0x1p-32);
            top = std::max(top, -slip_[2 * k] / shift_[2 * k]);
        }
        for (double& x : shift_) x *= top;
        return 1.0 + rest_tolerance::k_path_before;
    }
    for (std::size_t k = 0; k < points.size(); ++k) {
        const ContactPoint& c = points[k];
        const double slip = slip_[2 * k + 1];
        const double most = c.friction * c.normal;
        const bool slips_on = (c.tangent >= most && slip < 0.0) || (c.tangent <= -most && slip > 0.0);
        if (c.normal > 0.0 || slip_[2 * k] < 0.0) shift_[2 * k] = -slip_[2 * k];
        if (c.normal > 0.0 && !slips_on) shift_[2 * k + 1] = -slip;
    }
    return 1.0;
}

/// The speeds of all points are shifted at first, so that a solution is known; the shift shrinks to nothing, and the
/// solution goes with it. From piece to piece one point changes what it does; where that turns the path round, which
/// the sign of the determinant tells, the shift grows again for a while. A path from nothing has nowhere else to end
/// but at a solution (Lemke 1965; Eaves 1976), wherever no bound asks bodies to part: in the plane Coulomb's cone has
/// two edges, so that his conditions are linear in pieces, and their matrix is copositive whatever the friction.
bool GroupSolver::follow_path(std::span<const Mover> movers, std::span<const ContactPoint> points, PathStart start,
                              int most)
{
    double left = shift_speeds(points, start);
    start_springs(points, left);
    double first = 1.0;
    Turn last;
    for (int piece = 0; piece < most; ++piece) {
        if (!assemble(movers, points)) return false;
        push_shifts(points);
        system_.solve(delta_);
        if (piece == 0) first = system_.orientation();
        const double sign = first * system_.orientation();
        measure_rates(points, sign);
        const Turn next = next_turn(points, last, sign > 0.0 ? left : rest_tolerance::k_path_farthest - left);
        left -= sign * next.way;
        for (Springs& s : springs_) {
            s.normal += next.way * s.normal_rate;
            s.tangent += next.way * s.tangent_rate;
        }
        if (next.point < 0) {
            take_springs(points);
            return sign > 0.0;
        }
        mode_[next.point] = next.to;
        last = next;
    }
    return false;
}

void GroupSolver::start_springs(std::span<const ContactPoint> points, double left)
{
    springs_.resize(points.size());
    for (std::size_t k = 0; k < points.size(); ++k) {
        const ContactPoint& c = points[k];
        const double normal = c.normal - (k_stiffness * c.normal_mass) * (slip_[2 * k] + left * shift_[2 * k]);
        const double tangent =
            c.tangent - (k_stiffness * c.tangent_mass) * (slip_[2 * k + 1] + left * shift_[2 * k + 1]);
        springs_[k] = {normal, tangent, 0.0, 0.0};
        mode_[k] = Mode::stuck;
        if (!(normal > 0.0)) mode_[k] = Mode::apart;
        else if (c.friction == 0.0 || tangent > c.friction * normal) mode_[k] = Mode::slips_backwards;
        else if (tangent < -c.friction * normal) mode_[k] = Mode::slips_forwards;
    }
}

void GroupSolver::push_shifts(std::span<const ContactPoint> points)
{
    std::fill(delta_.begin(), delta_.end(), 0.0);
    for (std::size_t k = 0; k < points.size(); ++k) {
        if (mode_[k] == Mode::apart) continue;
        const ContactPoint& c = points[k];
        const double normal = (k_stiffness * c.normal_mass) * shift_[2 * k];
        double tangent = 0.0;
        if (mode_[k] == Mode::stuck) tangent = (k_stiffness * c.tangent_mass) * shift_[2 * k + 1];
        if (mode_[k] == Mode::slips_backwards) tangent = c.friction * normal;
        if (mode_[k] == Mode::slips_forwards) tangent = -c.friction * normal;
        push_members(c, normal, tangent, delta_);
    }
}

void GroupSolver::measure_rates(std::span<const ContactPoint> points, double sign)
{
    static constexpr double k_none[3] = {0.0, 0.0, 0.0};
    for (std::size_t k = 0; k < points.size(); ++k) {
        const ContactPoint& c = points[k];
        const double* of_a = local_[c.a] >= 0 ? &delta_[3 * local_[c.a]] : k_none;
        const double* of_b = local_[c.b] >= 0 ? &delta_[3 * local_[c.b]] : k_none;
        const Line n = normal_line(c);
        const Line t = tangent_line(c);
        const double closing = shift_[2 * k] - (along(n.a, of_a) + along(n.b, of_b));
        const double slipping = shift_[2 * k + 1] - (along(t.a, of_a) + along(t.b, of_b));
        springs_[k].normal_rate = sign * (k_stiffness * c.normal_mass) * closing;
        springs_[k].tangent_rate = sign * (k_stiffness * c.tangent_mass) * slipping;
    }
}

/// The first point that changes what it does, within so much of the path; not back to what the last has just left.
GroupSolver::Turn GroupSolver::next_turn(std::span<const ContactPoint> points, const Turn& last, double within) const
{
    Turn next;
    next.way = within;
    for (int k = 0; k < static_cast<int>(points.size()); ++k) {
        const Mode now = mode_[k];
        const Springs& s = springs_[k];
        const double mu = points[k].friction;
        // What is positive as long as nothing changes
        const auto ends = [&](double value, double rate, Mode to) {
            if (!(rate < 0.0) || (k == last.point && to == last.from)) return;
            const double way = std::max(value, 0.0) / -rate;
            if (way < next.way) next = {k, now, to, way};
        };
        if (now == Mode::apart) {
            const double tangent = s.tangent;
            ends(-s.normal, -s.normal_rate, mu == 0.0 || tangent > 0.0 ? Mode::slips_backwards : Mode::slips_forwards);
            continue;
        }
        ends(s.normal, s.normal_rate, Mode::apart);
        if (mu == 0.0) continue;
        const double above = mu * s.normal - s.tangent;
        const double below = mu * s.normal + s.tangent;
        const double above_rate = mu * s.normal_rate - s.tangent_rate;
        const double below_rate = mu * s.normal_rate + s.tangent_rate;
        if (now == Mode::stuck) {
            ends(above, above_rate, Mode::slips_backwards);
            ends(below, below_rate, Mode::slips_forwards);
        } else if (now == Mode::slips_backwards) ends(-above, -above_rate, Mode::stuck);
        else ends(-below, -below_rate, Mode::stuck);
    }
    // What comes to bear slips the way that it moves when it does
    const bool comes = next.point >= 0 && next.from == Mode::apart && points[next.point].friction > 0.0;
    if (comes) {
        const Springs& s = springs_[next.point];
        next.to = s.tangent + next.way * s.tangent_rate > 0.0 ? Mode::slips_backwards : Mode::slips_forwards;
    }
    return next;
}

void GroupSolver::take_springs(std::span<const ContactPoint> points)
{
    for (std::size_t k = 0; k < points.size(); ++k) {
        const double normal = mode_[k] == Mode::apart ? 0.0 : std::max(springs_[k].normal, 0.0);
        const double most = points[k].friction * normal;
        impulse_[2 * k] = normal;
        impulse_[2 * k + 1] = std::clamp(springs_[k].tangent, -most, most);
    }
}

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

} // namespace flying
