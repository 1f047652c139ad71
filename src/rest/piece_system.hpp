#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "math/block_system.hpp"
#include "rest/contact_problem.hpp"
#include "rest/rest_tolerance.hpp"

namespace flying {

/// Coulomb's conditions are linear once it is known what each point does. This is the linear system of one such piece:
/// a point that bears is a stiff spring along its normal; one that sticks, along its tangent too; one that slips pushes
/// along its tangent what the spring of the normal says. One 3 x 3 block for each body, one beside the diagonal for two
/// that touch.
class PieceSystem
{
public:
    /// What a point does.
    enum class Mode : unsigned char
    {
        apart,
        stuck,
        slips_forwards,
        slips_backwards
    };

    /// Seats the points, and makes room for slips and impulses.
    ///
    /// problem  with its points and bodies
    /// members  the island's bodies that can move, ascending, as in `problem.bodies`
    /// movers   number of all bodies
    void begin(ContactProblem& problem, std::span<const int> members, std::size_t movers);
    /// Springs as stiff as the inertia that each moves asks for, times `k_stiffness`; so they begin. Between bodies so
    /// light that a heavy one of the island would make them yield they are stiffer: by the geometric mean of that
    /// inertia and of what counts as light beside the heaviest.
    void set_hard(const ContactProblem& problem);
    /// Springs `k_soft_stiffness` times the geometric mean of that inertia and of all points' mean. Springs that suit
    /// each point are too soft between light bodies that bear heavy ones; of equal ones, friction of light bodies
    /// doesn't follow.
    void set_soft(const ContactProblem& problem);
    /// Stiffness of a point.  [kg]
    struct Spring
    {
        double normal;
        double tangent;
    };
    [[nodiscard]] const Spring& spring(std::size_t point) const { return springs_[point]; }

    [[nodiscard]] const std::vector<Mode>& modes() const { return modes_; }
    [[nodiscard]] Mode mode(std::size_t point) const { return modes_[point]; }
    void set_mode(std::size_t point, Mode mode) { modes_[point] = mode; }

    /// False where a block on the diagonal is singular. A piece that is factorised already is not factorised again.
    [[nodiscard]] bool factorise(const ContactProblem& problem);
    /// Sign of the determinant of what was factorised: 1 or -1.
    [[nodiscard]] double orientation() const { return blocks_.orientation(); }
    [[nodiscard]] std::int64_t factorisations() const { return factorisations_; }

    /// Right-hand sides: pushes on the bodies of a point.  [N s]
    void clear_pushes();
    void push(const ContactProblem& problem, std::size_t point, double normal, double tangent);
    /// From pushes to changes of the members' velocities.
    void solve();
    /// The same where no point of any friction slips.
    void solve_stuck();

    /// What the last solve changes of a point's speeds.
    struct Change
    {
        double normal;  ///< [m/s]
        double tangent; ///< [m/s]
    };
    [[nodiscard]] Change change(const ContactProblem& problem, std::size_t point) const;

private:
    void assemble(const ContactProblem& problem);

    BlockSystem blocks_;
    std::vector<Spring> springs_; // of each point
    std::vector<Mode> modes_;
    std::vector<Mode> modes_factorised_;
    bool is_factorised_ = false;
    std::int64_t factorisations_ = 0;
    std::vector<double> delta_; // pushes, then changes of the members' velocities, and of what is static
    std::vector<int> number_;   // of the movers among the members, while points are seated
    std::vector<BlockSystem::Edge> edges_;
};

/// Normal speed less the bound, and tangential speed, of each point, filled into the problem: all that follows is in
/// changes from here, so that rounding takes its share of the changes only. The answer begins with the impulses that
/// are there.
void measure_slips(ContactProblem& problem, std::span<const Mover> movers);

/// What is tried before a search for impulses gives up.
enum class Effort
{
    full,  ///< all that is known
    brief, ///< Newton's method, from what is there, as long as it closes in
};

/// Newton's method on conditions that are linear in pieces (semismooth Newton): guesses what each point does, solves,
/// and where the answer disagrees takes its word for the next guess. True where some guess agrees; the answer is in the
/// problem.
[[nodiscard]] bool find_by_newton(PieceSystem& pieces, ContactProblem& problem, Effort effort = Effort::full);

} // namespace flying
