#include <algorithm>
#include <cmath>
#include <doctest/doctest.h>
#include <numbers>

#include "crowd.hpp"
#include "gas.hpp"
#include "support/receipts.hpp"

using namespace flying;

namespace {

/// Mean number of side-by-side and of overlapping pairs in so many random rooms.
struct Means
{
    double side_by_side = 0.0;
    double overlapping = 0.0;
};

Means mean_of_rooms(int rooms, int n, double R, double W, double H, Random& random)
{
    Means means;
    for (int k = 0; k < rooms; ++k) {
        Sweep sweep;
        sweep.line_up(discs_in_room(n, R, W, H, random));
        sweep.for_each_side_by_side(
            [&](const auto&, const auto&) { return means.side_by_side += 1.0, true; });
        sweep.for_each_pair([&](int, int) { return means.overlapping += 1.0, true; });
    }
    means.side_by_side /= rooms;
    means.overlapping /= rooms;
    return means;
}

} // namespace


TEST_CASE("all pairs of n bodies are n (n - 1) / 2")
{
    const Aabb box{Vec2(0.0, 0.0), Vec2(1.0, 1.0)};
    std::vector<BoxedBody> bodies;
    for (int n = 1; n <= 60; ++n) {
        bodies.push_back({n - 1, false, box}); // all in one place: every pair overlaps
        long visits = 0;
        for_each_pair_of_all(bodies, [&](int, int) { ++visits; });
        if (n < 2) continue;
        const auto found = static_cast<double>(visits);
        CHECK_EQUATION("pairs.all", found, 0.5 * n * (n - 1), 0.0, {"n", n});
        CHECK_TWIN("pairs.all", found, 0.5 * n * (n + 1), 0.0);
    }
}



TEST_CASE(
    "in a room of random discs as many are side by side, and as many overlap, as areas say")
{
    // Counts of tens of thousands, which their own chance leaves uncertain by less than a
    // hundredth
    constexpr double k_chance = 0.03;
    Random random(911);
    for (const double w : {1.0, 1.5, 2.0, 3.0}) {
        const int n = 60;
        const double W = 10.0;
        const double H = 8.0;
        const double all = 0.5 * n * (n - 1);
        const Means means = mean_of_rooms(600, n, 0.5 * w, W, H, random);
        const double p_x = 1.0 - (1.0 - w / W) * (1.0 - w / W);
        const double p_y = 1.0 - (1.0 - w / H) * (1.0 - w / H);
        CHECK_EQUATION("sweep.chance", means.side_by_side / all, p_x, k_chance, {"w", w},
                       {"W", W});
        CHECK_TWIN("sweep.chance", means.side_by_side / all, 2.0 * w / W, k_chance);
        CHECK_EQUATION("sweep.count", means.side_by_side, all * p_x, k_chance, {"n", n},
                       {"w", w}, {"W", W});
        CHECK_TWIN("sweep.count", means.side_by_side, all * 2.0 * w / W, k_chance);
        CHECK_EQUATION("pairs.overlapping", means.overlapping, all * p_x * p_y, k_chance,
                       {"n", n}, {"p_x", p_x}, {"p_y", p_y});
        CHECK_TWIN("pairs.overlapping", means.overlapping, all * p_x * p_x, k_chance);
    }
}



TEST_CASE("nine cells hold nine cells' share of the bodies")
{
    constexpr double k_chance = 0.02;
    Random random(912);
    for (const double s : {1.0, 1.25, 2.0, 2.5}) {
        const int n = 400;
        const double W = 20.0;
        double found = 0.0;
        int looks = 0;
        for (int room = 0; room < 20; ++room) {
            Grid grid(s, 32, 32, n);
            for (int k = 0; k < n; ++k) {
                const Vec2 x{random.uniform(0.0, W), random.uniform(0.0, W)};
                grid.insert(k, grid.cell_at(x));
            }
            // From every cell that has eight others round it
            const int cells = static_cast<int>(W / s);
            for (int row = 1; row + 1 < cells; ++row) {
                for (int column = 1; column + 1 < cells; ++column) {
                    grid.for_each_near({column, row}, [&](int) { found += 1.0; });
                    ++looks;
                }
            }
        }
        const double rho = n / (W * W);
        CHECK_EQUATION("grid.compared", found / looks, 9.0 * rho * s * s, k_chance,
                       {"\\rho", rho}, {"s", s});
        CHECK_TWIN("grid.compared", found / looks, 8.0 * rho * s * s, k_chance);
    }
}



TEST_CASE("a body that flies straight crosses 4 v / (pi s) borders a second, on average "
          "over directions")
{
    Random random(913);
    for (int i = 0; i < 20; ++i) {
        const double v = random.uniform(0.5, 5.0);
        const double s = random.uniform(0.5, 3.0);
        const double T = 1000.0 * s / v;
        const Grid grid(s, 4, 4, 1);
        double borders = 0.0;
        constexpr int k_ways = 1000;
        for (int k = 0; k < k_ways; ++k) {
            const double theta = 2.0 * std::numbers::pi * (k + 0.5) / k_ways;
            const Vec2 x{random.uniform(0.0, s), random.uniform(0.0, s)};
            const Cell from = grid.cell_at(x);
            const Cell to =
                grid.cell_at(x + T * v * Vec2(std::cos(theta), std::sin(theta)));
            borders += static_cast<double>(std::abs(to.column - from.column) +
                                           std::abs(to.row - from.row));
        }
        // A border more or less in a thousand, at random
        const double found = borders / (k_ways * T);
        CHECK_EQUATION("grid.crossings", found, 4.0 * v / (std::numbers::pi * s), 1e-3,
                       {"v", v}, {"s", s});
        CHECK_TWIN("grid.crossings", found, 2.0 * v / (std::numbers::pi * s), 1e-3);
    }
}



TEST_CASE("the engine's cells are those that are best where a change of cells costs one and a "
          "half comparisons")
{
    Random random(914);
    for (int i = 0; i < 1000; ++i) {
        const double W = random.uniform(5.0, 50.0);
        const double H = random.uniform(5.0, 50.0);
        const int n = 1 + random.below(500);
        const double rho = n / (W * H);
        const double s = make_grid({Vec2::Zero(), Vec2(W, H)}, 0.01, n, n).cell_size();
        CHECK_EQUATION("grid.best", s, std::sqrt(1.5 / (3.0 * rho)), 1e-15, {"c", 1.5},
                       {"\\rho", rho});
        CHECK_TWIN("grid.best", s, std::sqrt(1.5 / (9.0 * rho)), 1e-15);
    }
}


// [which-pairs.tests.wrong]
TEST_CASE("an index over velocities finds the overlaps of those whose velocities are near, "
          "and the oracle tells")
{
    double found = 0.0;
    double all = 0.0;
    for (std::uint64_t seed = 0; seed < 40; ++seed) {
        const Crowd crowd = make_crowd(1000, 34.5, 6.25, 9400 + seed);
        Pairs right = crowd.find(Index::position);
        Pairs wrong = crowd.find(Index::velocity);
        std::sort(right.begin(), right.end());
        std::sort(wrong.begin(), wrong.end());
        CHECK(wrong != right); // this finds it, and nothing else does
        CHECK(std::includes(right.begin(), right.end(), wrong.begin(), wrong.end()));
        found += static_cast<double>(wrong.size());
        all += static_cast<double>(right.size());
    }
    const double share = (28.0 / 100.0) * (28.0 / 100.0);
    CHECK_EQUATION("pairs.wrong_share", found / all, share, 0.05, {"z", 10});
    CHECK_TWIN("pairs.wrong_share", found / all, 9.0 / 100.0, 0.05);
}
// [which-pairs.tests.wrong]


TEST_CASE("whichever index finds the pairs, energy stays: it can't tell a wrong index from "
          "a right one")
{
    for (const Index index : {Index::position, Index::velocity}) {
        Crowd crowd = make_crowd(60, 20.0, 6.25, 95);
        const double before = crowd.energy();
        std::size_t overlapping = 0;
        for (int k = 0; k < 600; ++k) {
            crowd.step(index, 1.0 / 60.0);
            if (k >= 300) overlapping += crowd.find(Index::position).size();
        }
        CHECK(std::abs(crowd.energy() - before) < 1e-12 * before);
        if (index == Index::velocity) CHECK(overlapping > 1000);
    }
}



TEST_CASE("few bodies are compared with all others for less than it takes to keep cells: "
          "many are not")
{
    CHECK(work(count_work(8, PairFinder::all_pairs)) <
          work(count_work(8, PairFinder::grid)));
    CHECK(work(count_work(32, PairFinder::all_pairs)) >
          work(count_work(32, PairFinder::grid)));
    CHECK(count_work(32, PairFinder::all_pairs).impacts ==
          count_work(32, PairFinder::grid).impacts);
}

