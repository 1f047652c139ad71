#include "rest/island_solver.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "rest/rest_tolerance.hpp"

namespace flying {
namespace {

/// The most that an impulse changes the velocity of the lightest it pushes.  [m/s]
[[nodiscard]] double greatest_push(std::span<const ContactPoint> points)
{
    double greatest = 0.0;
    for (const ContactPoint& c : points) greatest = std::max(greatest, c.normal / c.normal_mass);
    return greatest;
}

/// Pieces of a path that begins near its end.
[[nodiscard]] int few_pieces(std::size_t points)
{
    return std::min(static_cast<int>(points) + rest_tolerance::k_quick_rounds, rest_tolerance::k_more_sweeps);
}

} // namespace

double rounding_of(std::span<const ContactPoint> points, std::size_t members)
{
    return rest_tolerance::k_residual * static_cast<double>(members) * greatest_push(points);
}

bool IslandSolver::solve(std::span<Mover> movers, std::span<const int> members, std::span<ContactPoint> points,
                         double tolerance, Effort effort)
{
    const Island island{movers, members, points, tolerance};
    take_problem(island);

    // What was right in the step before most often is right still
    if (!is_warm_) forget_impulses(points);
    warm_start(points, movers);
    if (worst_residual(points, movers) <=
        rest_tolerance::k_stagnant * std::max(tolerance, rounding_of(points, members.size()))) {
        ++counts_.accepted;
        return true;
    }
    forget_what_suits_worse(island);

    const std::int64_t before = pieces_.factorisations();
    pieces_.begin(problem_, members, movers.size());
    best_ = worst_residual(points, movers);
    kept_.assign(points.begin(), points.end());
    bool content = improve(island, From::here);
    for (const From from : {From::turns, From::more_turns, From::nothing}) {
        if (content || effort == Effort::brief) break;
        if (from == From::nothing && points.size() > rest_tolerance::k_most_whole) break;
        go_back_to_best(island);
        content = improve(island, from);
    }
    if (!content) go_back_to_best(island);
    counts_.factorisations += pieces_.factorisations() - before;
    ++(content ? counts_.solved : counts_.unsolved);
    return content;
}

void IslandSolver::solve_by_turns(std::span<Mover> movers, std::span<const int> members, std::span<ContactPoint> points,
                                  double tolerance, int rounds)
{
    const Island island{movers, members, points, tolerance};
    take_problem(island);
    warm_start(points, movers);
    const std::int64_t before = pieces_.factorisations();
    pieces_.begin(problem_, members, movers.size());
    go_by_turns(island, {tolerance, rounds, rounds});
    counts_.factorisations += pieces_.factorisations() - before;
}

void IslandSolver::take_problem(const Island& island)
{
    problem_.points = island.points;
    problem_.bodies.clear();
    for (const int member : island.members) problem_.bodies.push_back(island.movers[member]);
}

/// Impulses that suit this step worse than none go.
void IslandSolver::forget_what_suits_worse(const Island& island)
{
    const double warm = worst_residual(island.points, island.movers);
    kept_.assign(island.points.begin(), island.points.end());
    forget_impulses(island.points);
    restore_free(island);
    if (worst_residual(island.points, island.movers) < warm) return;
    std::copy(kept_.begin(), kept_.end(), island.points.begin());
    apply(island);
}

/// Looks for the pieces, then takes off what rounding leaves, until all points are content.
bool IslandSolver::improve(const Island& island, From from)
{
    double before = std::numeric_limits<double>::infinity();
    for (int k = 0; k < rest_tolerance::k_patience; ++k) {
        measure_slips(problem_, island.movers);
        if (!(k == 0 ? find_pieces(island, from) : find_from_here(island))) return false;
        take_impulses(island);
        const double now = worst_residual(island.points, island.movers);
        const double rounding = std::max(island.tolerance, rounding_of(island.points, island.members.size()));
        const bool content = now <= rounding || (now >= 0.5 * before && now <= rest_tolerance::k_stagnant * rounding);
        if (now < best_ || content) {
            best_ = now;
            kept_.assign(island.points.begin(), island.points.end());
        }
        if (content) return true;
        if (!(now < before)) return false;
        before = now;
    }
    return false;
}

bool IslandSolver::find_pieces(const Island& island, From from)
{
    switch (from) {
    case From::here:
        return find_by_newton(pieces_, problem_);
    case From::turns:
    case From::more_turns:
        go_by_turns(island, {0.0, rest_tolerance::k_more_sweeps,
                             from == From::turns ? rest_tolerance::k_quick_rounds : rest_tolerance::k_patience});
        measure_slips(problem_, island.movers);
        return find_from_here(island);
    case From::nothing:
        forget_impulses(island.points);
        restore_free(island);
        measure_slips(problem_, island.movers);
        return path_.follow(pieces_, problem_, PiecePath::Start::nothing,
                            rest_tolerance::k_few_rounds * static_cast<int>(island.points.size()));
    }
    return false;
}

void IslandSolver::go_by_turns(const Island& island, const Rounds& rounds)
{
    measure_slips(problem_, island.movers);
    turns_.solve(pieces_, problem_, rounds);
    take_impulses(island);
}

/// From impulses that are nearly right.
bool IslandSolver::find_from_here(const Island& island)
{
    return find_by_newton(pieces_, problem_) ||
           path_.follow(pieces_, problem_, PiecePath::Start::impulses, few_pieces(island.points.size()));
}

void IslandSolver::restore_free(const Island& island) const
{
    for (std::size_t k = 0; k < island.members.size(); ++k) island.movers[island.members[k]] = problem_.bodies[k];
}

/// The impulses of the points, and nothing else, act on the members.
void IslandSolver::apply(const Island& island) const
{
    restore_free(island);
    warm_start(island.points, island.movers);
}

void IslandSolver::go_back_to_best(const Island& island) const
{
    std::copy(kept_.begin(), kept_.end(), island.points.begin());
    apply(island);
}

void IslandSolver::take_impulses(const Island& island) const
{
    for (std::size_t k = 0; k < island.points.size(); ++k) {
        island.points[k].normal = problem_.impulse[2 * k];
        island.points[k].tangent = problem_.impulse[2 * k + 1];
    }
    apply(island);
}

} // namespace flying
