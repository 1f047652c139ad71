#include "rest/alternating_directions.hpp"

#include <algorithm>
#include <cmath>

#include "rest/rest_tolerance.hpp"

namespace flying {

using rest_tolerance::k_over_relaxation;

namespace {

/// What a point does that takes an impulse of what it is asked for.
[[nodiscard]] PieceSystem::Mode mode_of(const double* impulse, const double* asked)
{
    if (!(impulse[0] > 0.0)) return PieceSystem::Mode::apart;
    if (impulse[1] == asked[1]) return PieceSystem::Mode::stuck;
    return asked[1] > 0.0 ? PieceSystem::Mode::slips_backwards : PieceSystem::Mode::slips_forwards;
}

} // namespace

void AlternatingDirections::solve(PieceSystem& pieces, ContactProblem& problem, const Rounds& rounds)
{
    pieces.set_soft(problem);
    start(pieces, problem);
    if (pieces.factorise(problem)) go_round(pieces, problem, rounds);
    pieces.set_hard(problem);
}

/// A point that parts, or slips, was denied what would have held it.
void AlternatingDirections::start(PieceSystem& pieces, ContactProblem& problem)
{
    asked_.resize(problem.impulse.size());
    spring_.resize(problem.impulse.size());
    does_.assign(problem.points.size(), PieceSystem::Mode::apart);
    for (std::size_t k = 0; k < problem.points.size(); ++k) {
        const ContactPoint& c = problem.points[k];
        if (std::isinf(c.bound)) { // without a spring
            for (double* of : {&problem.slip[2 * k], &problem.impulse[2 * k], &asked_[2 * k]}) of[0] = of[1] = 0.0;
            pieces.set_mode(k, PieceSystem::Mode::apart);
            continue;
        }
        spring_[2 * k] = pieces.spring(k).normal;
        spring_[2 * k + 1] = c.friction > 0.0 ? pieces.spring(k).tangent : 0.0;
        const double u_n = problem.slip[2 * k];
        const double u_t = problem.slip[2 * k + 1];
        const bool slips = std::abs(c.tangent) >= c.friction * c.normal && c.tangent * u_t <= 0.0;
        asked_[2 * k] = c.normal > 0.0 ? c.normal : -spring_[2 * k] * std::max(u_n, 0.0);
        asked_[2 * k + 1] = c.tangent - (slips ? spring_[2 * k + 1] * u_t : 0.0);
        pieces.set_mode(k, c.friction > 0.0 ? PieceSystem::Mode::stuck : PieceSystem::Mode::slips_forwards);
    }
}

void AlternatingDirections::go_round(PieceSystem& pieces, ContactProblem& problem, const Rounds& rounds)
{
    double moved = 2.0 * rounds.tolerance; // [m/s]
    int last_change = 0;
    for (int round = 0; round < rounds.most && moved >= rounds.tolerance; ++round) {
        if (round - last_change > rounds.lasting) break;
        // [rest.alternate.together]
        // All points are springs, and all bodies follow
        pieces.clear_pushes();
        for (std::size_t k = 0; k < problem.points.size(); ++k) {
            const ContactPoint& c = problem.points[k];
            const double* j = &problem.impulse[2 * k];
            const double* u = &problem.slip[2 * k];
            pieces.push(problem, k, (2.0 * j[0] - asked_[2 * k]) - (c.normal + spring_[2 * k] * u[0]),
                        (2.0 * j[1] - asked_[2 * k + 1]) - (c.tangent + spring_[2 * k + 1] * u[1]));
        }
        pieces.solve_stuck();
        // [rest.alternate.together]

        // [rest.alternate.alone]
        // Each point takes what it may of what its spring asks for
        moved = 0.0;
        for (std::size_t k = 0; k < problem.points.size(); ++k) {
            if (pieces.mode(k) == PieceSystem::Mode::apart) continue;
            const ContactPoint& c = problem.points[k];
            const PieceSystem::Change change = pieces.change(problem, k);
            double* j = &problem.impulse[2 * k];
            double* asked = &asked_[2 * k];
            const double normal = (j[0] - asked[0]) - spring_[2 * k] * (problem.slip[2 * k] + change.normal);
            const double tangent = (j[1] - asked[1]) - spring_[2 * k + 1] * (problem.slip[2 * k + 1] + change.tangent);
            asked[0] += k_over_relaxation * normal;
            asked[1] += k_over_relaxation * tangent;
            j[0] = std::max(asked[0], 0.0);
            j[1] = std::clamp(asked[1], -c.friction * j[0], c.friction * j[0]);
            const PieceSystem::Mode does = mode_of(j, asked);
            if (does != does_[k]) last_change = round;
            does_[k] = does;
            moved = std::max({moved, std::abs(normal) / c.normal_mass, std::abs(tangent) / c.tangent_mass});
        }
        // [rest.alternate.alone]
    }
}

} // namespace flying
