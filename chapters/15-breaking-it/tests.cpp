// What the chapter says, checked.

#include <cmath>
#include <doctest/doctest.h>

#include "hunt.hpp"
#include "row.hpp"
#include "silence.hpp"
#include "support/receipts.hpp"

using namespace flying;
using namespace flying::breaking;

// [breaking-it.tests.silence]
TEST_CASE("the share that may fail is where n cases in a row go well with just that luck")
{
    Random random(1501);
    for (int k = 0; k < 200; ++k) {
        const double n = 1.0 + random.below(1000);
        const double alpha = random.uniform(0.001, 0.5);
        // By halving: (1 - p)^n falls from 1 to 0 as p grows
        double low = 0.0;
        double high = 1.0;
        for (int half = 0; half < 60; ++half) {
            const double p = 0.5 * (low + high);
            (std::pow(1.0 - p, n) > alpha ? low : high) = p;
        }
        CHECK_EQUATION("breaking.silence", share_that_may_fail(n, alpha), 1.0 - std::pow(alpha, 1.0 / n), 1e-10, {"n", n}, {"\\alpha", alpha});
        CHECK_TWIN("breaking.silence", share_that_may_fail(n, alpha), 1.0 - std::pow(alpha, 2.0 / n), 1e-10);
        CHECK(share_that_may_fail(n, alpha) == doctest::Approx(low).epsilon(1e-10));
    }
}
// [breaking-it.tests.silence]

TEST_CASE("doubles lie as far apart as their exponent says")
{
    Random random(1502);
    for (int k = 0; k < 200; ++k) {
        const double D = std::pow(10.0, random.uniform(-10.0, 15.0));
        const double closed = std::exp2(std::floor(std::log(D) / std::log(2.0)) - 52.0);
        CHECK_EQUATION("breaking.spacing", spacing(D), closed, 1e-15, {"D", D});
        CHECK_TWIN("breaking.spacing", spacing(D), 2.0 * closed, 1e-15);
    }
}

TEST_CASE("the mean square of a rounding is a twelfth of the spacing squared, and many add up by their number")
{
    Random random(1503);
    for (int k = 0; k < 50; ++k) {
        const double u = random.uniform(0.1, 3.0);
        const int n = 1 + random.below(1000);
        // All roundings that there are, in equal parts, and a sum of squares: independent ones add their squares
        constexpr int k_parts = 2000;
        double square = 0.0;
        for (int part = 0; part < k_parts; ++part) {
            const double off = u * ((part + 0.5) / k_parts - 0.5);
            square += off * off / k_parts;
        }
        CHECK_EQUATION("breaking.walk", std::sqrt(n * square), u * std::sqrt(n / 12.0), 1e-6, {"u", u}, {"n", n});
        CHECK_TWIN("breaking.walk", std::sqrt(n * square), u * std::sqrt(n / 11.0), 1e-6);
    }
}

// [breaking-it.tests.shrink]
TEST_CASE("what has been shrunk still breaks, is no less simple, and can't be made simpler by one number")
{
    int shrunk = 0;
    for (std::uint64_t seed = 1; seed <= 300; ++seed) {
        const Throw found = random_throw(seed);
        if (!gets_out(found)) continue;
        ++shrunk;
        const Throw smallest = shrink(found, gets_out);
        CHECK(gets_out(smallest));
        CHECK(smallest.steps <= found.steps);
        for (double Throw::*number : {&Throw::u, &Throw::v, &Throw::g, &Throw::e, &Throw::x, &Throw::y}) {
            if (effort(smallest.*number) == 0) continue;
            Throw simpler = smallest;
            simpler.*number = 0.0;
            CHECK_FALSE(gets_out(simpler));
        }
    }
    CHECK(shrunk > 50);
}
// [breaking-it.tests.shrink]

// [breaking-it.tests.blind]
TEST_CASE("walls that lose balls never give them energy: an account of energy sees nothing")
{
    int got_out = 0;
    for (std::uint64_t seed = 1; seed <= 2000; ++seed) {
        Throw how = random_throw(seed);
        how.g = 0.0;
        CHECK_FALSE(gains_energy(how));
        got_out += gets_out(how) ? 1 : 0;
    }
    CHECK(got_out > 200);
}
// [breaking-it.tests.blind]

TEST_CASE("a table comes back as it was written, without a line that was cut off, and a row that was tried again counts last")
{
    Row row{3, "far", "ulp", 1.5, 2.0, false, "none", "100", "", true, true, 0.25};
    std::string text = line_of("run", TableRun{"2026-01-01", "here", "g++"}) + "\n" + line_of("row", row) + "\n";
    row.reached = 1.0;
    Row other = row;
    other.number = 1;
    other.name = "heavy";
    text += line_of("row", row) + "\n" + line_of("row", other) + "\n" + "{\"row\":{\"num";
    const std::optional<Table> table = read_table(text);
    REQUIRE(table);
    REQUIRE(table->rows.size() == 2);
    CHECK(table->rows[0].name == "heavy");
    CHECK(table->rows[1].reached == 1.0);
    CHECK(table->row("far")->elsewhere == "none");
    CHECK(table->row("near") == nullptr);
    CHECK_FALSE(read_table("no record\n"));
    CHECK_FALSE(read_table(""));
}

TEST_CASE("the run that the chapter quotes is one of this format, its rows in the order of their numbers")
{
    const auto table = read_table_file(FLYING_MEASURED);
    REQUIRE(table);
    CHECK_FALSE(table->rows.empty());
    int number = 0;
    for (const Row& row : table->rows) {
        CHECK(row.number >= number);
        number = row.number;
    }
}
