#include "response/push_together.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "math/tolerance.hpp"

namespace flying {
namespace {

/// Rounds of compression, after which the best is given back that was found. Most take four, one in a hundred some
/// dozens.
constexpr int k_push_rounds = 128;

/// Stiffness of a damper, at most, by the inertia that its point moves. What so stiff a damper leaves of an approach is
/// about what rounding leaves of its equations, and the next round takes that off.
constexpr double k_stiffest = 0x1p24;

/// At least: with softer ones a load takes too many rounds to get through light bodies that lie among heavy ones.
constexpr double k_softest = 0x1p5;

} // namespace

PushTogether::~PushTogether()
{
    for (const int body : movers_) shares_[body] = {};
}

void PushTogether::add(const ImpactPair& pair, std::span<const ImpactPoint> points, std::span<const double> least)
{
    for (std::size_t k = pair.first; k < pair.end; ++k) {
        points_.push_back({pair.a, pair.b, frame_at(points[k]), pair.material});
        GroupPoint& point = points_.back();
        if (!least.empty()) point.least = least[k];
        const double v_n = speed_along(point.frame.normal, motion_of(point));
        const double v_t = speed_along(point.frame.tangent, motion_of(point));
        top_speed_ = std::max({top_speed_, std::abs(v_n), std::abs(v_t), bodies_[pair.a].velocity.norm(),
                               bodies_[pair.b].velocity.norm()});
    }
    rests_ = std::max(rests_, pair.rests);
}

// [response.at_once.compress]
void PushTogether::compress()
{
    const auto parts = [&](const GroupPoint& p) {
        return speed_along(p.frame.normal, motion_of(p)) > std::max(tolerance::k_approach * top_speed_, rests_);
    };
    std::erase_if(points_, parts);
    static_cast<void>(find_impulses(0.0, k_push_rounds, k_push_rounds));
    end_together();
    take_back();
}

/// True where none misses by more than enough, or than rounding, what would end its approach.
///
/// enough    what may be left, where another round gets no nearer [m/s]
/// patience  rounds in a row, at most, that get no nearer
bool PushTogether::find_impulses(double enough, int rounds, int patience)
{
    set_up();
    const double rounding = 4.0 * tolerance::k_epsilon * top_speed_;
    double least = std::numeric_limits<double>::infinity();
    double stiffness = k_stiffest;
    int best_round = 0;
    for (int round = 0; round < rounds && round - best_round <= patience; ++round) {
        const double left = ask_points(round == 0 ? enough : 0.0); // at first, what touches closes
        if (least <= enough && !(left < least)) break;
        if (left < least) {
            least = left;
            best_round = round;
            for (GroupPoint& p : points_) p.best = p.bears;
            stiffness = std::min(16.0 * stiffness, k_stiffest);
        } else stiffness = std::max(0.25 * stiffness, k_softest);
        if (left <= rounding) break; // both are zero where all is too slow for numbers
        push_at_once(stiffness);
    }
    for (GroupPoint& p : points_) p.bears = within_cone(p, p.best);
    return least <= std::max(rounding, enough);
}
// [response.at_once.compress]

bool PushTogether::stop(double enough, int rounds)
{
    const bool is_found = find_impulses(enough, rounds, rounds / 4);
    take_back();
    if (!is_found) return false;
    static_cast<void>(push_all(&PointFrame::normal, [](const GroupPoint& p) { return p.bears.normal; }));
    static_cast<void>(push_all(&PointFrame::tangent, [](const GroupPoint& p) { return p.bears.tangent; }));
    give(1.0);
    return true;
}

// [response.at_once.give_back]
void PushTogether::give_back()
{
    const auto along_normal = [](const GroupPoint& p) { return (1.0 + p.material.restitution) * p.bears.normal; };
    const auto along_tangent = [](const GroupPoint& p) { return (1.0 + p.material.restitution) * p.bears.tangent; };
    static_cast<void>(push_all(&PointFrame::normal, along_normal));
    give(1.0);
    const double slip = push_all(&PointFrame::tangent, along_tangent);
    const double part = slip < 0.0 ? std::min(1.0, -slip / taken_up()) : 0.0;
    take_back();

    double work = push_all(&PointFrame::normal, along_normal);
    work += push_all(&PointFrame::tangent, [&](const GroupPoint& p) { return part * along_tangent(p); });
    give(work < 0.0 ? std::min(1.0, -2.0 * work / taken_up()) : 0.0);
}
// [response.at_once.give_back]

PushTogether::PointImpulse PushTogether::within_cone(const GroupPoint& p, const PointImpulse& wanted)
{
    const double j = std::max(0.0, wanted.normal);
    const double most = p.material.friction * j;
    return {j, std::clamp(wanted.tangent, -most, most)};
}

/// Number the bodies that move, and list which of them are coupled.
void PushTogether::set_up()
{
    std::vector<BlockSystem::Edge> edges;
    for (GroupPoint& p : points_) {
        for (const int body : {p.a, p.b}) {
            Share& share = shares_[body];
            if (!moves(bodies_[body]) || share.number >= 0) continue;
            share.before = bodies_[body];
            share.root_mass = std::sqrt(share.before.inertia.inv_mass);
            share.root_moment = std::sqrt(share.before.inertia.inv_moment_of_inertia);
            share.number = static_cast<int>(movers_.size());
            movers_.push_back(body);
        }
        const PairInertia inertia{bodies_[p.a].inertia, bodies_[p.b].inertia};
        p.response_n = inverse_mass(p.frame.normal, inertia);
        p.response_t = inverse_mass(p.frame.tangent, inertia);
        const BlockSystem::Edge edge{shares_[p.a].number, shares_[p.b].number};
        if (std::min(edge.first, edge.second) < 0) continue;
        if (edges.empty() || edges.back() != edge) edges.push_back(edge);
        p.edge = static_cast<int>(edges.size()) - 1;
    }
    system_.set_pattern(static_cast<int>(movers_.size()), edges);
    unknowns_.resize(3 * movers_.size());
}

// [response.at_once.ask]
/// Ask each point what would end the approach and the slip at its own place: whether it is closed then, and grips.
/// Returns how far at most that is from what it bears.  [m/s]
///
/// near  what opens no faster is closed [m/s]
double PushTogether::ask_points(double near)
{
    double left = 0.0;
    for (GroupPoint& p : points_) {
        const PairMotion motion = motion_of(p);
        const PointImpulse wanted{p.bears.normal - (speed_along(p.frame.normal, motion) - p.least) / p.response_n,
                                  p.bears.tangent - speed_along(p.frame.tangent, motion) / p.response_t};
        const PointImpulse possible = within_cone(p, wanted);
        p.is_closed = p.response_n * wanted.normal > -near;
        p.grips = p.is_closed && p.material.friction > 0.0 && possible.tangent == wanted.tangent;
        p.lean = std::copysign(p.material.friction, wanted.tangent);
        left = std::max({left, std::abs(possible.normal - p.bears.normal) * p.response_n,
                         std::abs(possible.tangent - p.bears.tangent) * p.response_t});
    }
    return left;
}

/// What a point bears after its dampers have met these speeds.
///
/// free  speed along the normal that is none to them [m/s]
PushTogether::PointImpulse PushTogether::damped(const GroupPoint& p, double stiffness, const PairMotion& motion,
                                                double free)
{
    if (!p.is_closed) return {};
    const double j = p.bears.normal - stiffness / p.response_n * (speed_along(p.frame.normal, motion) - free);
    if (!p.grips) return {j, p.lean * j};
    return {j, p.bears.tangent - stiffness / p.response_t * speed_along(p.frame.tangent, motion)};
}
// [response.at_once.ask]

// [response.at_once.round]
/// Put a damper at each closed point, along its normal and, where it grips, along its tangent; all push at once.
void PushTogether::push_at_once(double stiffness)
{
    // Find what they push at the speeds that there are, and the changes of speed at which all have met their pushes
    for (GroupPoint& p : points_) {
        const PointImpulse before = p.bears;
        p.bears = damped(p, stiffness, motion_of(p), p.least);
        push(p, p.frame.normal, p.bears.normal - before.normal);
        push(p, p.frame.tangent, p.bears.tangent - before.tangent);
    }
    for (std::size_t k = 0; k < movers_.size(); ++k) {
        const Share& share = shares_[movers_[k]];
        unknowns_[3 * k] = share.root_mass * share.impulse.x();
        unknowns_[3 * k + 1] = share.root_mass * share.impulse.y();
        unknowns_[3 * k + 2] = share.root_moment * share.moment;
    }
    assemble(stiffness);
    const bool is_solved = system_.factorise();
    if (is_solved) system_.solve(unknowns_);
    for (GroupPoint& p : points_) p.bears = is_solved ? damped(p, stiffness, change_of(p), 0.0) : p.best;

    // Let all that points bear have pushed
    take_back();
    for (const GroupPoint& p : points_) {
        push(p, p.frame.normal, p.bears.normal);
        push(p, p.frame.tangent, p.bears.tangent);
    }
    give(1.0);
}
// [response.at_once.round]

/// The changes of speed that were found.
PairMotion PushTogether::change_of(const GroupPoint& p) const
{
    PairMotion change;
    const auto fill = [&](int body, Vec2& velocity, double& spin) {
        const Share& share = shares_[body];
        if (share.number < 0) return;
        const double* own = &unknowns_[3 * static_cast<std::size_t>(share.number)];
        velocity = share.root_mass * Vec2(own[0], own[1]);
        spin = share.root_moment * own[2];
    };
    fill(p.a, change.velocity_a, change.spin_a);
    fill(p.b, change.velocity_b, change.spin_b);
    return change;
}

PairRow PushTogether::row_of(const GroupPoint& p, const PushLine& line) const
{
    const Share& a = shares_[p.a];
    const Share& b = shares_[p.b];
    return {{-a.root_mass * line.direction.x(), -a.root_mass * line.direction.y(), -a.root_moment * line.arm_a},
            {b.root_mass * line.direction.x(), b.root_mass * line.direction.y(), b.root_moment * line.arm_b}};
}

/// Fill in the system. Its unknowns are changes of speed, by the roots of inverse inertias.
void PushTogether::assemble(double stiffness)
{
    system_.clear();
    for (std::size_t k = 0; k < movers_.size(); ++k) {
        Block& own = system_.diagonal(static_cast<int>(k));
        own.at[0][0] = own.at[1][1] = own.at[2][2] = 1.0;
    }
    for (const GroupPoint& p : points_) {
        if (!p.is_closed) continue;
        const PushLine& n = p.frame.normal;
        const PushLine& t = p.frame.tangent;
        const double lean = p.grips ? 0.0 : p.lean;
        const PushLine cone{n.direction + lean * t.direction, n.arm_a + lean * t.arm_a, n.arm_b + lean * t.arm_b};
        const BlockSystem::Edge pair{shares_[p.a].number, shares_[p.b].number};
        system_.add(pair, p.edge, stiffness / p.response_n, row_of(p, cone), row_of(p, n));
        if (p.grips) system_.add(pair, p.edge, stiffness / p.response_t, row_of(p, t), row_of(p, t));
    }
}

void PushTogether::push(const GroupPoint& p, const PushLine& line, double j)
{
    shares_[p.a].impulse -= j * line.direction;
    shares_[p.a].moment -= j * line.arm_a;
    shares_[p.b].impulse += j * line.direction;
    shares_[p.b].moment += j * line.arm_b;
}

/// Where the rounds were not enough: as much of all that was found as ends the approach on the whole.
void PushTogether::end_together()
{
    const double left = push_all(&PointFrame::normal, [](const GroupPoint& p) { return p.bears.normal; });
    const double taken = taken_up();
    const double part = taken > 0.0 ? 1.0 - left / taken : 1.0; // both may be too small for their squares
    for (GroupPoint& p : points_) p.bears.normal *= part;
}

/// Twice the energy that bodies at rest would take up from what they were pushed with since the last time.  [J]
double PushTogether::taken_up() const
{
    double sum = 0.0;
    for (const int body : movers_) {
        const Share& share = shares_[body];
        const Inertia& inertia = bodies_[body].inertia;
        sum += inertia.inv_mass * share.impulse.squaredNorm() +
               inertia.inv_moment_of_inertia * (share.moment * share.moment);
    }
    return sum;
}

/// Give all bodies a part of what they were pushed with since the last time.
void PushTogether::give(double part)
{
    for (const int body : movers_) {
        ImpactBody& one = bodies_[body];
        Share& share = shares_[body];
        one.velocity += part * (one.inertia.inv_mass * share.impulse);
        one.spin += part * (one.inertia.inv_moment_of_inertia * share.moment);
        share.impulse = Vec2::Zero();
        share.moment = 0.0;
    }
}

/// Push at all points.
/// Returns the work of it at the speeds that they have.  [J]
template <typename Impulse>
double PushTogether::push_all(PushLine PointFrame::*line, const Impulse& impulse_of)
{
    double work = 0.0;
    for (const GroupPoint& p : points_) {
        work += impulse_of(p) * speed_along(p.frame.*line, motion_of(p));
        push(p, p.frame.*line, impulse_of(p));
    }
    return work;
}

/// All bodies move as before, and nothing pushes them yet.
void PushTogether::take_back()
{
    give(0.0);
    for (const int body : movers_) bodies_[body] = shares_[body].before;
}

} // namespace flying
