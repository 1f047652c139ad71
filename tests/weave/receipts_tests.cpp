#include <array>

#include "support/receipts.hpp"

// What the macros note is seen by calling what they call: a check that should fail would fail this test.

using namespace flying::receipts;

namespace {

constexpr Here k_here{__FILE__, __LINE__};

} // namespace

TEST_CASE("an equation outside its bound is refused, one inside passes, NaN never passes")
{
    CHECK(equation("t.a", 1.0 + 1e-12, 1.0, k_own_scale, 1e-11, k_here, {}).passed);
    CHECK_FALSE(equation("t.a", 1.0 + 1e-10, 1.0, k_own_scale, 1e-11, k_here, {}).passed);
    CHECK_FALSE(equation("t.a", std::nan(""), 1.0, k_own_scale, 1e-11, k_here, {}).passed);
    CHECK_FALSE(equation("t.a", 1e-30, 0.0, k_own_scale, 1e-11, k_here, {}).passed);
    CHECK(equation("t.a", 1e-30, 0.0, 1.0, 1e-11, k_here, {}).passed);
}

TEST_CASE("a twin passes where it is far off, and fails where it is as good as the original")
{
    CHECK(twin("t.b", 1.0, 2.0, k_own_scale, 1e-11, k_here).passed);
    CHECK_FALSE(twin("t.b", 1.0, 1.0, k_own_scale, 1e-11, k_here).passed);
}

TEST_CASE("the lines of a derivation are compared with their neighbours, and must depend on the point")
{
    const std::array<double, 3> points = {1.0, 2.0, 3.0};
    const auto square = [](double x) { return x * x; };
    CHECK(derivation("t.c", points, 1e-14, k_here, square, [](double x) { return (x + 1) * x - x; }).passed);
    CHECK_FALSE(derivation("t.c", points, 1e-14, k_here, square, [](double x) { return x * x + 1e-9; }).passed);
    CHECK_FALSE(derivation(
                    "t.c", points, 1e-14, k_here, [](double) { return 2.0; }, [](double) { return 2.0; })
                    .passed);
}

TEST_CASE("the macros take bare calls, quantities and vectors")
{
    CHECK_EQUATION("t.d", 2.0, 2.0, 0.0);
    CHECK_EQUATION("t.d", 2.0, 2, 0.0, {"a", 1}, {"\\omega", 2.0f});
    CHECK_TWIN("t.d", 2.0, 3.0, 1e-15);
    const std::array<double, 2> points = {1.0, 2.0};
    CHECK_DERIVATION(
        "t.e", points, 0.0, [](double x) { return x; }, [](double x) { return 1.0 * x; });
    RECORD_VALUE("t.f", 3);
}
