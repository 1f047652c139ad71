#include "rest/interior_point.hpp"

#include <algorithm>
#include <cmath>

#include "rest/push_lines.hpp"
#include "rest/rest_tolerance.hpp"

namespace flying {
namespace {

/// Part of a change after which a positive number is zero; 2 where it does not shrink.
[[nodiscard]] double part_until_zero(double value, double change)
{
    return change < 0.0 ? -value / change : 2.0;
}

} // namespace

void InteriorPoint::start(const ContactProblem& problem, std::span<const double> limits)
{
    unit_ = 0.0;
    for (std::size_t k = 0; k < problem.points.size(); ++k) {
        unit_ = std::max(unit_, -problem.slip[2 * k]);
        if (problem.points[k].friction > 0.0) unit_ = std::max(unit_, std::abs(problem.slip[2 * k + 1]));
    }
    if (!(unit_ > 0.0)) unit_ = 1.0;
    now_.resize(problem.points.size());
    rows_.resize(now_.size());
    change_.assign(now_.size(), Pairs{});
    delta_.assign(3 * problem.bodies.size(), 0.0);
    for (std::size_t k = 0; k < now_.size(); ++k) {
        const ContactPoint& c = problem.points[k];
        Pairs& x = now_[k];
        x.j = 1.0 / std::max(1.0, problem.slip[2 * k] / unit_);
        double most = c.friction * x.j;
        if (!limits.empty()) {
            most = limits[k] / (c.normal_mass * unit_);
            if (most > 0.0) x.j = std::max(x.j, most / c.friction); // of the size that the limits are for
        }
        rows_[k].coupling = limits.empty() ? c.friction : 0.0;
        rows_[k].has_friction = most > 0.0;
        x.p = x.q = 0.25 * most;
        x.c = 0.5 * most;
        const auto& seat = problem.seats[k];
        // p = q: pushes along the normal alone
        const Line n = normal_line(c);
        const auto add_push = [&](int body, const double* line) {
            if (body < 0) return;
            const Mover& m = problem.bodies[body];
            const double j = c.normal_mass * unit_ * x.j;
            delta_[3 * body] += m.inv_mass * j * line[0];
            delta_[3 * body + 1] += m.inv_mass * j * line[1];
            delta_[3 * body + 2] += m.inv_moment * j * line[2];
        };
        add_push(seat.a, n.a);
        add_push(seat.b, n.b);
    }
    static constexpr double k_none[3] = {0.0, 0.0, 0.0};
    double greatest = 0.0; // product
    for (std::size_t k = 0; k < now_.size(); ++k) {
        const ContactPoint& c = problem.points[k];
        Pairs& x = now_[k];
        const auto& seat = problem.seats[k];
        const double* of_a = seat.a >= 0 ? &delta_[3 * seat.a] : k_none;
        const double* of_b = seat.b >= 0 ? &delta_[3 * seat.b] : k_none;
        const Line n = normal_line(c);
        const Line t = tangent_line(c);
        const double u_n = (problem.slip[2 * k] + (along(n.a, of_a) + along(n.b, of_b))) / unit_;
        const double u_t = (problem.slip[2 * k + 1] + (along(t.a, of_a) + along(t.b, of_b))) / unit_;
        x.w = std::max(u_n, 1.0);
        x.a = u_t;
        x.l = std::abs(u_t) + 1.0;
        if (limits.empty()) x.l /= x.j;
        rows_[k].left = u_n;
        greatest = std::max({greatest, x.j * x.w, x.c * x.l});
    }
    for (std::size_t k = 0; k < now_.size(); ++k) {
        Pairs& x = now_[k];
        if (!limits.empty()) { // begin where all products are of one size
            x.w = std::max(x.w, greatest / x.j);
            if (rows_[k].has_friction) x.l = std::max(x.l, greatest / x.c);
        }
        rows_[k].left -= x.w;
        x.b = x.l - x.a;
        x.a += x.l;
    }
}

bool InteriorPoint::assemble(const ContactProblem& problem, BlockSystem& system)
{
    system.clear();
    for (std::size_t k = 0; k < problem.bodies.size(); ++k) {
        Block& block = system.diagonal(static_cast<int>(k));
        block.at[0][0] = block.at[1][1] = 1.0 / problem.bodies[k].inv_mass;
        block.at[2][2] = 1.0 / problem.bodies[k].inv_moment;
    }
    for (std::size_t k = 0; k < now_.size(); ++k) {
        const ContactPoint& c = problem.points[k];
        const Pairs& x = now_[k];
        Row& row = rows_[k];
        row.stiff_nn = x.j / x.w;
        row.stiff_tt = row.stiff_tn = row.mix = 0.0;
        if (row.has_friction) {
            const double forwards = x.p / x.a;
            const double backwards = x.q / x.b;
            const double limit = x.l / x.c;
            row.mix = 1.0 / (1.0 + limit * (forwards + backwards));
            row.stiff_tt = ((forwards + backwards) + 4.0 * forwards * backwards * limit) * row.mix;
            row.stiff_tn = (forwards - backwards) * row.mix * limit * row.coupling * row.stiff_nn;
        }
        const double stiff_nn = c.normal_mass * row.stiff_nn;
        const double stiff_tt = c.normal_mass * row.stiff_tt;
        const double stiff_tn = c.normal_mass * row.stiff_tn;
        const Line n = normal_line(c);
        const Line t = tangent_line(c);
        Line left{};
        add(left.a, stiff_nn, n.a);
        add(left.b, stiff_nn, n.b);
        add(left.a, stiff_tn, t.a);
        add(left.b, stiff_tn, t.b);
        const auto& seat = problem.seats[k];
        const auto add_to = [&](Block& block, const double* of_left, const double* of_t, const double* n_of,
                                const double* t_of) {
            add_product(block, 1.0, of_left, n_of);
            if (stiff_tt > 0.0) add_product(block, stiff_tt, of_t, t_of);
        };
        if (seat.a >= 0) add_to(system.diagonal(seat.a), left.a, t.a, n.a, t.a);
        if (seat.b >= 0) add_to(system.diagonal(seat.b), left.b, t.b, n.b, t.b);
        if (seat.edge < 0) continue;
        const BlockSystem::Place& place = system.place(seat.edge);
        add_to(system.block(place.first_second), left.a, t.a, n.b, t.b);
        add_to(system.block(place.second_first), left.b, t.b, n.a, t.a);
    }
    return system.factorise();
}

void InteriorPoint::step_towards(const ContactProblem& problem, BlockSystem& system, const Aim& aim)
{
    static constexpr double k_none[3] = {0.0, 0.0, 0.0};
    std::fill(delta_.begin(), delta_.end(), 0.0);
    const auto wanted = [&](double x, double y, double dx, double dy) {
        return aim.product - x * y - (aim.is_corrected ? dx * dy : 0.0);
    };
    for (std::size_t k = 0; k < now_.size(); ++k) {
        const ContactPoint& c = problem.points[k];
        const Pairs& x = now_[k];
        const Pairs& d = change_[k];
        Row& row = rows_[k];
        row.normal = (wanted(x.j, x.w, d.j, d.w) - x.j * (aim.closed * row.left)) / x.w;
        row.tangent = row.lift = 0.0;
        if (row.has_friction) {
            const double forwards = x.p / x.a;
            const double backwards = x.q / x.b;
            const double limit = x.l / x.c;
            const double p = wanted(x.p, x.a, d.p, d.a) / x.a;
            const double q = wanted(x.q, x.b, d.q, d.b) / x.b;
            row.lift = row.mix * (wanted(x.l, x.c, d.l, d.c) / x.c + limit * (p + q));
            row.tangent = (p - q) - (forwards - backwards) * (row.lift - row.mix * limit * row.coupling * row.normal);
        }
        const double j = c.normal_mass * unit_ * row.normal;
        const double q = c.normal_mass * unit_ * row.tangent;
        const auto& seat = problem.seats[k];
        const Line n = normal_line(c);
        const Line t = tangent_line(c);
        if (seat.a >= 0) {
            add(&delta_[3 * seat.a], j, n.a);
            add(&delta_[3 * seat.a], q, t.a);
        }
        if (seat.b >= 0) {
            add(&delta_[3 * seat.b], j, n.b);
            add(&delta_[3 * seat.b], q, t.b);
        }
    }
    system.solve(delta_);
    for (std::size_t k = 0; k < now_.size(); ++k) {
        const ContactPoint& c = problem.points[k];
        const Pairs& x = now_[k];
        Pairs& d = change_[k];
        const Row& row = rows_[k];
        const auto& seat = problem.seats[k];
        const double* of_a = seat.a >= 0 ? &delta_[3 * seat.a] : k_none;
        const double* of_b = seat.b >= 0 ? &delta_[3 * seat.b] : k_none;
        const Line n = normal_line(c);
        const double u_n = (along(n.a, of_a) + along(n.b, of_b)) / unit_;
        const Pairs last = d;
        d.j = row.normal - row.stiff_nn * u_n;
        d.w = u_n + aim.closed * row.left;
        if (!row.has_friction) {
            d.p = d.a = d.q = d.b = d.l = d.c = 0.0;
            continue;
        }
        const Line t = tangent_line(c);
        const double u_t = (along(t.a, of_a) + along(t.b, of_b)) / unit_;
        const double forwards = x.p / x.a;
        const double backwards = x.q / x.b;
        const double limit = x.l / x.c;
        const double p = wanted(x.p, x.a, last.p, last.a) / x.a;
        const double q = wanted(x.q, x.b, last.q, last.b) / x.b;
        d.l = row.lift - row.mix * limit * (row.coupling * d.j + (forwards - backwards) * u_t);
        d.a = d.l + u_t;
        d.b = d.l - u_t;
        d.p = p - forwards * d.a;
        d.q = q - backwards * d.b;
        d.c = row.coupling * d.j - (d.p + d.q);
    }
}

double InteriorPoint::longest_step() const
{
    double most = 2.0;
    for (std::size_t k = 0; k < now_.size(); ++k) {
        const Pairs& x = now_[k];
        const Pairs& d = change_[k];
        most = std::min({most, part_until_zero(x.j, d.j), part_until_zero(x.w, d.w), part_until_zero(x.p, d.p),
                         part_until_zero(x.a, d.a), part_until_zero(x.q, d.q), part_until_zero(x.b, d.b),
                         part_until_zero(x.l, d.l), part_until_zero(x.c, d.c)});
    }
    return most;
}

double InteriorPoint::mean_product(double step) const
{
    double sum = 0.0;
    std::size_t pairs = 0;
    for (std::size_t k = 0; k < now_.size(); ++k) {
        const Pairs& x = now_[k];
        const Pairs& d = change_[k];
        sum += (x.j + step * d.j) * (x.w + step * d.w);
        ++pairs;
        if (x.c <= 0.0) continue;
        sum += (x.p + step * d.p) * (x.a + step * d.a) + (x.q + step * d.q) * (x.b + step * d.b);
        sum += (x.l + step * d.l) * (x.c + step * d.c);
        pairs += 3;
    }
    return sum / static_cast<double>(pairs);
}

void InteriorPoint::take(double step, double closed)
{
    for (std::size_t k = 0; k < now_.size(); ++k) {
        Pairs& x = now_[k];
        const Pairs& d = change_[k];
        x.j += step * d.j;
        x.w += step * d.w;
        x.p += step * d.p;
        x.a += step * d.a;
        x.q += step * d.q;
        x.b += step * d.b;
        x.l += step * d.l;
        x.c += step * d.c;
        rows_[k].left *= 1.0 - step * closed;
    }
}

bool InteriorPoint::solve(const ContactProblem& problem, BlockSystem& system, std::span<double> impulse,
                          std::int64_t& factorisations, std::span<const double> limits)
{
    start(problem, limits);
    double missed = mean_product(0.0); // what the first numbers miss of the bounds, as a mean product
    bool small = false;
    for (int k = 0; k < rest_tolerance::k_patience && !small; ++k) {
        ++factorisations;
        if (!assemble(problem, system)) break;

        // See how far the products could fall at once, then go where they are as much less, and all of one size
        const double mean = mean_product(0.0);
        step_towards(problem, system, {0.0, 1.0, false});
        const double blocked = 1.0 - std::min(1.0, longest_step());
        double share = blocked * blocked;
        const double size = std::max(mean, missed);
        step_towards(problem, system, {share * size, 1.0 - share, blocked < 1.0 - rest_tolerance::k_interior_short});
        double step = std::min(1.0, rest_tolerance::k_interior_inside * longest_step());
        if (step < rest_tolerance::k_interior_short) {
            share = 1.0;
            step_towards(problem, system, {size, 0.0, false});
            step = std::min(1.0, rest_tolerance::k_interior_inside * longest_step());
        }
        take(step, 1.0 - share);
        missed *= 1.0 - step * (1.0 - share);
        small = mean_product(0.0) <= rest_tolerance::k_interior_small;
    }

    // Of each pair only the greater number is left
    for (std::size_t k = 0; k < now_.size(); ++k) {
        const ContactPoint& c = problem.points[k];
        const Pairs& x = now_[k];
        const double scale = c.normal_mass * unit_;
        const bool bears = x.j > x.w;
        const double most = limits.empty() ? c.friction * x.j : limits[k] / scale;
        double friction = x.p - x.q;
        if (x.l > x.c) friction = x.p > x.q ? most : -most;
        impulse[2 * k] = bears ? scale * x.j : 0.0;
        impulse[2 * k + 1] = bears || !limits.empty() ? scale * std::clamp(friction, -most, most) : 0.0;
    }
    return small;
}

} // namespace flying
