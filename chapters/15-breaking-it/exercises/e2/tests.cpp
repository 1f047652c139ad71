#include <cmath>
#include <doctest/doctest.h>
#include <initializer_list>

#include FLYING_ANSWER

TEST_CASE("a fault in every second case is seen within five tries, but for one chance in twenty")
{
    CHECK_MESSAGE(tries_needed(0.5, 0.05) == 5.0, "a half to the fifth is the first power below a twentieth");
}

TEST_CASE("so many are enough, and one fewer is not")
{
    for (const double p : {0.9, 0.3, 0.05, 1e-3}) {
        for (const double alpha : {0.3, 0.05, 1e-3}) {
            const double n = tries_needed(p, alpha);
            CAPTURE(p);
            CAPTURE(alpha);
            CHECK(n == std::floor(n));
            CHECK(std::pow(1.0 - p, n) <= alpha * (1.0 + 1e-9));
            CHECK(std::pow(1.0 - p, n - 1.0) > alpha * (1.0 - 1e-9));
        }
    }
}

TEST_CASE("tiny shares keep their digits")
{
    const double expected = -std::log(0.05) / 1e-12;
    CHECK_MESSAGE(tries_needed(1e-12, 0.05) == doctest::Approx(expected).epsilon(1e-9),
                  "1 - p, formed first, has lost most of a tiny p: use log1p");
}
