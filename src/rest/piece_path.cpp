#include "rest/piece_path.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "rest/rest_tolerance.hpp"

namespace flying {
namespace {

/// 2^32 over the golden section: multiples of it, modulo 2^32, lie far from each other.
constexpr std::uint32_t k_golden = 2654435769U;

/// Friction is at its limit, against this slip.
[[nodiscard]] bool slips_on(const ContactPoint& c, double slip)
{
    const double most = c.friction * c.normal;
    return (c.tangent >= most && slip < 0.0) || (c.tangent <= -most && slip > 0.0);
}

} // namespace

bool PiecePath::follow(PieceSystem& pieces, ContactProblem& problem, int most)
{
    shift_.assign(2 * problem.points.size(), 0.0);
    shift_from_impulses(problem);
    double left = 1.0;
    start_springs(pieces, problem, left);
    double first = 1.0;
    Turn last;
    for (int piece = 0; piece < most; ++piece) {
        if (!pieces.factorise(problem)) return false;
        push_shifts(pieces, problem);
        pieces.solve();
        if (piece == 0) first = pieces.orientation();
        const double sign = first * pieces.orientation();
        measure_rates(pieces, problem, sign);
        // Backwards it comes to a turn, or from nowhere
        const double within = sign > 0.0 ? left : std::numeric_limits<double>::infinity();
        const Turn next = next_turn(pieces, problem, last, within);
        if (std::isinf(next.way)) return false;
        left -= sign * next.way;
        for (Springs& s : springs_) {
            s.normal += next.way * s.normal_rate;
            s.tangent += next.way * s.tangent_rate;
        }
        if (next.point < 0) {
            take_springs(pieces, problem);
            return true;
        }
        pieces.set_mode(next.point, next.to);
        last = next;
    }
    return false;
}

/// Shifts of speeds with which the impulses that are there are right; with none, no point closes. No two are alike, and
/// none leaves a point between bearing and parting, or between holding and slipping: from there the path could lead
/// anywhere. Boxes in a row on a slope all start to slide at once, and bear nothing on each other.
void PiecePath::shift_from_impulses(const ContactProblem& problem)
{
    const auto spread = [](std::size_t k) {
        return 1.0 + static_cast<double>(static_cast<std::uint32_t>(k + 1) * k_golden) * 0x1p-32;
    };
    double top = 0.0; // [m/s]
    for (std::size_t k = 0; k < problem.points.size(); ++k) {
        const ContactPoint& c = problem.points[k];
        const double* const slip = &problem.slip[2 * k];
        if (!(c.normal > 0.0)) {
            top = std::max(top, -slip[0] / spread(k));
            continue;
        }
        shift_[2 * k] = -slip[0];
        if (!slips_on(c, slip[1])) shift_[2 * k + 1] = -slip[1];
        top = std::max({top, std::abs(shift_[2 * k]), std::abs(shift_[2 * k + 1])});
    }
    for (std::size_t k = 0; k < problem.points.size(); ++k) {
        const ContactPoint& c = problem.points[k];
        const double slip = problem.slip[2 * k + 1];
        const double most = c.friction * c.normal;
        const double far = spread(k) * top;
        if (!(c.normal > 0.0)) shift_[2 * k] = far;
        else if (c.tangent >= most) shift_[2 * k + 1] = std::min(0.0, -far - slip);
        else if (c.tangent <= -most) shift_[2 * k + 1] = std::max(0.0, far - slip);
    }
}

void PiecePath::start_springs(PieceSystem& pieces, const ContactProblem& problem, double left)
{
    springs_.clear();
    for (std::size_t k = 0; k < problem.points.size(); ++k) {
        const ContactPoint& c = problem.points[k];
        const double approach = problem.slip[2 * k] + left * shift_[2 * k];
        const double slip = problem.slip[2 * k + 1] + left * shift_[2 * k + 1];
        const double normal = c.normal - pieces.spring(k).normal * approach;
        const double tangent = c.tangent - pieces.spring(k).tangent * slip;
        springs_.push_back({normal, tangent, 0.0, 0.0});
        Mode mode = Mode::stuck;
        if (!(normal > 0.0)) mode = Mode::apart;
        else if (c.friction == 0.0 || tangent > c.friction * normal) mode = Mode::slips_backwards;
        else if (tangent < -c.friction * normal) mode = Mode::slips_forwards;
        pieces.set_mode(k, mode);
    }
}

void PiecePath::push_shifts(PieceSystem& pieces, const ContactProblem& problem) const
{
    pieces.clear_pushes();
    for (std::size_t k = 0; k < problem.points.size(); ++k) {
        const Mode mode = pieces.mode(k);
        if (mode == Mode::apart) continue;
        const ContactPoint& c = problem.points[k];
        const double normal = pieces.spring(k).normal * shift_[2 * k];
        double tangent = 0.0;
        if (mode == Mode::stuck) tangent = pieces.spring(k).tangent * shift_[2 * k + 1];
        if (mode == Mode::slips_backwards) tangent = c.friction * normal;
        if (mode == Mode::slips_forwards) tangent = -c.friction * normal;
        pieces.push(problem, k, normal, tangent);
    }
}

void PiecePath::measure_rates(const PieceSystem& pieces, const ContactProblem& problem, double sign)
{
    for (std::size_t k = 0; k < problem.points.size(); ++k) {
        const PieceSystem::Change change = pieces.change(problem, k);
        const double closing = shift_[2 * k] - change.normal;
        const double slipping = shift_[2 * k + 1] - change.tangent;
        springs_[k].normal_rate = sign * pieces.spring(k).normal * closing;
        springs_[k].tangent_rate = sign * pieces.spring(k).tangent * slipping;
    }
}

/// The first point that changes what it does, within so much of the path; not back to what the last has just left.
PiecePath::Turn PiecePath::next_turn(const PieceSystem& pieces, const ContactProblem& problem, const Turn& last,
                                     double within) const
{
    Turn next;
    next.way = within;
    for (int k = 0; k < static_cast<int>(problem.points.size()); ++k) {
        const Mode now = pieces.mode(k);
        const Springs& s = springs_[k];
        const double mu = problem.points[k].friction;
        // What is positive as long as nothing changes
        const auto ends = [&](double value, double rate, Mode to) {
            if (!(rate < 0.0) || (k == last.point && to == last.from)) return;
            const double way = std::max(value, 0.0) / -rate;
            if (way < next.way) next = {k, now, to, way};
        };
        if (now == Mode::apart) {
            const double tangent = s.tangent;
            ends(-s.normal, -s.normal_rate, mu == 0.0 || tangent > 0.0 ? Mode::slips_backwards : Mode::slips_forwards);
            continue;
        }
        ends(s.normal, s.normal_rate, Mode::apart);
        if (mu == 0.0) continue;
        const double above = mu * s.normal - s.tangent;
        const double below = mu * s.normal + s.tangent;
        const double above_rate = mu * s.normal_rate - s.tangent_rate;
        const double below_rate = mu * s.normal_rate + s.tangent_rate;
        if (now == Mode::stuck) {
            ends(above, above_rate, Mode::slips_backwards);
            ends(below, below_rate, Mode::slips_forwards);
        } else if (now == Mode::slips_backwards) ends(-above, -above_rate, Mode::stuck);
        else ends(-below, -below_rate, Mode::stuck);
    }
    // What comes to bear slips the way that it moves when it does
    const bool comes = next.point >= 0 && next.from == Mode::apart && problem.points[next.point].friction > 0.0;
    if (comes) {
        const Springs& s = springs_[next.point];
        next.to = s.tangent + next.way * s.tangent_rate > 0.0 ? Mode::slips_backwards : Mode::slips_forwards;
    }
    return next;
}

void PiecePath::take_springs(const PieceSystem& pieces, ContactProblem& problem) const
{
    for (std::size_t k = 0; k < problem.points.size(); ++k) {
        const double normal = pieces.mode(k) == Mode::apart ? 0.0 : std::max(springs_[k].normal, 0.0);
        const double most = problem.points[k].friction * normal;
        problem.impulse[2 * k] = normal;
        problem.impulse[2 * k + 1] = std::clamp(springs_[k].tangent, -most, most);
    }
}

} // namespace flying
