#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "math/four.hpp"
#include "rest/contact_point.hpp"

namespace flying {

/// The points of an island that is swept, in batches of pairs that are swept side by side: two rows of four. Pairs that
/// share a moving body have different colours; all of one colour are swept before any of the next, in any order, as
/// none of them knows of another. (A long list is coloured in parts, and swept part by part.) The bits are those of the
/// plain sweep over the points in that order.
class SweepBatches
{
public:
    /// points   with impulses that the movers already have; those of one pair in a row, with one normal
    /// members  all bodies of theirs that can move
    void lay_out(std::span<const ContactPoint> points, std::span<const Mover> movers, std::span<const int> members);
    /// The points that were laid out, in the order in which a plain sweep would take them.
    [[nodiscard]] std::vector<int> order() const;

    /// How many sweeps, each from the beginning of the list, that go on in the direction of those before, as conjugate
    /// gradients do.
    struct Ahead
    {
        int least = 8;
        int most = 8;        ///< >= least
        double enough = 0.0; ///< once a sweep's changes are worth less, those beyond the least may end [J]
    };
    /// Returns how many it made. A sweep's changes are worth what they would move from rest, without its turning: the
    /// sum of their squares, over the masses of both bodies.
    int sweep_ahead(const Ahead& ahead);

    /// The members' velocities, in the order of `members` as they were laid out.
    void get_velocities(std::span<Mover> movers, std::span<const int> members) const;
    /// Impulses to the points that were laid out.
    void get_impulses(std::span<ContactPoint> points) const;

private:
    /// Four pairs. Where there are fewer, the rest are between bodies that nothing moves.
    struct Row
    {
        int a[4]; // places in bodies_
        int b[4];
        Four n_x;
        Four n_y;
        Four inv_moment_a;
        Four inv_moment_b;
        Four friction;
    };
    /// While one row waits for what it has just asked for, the processor goes on with the other.
    struct Batch
    {
        Row rows[2];
        int first; // of its points
        int count; // points of each pair: the k-th of each row are one Points, those of the rows side by side
    };
    /// One point of each of four pairs.
    struct Points
    {
        Four normal_arm_a;
        Four normal_arm_b;
        Four tangent_arm_a;
        Four tangent_arm_b;
        Four normal_mass;
        Four tangent_mass;
        Four bound;
        Four normal;
        Four tangent;
    };
    /// Velocity and spin of a body, and the inverse of its mass.
    struct Body
    {
        Four motion;
    };
    /// Of the impulses of one point of each of the four.  [N s]
    struct Change
    {
        Four normal;
        Four tangent;
    };
    struct Way
    {
        Change last;   ///< by the last sweep
        Change so_far; ///< by those before, since directions were forgotten
    };
    /// The same of a body's velocity.
    struct Drift
    {
        Four old; ///< before the last sweep
        Four way;
    };
    struct Motion;

    void set_velocities(std::span<const Mover> movers, std::span<const int> members);
    struct Run;
    [[nodiscard]] int colour_of(const Run& run);
    std::size_t lay_out_part(std::size_t from, std::span<const ContactPoint> points, std::span<const Mover> movers);
    void colour_part(std::span<const ContactPoint> points, std::size_t from);
    void add_batches(int pairs, int count);
    void set_lane(Batch& batch, int pair, std::span<const ContactPoint> points, std::span<const Mover> movers);
    void clear(Batch& batch);
    static void solve_point(const Row& row, Points& points, Motion& a, Motion& b, Change& change);
    static void go_ahead(Points& points, Way& way, const Four& share);
    void go_ahead(const Four& share);
    void fetch(const int (&places)[4], Motion& motion) const;
    void put_back(const int (&places)[4], const Motion& motion);
    template <typename Content>
    void sweep_batch(const Batch& batch, Content&& content);

    std::vector<Batch> batches_; // the first batch_count_, and what is kept of earlier ones
    std::vector<Points> points_; // point_count_
    int batch_count_ = 0;
    int point_count_ = 0;
    std::vector<int> lane_of_; // of each point laid out: 4 times its Points, and the lane
    std::vector<Body> bodies_; // the members, and at the end one that nothing moves
    std::vector<int> place_;   // of each mover; of those that can't move, of none
    /// One or two points of a pair, swept one after the other.
    struct Run
    {
        int first; // of the points
        int count;
        int a; // places in bodies_
        int b;
        int kind; // 2 for each colour before its own, and 1 where it has two points
    };
    std::vector<Run> runs_;
    std::vector<std::uint64_t> used_; // of each body: a bit for each colour of its pairs in this part
    std::vector<int> in_kind_;        // of each kind: runs
    std::vector<int> places_;         // of each kind: 8 times the batch of the next run, and the pair in that
    std::vector<Way> way_;
    std::vector<Drift> drift_;
};

} // namespace flying
