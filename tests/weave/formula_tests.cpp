#include <cmath>
#include <numbers>

#include <doctest/doctest.h>

#include "weave/formula.hpp"

using namespace flying::weave;

namespace {

double value_of(const std::string& tex, const Expression::Values& values = {})
{
    const Reading reading = read_expression(tex);
    INFO(tex << ": " << reading.fault);
    REQUIRE(reading.expression.has_value());
    return reading.expression->value(values);
}

std::string fault_of(const std::string& tex)
{
    const Reading reading = read_expression(tex);
    return reading.expression ? "none" : reading.fault;
}

} // namespace

TEST_CASE("sums, products side by side, fractions and powers mean what they mean in print")
{
    const Expression::Values v = {{"a", 3.0}, {"b", 5.0}, {"c", 7.0}};
    CHECK(value_of("a + b c", v) == 38.0);
    CHECK(value_of("-a^2 + b", v) == -4.0);
    CHECK(value_of("2a b^2", v) == 150.0);
    CHECK(value_of("\\frac{a}{b} c", v) == doctest::Approx(4.2).epsilon(1e-15));
    CHECK(value_of("\\frac12 c", v) == 3.5);
    CHECK(value_of("\\left( a + b \\right) \\cdot c", v) == 56.0);
    CHECK(value_of("a - b - c", v) == -9.0);
    CHECK(value_of("a / b / c", v) == doctest::Approx(3.0 / 35.0).epsilon(1e-15));
    CHECK(value_of("a^{b - a}", v) == 9.0);
    CHECK(value_of("|a - b| c", v) == 14.0);
    CHECK(value_of("2 \\lceil \\frac{b}{a} \\rceil - \\left\\lfloor \\frac{c}{a} \\right\\rfloor", v) == 2.0);
    CHECK(value_of("\\sqrt{a^2 + 16} \\, c", v) == 35.0);
    CHECK(value_of("\\sqrt[3]{27}") == doctest::Approx(3.0).epsilon(1e-15));
    CHECK(value_of("\\max(a, b, c) - \\min(a, b)", v) == 4.0);
}

TEST_CASE("symbols carry indices, primes and accents, and every spelling of one is the same")
{
    CHECK(symbol_name("v_{a}") == symbol_name("v_a"));
    CHECK(symbol_name("v'_{a}") != symbol_name("v_a"));
    CHECK(value_of("v_a + v_b' + \\omega_{12} + \\bar{x}", {{symbol_name("v_{a}"), 1.0},
                                                            {symbol_name("v_b'"), 2.0},
                                                            {symbol_name("\\omega_{12}"), 4.0},
                                                            {symbol_name("\\bar x"), 8.0}}) == 15.0);
    CHECK(read_expression("m \\frac{w^2}{n_1} \\pi").expression->symbols() == std::set<std::string>{"m", "w", "n_1"});
}

TEST_CASE("functions take what follows up to a sign or the next function")
{
    const Expression::Values v = {{"x", 0.3}, {"y", 1.1}};
    CHECK(value_of("\\sin x \\cos y", v) == doctest::Approx(std::sin(0.3) * std::cos(1.1)).epsilon(1e-15));
    CHECK(value_of("\\sin 2 x + 1", v) == doctest::Approx(std::sin(0.6) + 1.0).epsilon(1e-15));
    CHECK(value_of("\\sin^2 x + \\cos^2 x", v) == doctest::Approx(1.0).epsilon(1e-15));
    CHECK(value_of("\\cot \\frac{\\pi}{4}") == doctest::Approx(1.0).epsilon(1e-15));
    CHECK(value_of("\\arctan(1) \\cdot 4") == doctest::Approx(std::numbers::pi).epsilon(1e-15));
}

TEST_CASE("integrals and sums are computed, one inside the other too")
{
    CHECK(value_of("\\int_0^1 x^2 \\, dx") == doctest::Approx(1.0 / 3.0).epsilon(1e-14));
    CHECK(value_of("\\int_{-a}^{a} \\int_0^b (x^2 + y) \\, dy \\, dx", {{"a", 1.0}, {"b", 2.0}}) ==
          doctest::Approx(16.0 / 3.0).epsilon(1e-13));
    CHECK(value_of("2 \\int_0^\\pi \\sin \\theta \\, d\\theta + 1") == doctest::Approx(5.0).epsilon(1e-13));
    CHECK(value_of("\\sum_{k=1}^{n} k^2 + 1", {{"n", 10.0}}) == 386.0);
    CHECK(value_of("m d^2", {{"m", 2.0}, {"d", 3.0}}) == 18.0);
}

TEST_CASE("what can't be read is refused with the place where reading stopped")
{
    CHECK(fault_of("\\int x \\, dx") == "an integral without bounds");
    CHECK(fault_of("\\vec{v} \\times \\vec{w}") == "`\\vec`");
    CHECK(fault_of("a +") == "end of the formula where a quantity should stand");
    CHECK(fault_of("(a + b") == "end before `)`");
    CHECK(fault_of("a \\approx b") == "`\\approx`");
    CHECK(fault_of("") == "end of the formula where a quantity should stand");
    CHECK(std::isnan(value_of("q")));
}

TEST_CASE("a formula's sides part at the signs of equality outside braces")
{
    CHECK(sides("I = \\sum_{k=1}^n k = n") == std::vector<std::string>{"I", "\\sum_{k=1}^n k", "n"});
}
