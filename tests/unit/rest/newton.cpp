// Newton's method on pieces ends where a guess comes again. What a guess leads to depends on nothing else, so that a
// search which goes on must come to the same.

#include <algorithm>
#include <cmath>
#include <vector>

#include <doctest/doctest.h>

#include "math/random.hpp"
#include "rest/piece_system.hpp"

using namespace flying;

namespace {

using Mode = PieceSystem::Mode;

/// Bodies in a row on a floor, the lowest body, and points between neighbours along any lines.
struct Jumble
{
    std::vector<Mover> movers;
    std::vector<int> members;
    std::vector<ContactPoint> points;
};

Jumble jumble(Random& random)
{
    Jumble all;
    const int count = 2 + random.below(5);
    all.movers.resize(count + 1);
    for (int k = 1; k <= count; ++k) {
        Mover& body = all.movers[k];
        body = {random.uniform(-1.0, 1.0), random.uniform(-2.0, 0.0), random.uniform(-2.0, 2.0),
                random.uniform(0.5, 2.0), random.uniform(0.5, 8.0)};
        all.members.push_back(k);
    }
    for (int b = 1; b <= count; ++b) {
        for (int k = 0; k < 4; ++k) {
            ContactPoint& c = all.points.emplace_back();
            c.a = k < 2 ? 0 : b - 1;
            c.b = b;
            const double angle = random.uniform(0.5, 2.6);
            c.n_x = std::cos(angle);
            c.n_y = std::sin(angle);
            for (double* arm : {&c.normal_arm_a, &c.normal_arm_b, &c.tangent_arm_a, &c.tangent_arm_b})
                *arm = random.uniform(-1.0, 1.0);
            const Mover& one = all.movers[c.a];
            const Mover& two = all.movers[c.b];
            const auto mass = [&](double arm_a, double arm_b) {
                return 1.0 / (one.inv_mass + two.inv_mass + one.inv_moment * (arm_a * arm_a) +
                              two.inv_moment * (arm_b * arm_b));
            };
            c.normal_mass = mass(c.normal_arm_a, c.normal_arm_b);
            c.tangent_mass = mass(c.tangent_arm_a, c.tangent_arm_b);
            c.friction = random.uniform(0.1, 1.5);
        }
    }
    return all;
}

/// All steps that there may be, from the same first guess, whether guesses come again or not. No point has a past.
bool find_in_all_steps(PieceSystem& pieces, ContactProblem& problem)
{
    const double stiffness = rest_tolerance::k_stiffness;
    for (std::size_t k = 0; k < problem.points.size(); ++k)
        pieces.set_mode(k, problem.slip[2 * k] <= 0.0 ? Mode::stuck : Mode::apart);
    for (int step = 0; step < rest_tolerance::k_quick_rounds + rest_tolerance::k_few_rounds; ++step) {
        if (!pieces.factorise(problem)) return false;
        pieces.clear_pushes();
        for (std::size_t k = 0; k < problem.points.size(); ++k) {
            const ContactPoint& c = problem.points[k];
            const Mode mode = pieces.mode(k);
            const double bears = mode == Mode::apart ? 0.0 : -(stiffness * c.normal_mass) * problem.slip[2 * k];
            double tangent = mode == Mode::stuck ? -(stiffness * c.tangent_mass) * problem.slip[2 * k + 1] : 0.0;
            if (mode == Mode::slips_backwards) tangent = c.friction * bears;
            if (mode == Mode::slips_forwards) tangent = -c.friction * bears;
            pieces.push(problem, k, bears, tangent);
        }
        pieces.solve();
        bool agrees = true;
        for (std::size_t k = 0; k < problem.points.size(); ++k) {
            const ContactPoint& c = problem.points[k];
            const PieceSystem::Change change = pieces.change(problem, k);
            const double normal = -(stiffness * c.normal_mass) * (problem.slip[2 * k] + change.normal);
            const double tangent = -(stiffness * c.tangent_mass) * (problem.slip[2 * k + 1] + change.tangent);
            const double most = c.friction * normal;
            Mode mode = Mode::stuck;
            if (!(normal > 0.0)) mode = Mode::apart;
            else if (tangent > most) mode = Mode::slips_backwards;
            else if (tangent < -most) mode = Mode::slips_forwards;
            agrees = agrees && mode == pieces.mode(k);
            const bool slips = mode == Mode::slips_backwards || mode == Mode::slips_forwards;
            pieces.set_mode(k, slips && mode != pieces.mode(k) && pieces.mode(k) != Mode::stuck ? Mode::stuck : mode);
            problem.impulse[2 * k] = mode == Mode::apart ? 0.0 : normal;
            problem.impulse[2 * k + 1] = mode == Mode::apart ? 0.0 : std::clamp(tangent, -most, most);
        }
        if (agrees) return true;
    }
    return false;
}

} // namespace

TEST_CASE("a search by Newton's method that ends where a guess comes again finds what all its steps would find")
{
    Random random(1126);
    int found = 0;
    int lost = 0;
    int ended_early = 0;
    for (int number = 0; number < 4000; ++number) {
        CAPTURE(number);
        const Jumble all = jumble(random);
        const auto begin = [&](PieceSystem& pieces, ContactProblem& problem) {
            problem.points = all.points;
            for (const int member : all.members) problem.bodies.push_back(all.movers[member]);
            pieces.begin(problem, all.members, all.movers.size());
            measure_slips(problem, all.movers);
        };
        PieceSystem one;
        ContactProblem problem;
        begin(one, problem);
        const bool is_found = find_by_newton(one, problem);
        PieceSystem other;
        ContactProblem oracle;
        begin(other, oracle);
        REQUIRE(is_found == find_in_all_steps(other, oracle));
        if (is_found) REQUIRE(problem.impulse == oracle.impulse);
        (is_found ? found : lost) += 1;
        ended_early += !is_found && one.factorisations() < other.factorisations() ? 1 : 0;
    }
    MESSAGE(found << " found; of " << lost << " others " << ended_early << " ended early");
    CHECK(found > 400);
    CHECK(ended_early > 100);
}
