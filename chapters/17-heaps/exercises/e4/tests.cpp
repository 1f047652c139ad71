#include <numeric>

#include <doctest/doctest.h>

#include FLYING_ANSWER

#include "math/random.hpp"

namespace {

using Pairs = std::vector<std::pair<int, int>>;

/// The same with numbers: eliminates a full matrix, and counts what is not zero when its row goes.
int eliminated(int count, const Pairs& pairs, const std::vector<int>& order, flying::Random& random)
{
    std::vector<std::vector<double>> m(count, std::vector<double>(count, 0.0));
    for (int k = 0; k < count; ++k) m[k][k] = 100.0;
    for (const auto& [a, b] : pairs) m[a][b] = m[b][a] = random.uniform(0.5, 1.0);
    std::vector<char> gone(count, 0);
    int sum = 0;
    for (const int k : order) {
        gone[k] = 1;
        for (int i = 0; i < count; ++i) {
            if (gone[i] || m[i][k] == 0.0) continue;
            ++sum;
            const double share = m[i][k] / m[k][k];
            for (int j = 0; j < count; ++j)
                if (!gone[j]) m[i][j] -= share * m[k][j];
        }
    }
    return sum;
}

std::vector<int> in_order(int count)
{
    std::vector<int> order(count);
    std::iota(order.begin(), order.end(), 0);
    return order;
}

} // namespace

TEST_CASE("a chain fills in nothing, a ring doubles")
{
    Pairs pairs;
    for (int k = 1; k < 20; ++k) pairs.emplace_back(k - 1, k);
    CHECK(blocks(20, pairs, in_order(20)) == 19);
    pairs.emplace_back(0, 19);
    CHECK(blocks(20, pairs, in_order(20)) == 37);
}

TEST_CASE("a star is cheap if its middle goes last, and full if it goes first")
{
    Pairs pairs;
    for (int k = 1; k < 10; ++k) pairs.emplace_back(0, k);
    CHECK(blocks(10, pairs, in_order(10)) == 45);
    CHECK(blocks(10, pairs, {1, 2, 3, 4, 5, 6, 7, 8, 9, 0}) == 9);
}

TEST_CASE("blocks are the numbers of a full matrix that are not zero")
{
    flying::Random random(1742);
    for (int i = 0; i < 60; ++i) {
        const int count = 3 + i % 12;
        const auto any = [&](int below) { return static_cast<int>(random.uniform(0.0, below - 1e-9)); };
        Pairs pairs;
        for (int k = 0; k < 2 * count; ++k) {
            const int a = any(count);
            const int b = any(count);
            if (a != b) pairs.emplace_back(a, b);
        }
        std::vector<int> order = in_order(count);
        for (int k = count - 1; k > 0; --k) std::swap(order[k], order[any(k + 1)]);
        CHECK(blocks(count, pairs, order) == eliminated(count, pairs, order, random));
    }
}
