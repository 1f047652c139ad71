#include <doctest/doctest.h>

#include FLYING_ANSWER

#include <algorithm>
#include <cmath>
#include <set>

#include "math/random.hpp"
#include "support/say_lists.hpp"

using namespace flying;

namespace {

std::vector<Disc> crowd(std::uint64_t seed)
{
    Random random(seed);
    std::vector<Disc> discs;
    const int count = 3 + random.below(20);
    for (int k = 0; k < count; ++k) {
        Disc disc;
        disc.position = Vec2(random.uniform(0.0, 14.0), random.uniform(0.0, 14.0));
        disc.leans = random.below(4) == 0;
        const double speed = disc.leans ? 0.5 : 8.0;
        disc.velocity = Vec2(random.uniform(-speed, speed), random.uniform(-speed, speed));
        disc.radius = random.uniform(0.2, 0.6);
        discs.push_back(disc);
    }
    return discs;
}

/// Nearest approach of a centre on its way to a place, by looking often.
double nearest(const Disc& flyer, const Vec2& place, double d)
{
    double least = 1e300;
    for (int k = 0; k <= 400; ++k) {
        least = std::min(least, (flyer.position + k / 400.0 * d * flyer.velocity - place).norm());
    }
    return least;
}

/// Whether a flyer must come, where these lean.  slack  on the reach [m]
bool must_come(const std::vector<Disc>& discs, const std::set<int>& leaning, int k, double d, double slack)
{
    double v = 0.0;
    for (const int other : leaning) v = std::max(v, discs[other].velocity.norm());
    return std::any_of(leaning.begin(), leaning.end(), [&](int other) {
        const double reach = discs[k].radius + discs[other].radius + 2.0 * v * d + slack;
        return nearest(discs[k], discs[other].position, d) < reach;
    });
}

std::set<int> leaning_of(const std::vector<Disc>& discs)
{
    std::set<int> leaning;
    for (int k = 0; k < static_cast<int>(discs.size()); ++k) {
        if (discs[k].leans) leaning.insert(k);
    }
    return leaning;
}

constexpr double k_d = 0.1; // [s]

} // namespace

TEST_CASE("no disc is taken in for nothing")
{
    for (std::uint64_t seed = 1; seed <= 300; ++seed) {
        const std::vector<Disc> discs = crowd(seed);
        std::set<int> leaning = leaning_of(discs);
        std::vector<int> left = taken_in(discs, k_d);

        // One after another, each must be near some that were there before
        for (bool changed = true; changed;) {
            changed = false;
            for (std::size_t i = 0; i < left.size(); ++i) {
                if (!must_come(discs, leaning, left[i], k_d, 1e-3)) continue;
                leaning.insert(left[i]);
                left.erase(left.begin() + static_cast<std::ptrdiff_t>(i));
                changed = true;
                break;
            }
        }
        CHECK(left.empty());
    }
}

TEST_CASE("no flyer is left out that may meet one that leans, or one that was taken in")
{
    int left_out = 0;
    for (std::uint64_t seed = 1; seed <= 300; ++seed) {
        const std::vector<Disc> discs = crowd(seed);
        std::set<int> leaning = leaning_of(discs);
        const std::vector<int> taken = taken_in(discs, k_d);
        leaning.insert(taken.begin(), taken.end());
        for (int k = 0; k < static_cast<int>(discs.size()); ++k) {
            if (leaning.count(k) > 0) continue;
            ++left_out;
            CHECK_FALSE(must_come(discs, leaning, k, k_d, -1e-3));
        }
    }
    CHECK(left_out > 500);
}

TEST_CASE("the set doesn't depend on the order of the discs, and is given in ascending order")
{
    for (std::uint64_t seed = 1; seed <= 100; ++seed) {
        std::vector<Disc> discs = crowd(seed);
        const std::vector<int> taken = taken_in(discs, k_d);
        CHECK(std::is_sorted(taken.begin(), taken.end()));
        std::reverse(discs.begin(), discs.end());
        std::vector<int> mirrored;
        for (const int k : taken_in(discs, k_d)) mirrored.push_back(static_cast<int>(discs.size()) - 1 - k);
        std::sort(mirrored.begin(), mirrored.end());
        CHECK(mirrored == taken);
    }
}
