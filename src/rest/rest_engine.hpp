#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "collide/manifold.hpp"
#include "collide/seams.hpp"
#include "motion/field.hpp"
#include "rest/group_solver.hpp"
#include "rest/pair_list.hpp"
#include "rest/rest_body.hpp"
#include "rest/rest_way.hpp"

namespace flying {


struct RestOptions
{
    double step = 1.0 / 60.0; ///< > 0 [s]
    bool warm_starts = true;  ///< impulses are sought from those of the step before
    bool sleeps = true;       ///< groups that a step leaves as they are, to the bit, are left out of the next
    int most_solved = 400;    ///< bodies in the largest group that is solved to rounding; more are swept
    int sweeps = 8;           ///< over larger groups
    int most_sweeps = 64;     ///< over those that have more to change, as where a pile lands
    int push_sweeps = 4;      ///< over larger groups, that push overlap apart
    std::optional<CentralField> centre = {}; ///< round which all are pulled that move, in place of their accelerations
    double (*seconds)() = nullptr; ///< a clock, lent to measure the stages; null to measure nothing [s]
};



/// Work done so far.
struct RestCounts
{
    std::int64_t steps = 0;
    std::int64_t looks = 0;     ///< searches for pairs
    std::int64_t manifolds = 0; ///< pairs whose points were sought
    std::int64_t points = 0;    ///< points solved for
    std::int64_t groups = 0;    ///< groups solved for
    std::int64_t impacts = 0;   ///< points at which an approach was ended
    std::int64_t asleep = 0;    ///< bodies left out, over all steps
    std::int64_t parts = 0;     ///< steps, or parts of steps, of islands that ended early
    std::int64_t projected = 0; ///< islands whose overlap was taken off
    std::int64_t limited = 0;   ///< islands slowed down, so that they have no more energy than before
};



/// Seconds spent, where a clock was lent.
struct RestSeconds
{
    double pairs = 0.0;
    double collide = 0.0;
    double solve = 0.0;
    double move = 0.0;
};



/// One point of contact as the last step left it.
struct RestContact
{
    int a = 0;
    int b = 0;
    Vec2 normal = Vec2::Zero(); ///< from A to B
    double gap = 0.0;           ///< at the start of the step [m]
    double normal_force = 0.0;  ///< mean over the step [N]
    double tangent_force = 0.0; ///< mean over the step, along the normal turned a quarter counter-clockwise [N]
};



/// Moves bodies that lean on each other, by steps of one length. What happens depends on the bodies and the step alone:
/// not on who looks, when, or where the bodies lie in memory.
///
/// Between changes of contact, motion under constant forces is exact whatever the step: places move by the mean of
/// the velocities before and after. An impact acts at its own moment within the step. Pushes end an approach or hold a
/// load and never do work, so that energy doesn't rise; overlap that the turning of bodies brings is taken off by
/// moving them apart, which adds no velocity.
class RestEngine
{
public:
    /// bodies  not overlapping, beyond touching
    /// time    of their states [s]

    explicit RestEngine(std::vector<RestBody> bodies, const RestOptions& options = {}, double time = 0.0);

    /// Step as long as whole steps fit before `time`.  [s]
    void advance(double time);
    void step();


    /// One step of another length, which ends at a moment that is known better than as a sum.  [s]
    void step_by(double length, double end);
    /// The ways on which such a step would lead, of each body that is awake. Nothing is changed by it.
    [[nodiscard]] std::vector<std::vector<Leg>> foresee(double length, double end);
    /// The moment at which the next step begins, where all bodies that are here sleep.  [s]
    void set_time(double time);

    /// Moment that the steps have reached.  [s]
    [[nodiscard]] double time() const { return start_ + static_cast<double>(steps_) * options_.step; }

    [[nodiscard]] int body_count() const { return static_cast<int>(bodies_.size()); }
    [[nodiscard]] const RestBody& body(int body) const { return bodies_[place_[body]]; }
    [[nodiscard]] BodyState state(int body) const
    {
        BodyState state = bodies_[place_[body]].state;
        state.time = time();
        return state;
    }

    /// Put a body elsewhere, or give it another motion; it wakes, and whatever touches it.
    void set_state(int body, const BodyState& state);
    /// Take a body out, or put it back where its state says.
    void set_active(int body, bool active);

    /// Marks each awake body that bears no load, and that nothing will touch for so long if all goes on as it does. [s]
    void find_clear(double within, std::vector<char>& clear) const;

    /// What the engine knows beside shapes and inertia: all that the next step depends on.
    struct Memory
    {
        struct Body
        {
            BodyState state;
            Vec2 pull = Vec2::Zero();
            double turn_pull = 0.0;
            double reach = 0.0;
            int sleep_group = -1; ///< -1 where awake
            bool is_active = true;
            bool in_crowd = false;
        };
        double time = 0.0;
        std::vector<int> order; ///< which body each of `bodies` is; all numbers in here are places in that list
        std::vector<Body> bodies;
        std::vector<RestPair> pairs;
        double max_overlap = 0.0;
    };
    [[nodiscard]] Memory memory() const;
    void go_on_from(const Memory& memory);

    /// Contacts of the last step, in the order of (a, b); those of sleeping groups included.
    [[nodiscard]] std::vector<RestContact> contacts() const;
    /// For each body, the number of its group: bodies that touch, by whatever chain of moving bodies, share one, which
    /// is its lowest body. -1 for static bodies and those not active.
    [[nodiscard]] std::vector<int> groups() const;
    [[nodiscard]] bool is_asleep(int body) const { return asleep_[place_[body]] != 0; }
    /// The last step changed nothing of the body.
    [[nodiscard]] bool is_still(int body) const { return still_[place_[body]] != 0; }

    [[nodiscard]] const RestCounts& counts() const { return counts_; }
    [[nodiscard]] const SolveCounts& solve_counts() const { return solver_.counts(); }
    [[nodiscard]] const RestSeconds& seconds() const { return seconds_; }
    void set_clock(double (*clock)()) { options_.seconds = clock; }
    /// Deepest overlap that any step has begun with.  [m]
    [[nodiscard]] double max_overlap() const { return max_overlap_; }
    /// Fingerprint of all states.
    [[nodiscard]] std::uint64_t hash() const;

private:
    RestEngine(std::vector<RestBody> bodies, const RestOptions& options, double time, std::vector<int> order);

    struct Group
    {
        int first_member = 0;
        int member_count = 0;
        int first_point = 0;
        int point_count = 0;
        bool is_exact = true;   ///< solved to rounding, all at once; else swept
        bool has_ways = false;  ///< places are found already, along curves
        bool is_content = true; ///< the impulses that were found are right to rounding
        bool in_turn = false;   ///< its impacts have moments of their own
        double cut_at = 0.0;    ///< where its step is to end early, and to go on from; 0 if nowhere [s]
    };
    /// Groups whose step ends early.
    struct Again
    {
        struct Part
        {
            int first_member = 0;
            int member_count = 0;
            int first_pair = 0;
            int pair_count = 0;
            double cut_at = 0.0; ///< after the step's beginning [s]
        };
        std::vector<Part> parts;
        std::vector<int> members;
        std::vector<int> pairs;
    };
    struct Saved
    {
        BodyState state;
        Vec2 pull = Vec2::Zero();
        double turn_pull = 0.0;
        char in_crowd = 0;
    };

    void list_awake();
    void measure_reach(std::span<const int> who);
    void finish_groups(int depth, std::span<const int> pairs);
    [[nodiscard]] bool may_be_cut(const Group& group, int depth) const;
    void note_again(const Group& group, Again& again);
    void find_pairs_of(Again& again, std::span<const int> pairs);
    void make_parts(int depth);
    void scale_loads(std::span<const int> pairs, double factor);
    [[nodiscard]] bool is_solved_whole(const Group& group) const;
    void expect_flight(int body, const Vec2& place);
    [[nodiscard]] Vec2 mean_field(int body, const Vec2& from, const Vec2& to) const;
    [[nodiscard]] Vec2 field_at(int body, const Vec2& place) const;
    [[nodiscard]] double work_of_field(int body) const;
    void aim_field(int body);
    [[nodiscard]] double greatest_field(int body, double within) const;
    void fly(Group& group);
    void expect_same(int body);
    void expect(const Group& group);
    void collide();
    bool collide_pair(int pair);
    /// The points of a pair that were open when the step began, and below which gap they count as closed.
    struct Closing
    {
        std::uint32_t open[2];
        int count;
        double closed; // [m]
        double speed;  ///< with which the first one closes [m/s]
    };
    [[nodiscard]] double next_closing(const RestPair& pair, const Manifold& manifold, double moment,
                                      Closing& closing) const;
    [[nodiscard]] bool stays_open(const RestPair& pair, double touch) const;
    [[nodiscard]] double fall_at(const RestPair& pair, const Contact& contact, double moment) const;
    [[nodiscard]] double fall_of(const ContactPoint& c) const;
    [[nodiscard]] double weight_of(const ContactPoint& c) const;
    [[nodiscard]] Vec2 place_at(int body, double moment) const;
    [[nodiscard]] Pose pose_at(int body, double moment) const;
    void add_points(int pair, const Manifold& manifold, double closes_at, double closing_speed);
    void set_pose(int body, const Pose& pose);
    [[nodiscard]] Manifold look_again(RestPair& pair, double margin);
    [[nodiscard]] Manifold look(const RestPair& pair, const Pose& pose_a, const Pose& pose_b, double margin) const;
    void find_fixed_seams();
    void find_seams_with(int body, int part, int neighbour, int neighbours_part, std::vector<Seam>& seams) const;
    void find_moving_seams(const RestPair& pair, Owner owner, const Pose& pose, const Manifold& manifold,
                           std::vector<Seam>& seams) const;
    [[nodiscard]] Vec2 velocity_of(int body, const Vec2& point) const;
    void mend(const RestPair& pair, const Pose& pose_a, const Pose& pose_b, double margin, Manifold& manifold) const;
    [[nodiscard]] bool wake_touched();
    void wake_all_with(int group);
    [[nodiscard]] int root_of(int body);
    bool join(const ContactPoint& point);
    void gather_groups(std::span<const int> who);
    void part_slow(std::span<const int> who);
    void lay_out_points();
    void solve_group(Group& group, int depth);
    [[nodiscard]] static bool strikes_at_start(const Group& group);
    [[nodiscard]] static bool is_heap(const Group& group);
    [[nodiscard]] double slowest_blow(const Group& group) const;
    [[nodiscard]] double slowest_rebound(const ContactPoint& c) const;
    [[nodiscard]] bool strike(const Group& group);
    [[nodiscard]] double hardly_open(const ContactPoint& c) const;
    [[nodiscard]] double missed_impact(const Group& group) const;
    void end_approaches(const Group& group);
    void recall_load(ContactPoint& point) const;
    void sweep_heap(const Group& group, std::span<Mover> movers, std::span<ContactPoint> points, double tolerance = -1.0);
    void find_pushes(const Group& group, double tolerance);
    void set_bounds(const Group& group);
    void sweep_large(Group& group);
    void bound_swept(const Group& group, bool is_calm);
    void move_as_swept(const Group& group);
    [[nodiscard]] double approaches_left(std::span<const ContactPoint> points) const;
    void end_approaches_whole(const Group& group, GroupSolver::SweepPlan plan, double most);
    void bear_less(const Group& group);
    [[nodiscard]] Vec2 push_of(int member) const;
    [[nodiscard]] double energy_of_fall(const Group& group) const;
    [[nodiscard]] static double greatest_speed(std::span<const Mover> movers, std::span<const double> radius, std::span<const int> members);
    void set_free(const Group& group, double time);
    void find_impulses(Group& group, double time);
    [[nodiscard]] bool stood(const Group& group) const;
    void keep_loads(Group& group, double time);
    void part_where_slip_ends(Group& group);
    [[nodiscard]] bool follow_curves(Group& group);
    [[nodiscard]] bool may_bend(const Group& group) const;
    [[nodiscard]] double top_motion(const Group& group) const;
    void first_ways(const Group& group);
    void forget_ways(const Group& group);
    [[nodiscard]] const Contact* same_contact(const ContactPoint& c, const Manifold& manifold) const;
    void look_along(const Group& group, double part, std::vector<ContactPoint>& there);
    /// Of the lines of those that bear, while bodies go their ways.
    enum class Bend : char { none, some, lost };
    [[nodiscard]] Bend bend_lines(const Group& group, bool is_corrected);
    [[nodiscard]] bool find_mean_velocities(const Group& group);
    [[nodiscard]] bool see_ends(const Group& group);
    [[nodiscard]] bool all_close() const;
    [[nodiscard]] bool end_velocities(const Group& group);
    [[nodiscard]] bool any_slip_ended(const Group& group, double still) const;
    [[nodiscard]] const Mover& start_of_part(int member) const;
    void scale_impulses(const Group& group, double factor);
    void add_part(const Group& group, double time);
    [[nodiscard]] double solve_rounding(const Group& group) const;
    [[nodiscard]] double still_speed(const Group& group) const;
    void calm(const Group& group);
    void find_places(const Group& group);
    /// The energy that a group has before and after, and what it has gained beyond the field's work.
    struct Gain
    {
        double gained = 0.0; // [J]
        double scale = 0.0;  // sum of the sizes of all that `gained` is made of [J]
    };
    [[nodiscard]] Gain gain_of(const Group& group) const;
    [[nodiscard]] double overlap_at_start(const Group& group) const;
    [[nodiscard]] double first_impact(const Group& group) const;
    [[nodiscard]] double end_of_load(const Group& group) const;
    [[nodiscard]] bool is_fair(const Group& group, double overlap) const;
    [[nodiscard]] bool may_overlap(const ContactPoint& c) const;
    [[nodiscard]] double look_at_end(const Group& group);
    [[nodiscard]] double look_at_pair(int pair);
    [[nodiscard]] bool comes_nearer(int a, int b) const;
    void list_pairs_of(std::span<const ContactPoint> points);
    [[nodiscard]] Contact overlap_at_end(const RestPair& pair) const;
    void put_apart(const Group& group, double overlap);
    /// A motion of an island as one rigid body.
    struct RigidMotion
    {
        Vec2 centre = Vec2::Zero();   ///< [m]
        Vec2 velocity = Vec2::Zero(); ///< of the centre [m/s]
        double spin = 0.0;            ///< [rad/s]
    };
    [[nodiscard]] RigidMotion free_motion(const Group& group) const;
    [[nodiscard]] double slow_down(const Group& group, const RigidMotion& rigid, double by);
    void limit_energy(const Group& group);
    [[nodiscard]] bool stood_alike(int member) const;
    void move_group(const Group& group);
    void note_legs(const Group& group);
    void set_arms(ContactPoint& point, const Vec2& normal, const Vec2& r_a, const Vec2& r_b) const;
    [[nodiscard]] double field_speed(const Group& group) const;
    [[nodiscard]] double top_speed(const Group& group) const;
    [[nodiscard]] double touch_gap(int a, int b) const;
    [[nodiscard]] double touch_gap(int a, const Vec2& place_a, int b, const Vec2& place_b) const;
    /// Whether anything moves a body: what the solver knows says it, and lies nearer than the body.
    [[nodiscard]] bool is_moved(int body) const
    {
        return movers_[body].inv_mass > 0.0 || movers_[body].inv_moment > 0.0;
    }
    [[nodiscard]] bool stays_apart(const RestPair& pair, double within) const;
    void scale_loads_awake(double factor);


    std::vector<RestBody> bodies_; // as they lie in memory (rest/body_order.hpp), as all that follows
    std::vector<int> order_;       // of each of them, the number by which it is known outside
    std::vector<int> place_;       // of each such number, its place
    RestOptions options_;
    double start_ = 0.0;
    std::int64_t steps_ = 0;
    double span_ = 0.0; // length of the step, or part of one, that is being made [s]
    double after_ = 0.0; // from its end to that of the whole step [s]
    std::vector<CollisionShape> shapes_;
    std::vector<std::vector<std::vector<char>>> real_edges_; // of each body and part, as NearSide has it
    std::vector<std::vector<std::vector<Seam>>> seams_; // of each body and part, with what never moves against it
    std::vector<double> radius_; // bounding radii [m]
    std::vector<Vec2> field_;       // accelerations that the field gives, within the present step [m/s^2]
    std::vector<double> field_size_; // their sizes
    std::vector<double> turning_; // how far a turn may bring any point of each: the same, 0 for discs [m]
    std::vector<double> reach_;  // how far each may get in a step [m]
    std::vector<Saved> saved_; // of those awake, as the step has found them
    std::vector<int> awake_;     // ascending
    std::vector<Pose> poses_;
    struct Travel
    {
        double shift = 0.0; // [m]
        double turn = 0.0;
    };
    std::vector<Travel> travel_; // of each body, in all
    std::vector<Mover> movers_;
    std::vector<Mover> before_;
    std::vector<Vec2> shift_; // ways that the step leads [m], and turns
    std::vector<double> turn_;
    std::vector<Pose> next_poses_; // where the step ends
    std::vector<Vec2> pull_;        // accelerations that are expected: of the last step, or the field's
    std::vector<double> turn_pull_; // the same of spins [1/s^2]
    PairList pairs_;
    std::vector<char> is_near_; // of each pair: its parts may touch within the step
    std::vector<ContactPoint> found_;  // in the order of the pairs
    std::vector<ContactPoint> points_; // by groups
    std::vector<ContactPoint> struck_; // of a group, while its impacts are found
    std::vector<double> slowest_;      // of each of them: the slowest approach that brings a rebound [m/s]
    std::vector<Group> groups_;
    std::vector<int> members_;
    std::vector<Again> again_; // at each depth of halving
    int parts_made_ = 0;       // of the step of a group
    std::vector<int> part_of_; // of each body, while pairs are sorted out; -1 for none
    std::vector<int> looked_at_;     // pairs
    std::vector<char> is_inside_; // a group that is looked at
    std::vector<Vec2> shift_before_; // before overlap was taken off
    std::vector<double> turn_before_;
    std::vector<int> parent_; // of each body, towards the lowest of its group
    std::vector<int> slot_;
    std::vector<int> parts_; // bodies of groups that may part
    std::vector<int> slots_; // of each point that was found
    std::vector<char> asleep_;
    bool none_sleeps_ = false;
    std::vector<char> wakes_; // of each body: awake, and can move
    std::int64_t sleepers_ = -1; // where nobody is awake: how many sleep
    std::vector<char> still_;
    std::vector<char> in_crowd_; // the body's group was one in the last step
    std::vector<int> sleep_group_;   // of each sleeping body
    std::vector<Mover> part_movers_; // at the start of a part of the step
    bool parted_ = false;
    std::vector<ContactPoint> load_points_; // of a group, as the step ends
    /// Of a group that follows curves.
    struct Curves
    {
        std::vector<ContactPoint> bent;   // points with the mean of their lines over the step,
        std::vector<ContactPoint> half;   // those halfway,
        std::vector<ContactPoint> end;    // and those at its end
        std::vector<char> is_seen;        // halfway and at the end
        std::vector<Mover> straight;      // bodies as straight lines leave them
    };
    Curves curves_;
    std::vector<Mover> place_movers_;
    std::vector<ContactPoint> place_points_;
    GroupSolver solver_;
    RestCounts counts_;
    RestSeconds seconds_;
    double energy_limited_ = 0.0; // [J]
    double max_overlap_ = 0.0;
    std::vector<std::vector<Leg>>* legs_ = nullptr; // of each body, as it is known outside, while they are noted

};


} // namespace flying
