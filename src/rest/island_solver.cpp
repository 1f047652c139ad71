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

bool are_many(std::span<const ContactPoint> points)
{
    return points.size() > rest_tolerance::k_few_rounds * rest_tolerance::k_most_whole;
}

double rounding_of(std::span<const ContactPoint> points, std::size_t members)
{
    return rest_tolerance::k_residual * static_cast<double>(members) * greatest_push(points);
}

bool IslandSolver::solve(std::span<Mover> movers, std::span<const int> members, std::span<ContactPoint> points,
                         double tolerance, Effort effort)
{
    const Task task{movers, members, points, tolerance, effort};
    take_problem(task);

    // What was right in the step before most often is right still
    const double of_none = worst_residual_of_none(points, movers);
    if (!is_warm_) forget_impulses(points);
    warm_start(points, movers);
    best_ = worst_residual(points, movers);
    if (best_ <= rest_tolerance::k_stagnant * enough(task)) {
        ++counts_.accepted;
        return true;
    }
    // Impulses that suit this step worse than none go
    if (of_none < best_) {
        best_ = of_none;
        forget_impulses(points);
        restore_free(task);
    }
    kept_.assign(points.begin(), points.end());

    const std::int64_t before = pieces_.factorisations();
    pieces_.begin(problem_, members, movers.size());
    bool content = improve(task, From::here);
    for (const From from : {From::turns, From::nothing}) {
        if (content || effort == Effort::brief) break;
        if (from == From::nothing && are_many(points)) break;
        go_back_to_best(task);
        content = improve(task, from);
    }
    if (!content) go_back_to_best(task);
    counts_.factorisations += pieces_.factorisations() - before;
    ++(content ? counts_.solved : counts_.unsolved);
    return content;
}

void IslandSolver::solve_by_turns(std::span<Mover> movers, std::span<const int> members, std::span<ContactPoint> points,
                                  double tolerance, int rounds)
{
    const Task task{movers, members, points, tolerance};
    take_problem(task);
    warm_start(points, movers);
    const std::int64_t before = pieces_.factorisations();
    pieces_.begin(problem_, members, movers.size());
    go_by_turns(task, {tolerance, rounds, rounds});
    counts_.factorisations += pieces_.factorisations() - before;
}

void IslandSolver::take_problem(const Task& task)
{
    problem_.points = task.points;
    problem_.bodies.clear();
    for (const int member : task.members) problem_.bodies.push_back(task.movers[member]);
}

/// A residual that is no motion, nor more than rounding explains.  [m/s]
double IslandSolver::enough(const Task& task)
{
    // Light bodies that bear heavy ones may move by what rounding leaves: as long as more can be taken off, it is
    const double still = rest_tolerance::k_still / rest_tolerance::k_residual * task.tolerance;
    return std::clamp(rounding_of(task.points, task.members.size()), task.tolerance, still);
}

/// The most that rounding leaves where nothing more can be taken off.  [m/s]
double IslandSolver::most_left(const Task& task)
{
    return rest_tolerance::k_stagnant * std::max(task.tolerance, rounding_of(task.points, task.members.size()));
}

/// Looks for the pieces, then takes off what rounding leaves, until all points are content.
bool IslandSolver::improve(const Task& task, From from)
{
    double before = std::numeric_limits<double>::infinity();
    for (int k = 0; k < rest_tolerance::k_patience; ++k) {
        measure_slips(problem_, task.movers);
        const bool is_found = k == 0 ? find_pieces(task, from) : find_from_here(task);
        take_impulses(task); // less may be left by what isn't the end of the way
        const double now = worst_residual(task.points, task.movers);
        const bool content = now <= enough(task) || (now >= 0.5 * before && now <= most_left(task));
        if (now < best_) {
            best_ = now;
            kept_.assign(task.points.begin(), task.points.end());
        } else if (content) go_back_to_best(task);
        if (content) return true;
        if (!is_found || !(now < before)) return false;
        before = now;
    }
    return false;
}

bool IslandSolver::find_pieces(const Task& task, From from)
{
    switch (from) {
    case From::here:
        return find_by_newton(pieces_, problem_, task.effort);
    case From::turns:
        go_by_turns(task, {0.0, rest_tolerance::k_more_sweeps, rest_tolerance::k_quick_rounds});
        measure_slips(problem_, task.movers);
        return find_from_here(task);
    case From::nothing:
        forget_impulses(task.points);
        restore_free(task);
        measure_slips(problem_, task.movers);
        return path_.follow(pieces_, problem_, rest_tolerance::k_few_rounds * static_cast<int>(task.points.size()));
    }
    return false;
}

void IslandSolver::go_by_turns(const Task& task, const Rounds& rounds)
{
    measure_slips(problem_, task.movers);
    turns_.solve(pieces_, problem_, rounds);
    take_impulses(task);
}

/// From impulses that are nearly right.
bool IslandSolver::find_from_here(const Task& task)
{
    return find_by_newton(pieces_, problem_) || path_.follow(pieces_, problem_, few_pieces(task.points.size()));
}

void IslandSolver::restore_free(const Task& task) const
{
    for (std::size_t k = 0; k < task.members.size(); ++k) task.movers[task.members[k]] = problem_.bodies[k];
}

/// The impulses of the points, and nothing else, act on the members.
void IslandSolver::apply(const Task& task) const
{
    restore_free(task);
    warm_start(task.points, task.movers);
}

void IslandSolver::go_back_to_best(const Task& task) const
{
    std::copy(kept_.begin(), kept_.end(), task.points.begin());
    apply(task);
}

void IslandSolver::take_impulses(const Task& task) const
{
    for (std::size_t k = 0; k < task.points.size(); ++k) {
        task.points[k].normal = problem_.impulse[2 * k];
        task.points[k].tangent = problem_.impulse[2 * k + 1];
    }
    apply(task);
}

} // namespace flying
