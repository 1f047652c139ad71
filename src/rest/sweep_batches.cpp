#include "rest/sweep_batches.hpp"

#include <algorithm>

namespace flying {
namespace {

// [rest.batches.all]
/// All four alike. (Handed over by reference: how a function returns four numbers depends on the processor.)
inline void set_all(Four& four, double x) { four = Four{x, x, x, x}; }
// [rest.batches.all]

// [rest.batches.apart]
/// Batches from one pair of a body to its next: a batch that doesn't wait for the one before it is swept beside it.
constexpr int k_apart = 3;
// [rest.batches.apart]

} // namespace

// [rest.batches.turns]
int SweepBatches::first_open(std::vector<int>& open, int turn)
{
    while (open[turn] != turn) turn = open[turn] = open[open[turn]];
    return turn;
}

void SweepBatches::add_batch(int count)
{
    const int batch = static_cast<int>(batches_.size());
    open_[count - 1].push_back(batch + 1);
    std::vector<int>& other = open_[2 - count];
    other.push_back(batch + 1);
    other[batch] = batch + 1;
    const int nobody = static_cast<int>(bodies_.size()) - 1;
    Batch& added = batches_.emplace_back();
    std::fill(added.a, added.a + 4, nobody);
    std::fill(added.b, added.b + 4, nobody);
    added.first = static_cast<int>(points_.size());
    added.count = count;
    added.pairs = 0;
    for (int i = 0; i < count; ++i) {
        Points& empty = points_.emplace_back();
        set_all(empty.normal_mass, 1.0);
        set_all(empty.tangent_mass, 1.0);
    }
}

/// The first batch from a turn on that has room for a pair of so many points; a new one at the end where none has.
int SweepBatches::batch_from(int turn, int count)
{
    while (static_cast<int>(batches_.size()) < turn) add_batch(count);
    std::vector<int>& open = open_[count - 1];
    const int batch = first_open(open, turn);
    if (batch == static_cast<int>(batches_.size())) add_batch(count);
    if (++batches_[batch].pairs == 4) open[batch] = batch + 1;
    return batch;
}
// [rest.batches.turns]

// [rest.batches.lay]
void SweepBatches::lay_out(std::span<const ContactPoint> points, std::span<const int> which,
                           std::span<const Mover> movers, std::span<const int> members)
{
    place_.assign(movers.size(), static_cast<int>(members.size())); // nobody's
    for (std::size_t k = 0; k < members.size(); ++k) place_[members[k]] = static_cast<int>(k);
    bodies_.assign(members.size() + 1, Body{});
    set_velocities(movers, members);
    turns_.assign(members.size() + 1, 0);
    batches_.clear();
    points_.clear();
    for (std::vector<int>& open : open_) open.assign(1, 0);
    which_.assign(which.begin(), which.end());
    lane_of_.resize(which.size());

    for (std::size_t k = 0; k < which.size();) {
        const ContactPoint& c = points[which[k]];
        int count = 1;
        while (count < 2 && k + count < which.size() && points[which[k + count]].pair == c.pair) ++count;
        const int a = place_[c.a];
        const int b = place_[c.b];
        const int turn = batch_from(std::max(turns_[a], turns_[b]), count);
        turns_[a] = turns_[b] = turn + k_apart;
        turns_.back() = 0; // what can't move is never in the way
        Batch& batch = batches_[turn];
        const int lane = batch.pairs - 1;
        set_lane(batch, lane, points, which.subspan(k, count), movers);
        for (int i = 0; i < count; ++i) lane_of_[k + i] = 4 * (batch.first + i) + lane;
        k += count;
    }
}

void SweepBatches::set_lane(Batch& batch, int lane, std::span<const ContactPoint> points, std::span<const int> which,
                            std::span<const Mover> movers)
{
    const ContactPoint& c = points[which[0]];
    batch.a[lane] = place_[c.a];
    batch.b[lane] = place_[c.b];
    batch.n_x[lane] = c.n_x;
    batch.n_y[lane] = c.n_y;
    batch.inv_moment_a[lane] = movers[c.a].inv_moment;
    batch.inv_moment_b[lane] = movers[c.b].inv_moment;
    batch.friction[lane] = c.friction;
    for (int i = 0; i < batch.count; ++i) {
        const ContactPoint& from = points[which[i]];
        Points& to = points_[batch.first + i];
        to.normal_arm_a[lane] = from.normal_arm_a;
        to.normal_arm_b[lane] = from.normal_arm_b;
        to.tangent_arm_a[lane] = from.tangent_arm_a;
        to.tangent_arm_b[lane] = from.tangent_arm_b;
        to.normal_mass[lane] = from.normal_mass;
        to.tangent_mass[lane] = from.tangent_mass;
        to.bound[lane] = from.bound;
        to.normal[lane] = from.normal;
        to.tangent[lane] = from.tangent;
    }
}
// [rest.batches.lay]

// [rest.batches.velocities]
void SweepBatches::set_velocities(std::span<const Mover> movers, std::span<const int> members)
{
    for (std::size_t k = 0; k < members.size(); ++k) {
        const Mover& m = movers[members[k]];
        bodies_[k].motion = Four{m.v_x, m.v_y, m.spin, m.inv_mass};
    }
}

void SweepBatches::get_velocities(std::span<Mover> movers, std::span<const int> members) const
{
    for (std::size_t k = 0; k < members.size(); ++k) {
        Mover& m = movers[members[k]];
        const Four& motion = bodies_[k].motion;
        m.v_x = motion[0];
        m.v_y = motion[1];
        m.spin = motion[2];
    }
}

void SweepBatches::get_impulses(std::span<ContactPoint> points) const
{
    for (std::size_t k = 0; k < which_.size(); ++k) {
        const Points& from = points_[lane_of_[k] / 4];
        points[which_[k]].normal = from.normal[lane_of_[k] % 4];
        points[which_[k]].tangent = from.tangent[lane_of_[k] % 4];
    }
}
// [rest.batches.velocities]

// [rest.batches.content]
struct SweepBatches::Motion
{
    Four v_x;
    Four v_y;
    Four spin;
    Four inv_mass;
};

inline void SweepBatches::content(const Batch& batch, Points& c, Motion& a, Motion& b, Change& change)
{
    // The plain sweep's sums, in its order
    Four v_x = b.v_x - a.v_x;
    Four v_y = b.v_y - a.v_y;
    const Four u_n = (batch.n_x * v_x + batch.n_y * v_y) + (b.spin * c.normal_arm_b - a.spin * c.normal_arm_a);
    const Four none{};
    Four normal = c.normal - c.normal_mass * (u_n - c.bound);
    normal = none < normal ? normal : none;
    const Four j = normal - c.normal;
    c.normal = normal;

    const Four w = a.inv_mass + b.inv_mass;
    const Four spin_a = a.spin - batch.inv_moment_a * (j * c.normal_arm_a);
    const Four spin_b = b.spin + batch.inv_moment_b * (j * c.normal_arm_b);
    v_x += j * (w * batch.n_x);
    v_y += j * (w * batch.n_y);
    const Four u_t = (batch.n_x * v_y - batch.n_y * v_x) + (spin_b * c.tangent_arm_b - spin_a * c.tangent_arm_a);
    const Four most = batch.friction * normal;
    Four tangent = c.tangent - c.tangent_mass * u_t;
    tangent = tangent < -most ? -most : tangent;
    tangent = most < tangent ? most : tangent;
    const Four q = tangent - c.tangent;
    c.tangent = tangent;

    const Four p_x = j * batch.n_x - q * batch.n_y;
    const Four p_y = j * batch.n_y + q * batch.n_x;
    a.v_x -= a.inv_mass * p_x;
    a.v_y -= a.inv_mass * p_y;
    a.spin = spin_a - batch.inv_moment_a * (q * c.tangent_arm_a);
    b.v_x += b.inv_mass * p_x;
    b.v_y += b.inv_mass * p_y;
    b.spin = spin_b + batch.inv_moment_b * (q * c.tangent_arm_b);
    change.normal = j;
    change.tangent = q;
}
// [rest.batches.content]

// [rest.batches.sweep]
// (Without loops, so that what is fetched need not be put down in between.)
inline void SweepBatches::fetch(const int (&who)[4], Motion& motion) const
{
    const Four rows[4] = {bodies_[who[0]].motion, bodies_[who[1]].motion, bodies_[who[2]].motion, bodies_[who[3]].motion};
    turn(rows, motion.v_x, motion.v_y, motion.spin, motion.inv_mass);
}

inline void SweepBatches::put_back(const int (&who)[4], const Motion& motion)
{
    const Four columns[4] = {motion.v_x, motion.v_y, motion.spin, motion.inv_mass};
    turn(columns, bodies_[who[0]].motion, bodies_[who[1]].motion, bodies_[who[2]].motion, bodies_[who[3]].motion);
}

template <typename Note>
inline void SweepBatches::sweep_batch(const Batch& batch, bool backwards, Note&& note)
{
    Motion a;
    Motion b;
    fetch(batch.a, a);
    fetch(batch.b, b);
    for (int k = 0; k < batch.count; ++k) {
        const int point = batch.first + (backwards ? batch.count - 1 - k : k);
        Change change;
        content(batch, points_[point], a, b, change);
        note(point, change);
    }

    put_back(batch.a, a);
    put_back(batch.b, b);
}

void SweepBatches::sweep()
{
    for (const Batch& batch : batches_) sweep_batch(batch, false, [](int, const Change&) {});
}

void SweepBatches::sweep_back()
{
    for (std::size_t k = batches_.size(); k > 0; --k) sweep_batch(batches_[k - 1], true, [](int, const Change&) {});
}

void SweepBatches::sweep_to_and_fro(int sweeps)
{
    for (int k = 0; k < sweeps; ++k) {
        if (k % 2 == 0) sweep();
        else sweep_back();
    }
}
// [rest.batches.sweep]

// [rest.batches.ahead]
/// Of what one sweep takes off little, many would take off alike. Wherever a sweep changes more than the last, the
/// directions are forgotten (Silcowitz, Niebe and Erleben, A nonsmooth nonlinear conjugate gradient method, 2010).
int SweepBatches::sweep_ahead(const Ahead& ahead)
{
    way_.assign(points_.size(), Way{});
    drift_.assign(bodies_.size(), Drift{});
    for (std::size_t i = 0; i < bodies_.size(); ++i) drift_[i].old = bodies_[i].motion;
    double last = 0.0;
    for (int k = 0;; ++k) {
        Four sum{};
        for (const Batch& batch : batches_) {
            sweep_batch(batch, false, [&](int point, const Change& change) {
                const Points& c = points_[point];
                way_[point].last = change;
                sum += change.normal * change.normal / c.normal_mass + change.tangent * change.tangent / c.tangent_mass;
            });
        }
        // What a sweep leaves lies in Coulomb's cones; what goes ahead may not
        const int sweeps = k + 1;
        if (sweeps >= ahead.most || (sweeps >= ahead.least && last <= ahead.enough)) return sweeps;
        const double now = (sum[0] + sum[1]) + (sum[2] + sum[3]);
        const double share = k > 0 && last > 0.0 ? now / last : 0.0;
        last = now;
        go_ahead(share <= 1.0 ? share : 0.0);
    }
}

void SweepBatches::go_ahead(double share)
{
    // The way of a sweep, and a share of the way before it
    Four part;
    set_all(part, share);
    for (std::size_t i = 0; i < points_.size(); ++i) {
        Points& c = points_[i];
        Way& way = way_[i];
        const Four normal = part * way.so_far.normal;
        const Four tangent = part * way.so_far.tangent;
        c.normal += normal;
        c.tangent += tangent;
        way.so_far.normal = normal + way.last.normal;
        way.so_far.tangent = tangent + way.last.tangent;
    }
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
        Four& motion = bodies_[i].motion;
        Drift& drift = drift_[i];
        const Four change = motion - drift.old;
        const Four way = part * drift.way;
        motion += way;
        drift.way = way + change;
        drift.old = motion;
    }
}
// [rest.batches.ahead]

// [rest.batches.push]
void SweepBatches::begin_push(std::span<const ContactPoint> points, double share, double time)
{
    for (Batch& batch : batches_) batch.friction = Four{};
    for (Points& c : points_) c.normal = c.tangent = Four{};
    for (std::size_t k = 0; k < which_.size(); ++k) {
        const ContactPoint& c = points[which_[k]];
        if (c.gap < 0.0) points_[lane_of_[k] / 4].bound[lane_of_[k] % 4] = share * -c.gap / time;
    }
}
// [rest.batches.push]

} // namespace flying
