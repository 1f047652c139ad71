#pragma once

#include <span>
#include <vector>

#include "math/four.hpp"
#include "rest/contact_point.hpp"

namespace flying {

// [rest.batches.class]
/// The points of a large group, laid out in batches of four pairs that are swept side by side. A pair comes into the
/// first batch with room after those of all pairs before it that share a moving body with it. So every pair finds what it
/// would find in its place in the list: the bits are those of the plain sweep.
class SweepBatches
{
public:
    /// points   with impulses that the movers already have; those of one pair in a row, with one normal
    /// which    of them to sweep over, ascending
    /// members  all bodies of theirs that can move
    void lay_out(std::span<const ContactPoint> points, std::span<const int> which, std::span<const Mover> movers,
                 std::span<const int> members);

    void sweep();
    void sweep_back();
    /// Sweeps, the first to the end of the list, the next back to its beginning, and so on.
    void sweep_to_and_fro(int sweeps);
    /// How many sweeps that go on in the direction of those before, as conjugate gradients do.
    struct Ahead
    {
        int least = 8;
        int most = 8;        ///< >= least
        double enough = 0.0; ///< once a sweep's changes are worth less, those beyond the least may end [J]
    };
    /// Returns how many it made. A sweep's changes are worth the sum of their squares over the effective masses.
    int sweep_ahead(const Ahead& ahead);

    /// From here on other impulses, from none, without friction, of the points that were laid out: where one overlaps,
    /// so that it parts by `share` of that within `time` at least.
    void begin_push(std::span<const ContactPoint> points, double share, double time);
    /// The members' velocities, in the order of `members` as they were laid out.
    void get_velocities(std::span<Mover> movers, std::span<const int> members) const;
    /// Impulses to the points that were laid out.
    void get_impulses(std::span<ContactPoint> points) const;

private:
    /// Four pairs. Where there are fewer, the rest are between bodies that nothing moves.
    struct Batch
    {
        int a[4]; // places in bodies_
        int b[4];
        int first; // of its points
        int count; // points of each pair: the k-th of all four are one Points
        int pairs; // that there are
        Four n_x;
        Four n_y;
        Four inv_moment_a;
        Four inv_moment_b;
        Four friction;
    };
    /// One point of each of the four.
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
        Change so_far; ///< by all sweeps since directions were forgotten
    };
    /// The same of a body's velocity.
    struct Drift
    {
        Four old; ///< before the last sweep
        Four way;
    };
    struct Motion;

    void set_velocities(std::span<const Mover> movers, std::span<const int> members);
    [[nodiscard]] static int first_open(std::vector<int>& open, int turn);
    void add_batch(int count);
    [[nodiscard]] int batch_from(int turn, int count);
    void set_lane(Batch& batch, int lane, std::span<const ContactPoint> points, std::span<const int> which,
                  std::span<const Mover> movers);
    static void content(const Batch& batch, Points& points, Motion& a, Motion& b, Change& change);
    void fetch(const int (&who)[4], Motion& motion) const;
    void put_back(const int (&who)[4], const Motion& motion);
    template <typename Note>
    void sweep_batch(const Batch& batch, bool backwards, Note&& note);
    void go_ahead(double share);

    std::vector<Batch> batches_;
    std::vector<Points> points_;
    std::vector<int> lane_of_; // of each point laid out: 4 times its Points, and the lane
    std::vector<int> which_;
    std::vector<Body> bodies_; // the members, and at the end one that nothing moves
    std::vector<int> place_;   // of each mover; of those that can't move, nobody's
    std::vector<int> turns_;   // of each body: the batch after the last that it is in
    std::vector<int> open_[2]; // for pairs of one point, and of two: of each batch, one from it on that may have room
    std::vector<Way> way_;
    std::vector<Drift> drift_;
};
// [rest.batches.class]

} // namespace flying
