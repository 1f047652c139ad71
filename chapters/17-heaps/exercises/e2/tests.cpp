#include <doctest/doctest.h>

#include FLYING_ANSWER

#include "math/random.hpp"
#include "support/say_lists.hpp"

namespace {

using Pairs = std::vector<std::pair<int, int>>;

/// The same by walking from body to body, as long as there is anything new.
std::vector<int> walk(int count, const Pairs& pairs, const std::vector<char>& moves)
{
    std::vector<int> result(count, -1);
    for (int k = 0; k < count; ++k) {
        if (!moves[k] || result[k] >= 0) continue;
        std::vector<int> waiting = {k};
        result[k] = k;
        while (!waiting.empty()) {
            const int here = waiting.back();
            waiting.pop_back();
            for (const auto& [a, b] : pairs) {
                const int other = a == here ? b : b == here ? a : -1;
                if (other < 0 || !moves[other] || result[other] >= 0) continue;
                result[other] = k;
                waiting.push_back(other);
            }
        }
    }
    return result;
}

} // namespace

TEST_CASE("a floor joins nothing")
{
    const Pairs pairs = {{0, 1}, {0, 2}, {2, 3}};
    CHECK(islands(4, pairs, {0, 1, 1, 1}) == std::vector<int>{-1, 1, 2, 2});
}

TEST_CASE("islands are those that one can walk through")
{
    flying::Random random(1741);
    for (int i = 0; i < 200; ++i) {
        const int count = 2 + i % 40;
        const auto any = [&] { return static_cast<int>(random.uniform(0.0, count - 1e-9)); };
        Pairs pairs;
        std::vector<char> moves;
        for (int k = 0; k < count; ++k) moves.push_back(random.uniform(0.0, 1.0) < 0.9 ? 1 : 0);
        for (int k = 0; k < count; ++k) {
            const int a = any();
            const int b = any();
            if (a != b) pairs.emplace_back(a, b);
        }
        CHECK(islands(count, pairs, moves) == walk(count, pairs, moves));
    }
}
