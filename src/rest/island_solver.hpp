#pragma once

#include <span>
#include <vector>

#include "rest/alternating_directions.hpp"
#include "rest/contact_point.hpp"
#include "rest/contact_problem.hpp"
#include "rest/piece_path.hpp"
#include "rest/piece_system.hpp"
#include "rest/solve_counts.hpp"
#include "rest/sweeps.hpp"

namespace flying {

/// What rounding leaves of the residual of an island: in proportion to what its greatest impulse does to the lightest
/// it pushes, for each body through which the load goes.  [m/s]
[[nodiscard]] double rounding_of(std::span<const ContactPoint> points, std::size_t members);

/// Along a path each point takes a system of its own, and more: of so many points that is too long for a step.
[[nodiscard]] bool are_many(std::span<const ContactPoint> points);

/// Finds the impulses of one island of bodies that lean on each other, so that every point is content:
///
///     normal    0 <= j,  u_n >= bound,  and j > 0 only where u_n = bound
///     tangent   |q| <= mu j,  and where the point slips, q = -mu j times the sign of the slip
///
/// exactly, to rounding, for stacks of any height and masses of any ratio. These conditions are linear once it is known
/// what each point does; that is guessed from the impulses of the step before, and where no guess agrees, looked for
/// from better ones, each from farther away.
class IslandSolver
{
public:
    /// movers   all bodies; those of the island hold the velocities that they would have without contacts
    /// members  the island's bodies that can move, ascending
    /// points   the island's points with impulses to start from, not yet applied; on return those found, applied
    /// tolerance  velocities below this are content enough; rounding of the impulses adds its own share [m/s]
    /// True where all points are content to rounding; else the impulses are the best that were met.
    bool solve(std::span<Mover> movers, std::span<const int> members, std::span<ContactPoint> points, double tolerance,
               Effort effort = Effort::full);

    /// Better impulses for an island of any size, by rounds of alternating directions: allowed ones, whatever they
    /// leave.
    ///
    /// movers, members, points  as above
    /// tolerance  it ends where no point is moved by more in a round [m/s]
    /// rounds     at most
    void solve_by_turns(std::span<Mover> movers, std::span<const int> members, std::span<ContactPoint> points,
                        double tolerance, int rounds);

    [[nodiscard]] const SolveCounts& counts() const { return counts_; }
    [[nodiscard]] SolveCounts& counts() { return counts_; }
    /// Whether to begin with the impulses that the points have; else with none.
    void set_warm(bool warm) { is_warm_ = warm; }

private:
    /// Where the pieces are looked for from.
    enum class From
    {
        here,    ///< from the impulses that are there
        turns,   ///< from what rounds by turns make of them, as soon as all points do what they did
        nothing, ///< along the path that begins with no impulses
    };
    /// An island as it was handed over.
    struct Task
    {
        std::span<Mover> movers;
        std::span<const int> members;
        std::span<ContactPoint> points;
        double tolerance;
        Effort effort = Effort::full;
    };
    void take_problem(const Task& task);
    void go_by_turns(const Task& task, const Rounds& rounds);
    [[nodiscard]] bool improve(const Task& task, From from);
    [[nodiscard]] bool find_pieces(const Task& task, From from);
    [[nodiscard]] bool find_from_here(const Task& task);
    [[nodiscard]] static double enough(const Task& task);
    [[nodiscard]] static double most_left(const Task& task);
    void restore_free(const Task& task) const;
    void apply(const Task& task) const;
    void go_back_to_best(const Task& task) const;
    void take_impulses(const Task& task) const;

    bool is_warm_ = true;
    SolveCounts counts_;
    ContactProblem problem_;
    PieceSystem pieces_;
    PiecePath path_;
    AlternatingDirections turns_;
    double best_ = 0.0;
    std::vector<ContactPoint> kept_; // the best that was met
};

} // namespace flying
