#pragma once

#include <cmath>
#include <span>
#include <vector>

#include "rest/contact_point.hpp"
#include "rest/island_solver.hpp"
#include "rest/sweeps.hpp"

/// Bodies one above the other, as the solver sees them: nothing but masses and points.
namespace flying::test {

/// A floor, bodies on it, and a point below each. `fall` is what gravity adds in a step.
struct Column
{
    std::vector<Mover> movers; // the floor first
    std::vector<ContactPoint> points;
    std::vector<int> members;
};

inline Column column_of(const std::vector<double>& masses, double fall)
{
    Column column;
    column.movers.push_back({});
    for (const double m : masses) {
        const int k = static_cast<int>(column.movers.size());
        column.movers.push_back({0.0, -fall, 0.0, 1.0 / m, 1.0 / m});
        ContactPoint c;
        c.a = k - 1;
        c.b = k;
        c.pair = k;
        c.n_y = 1.0;
        c.normal_mass = 1.0 / (column.movers[k - 1].inv_mass + column.movers[k].inv_mass);
        c.tangent_mass = c.normal_mass;
        column.points.push_back(c);
        column.members.push_back(k);
    }
    return column;
}

/// The weights that points bear, in one step.  [N s]
inline std::vector<double> weights_above(const std::vector<double>& masses, double fall)
{
    std::vector<double> weights(masses.size());
    double sum = 0.0;
    for (std::size_t k = masses.size(); k > 0; --k) {
        sum += masses[k - 1] * fall;
        weights[k - 1] = sum;
    }
    return weights;
}

/// The worst impulse's error, as a share of the weight that it should bear.
inline double worst_error(std::span<const ContactPoint> points, std::span<const double> weights)
{
    double worst = 0.0;
    for (std::size_t k = 0; k < weights.size(); ++k)
        worst = std::max(worst, std::abs(points[k].normal / weights[k] - 1.0));
    return worst;
}

/// Sweeps over a column, and what is left after each.
class ColumnSweeps
{
public:
    explicit ColumnSweeps(const std::vector<double>& masses, double fall = 1.0)
        : column_(column_of(masses, fall)), weights_(weights_above(masses, fall))
    {
    }

    /// One sweep from the floor up; the worst error after it.
    double sweep_once()
    {
        sweep(column_.points, column_.movers);
        return worst_error(column_.points, weights_);
    }

    [[nodiscard]] double impulse(int point) const { return column_.points[point].normal; }

private:
    Column column_;
    std::vector<double> weights_;
};

/// Sweeps until no impulse is off by more than `share`.
inline int sweeps_until(const std::vector<double>& masses, double share)
{
    ColumnSweeps column(masses);
    int count = 1;
    while (column.sweep_once() > share) ++count;
    return count;
}

/// What one more sweep leaves of the error, once all that dies faster has died.
inline double rate_of_sweeps(const std::vector<double>& masses, int sweeps)
{
    ColumnSweeps column(masses);
    double before = 1.0;
    for (int k = 0; k < sweeps; ++k) before = column.sweep_once();
    return column.sweep_once() / before;
}

/// How far the uppermost of equal boxes sinks in a second of short steps, with so many
/// sweeps in each, from no impulses or from those of the step before.  [m]
inline double sinks_in_a_second(int count, int steps, int sweeps, bool is_warm)
{
    Column column = column_of(std::vector<double>(count, 1.0), 0.0);
    double way = 0.0;
    for (int k = 0; k < steps; ++k) {
        for (const int member : column.members) column.movers[member].v_y -= 9.81 / steps;
        if (!is_warm) forget_impulses(column.points);
        warm_start(column.points, column.movers);
        for (int i = 0; i < sweeps; ++i) sweep(column.points, column.movers);
        way -= column.movers.back().v_y / steps;
    }
    return way;
}

/// The same column, by the engine's direct solve: error and factorisations.
struct DirectSolve
{
    double error = 0.0;
    long factorisations = 0;
};

inline DirectSolve solve_at_once(const std::vector<double>& masses)
{
    Column column = column_of(masses, 1.0);
    IslandSolver solver;
    if (!solver.solve(column.movers, column.members, column.points, 0.0)) return {1.0, 0};
    const std::vector<double> weights = weights_above(masses, 1.0);
    return {worst_error(column.points, weights), static_cast<long>(solver.counts().factorisations)};
}

} // namespace flying::test
