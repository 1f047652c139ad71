#include <doctest/doctest.h>
#include <vector>

#include FLYING_ANSWER

namespace {

/// So many rounds, in the first `longer` of which one takes more than the other.
std::vector<double> rounds(int count, int longer)
{
    std::vector<double> seconds(static_cast<std::size_t>(count), 0.9);
    for (int k = 0; k < longer; ++k) seconds[static_cast<std::size_t>(k)] = 1.1;
    return seconds;
}

} // namespace

TEST_CASE("the share counts rounds that differ")
{
    const std::vector<double> ones(8, 1.0);
    CHECK(share_of_rounds(rounds(8, 6), ones) == 0.75);
    std::vector<double> some = rounds(8, 6);
    some[7] = 1.0;
    some[6] = 1.0;
    CHECK(share_of_rounds(some, ones) == 1.0);
    CHECK(share_of_rounds(ones, ones) == 0.0);
}

TEST_CASE("ten of ten tosses are rarer than one in a thousand, nine of nine are not")
{
    CHECK(is_slower(rounds(10, 10), std::vector<double>(10, 1.0)));
    CHECK_FALSE(is_slower(rounds(9, 9), std::vector<double>(9, 1.0)));
    CHECK_FALSE(is_slower(rounds(10, 9), std::vector<double>(10, 1.0)));
    CHECK_FALSE(is_slower(std::vector<double>(30, 1.0), std::vector<double>(30, 1.0)));
}

TEST_CASE("of thirty rounds it takes twenty-four")
{
    const std::vector<double> ones(30, 1.0);
    CHECK_FALSE(is_slower(rounds(30, 23), ones));
    CHECK(is_slower(rounds(30, 24), ones));
}

TEST_CASE("so many or more, of a hundred")
{
    // 65 or more: a chance of 1.8e-3. Just 65 have one of 0.9e-3. 66 or more: 0.9e-3
    const std::vector<double> ones(100, 1.0);
    CHECK_FALSE(is_slower(rounds(100, 65), ones));
    CHECK(is_slower(rounds(100, 66), ones));
}
