#pragma once

#include <span>
#include <vector>

#include "rest/piece_system.hpp"

namespace flying {

/// Follows a path of solutions from piece to piece. The speeds of all points are shifted at first, so that a solution
/// is known; the shift shrinks to nothing, and the solution goes with it. In each piece one point changes what it does;
/// where that turns the path round, which the sign of the determinant tells, the shift grows again for a while. A path
/// from nothing has nowhere else to end but at a solution (Lemke 1965; Eaves 1976), wherever no bound asks bodies to
/// part: in the plane Coulomb's cone has two edges, so that his conditions are linear in pieces, and their matrix is
/// copositive whatever the friction.
class PiecePath
{
public:
    /// Begins with the impulses that are there.
    ///
    /// most  pieces
    /// True where it has come to its end; the answer is in the problem.
    [[nodiscard]] bool follow(PieceSystem& pieces, ContactProblem& problem, int most);

private:
    using Mode = PieceSystem::Mode;

    /// A place of the path where a point changes what it does.
    struct Turn
    {
        int point = -1; ///< -1 where none does
        Mode from = Mode::apart;
        Mode to = Mode::apart;
        double way = 0.0; ///< along the path [shifts]
    };
    /// What the springs of a point push at a place of the path, and how that changes along it.
    struct Springs
    {
        double normal;
        double tangent;
        double normal_rate;
        double tangent_rate;
    };
    void shift_from_impulses(const ContactProblem& problem);
    void start_springs(PieceSystem& pieces, const ContactProblem& problem, double left);
    void push_shifts(PieceSystem& pieces, const ContactProblem& problem) const;
    void measure_rates(const PieceSystem& pieces, const ContactProblem& problem, double sign);
    [[nodiscard]] Turn next_turn(const PieceSystem& pieces, const ContactProblem& problem, const Turn& last,
                                 double within) const;
    void take_springs(const PieceSystem& pieces, ContactProblem& problem) const;

    std::vector<Springs> springs_;
    std::vector<double> shift_; // of normal and tangential speeds at the start of the path [m/s]
};

} // namespace flying
