#pragma once

#include <vector>

#include "rest/contact_problem.hpp"
#include "rest/piece_system.hpp"

namespace flying {

/// When rounds end.
struct Rounds
{
    double tolerance = 0.0; ///< where no point is moved by more in a round [m/s]
    int most = 1;           ///< after so many
    int lasting = 1;        ///< after so many in which all points do what they did: bear or part, hold or slip
};

/// Coulomb's conditions at all points of an island, met by turns (alternating direction method of multipliers, Boyd et
/// al. 2011; here the limits of friction follow the normal impulses). In one turn each point is a spring, which all
/// bodies follow at once: one system of equations, factorised once for all rounds. In the other each point by itself
/// takes the impulse that its conditions allow nearest to what its spring asks for, and remembers what it was denied.
/// So a load goes through the whole island in each round, where a sweep leads it one body on.
class AlternatingDirections
{
public:
    /// Better impulses for an island of any size, of masses of any ratio: allowed ones, whatever they leave. Points
    /// whose bound is -infinity, since they won't close, bear nothing.
    ///
    /// pieces   of the problem; they are soft meanwhile
    /// problem  with the impulses to start from, and what they leave of slips; on return with those found
    void solve(PieceSystem& pieces, ContactProblem& problem, const Rounds& rounds);

private:
    void start(PieceSystem& pieces, ContactProblem& problem);
    void go_round(PieceSystem& pieces, ContactProblem& problem, const Rounds& rounds);

    /// Stiffness of a point's springs, normal and tangential.  [kg]
    std::vector<double> spring_;
    /// What a point is asked for, normal and tangential: its impulse, less what it was denied.  [N s]
    std::vector<double> asked_;
    /// What each point does.
    std::vector<PieceSystem::Mode> does_;
};

} // namespace flying
