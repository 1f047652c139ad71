#include "rest/sweep_batches.hpp"

#include <algorithm>
#include <bit>
#include <numeric>

namespace flying {
namespace {

/// All four alike. (Handed over by reference: how a function returns four numbers depends on the processor.)
inline void set_all(Four& four, double x)
{
    four = Four{x, x, x, x};
}

/// Bodies have a bit for each. A pair that finds none left, on a body that more than so many lean on, gets one of its
/// own.
constexpr int k_colours = 64;
/// Pairs that are coloured together. The more, the fuller the batches; the fewer, the less is swept out of the list's
/// order.
constexpr std::size_t k_part = 512;

} // namespace

/// The first colour that neither body has a pair of.
int SweepBatches::colour_of(const Run& run)
{
    const int colour = std::countr_one(used_[run.a] | used_[run.b]);
    if (colour == k_colours) {
        in_kind_.resize(in_kind_.size() + 2);
        return static_cast<int>(in_kind_.size()) / 2 - 1;
    }
    const std::uint64_t bit = std::uint64_t{1} << colour;
    used_[run.a] |= bit;
    used_[run.b] |= bit;
    used_.back() = 0; // what can't move is never in the way
    return colour;
}

/// Runs of the next part, each with its kind.
void SweepBatches::colour_part(std::span<const ContactPoint> points, std::size_t from)
{
    for (const Run& run : runs_) used_[run.a] = used_[run.b] = 0;
    runs_.clear();
    in_kind_.assign(2 * k_colours, 0);
    for (std::size_t k = from; k < points.size() && runs_.size() < k_part;) {
        const ContactPoint& c = points[k];
        const int count = k + 1 < points.size() && points[k + 1].pair == c.pair ? 2 : 1;
        Run run{static_cast<int>(k), count, place_[c.a], place_[c.b], 0};
        run.kind = 2 * colour_of(run) + (count - 1);
        ++in_kind_[run.kind];
        runs_.push_back(run);
        k += count;
    }
}

/// Batches for so many pairs of so many points each.
void SweepBatches::add_batches(int pairs, int count)
{
    if (pairs == 0) return;
    const int from = batch_count_;
    batch_count_ += (pairs + 7) / 8;
    if (batch_count_ > static_cast<int>(batches_.size())) batches_.resize(2 * batch_count_);
    for (int k = from; k < batch_count_; ++k) {
        batches_[k].first = point_count_;
        batches_[k].count = count;
        point_count_ += 2 * count;
    }
    if (point_count_ > static_cast<int>(points_.size())) points_.resize(2 * point_count_);
    if (pairs % 8 != 0) clear(batches_[batch_count_ - 1]);
}

/// A row that pushes nothing.
void SweepBatches::clear(Batch& batch)
{
    const int none = static_cast<int>(bodies_.size()) - 1;
    for (Row& row : batch.rows) {
        row = Row{};
        std::fill(row.a, row.a + 4, none);
        std::fill(row.b, row.b + 4, none);
    }
    for (int k = batch.first; k < batch.first + 2 * batch.count; ++k) {
        points_[k] = Points{};
        set_all(points_[k].normal_mass, 1.0);
        set_all(points_[k].tangent_mass, 1.0);
    }
}

void SweepBatches::lay_out(std::span<const ContactPoint> points, std::span<const Mover> movers,
                           std::span<const int> members)
{
    place_.assign(movers.size(), static_cast<int>(members.size())); // of none
    for (std::size_t k = 0; k < members.size(); ++k) place_[members[k]] = static_cast<int>(k);
    bodies_.assign(members.size() + 1, Body{});
    set_velocities(movers, members);
    lane_of_.resize(points.size());
    runs_.clear();
    used_.assign(bodies_.size(), 0);
    batch_count_ = 0;
    point_count_ = 0;
    for (std::size_t k = 0; k < points.size();) k = lay_out_part(k, points, movers);
}

/// Returns where the next part begins.
std::size_t SweepBatches::lay_out_part(std::size_t from, std::span<const ContactPoint> points,
                                       std::span<const Mover> movers)
{
    colour_part(points, from);
    places_.clear();
    for (std::size_t kind = 0; kind < in_kind_.size(); ++kind) {
        places_.push_back(8 * batch_count_);
        add_batches(in_kind_[kind], 1 + kind % 2);
    }
    for (const Run& run : runs_) {
        const int place = places_[run.kind]++;
        Batch& batch = batches_[place / 8];
        const int pair = place % 8;
        set_lane(batch, pair, points.subspan(run.first, run.count), movers);
        for (int i = 0; i < run.count; ++i) lane_of_[run.first + i] = 4 * (batch.first + 2 * i) + pair;
    }
    return runs_.back().first + runs_.back().count;
}

std::vector<int> SweepBatches::order() const
{
    // The first points of all pairs of a batch, then the second ones: pairs of a batch know nothing of each other
    std::vector<int> order(lane_of_.size());
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(), order.end(), [&](int i, int j) { return lane_of_[i] < lane_of_[j]; });
    return order;
}

/// points  of the pair
void SweepBatches::set_lane(Batch& batch, int pair, std::span<const ContactPoint> points, std::span<const Mover> movers)
{
    const ContactPoint& c = points[0];
    Row& row = batch.rows[pair / 4];
    const int lane = pair % 4;
    row.a[lane] = place_[c.a];
    row.b[lane] = place_[c.b];
    row.n_x[lane] = c.n_x;
    row.n_y[lane] = c.n_y;
    row.inv_moment_a[lane] = movers[c.a].inv_moment;
    row.inv_moment_b[lane] = movers[c.b].inv_moment;
    row.friction[lane] = c.friction;
    for (int i = 0; i < batch.count; ++i) {
        const ContactPoint& from = points[i];
        Points& to = points_[batch.first + 2 * i + pair / 4];
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
    for (std::size_t k = 0; k < points.size(); ++k) {
        const Points& from = points_[lane_of_[k] / 4];
        points[k].normal = from.normal[lane_of_[k] % 4];
        points[k].tangent = from.tangent[lane_of_[k] % 4];
    }
}

struct SweepBatches::Motion
{
    Four v_x;
    Four v_y;
    Four spin;
    Four inv_mass;
};

[[gnu::always_inline]] inline void SweepBatches::solve_point(const Row& row, Points& c, Motion& a, Motion& b,
                                                             Change& change)
{
    // The plain sweep's sums, in its order
    Four v_x = b.v_x - a.v_x;
    Four v_y = b.v_y - a.v_y;
    const Four u_n = (row.n_x * v_x + row.n_y * v_y) + (b.spin * c.normal_arm_b - a.spin * c.normal_arm_a);
    const Four none{};
    Four normal = c.normal - c.normal_mass * (u_n - c.bound);
    normal = none < normal ? normal : none;
    const Four j = normal - c.normal;
    c.normal = normal;

    const Four w = a.inv_mass + b.inv_mass;
    const Four spin_a = a.spin - row.inv_moment_a * (j * c.normal_arm_a);
    const Four spin_b = b.spin + row.inv_moment_b * (j * c.normal_arm_b);
    v_x += j * (w * row.n_x);
    v_y += j * (w * row.n_y);
    const Four u_t = (row.n_x * v_y - row.n_y * v_x) + (spin_b * c.tangent_arm_b - spin_a * c.tangent_arm_a);
    const Four most = row.friction * normal;
    Four tangent = c.tangent - c.tangent_mass * u_t;
    tangent = tangent < -most ? -most : tangent;
    tangent = most < tangent ? most : tangent;
    const Four q = tangent - c.tangent;
    c.tangent = tangent;

    const Four p_x = j * row.n_x - q * row.n_y;
    const Four p_y = j * row.n_y + q * row.n_x;
    a.v_x -= a.inv_mass * p_x;
    a.v_y -= a.inv_mass * p_y;
    a.spin = spin_a - row.inv_moment_a * (q * c.tangent_arm_a);
    b.v_x += b.inv_mass * p_x;
    b.v_y += b.inv_mass * p_y;
    b.spin = spin_b + row.inv_moment_b * (q * c.tangent_arm_b);
    change.normal = j;
    change.tangent = q;
}

// (Without loops, so that what is fetched need not be put down in between.)
inline void SweepBatches::fetch(const int (&places)[4], Motion& motion) const
{
    const Four rows[4] = {bodies_[places[0]].motion, bodies_[places[1]].motion, bodies_[places[2]].motion,
                          bodies_[places[3]].motion};
    transpose(rows, motion.v_x, motion.v_y, motion.spin, motion.inv_mass);
}

inline void SweepBatches::put_back(const int (&places)[4], const Motion& motion)
{
    const Four columns[4] = {motion.v_x, motion.v_y, motion.spin, motion.inv_mass};
    transpose(columns, bodies_[places[0]].motion, bodies_[places[1]].motion, bodies_[places[2]].motion,
              bodies_[places[3]].motion);
}

template <typename Content>
inline void SweepBatches::sweep_batch(const Batch& batch, Content&& content_of)
{
    const Row& one = batch.rows[0];
    const Row& other = batch.rows[1];
    Motion one_a;
    Motion one_b;
    Motion other_a;
    Motion other_b;
    fetch(one.a, one_a);
    fetch(one.b, one_b);
    fetch(other.a, other_a);
    fetch(other.b, other_b);
    for (int k = 0; k < batch.count; ++k) {
        const int point = batch.first + 2 * k;
        content_of(one, point, one_a, one_b);
        content_of(other, point + 1, other_a, other_b);
    }

    put_back(one.a, one_a);
    put_back(one.b, one_b);
    put_back(other.a, other_a);
    put_back(other.b, other_b);
}

/// Of what one sweep takes off little, many would take off alike. Wherever a sweep changes more than the last, the
/// directions are forgotten (Silcowitz, Niebe and Erleben, A nonsmooth nonlinear conjugate gradient method, 2010).
int SweepBatches::sweep_ahead(const Ahead& ahead)
{
    way_.assign(point_count_, Way{});
    drift_.resize(bodies_.size());
    for (std::size_t i = 0; i < bodies_.size(); ++i) drift_[i] = {bodies_[i].motion, Four{}};
    Four share{};
    double last = 0.0;
    for (int sweeps = 1;; ++sweeps) {
        Four sum{};
        for (int k = 0; k < batch_count_; ++k) {
            sweep_batch(
                batches_[k], [&](const Row& row, int point, Motion& a, Motion& b) __attribute__((always_inline)) {
                    Way& way = way_[point];
                    go_ahead(points_[point], way, share);
                    Change& change = way.last;
                    solve_point(row, points_[point], a, b, change);
                    sum +=
                        (change.normal * change.normal + change.tangent * change.tangent) * (a.inv_mass + b.inv_mass);
                });
        }
        // What a sweep leaves lies in Coulomb's cones; what goes ahead may not
        if (sweeps >= ahead.most || (sweeps >= ahead.least && last <= ahead.enough)) return sweeps;
        const double now = (sum[0] + sum[1]) + (sum[2] + sum[3]);
        const double part = sweeps > 1 && last > 0.0 ? now / last : 0.0;
        last = now;
        set_all(share, part <= 1.0 ? part : 0.0);
        go_ahead(share);
    }
}

/// The way of a sweep, and a share of the way before it: of the impulses of a point
[[gnu::always_inline]] inline void SweepBatches::go_ahead(Points& c, Way& way, const Four& share)
{
    const Four normal = share * way.so_far.normal;
    const Four tangent = share * way.so_far.tangent;
    c.normal += normal;
    c.tangent += tangent;
    way.so_far.normal = normal + way.last.normal;
    way.so_far.tangent = tangent + way.last.tangent;
}

/// and of all velocities.
void SweepBatches::go_ahead(const Four& share)
{
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
        Four& motion = bodies_[i].motion;
        Drift& drift = drift_[i];
        const Four change = motion - drift.old;
        const Four way = share * drift.way;
        motion += way;
        drift.way = way + change;
        drift.old = motion;
    }
}

} // namespace flying
