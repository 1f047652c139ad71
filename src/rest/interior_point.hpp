#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "rest/block_system.hpp"
#include "rest/contact_problem.hpp"

namespace flying {

/// Coulomb's conditions at all points of an island, approached from within. Four pairs of numbers at each point must
/// each hold a zero when all is solved:
///
///     j  and  w = u_n - bound          either it bears, or it parts
///     p  and  a = l + u_t              friction forwards, or no slip backwards as fast as the fastest
///     q  and  b = l - u_t              the same the other way
///     l  and  c = mu j - p - q         the point slips, at the speed l, or its friction is below the limit
///
/// with the tangential impulse p - q. All eight stay positive, and each product is led down to zero along the way on
/// which all are of one size: so no combination of pieces is ever guessed, and a few tens of steps suffice for any
/// number of points and any ratio of masses. Each step solves one sparse system, with one 3 x 3 block for each body.
class InteriorPoint
{
public:
    /// system   with the pattern of the island
    /// impulse  filled: normal and tangential, of each point [N s]
    /// limits   of friction at each point, whatever its normal impulse comes to; where none are given, the limit is mu
    /// j.
    ///          With limits that are given the conditions are those of a least energy, and the way is never blocked [N
    ///          s]
    /// True where all products have become as small as asked for.
    bool solve(const ContactProblem& problem, BlockSystem& system, std::span<double> impulse,
               std::int64_t& factorisations, std::span<const double> limits = {});

private:
    /// The four pairs of a point, in units in which its effective mass is 1 and the fastest approach of the island
    /// is 1.
    struct Pairs
    {
        double j, w;
        double p, a;
        double q, b;
        double l, c;
    };
    /// What one step would change, and what it depends on.
    struct Row
    {
        double stiff_nn; ///< normal impulse for each m/s by which the normal speed falls
        double stiff_tt;
        double stiff_tn; ///< tangential impulse for each m/s by which the normal speed falls
        double normal;   ///< impulses at unchanged speeds
        double tangent;
        double lift;
        double mix;        ///< share of changes of the limit and of slip in that of l
        double left;       ///< of u_n - bound - w
        double coupling;   ///< by which the limit of friction grows with j
        bool has_friction; ///< and with it the pairs beyond the first
    };

    void start(const ContactProblem& problem, std::span<const double> limits);
    [[nodiscard]] bool assemble(const ContactProblem& problem, BlockSystem& system);
    /// Where a step leads.
    struct Aim
    {
        double product;    ///< of each pair, in their units
        double closed;     ///< share of `left` that it takes off
        bool is_corrected; ///< for what the last aim's changes multiply to
    };
    void step_towards(const ContactProblem& problem, BlockSystem& system, const Aim& aim);
    [[nodiscard]] double longest_step() const;
    [[nodiscard]] double mean_product(double step) const;
    void take(double step, double closed);

    std::vector<Pairs> now_;
    std::vector<Pairs> change_;
    std::vector<Row> rows_;
    std::vector<double> delta_; // of the members' velocities
    double unit_ = 1.0;         // speed [m/s]
};

} // namespace flying
