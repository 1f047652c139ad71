#include "rest/piece_system.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "rest/push_lines.hpp"
#include "rest/rest_tolerance.hpp"

namespace flying {

void PieceSystem::begin(ContactProblem& problem, std::span<const int> members, std::size_t movers)
{
    // Number the members, and find which are coupled; all that is static is one more
    const int ground = static_cast<int>(members.size());
    number_.resize(movers);
    for (const ContactPoint& c : problem.points) number_[c.a] = number_[c.b] = ground;
    for (int k = 0; k < ground; ++k) number_[members[k]] = k;
    edges_.clear();
    problem.seats.clear();
    for (const ContactPoint& c : problem.points) {
        ContactProblem::Seat seat{number_[c.a], number_[c.b], -1};
        if (seat.a < ground && seat.b < ground) {
            const bool same = !edges_.empty() && edges_.back().first == seat.a && edges_.back().second == seat.b;
            if (!same) edges_.push_back({seat.a, seat.b});
            seat.edge = static_cast<int>(edges_.size()) - 1;
        }
        problem.seats.push_back(seat);
    }
    blocks_.set_pattern(ground, edges_);
    delta_.resize(3 * members.size() + 3);
    problem.slip.resize(2 * problem.points.size());
    problem.impulse.resize(2 * problem.points.size());
    modes_.resize(problem.points.size());
    set_hard(problem);
}

void PieceSystem::set_hard(const ContactProblem& problem)
{
    double least = std::numeric_limits<double>::infinity(); // of the inverse masses [1/kg]
    for (const Mover& body : problem.bodies) least = std::min(least, body.inv_mass);
    const double light = 1.0 / (rest_tolerance::k_unequal_masses * least); // [kg]
    const auto stiffness = [&](double inertia) {
        return rest_tolerance::k_stiffness * (inertia < light ? std::sqrt(inertia * light) : inertia);
    };
    springs_.clear();
    for (const ContactPoint& c : problem.points)
        springs_.push_back({stiffness(c.normal_mass), stiffness(c.tangent_mass)});
    is_factorised_ = false;
}

void PieceSystem::set_soft(const ContactProblem& problem)
{
    double sum = 0.0;
    for (const ContactPoint& c : problem.points) sum += c.normal_mass;
    const double mean = sum / static_cast<double>(problem.points.size());
    const auto stiffness = [&](double inertia) { return rest_tolerance::k_soft_stiffness * std::sqrt(inertia * mean); };
    for (std::size_t k = 0; k < springs_.size(); ++k)
        springs_[k] = {stiffness(problem.points[k].normal_mass), stiffness(problem.points[k].tangent_mass)};
    is_factorised_ = false;
}

bool PieceSystem::factorise(const ContactProblem& problem)
{
    if (is_factorised_ && modes_ == modes_factorised_) return true;
    assemble(problem);
    ++factorisations_;
    modes_factorised_ = modes_;
    is_factorised_ = blocks_.factorise();
    return is_factorised_;
}

void PieceSystem::assemble(const ContactProblem& problem)
{
    blocks_.clear();
    const int ground = static_cast<int>(problem.bodies.size());
    for (std::size_t k = 0; k < problem.bodies.size(); ++k) {
        Block& block = blocks_.diagonal(static_cast<int>(k));
        block.at[0][0] = block.at[1][1] = 1.0 / problem.bodies[k].inv_mass;
        block.at[2][2] = 1.0 / problem.bodies[k].inv_moment;
    }
    for (std::size_t k = 0; k < problem.points.size(); ++k) {
        if (modes_[k] == Mode::apart) continue;
        const ContactPoint& c = problem.points[k];
        const auto [a, b, edge] = problem.seats[k];
        const bool grips = modes_[k] == Mode::stuck;
        const PairRow n = normal_line(c);
        const PairRow t = tangent_line(c);
        PairRow left = n;
        if (!grips) {
            const double share = modes_[k] == Mode::slips_backwards ? c.friction : -c.friction;
            add(left.a, share, t.a);
            add(left.b, share, t.b);
        }
        const BlockSystem::Edge pair{a < ground ? a : -1, b < ground ? b : -1};
        blocks_.add(pair, edge, springs_[k].normal, left, n);
        if (grips) blocks_.add(pair, edge, springs_[k].tangent, t, t);
    }
}

void PieceSystem::clear_pushes()
{
    std::fill(delta_.begin(), delta_.end(), 0.0);
}

void PieceSystem::push(const ContactProblem& problem, std::size_t point, double normal, double tangent)
{
    const PushOnBoth p = push_on_both(problem.points[point], normal, tangent);
    double* a = &delta_[3 * problem.seats[point].a];
    double* b = &delta_[3 * problem.seats[point].b];
    a[0] -= p.x;
    a[1] -= p.y;
    a[2] -= p.moment_a;
    b[0] += p.x;
    b[1] += p.y;
    b[2] += p.moment_b;
}

void PieceSystem::solve()
{
    blocks_.solve(std::span(delta_).first(delta_.size() - 3));
    std::fill(delta_.end() - 3, delta_.end(), 0.0); // what is static stays
}

void PieceSystem::solve_stuck()
{
    blocks_.solve_symmetric(std::span(delta_).first(delta_.size() - 3));
    std::fill(delta_.end() - 3, delta_.end(), 0.0);
}

PieceSystem::Change PieceSystem::change(const ContactProblem& problem, std::size_t point) const
{
    const ContactPoint& c = problem.points[point];
    const double* a = &delta_[3 * problem.seats[point].a];
    const double* b = &delta_[3 * problem.seats[point].b];
    const double x = b[0] - a[0];
    const double y = b[1] - a[1];
    return {normal_speed(c, x, y, a[2], b[2]), tangent_speed(c, x, y, a[2], b[2])};
}

void measure_slips(ContactProblem& problem, std::span<const Mover> movers)
{
    for (std::size_t k = 0; k < problem.points.size(); ++k) {
        const ContactPoint& c = problem.points[k];
        problem.slip[2 * k] = normal_speed(c, movers[c.a], movers[c.b]) - c.bound;
        problem.slip[2 * k + 1] = tangent_speed(c, movers[c.a], movers[c.b]);
        problem.impulse[2 * k] = c.normal;
        problem.impulse[2 * k + 1] = c.tangent;
    }
}

namespace {

using Mode = PieceSystem::Mode;

/// A point that bore, or doesn't part, may bear, and holds: it is easier to let go of some than to find all one by one.
void guess(PieceSystem& pieces, const ContactProblem& problem)
{
    for (std::size_t k = 0; k < problem.points.size(); ++k) {
        const ContactPoint& c = problem.points[k];
        const double most = c.friction * c.normal;
        Mode mode = Mode::apart;
        if (c.normal > 0.0 || problem.slip[2 * k] <= 0.0) {
            mode = Mode::stuck;
            if (c.tangent >= most && (c.friction == 0.0 || c.tangent > 0.0)) mode = Mode::slips_backwards;
            if (-c.tangent >= most && c.tangent < 0.0) mode = Mode::slips_forwards;
        }
        pieces.set_mode(k, mode);
    }
}

/// What the pieces push at the speeds before the trial, beyond the impulses that are there.
void push_imbalance(PieceSystem& pieces, const ContactProblem& problem)
{
    pieces.clear_pushes();
    for (std::size_t k = 0; k < problem.points.size(); ++k) {
        const ContactPoint& c = problem.points[k];
        const double bears = c.normal - pieces.spring(k).normal * problem.slip[2 * k];
        double normal = -c.normal;
        double tangent = -c.tangent;
        const Mode mode = pieces.mode(k);
        if (mode != Mode::apart) normal += bears;
        if (mode == Mode::stuck) tangent = -pieces.spring(k).tangent * problem.slip[2 * k + 1];
        if (mode == Mode::slips_backwards) tangent += c.friction * bears;
        if (mode == Mode::slips_forwards) tangent -= c.friction * bears;
        pieces.push(problem, k, normal, tangent);
    }
}

/// What a point would do, and what it would push, if its springs had their say alone.
struct Wish
{
    Mode mode = Mode::apart;
    double normal = 0.0;  ///< [N s]
    double tangent = 0.0; ///< [N s]
};
[[nodiscard]] Wish wish_of(const PieceSystem& pieces, const ContactProblem& problem, std::size_t k)
{
    const ContactPoint& c = problem.points[k];
    const PieceSystem::Change change = pieces.change(problem, k);
    const double normal = c.normal - pieces.spring(k).normal * (problem.slip[2 * k] + change.normal);
    if (!(normal > 0.0)) return {};
    const double tangent = c.tangent - pieces.spring(k).tangent * (problem.slip[2 * k + 1] + change.tangent);
    const double most = c.friction * normal;
    if (tangent > most || c.friction == 0.0) return {Mode::slips_backwards, normal, most};
    if (tangent < -most) return {Mode::slips_forwards, normal, -most};
    return {Mode::stuck, normal, tangent};
}

[[nodiscard]] bool is_slip(Mode mode)
{
    return mode == Mode::slips_forwards || mode == Mode::slips_backwards;
}

/// Takes what all points wish; returns how many of them wish to do something else than they were taken to do.
[[nodiscard]] std::size_t take_wishes(PieceSystem& pieces, ContactProblem& problem)
{
    std::size_t changes = 0;
    for (std::size_t k = 0; k < problem.points.size(); ++k) {
        const Wish wish = wish_of(pieces, problem, k);
        problem.impulse[2 * k] = wish.normal;
        problem.impulse[2 * k + 1] = wish.tangent;
        const Mode last = pieces.mode(k);
        if (wish.mode == last) continue;
        ++changes;
        // Between nothing and slip, and between slip and slip the other way, lies holding
        const bool skips_holding = is_slip(wish.mode) && last != Mode::stuck && problem.points[k].friction > 0.0;
        pieces.set_mode(k, skips_holding ? Mode::stuck : wish.mode);
    }
    return changes;
}

} // namespace

bool find_by_newton(PieceSystem& pieces, ContactProblem& problem, Effort effort)
{
    guess(pieces, problem);
    constexpr int k_most = rest_tolerance::k_quick_rounds + rest_tolerance::k_few_rounds;
    std::size_t last_changes = problem.points.size() + 1;
    std::vector<Mode> met; // an earlier guess; one that comes again would come for ever (Brent 1980)
    for (int step = 1; step <= k_most; ++step) {
        if (!pieces.factorise(problem)) return false;
        push_imbalance(pieces, problem);
        pieces.solve();
        const std::size_t changes = take_wishes(pieces, problem);
        if (changes == 0) return true;
        // From near its end each guess changes less than the last one; in a heap that moves a search soon doesn't
        if (effort == Effort::brief && changes >= last_changes) return false;
        last_changes = changes;
        if (pieces.modes() == met) return false;
        if (std::has_single_bit(static_cast<unsigned>(step))) met = pieces.modes();
    }
    return false;
}

} // namespace flying
