#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "rest/block_system.hpp"
#include "rest/contact_point.hpp"
#include "rest/interior_point.hpp"
#include "rest/push_lines.hpp"
#include "rest/sweep_batches.hpp"
#include "rest/sweeps.hpp"

namespace flying {

/// What a solve took.
struct SolveCounts
{
    std::int64_t accepted = 0; ///< groups whose impulses of the step before were right already
    std::int64_t solved = 0;   ///< groups that were solved to rounding
    std::int64_t unsolved = 0; ///< groups of which no solution was found
    std::int64_t swept = 0;    ///< groups that ended with what sweeps could do
    std::int64_t sweeps = 0;   ///< over all points of a group
    std::int64_t factorisations = 0;
};

/// What rounding leaves of the content of a group: in proportion to what its greatest impulse does to the lightest it
/// pushes, for each body through which the load goes.  [m/s]
[[nodiscard]] double rounding_of(std::span<const ContactPoint> points, std::size_t members);

enum class Effort
{
    full,
    brief
};

/// Finds the impulses of one group of bodies that lean on each other, so that every point is content:
///
///     normal    0 <= j,  u_n >= bound,  and j > 0 only where u_n = bound
///     tangent   |q| <= mu j,  and where the point slips, q = -mu j times the sign of the slip
///
/// exactly, to rounding, for stacks of any height and masses of any ratio: by Newton's method on these conditions,
/// which are linear in pieces (semismooth Newton), each step a sparse system with one 3 x 3 block for each body.
class GroupSolver
{
public:
    /// movers   all bodies; those of the group hold the velocities that they would have without contacts
    /// members  the group's bodies that can move, ascending
    /// points   the group's points with impulses to start from, not yet applied; on return those found, applied
    /// tolerance  velocities below this are content enough; rounding of the impulses adds its own share [m/s]
    /// effort   a brief one gives up where Newton's method finds nothing at once, or its first trial is far from it
    /// True where all points are content to rounding; else the impulses are the best that were met.
    bool solve(std::span<Mover> movers, std::span<const int> members, std::span<ContactPoint> points, double tolerance,
               Effort effort = Effort::full);

    [[nodiscard]] const SolveCounts& counts() const { return counts_; }
    /// Whether to begin with the impulses that the points have; else with none.
    void set_warm(bool warm) { warm_ = warm; }

    /// How a group too large to factorise in each step is swept.
    struct SweepPlan
    {
        int sweeps = 8;
        int most_sweeps = 0;     ///< looking ahead: as many where fewer don't bring a sweep's changes below `enough`
        double enough = 0.0;     ///< [J]
        int push_sweeps = 0;     ///< after, that push overlap apart
        double push_share = 0.0; ///< of an overlap that they take off
        double time = 0.0;       ///< that the step lasts [s]
        double tolerance = -1.0; ///< where no point asks for a greater change, impulses stay as they are [m/s]
        double far_from_closing = std::numeric_limits<double>::infinity(); ///< points that part so fast wait [m/s]
        bool looks_ahead = false;
    };
    /// pushed  filled for the members: the velocities by which places move, those that push overlap apart included
    void sweep_group(std::span<Mover> movers, std::span<const int> members, std::span<ContactPoint> points,
                     const SweepPlan& plan, std::span<Mover> pushed);

private:
    void set_start(std::span<ContactPoint> points) const;
    void sweep_far(std::span<ContactPoint> points, std::span<Mover> movers);
    void push_apart(std::span<const int> members, std::span<const ContactPoint> points, const SweepPlan& plan,
                    std::span<Mover> pushed);

    /// What a point does under the next trial.
    enum class Mode : unsigned char
    {
        apart,
        stuck,
        slips_forwards,
        slips_backwards
    };

    /// How the pieces are looked for.
    enum class Way
    {
        newton,
        swept,
        path,
        interior,
        nothing
    };
    struct Island
    {
        std::span<Mover> movers;
        std::span<const int> members;
        std::span<ContactPoint> points;
        double tolerance;
    };
    void go_back_to_best(const Island& island);
    [[nodiscard]] bool improve(const Island& island, Way way);
    [[nodiscard]] bool find_pieces(const Island& island, Way way);
    void start_from_within(const Island& island);
    void take_impulses(const Island& island);
    void prepare(std::span<const int> members, std::span<const ContactPoint> points, std::size_t movers);
    void forget_what_suits_worse(std::span<Mover> movers, std::span<const int> members, std::span<ContactPoint> points);
    void settle_for_sweeps(std::span<Mover> movers, std::span<ContactPoint> points);
    void restore_free(std::span<Mover> movers, std::span<const int> members) const;
    void guess(std::span<const ContactPoint> points);
    void measure_slips(std::span<const Mover> movers, std::span<const ContactPoint> points);
    [[nodiscard]] bool newton(std::span<const Mover> movers, std::span<const ContactPoint> points);
    /// Where a path of solutions begins: with the impulses that are there, or with none.
    enum class PathStart
    {
        impulses,
        nothing
    };
    /// A place of the path where a point changes what it does.
    struct Turn
    {
        int point = -1; ///< -1 where none does
        Mode from = Mode::apart;
        Mode to = Mode::apart;
        double way = 0.0; ///< along the path [shifts]
    };
    [[nodiscard]] bool follow_path(std::span<const Mover> movers, std::span<const ContactPoint> points, PathStart start,
                                   int most);
    [[nodiscard]] double shift_speeds(std::span<const ContactPoint> points, PathStart start);
    void start_springs(std::span<const ContactPoint> points, double left);
    void push_shifts(std::span<const ContactPoint> points);
    void measure_rates(std::span<const ContactPoint> points, double sign);
    [[nodiscard]] Turn next_turn(std::span<const ContactPoint> points, const Turn& last, double within) const;
    void take_springs(std::span<const ContactPoint> points);
    void push_members(const ContactPoint& c, double normal, double tangent, std::span<double> force) const;
    [[nodiscard]] bool assemble(std::span<const Mover> movers, std::span<const ContactPoint> points);
    void assemble_masses(std::span<const Mover> movers);
    [[nodiscard]] std::size_t try_points(std::span<const ContactPoint> points);
    void imbalance(std::span<const ContactPoint> points);

    bool warm_ = true;
    BlockSystem system_;
    SolveCounts counts_;
    std::vector<int> local_; // of each mover, its number in the group; -1 for static ones
    std::vector<int> members_;
    std::vector<BlockSystem::Edge> edges_;
    std::vector<int> edge_of_;    // of each point; -1 where one of the two is static
    std::vector<Mover> free_;     // the members, without contacts
    std::vector<double> slip_;    // normal and tangential speeds before the trial, less what is asked for [m/s]
    std::vector<double> impulse_; // trial impulses, normal and tangential [N s]
    std::vector<Mode> mode_;
    std::vector<Mode> mode_factorised_;
    bool factorised_ = false;
    /// What the springs of a point push at a place of the path, and how that changes along it.
    struct Springs
    {
        double normal;
        double tangent;
        double normal_rate;
        double tangent_rate;
    };
    std::vector<Springs> springs_;
    std::vector<double> shift_; // of normal and tangential speeds at the start of the path [m/s]
    std::vector<double> delta_; // change of the members' velocities
    std::vector<SweepPoint> sweep_points_;
    std::vector<int> swept_; // the points that are swept over
    std::vector<int> far_;   // those that wait
    SweepBatches batches_;
    InteriorPoint interior_;
    ContactProblem problem_;
    double best_ = 0.0;
    std::vector<ContactPoint> kept_; // the best that was met
};

} // namespace flying
