#pragma once

#include <span>
#include <vector>

#include "math/block_system.hpp"
#include "response/impacts_at_once.hpp"
#include "response/push_line.hpp"

namespace flying {

[[nodiscard]] inline bool moves(const ImpactBody& body)
{
    return body.inertia.inv_mass > 0.0 || body.inertia.inv_moment_of_inertia > 0.0;
}

[[nodiscard]] inline PairMotion pair_motion(std::span<const ImpactBody> bodies, int a, int b)
{
    return {bodies[a].velocity, bodies[b].velocity, bodies[a].spin, bodies[b].spin};
}

/// Pairs of bodies that push together, since they share some that move.
class PushTogether
{
public:
    /// What pushes do to one body of a group.
    struct Share
    {
        ImpactBody before;
        double root_mass = 0.0;      ///< root of its inverse mass, in which unit its speed counts among the unknowns
        double root_moment = 0.0;    ///< likewise of its inverse moment of inertia
        Vec2 impulse = Vec2::Zero(); ///< not given yet [N s]
        double moment = 0.0;         ///< likewise [N m s]
        int number = -1;             ///< in its group; -1 of a body that isn't in it
    };

    /// shares  of all bodies, in no group; so they are again when the group is gone
    /// system  to work with
    PushTogether(std::span<ImpactBody> bodies, std::vector<Share>& shares, BlockSystem& system)
        : bodies_(bodies), shares_(shares), system_(system)
    {
    }
    ~PushTogether();
    PushTogether(const PushTogether&) = delete;
    PushTogether& operator=(const PushTogether&) = delete;

    /// Add the points of a pair.
    ///
    /// least  of all points: speed along the normal, at least, when approaches have been ended; none where that is
    ///        zero everywhere [m/s]
    void add(const ImpactPair& pair, std::span<const ImpactPoint> points, std::span<const double> least = {});

    /// Find the impulses that end the approach of all points at once.
    ///
    /// Each point parts, slips or grips, and a system of equations says what points bear that do as is guessed: a
    /// semismooth Newton's method (Alart and Curnier, "A mixed formulation for frictional contact problems prone to
    /// Newton like solution methods", 1991). A damper at each point stands for its being rigid. Where guesses lead to
    /// no better ones, dampers are made softer, down to steps as small as those of sweeps.
    void compress();

    /// Push with (1 + e) times what was found, and of the friction with the part at which most energy is lost; with all
    /// of it scaled down where it would add energy.
    void give_back();

    /// In place of both: end the approach of all points at once without rebound, those that part before included, since
    /// they may be driven together. False, and nothing pushed, where the rounds were not enough.
    ///
    /// enough  what may be left, where another round gets no nearer [m/s]
    [[nodiscard]] bool stop(double enough, int rounds);

private:
    /// What a point bears.
    struct PointImpulse
    {
        double normal = 0.0;  ///< >= 0 [N s]
        double tangent = 0.0; ///< at most mu times as much
    };

    /// A point of a group, with its impulses of compression.
    struct GroupPoint
    {
        int a = 0;
        int b = 0;
        PointFrame frame;
        Material material;
        double least = 0.0;      ///< speed along the normal, at least, in the end [m/s]
        int edge = -1;           ///< of the system of equations; -1 where one of both doesn't move
        double response_n = 0.0; ///< to a push along the normal [1/kg]
        double response_t = 0.0; ///< likewise along the tangent
        bool is_closed = false;
        bool grips = false;
        double lean = 0.0; ///< what it bears along the tangent, by what it bears along the normal, where it slips
        PointImpulse bears{0.0, 0.0}; ///< as the last round left it
        PointImpulse best{0.0, 0.0};  ///< the nearest so far
    };

    [[nodiscard]] PairMotion motion_of(const GroupPoint& p) const { return pair_motion(bodies_, p.a, p.b); }
    [[nodiscard]] static PointImpulse within_cone(const GroupPoint& p, const PointImpulse& wanted);
    [[nodiscard]] bool find_impulses(double enough, int rounds, int patience);
    void set_up();
    [[nodiscard]] double ask_points(double near);
    [[nodiscard]] static PointImpulse damped(const GroupPoint& p, double stiffness, const PairMotion& motion,
                                             double free);
    void push_at_once(double stiffness);
    [[nodiscard]] PairMotion change_of(const GroupPoint& p) const;
    [[nodiscard]] PairRow row_of(const GroupPoint& p, const PushLine& line) const;
    void assemble(double stiffness);
    void push(const GroupPoint& p, const PushLine& line, double j);
    void end_together();
    [[nodiscard]] double taken_up() const;
    void give(double part);
    template <typename Impulse>
    [[nodiscard]] double push_all(PushLine PointFrame::*line, const Impulse& impulse_of);
    void take_back();

    std::span<ImpactBody> bodies_;
    std::vector<Share>& shares_;
    BlockSystem& system_;
    std::vector<GroupPoint> points_;
    std::vector<int> movers_;
    std::vector<double> unknowns_; // three for each of them
    double top_speed_ = 0.0;       // [m/s]
    double rests_ = 0.0;           // what parts no faster rests [m/s]
};

} // namespace flying
