#include "rest/group_solver.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "rest/push_lines.hpp"
#include "rest/rest_tolerance.hpp"
#include "rest/sweeps.hpp"

namespace flying {
namespace {

/// The most that an impulse changes the velocity of the lightest it pushes.  [m/s]
[[nodiscard]] double greatest_push(std::span<const ContactPoint> points)
{
    double greatest = 0.0;
    for (const ContactPoint& c : points) greatest = std::max(greatest, c.normal / c.normal_mass);
    return greatest;
}

} // namespace

double rounding_of(std::span<const ContactPoint> points, std::size_t members)
{
    return rest_tolerance::k_content * static_cast<double>(members) * greatest_push(points);
}

void GroupSolver::set_start(std::span<ContactPoint> points) const
{
    if (warm_) return;
    for (ContactPoint& c : points) c.normal = c.tangent = 0.0;
}

void GroupSolver::prepare(std::span<const int> members, std::span<const ContactPoint> points, std::size_t movers)
{
    // Number the members, and find who is coupled to whom
    if (local_.size() < movers) local_.resize(movers, -1);
    members_.assign(members.begin(), members.end());
    for (std::size_t k = 0; k < members.size(); ++k) local_[members[k]] = static_cast<int>(k);
    edges_.clear();
    edge_of_.resize(points.size());
    for (std::size_t k = 0; k < points.size(); ++k) {
        const int first = local_[points[k].a];
        const int second = local_[points[k].b];
        edge_of_[k] = -1;
        if (first < 0 || second < 0) continue;
        const bool same = !edges_.empty() && edges_.back().first == first && edges_.back().second == second;
        if (!same) edges_.push_back({first, second});
        edge_of_[k] = static_cast<int>(edges_.size()) - 1;
    }
    system_.set_pattern(static_cast<int>(members.size()), edges_);
    delta_.resize(3 * members.size());
    slip_.resize(2 * points.size());
    impulse_.resize(2 * points.size());
    mode_.resize(points.size());
    mode_factorised_.resize(points.size());
    factorised_ = false;
}

void GroupSolver::restore_free(std::span<Mover> movers, std::span<const int> members) const
{
    for (std::size_t k = 0; k < members.size(); ++k) movers[members[k]] = free_[k];
}

void GroupSolver::forget_what_suits_worse(std::span<Mover> movers, std::span<const int> members,
                                          std::span<ContactPoint> points)
{
    // Impulses that suit this step worse than none
    const double warm = worst_complaint(points, movers);
    kept_.assign(points.begin(), points.end());
    for (ContactPoint& c : points) c.normal = c.tangent = 0.0;
    restore_free(movers, members);
    if (worst_complaint(points, movers) < warm) return;
    std::copy(kept_.begin(), kept_.end(), points.begin());
    warm_start(points, movers);
}

void GroupSolver::settle_for_sweeps(std::span<Mover> movers, std::span<ContactPoint> points)
{
    // From the best that was met; sweeps never do work, whatever they leave
    sweep_points_.clear();
    for (const ContactPoint& c : points) sweep_points_.push_back(sweep_point(c));
    for (int k = 0; k < rest_tolerance::k_leading_sweeps; ++k) {
        if (k % 2 == 0) sweep(sweep_points_, movers);
        else sweep_back(sweep_points_, movers);
    }
    counts_.sweeps += rest_tolerance::k_leading_sweeps;
    for (std::size_t k = 0; k < points.size(); ++k) {
        points[k].normal = sweep_points_[k].normal;
        points[k].tangent = sweep_points_[k].tangent;
    }
}

bool GroupSolver::solve(std::span<Mover> movers, std::span<const int> members, std::span<ContactPoint> points,
                        double tolerance, Effort effort)
{
    free_.clear();
    for (const int member : members) free_.push_back(movers[member]);

    // What was right in the step before most often is right still
    set_start(points);
    warm_start(points, movers);
    if (worst_complaint(points, movers) <=
        rest_tolerance::k_stagnant * std::max(tolerance, rounding_of(points, members.size()))) {
        ++counts_.accepted;
        return true;
    }

    forget_what_suits_worse(movers, members, points);

    // Pieces that are found at once; or from piece to piece, from what is there; or from within; or from nothing
    prepare(members, points, movers.size());
    const Island island{movers, members, points, tolerance};
    best_ = worst_complaint(points, movers);
    kept_.assign(points.begin(), points.end());
    bool content = improve(island, Way::newton);
    for (const Way way : {Way::swept, Way::interior, Way::nothing}) {
        if (content || effort == Effort::brief) break;
        if (way == Way::nothing && points.size() > rest_tolerance::k_most_from_nothing) break;
        go_back_to_best(island);
        content = improve(island, way);
    }
    if (!content) go_back_to_best(island);
    for (const int member : members) local_[member] = -1;
    ++(content ? counts_.solved : counts_.unsolved);
    return content;
}

void GroupSolver::go_back_to_best(const Island& island)
{
    std::copy(kept_.begin(), kept_.end(), island.points.begin());
    restore_free(island.movers, island.members);
    warm_start(island.points, island.movers);
}

bool GroupSolver::improve(const Island& island, Way way)
{
    double before = std::numeric_limits<double>::infinity();
    for (int k = 0; k < rest_tolerance::k_corrections; ++k) {
        measure_slips(island.movers, island.points);
        const bool found =
            k == 0 ? find_pieces(island, way) : find_pieces(island, Way::newton) || find_pieces(island, Way::path);
        if (!found) return false;
        take_impulses(island);
        const double now = worst_complaint(island.points, island.movers);
        const double rounding = std::max(island.tolerance, rounding_of(island.points, island.members.size()));
        const bool content = now <= rounding || (now >= 0.5 * before && now <= rest_tolerance::k_stagnant * rounding);
        if (now < best_ || content) {
            best_ = now;
            kept_.assign(island.points.begin(), island.points.end());
        }
        if (content) return true;
        if (!(now < before)) return false;
        before = now;
    }
    return false;
}

bool GroupSolver::find_pieces(const Island& island, Way way)
{
    const std::span<ContactPoint> points = island.points;
    const int few =
        std::min(static_cast<int>(points.size()) / rest_tolerance::k_path_share + rest_tolerance::k_path_fewest,
                 rest_tolerance::k_path_most);
    const int many = rest_tolerance::k_path_pieces * static_cast<int>(points.size());
    switch (way) {
    case Way::newton:
        return newton(island.movers, points);
    case Way::swept:
        settle_for_sweeps(island.movers, points);
        break;
    case Way::interior:
        start_from_within(island);
        break;
    case Way::nothing:
        for (ContactPoint& c : points) c.normal = c.tangent = 0.0;
        restore_free(island.movers, island.members);
        break;
    case Way::path:
        break;
    }
    measure_slips(island.movers, points);
    if (way == Way::swept) return newton(island.movers, points);
    if (way == Way::nothing) return follow_path(island.movers, points, PathStart::nothing, many);
    return follow_path(island.movers, points, PathStart::impulses, few);
}

void GroupSolver::start_from_within(const Island& island)
{
    restore_free(island.movers, island.members);
    problem_.points = island.points;
    problem_.bodies.assign(free_.begin(), free_.end());
    problem_.seats.clear();
    for (std::size_t k = 0; k < island.points.size(); ++k) {
        const ContactPoint& c = island.points[k];
        problem_.seats.push_back({local_[c.a], local_[c.b], edge_of_[k]});
    }
    measure_slips(island.movers, island.points);
    double top = 0.0; // [m/s]
    for (const double slip : slip_) top = std::isfinite(slip) ? std::max(top, std::abs(slip)) : top;
    problem_.slip.clear();
    for (const double slip : slip_)
        problem_.slip.push_back(std::min(slip, rest_tolerance::k_never_bears * top)); // some may never close
    factorised_ = false;
    (void)interior_.solve(problem_, system_, impulse_, counts_.factorisations);
    take_impulses(island);
}

void GroupSolver::take_impulses(const Island& island)
{
    for (std::size_t k = 0; k < island.points.size(); ++k) {
        island.points[k].normal = impulse_[2 * k];
        island.points[k].tangent = impulse_[2 * k + 1];
    }
    restore_free(island.movers, island.members);
    warm_start(island.points, island.movers);
}

void GroupSolver::measure_slips(std::span<const Mover> movers, std::span<const ContactPoint> points)
{
    // All that follows is in changes from here, so that rounding takes its share of
    // the changes only
    for (std::size_t k = 0; k < points.size(); ++k) {
        const ContactPoint& c = points[k];
        slip_[2 * k] = normal_speed(c, movers[c.a], movers[c.b]) - c.bound;
        slip_[2 * k + 1] = tangent_speed(c, movers[c.a], movers[c.b]);
    }
}

void GroupSolver::guess(std::span<const ContactPoint> points)
{
    // A point that does not part clearly may bear, and holds; it is easier to let go of some than to find all one by
    // one
    double worst = 0.0;
    for (std::size_t k = 0; k < points.size(); ++k) worst = std::max(worst, -slip_[2 * k]);
    for (std::size_t k = 0; k < points.size(); ++k) {
        const ContactPoint& c = points[k];
        const bool bears = c.normal > 0.0 || slip_[2 * k] <= rest_tolerance::k_may_bear * worst;
        mode_[k] = bears ? Mode::stuck : Mode::apart;
        if (bears && c.tangent >= c.friction * c.normal && (c.friction == 0.0 || c.tangent > 0.0))
            mode_[k] = Mode::slips_backwards;
        if (bears && -c.tangent >= c.friction * c.normal && c.tangent < 0.0) mode_[k] = Mode::slips_forwards;
    }
}

bool GroupSolver::newton(std::span<const Mover> movers, std::span<const ContactPoint> points)
{
    guess(points);
    for (int step = 0; step < rest_tolerance::k_newton_steps; ++step) {
        if (!assemble(movers, points)) return false;
        imbalance(points);
        system_.solve(delta_);

        // Where all points do as the pieces say, the pieces were right
        const std::size_t changes = try_points(points);
        if (changes == 0) return true;
    }
    return false;
}

std::size_t GroupSolver::try_points(std::span<const ContactPoint> points)
{
    static constexpr double k_still[3] = {0.0, 0.0, 0.0};
    std::size_t changes = 0;
    for (std::size_t k = 0; k < points.size(); ++k) {
        const ContactPoint& c = points[k];
        const double* of_a = local_[c.a] >= 0 ? &delta_[3 * local_[c.a]] : k_still;
        const double* of_b = local_[c.b] >= 0 ? &delta_[3 * local_[c.b]] : k_still;
        const Line n = normal_line(c);
        const double approach = slip_[2 * k] + (along(n.a, of_a) + along(n.b, of_b));
        const double normal = c.normal - (rest_tolerance::k_stiffness * c.normal_mass) * approach;

        Mode mode = Mode::apart;
        double tangent = 0.0;
        if (normal > 0.0) {
            const Line t = tangent_line(c);
            const double slip = slip_[2 * k + 1] + (along(t.a, of_a) + along(t.b, of_b));
            tangent = c.tangent - (rest_tolerance::k_stiffness * c.tangent_mass) * slip;
            const double most = c.friction * normal;
            mode = Mode::stuck;
            if (tangent > most || c.friction == 0.0) {
                mode = Mode::slips_backwards;
                tangent = most;
            } else if (tangent < -most) {
                mode = Mode::slips_forwards;
                tangent = -most;
            }
        }
        // Between nothing and slip, and between slip and slip the other way, lies holding
        const Mode last = mode_[k];
        const bool from_slip = last == Mode::slips_forwards || last == Mode::slips_backwards;
        const bool to_slip = mode == Mode::slips_forwards || mode == Mode::slips_backwards;
        if (mode != last) ++changes;
        if (mode != last && to_slip && (from_slip || last == Mode::apart) && c.friction > 0.0) mode = Mode::stuck;
        mode_[k] = mode;
        impulse_[2 * k] = std::max(normal, 0.0);
        impulse_[2 * k + 1] = tangent;
    }
    return changes;
}

void GroupSolver::assemble_masses(std::span<const Mover> movers)
{
    system_.clear();
    for (std::size_t k = 0; k < members_.size(); ++k) {
        Block& block = system_.diagonal(static_cast<int>(k));
        block.at[0][0] = block.at[1][1] = 1.0 / movers[members_[k]].inv_mass;
        block.at[2][2] = 1.0 / movers[members_[k]].inv_moment;
    }
}

bool GroupSolver::assemble(std::span<const Mover> movers, std::span<const ContactPoint> points)
{
    if (factorised_ && mode_ == mode_factorised_) return true;
    assemble_masses(movers);

    // A point that bears is a stiff spring along its normal; one that sticks, along its tangent too; one that slips
    // pushes along its tangent what the spring of the normal says
    for (std::size_t k = 0; k < points.size(); ++k) {
        const ContactPoint& c = points[k];
        if (mode_[k] == Mode::apart) continue;
        const bool grips = mode_[k] == Mode::stuck;
        const Line n = normal_line(c);
        const Line t = tangent_line(c);
        const double stiffness_n = rest_tolerance::k_stiffness * c.normal_mass;
        Line left = n;
        if (!grips) {
            const double share = mode_[k] == Mode::slips_backwards ? c.friction : -c.friction;
            add(left.a, share, t.a);
            add(left.b, share, t.b);
        }
        const double stiffness_t = grips ? rest_tolerance::k_stiffness * c.tangent_mass : 0.0;
        const int a = local_[c.a];
        const int b = local_[c.b];
        if (a >= 0) add_product(system_.diagonal(a), stiffness_n, left.a, n.a);
        if (a >= 0 && stiffness_t > 0.0) add_product(system_.diagonal(a), stiffness_t, t.a, t.a);
        if (b >= 0) add_product(system_.diagonal(b), stiffness_n, left.b, n.b);
        if (b >= 0 && stiffness_t > 0.0) add_product(system_.diagonal(b), stiffness_t, t.b, t.b);
        if (edge_of_[k] < 0) continue;
        const BlockSystem::Place& place = system_.place(edge_of_[k]);
        add_product(system_.block(place.first_second), stiffness_n, left.a, n.b);
        add_product(system_.block(place.second_first), stiffness_n, left.b, n.a);
        if (stiffness_t == 0.0) continue;
        add_product(system_.block(place.first_second), stiffness_t, t.a, t.b);
        add_product(system_.block(place.second_first), stiffness_t, t.b, t.a);
    }
    ++counts_.factorisations;
    mode_factorised_ = mode_;
    factorised_ = system_.factorise();
    return factorised_;
}

void GroupSolver::imbalance(std::span<const ContactPoint> points)
{
    // What the pieces push at the speeds before the trial, beyond the impulses that are there
    std::fill(delta_.begin(), delta_.end(), 0.0);
    for (std::size_t k = 0; k < points.size(); ++k) {
        const ContactPoint& c = points[k];
        const double bears = c.normal - (rest_tolerance::k_stiffness * c.normal_mass) * slip_[2 * k];
        double normal = -c.normal;
        double tangent = -c.tangent;
        if (mode_[k] != Mode::apart) normal += bears;
        if (mode_[k] == Mode::stuck) tangent = -(rest_tolerance::k_stiffness * c.tangent_mass) * slip_[2 * k + 1];
        if (mode_[k] == Mode::slips_backwards) tangent += c.friction * bears;
        if (mode_[k] == Mode::slips_forwards) tangent -= c.friction * bears;
        push_members(c, normal, tangent, delta_);
    }
}

} // namespace flying
