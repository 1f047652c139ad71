#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <string>
#include <string_view>
#include <type_traits>

#include <doctest/doctest.h>

/// Receipts: what a test found while it ran, for the pages that quote it.
///
/// A test program that ends with every check passed writes its receipts, as JSON, to the file that the environment
/// variable FLYING_RECEIPTS names; without the variable nothing is written, and the checks are checks like any other.
namespace flying::receipts {

/// A quantity of the printed formula and its value in the case at hand. `tex` is spelled as on the page.
struct Quantity
{
    template <typename Number>
    Quantity(const char* name, Number number) : tex(name), value(static_cast<double>(number))
    {
    }

    const char* tex;
    double value;
};

/// Where in the tests a check stands.
struct Here
{
    const char* file;
    int line;
};

/// What became of a check; `text` only says anything where it failed.
struct Outcome
{
    bool passed = true;
    std::string text;
};

/// Distance from `expected`, as a share of `scale`: 0 where the two are equal, infinite where only the scale vanishes,
/// NaN where anything is. Numbers and vectors.
template <typename Value>
[[nodiscard]] double relative_error(const Value& found, const Value& expected, double scale)
{
    double distance = 0.0;
    if constexpr (std::is_arithmetic_v<Value>) {
        distance = std::abs(static_cast<double>(found) - static_cast<double>(expected));
    } else {
        distance = (found - expected).norm();
    }
    return distance == 0.0 ? 0.0 : distance / scale;
}

template <typename Value>
[[nodiscard]] double size_of(const Value& value)
{
    if constexpr (std::is_arithmetic_v<Value>) {
        return std::abs(static_cast<double>(value));
    } else {
        return value.norm();
    }
}

/// Notes one case of the equation. `value` is the closed form's, NaN where it is no single number.
[[nodiscard]] Outcome note_equation(std::string_view id, double error, double bound, double value, Here here,
                                    std::initializer_list<Quantity> quantities);
[[nodiscard]] Outcome note_twin(std::string_view id, double error, double bound, Here here);
[[nodiscard]] Outcome note_derivation(std::string_view id, std::size_t lines, std::size_t points, double worst,
                                      double twin, double bound, Here here);
void note_value(std::string_view name, double value);

/// Stands for the size of the value that is compared with.
inline constexpr double k_own_scale = -1.0;

template <typename Value>
[[nodiscard]] Outcome equation(std::string_view id, const Value& engine, const std::type_identity_t<Value>& closed_form,
                               double scale, double bound, Here here, std::initializer_list<Quantity> quantities)
{
    if (scale == k_own_scale) scale = size_of(closed_form);
    double value = std::nan("");
    if constexpr (std::is_arithmetic_v<Value>) value = static_cast<double>(closed_form);
    return note_equation(id, relative_error(engine, closed_form, scale), bound, value, here, quantities);
}

template <typename Value>
[[nodiscard]] Outcome twin(std::string_view id, const Value& engine, const std::type_identity_t<Value>& wrong_form,
                           double scale, double bound, Here here)
{
    if (scale == k_own_scale) scale = size_of(wrong_form);
    return note_twin(id, relative_error(engine, wrong_form, scale), bound, here);
}

/// Evaluates the lines at every point and compares each with the next. So that no check is one that can't fail, each
/// line is compared with the next one at the following point as well, and there the two must differ at least once.
template <typename Points, typename... Lines>
[[nodiscard]] Outcome derivation(std::string_view id, const Points& points, double bound, Here here,
                                 const Lines&... lines)
{
    constexpr std::size_t count = sizeof...(Lines);
    static_assert(count >= 2, "a derivation has two lines at least");
    double worst = 0.0;
    std::array<double, count> apart{};
    std::array<double, count> before{};
    bool has_before = false;
    for (const auto& point : points) {
        const std::array<double, count> now{static_cast<double>(lines(point))...};
        for (std::size_t k = 0; k + 1 < count; ++k) {
            const double scale = std::max(std::abs(now[k]), std::abs(now[k + 1]));
            const double error = relative_error(now[k], now[k + 1], scale);
            if (!(error <= worst)) worst = error;
            if (has_before) apart[k] = std::max(apart[k], relative_error(before[k], now[k + 1], scale));
        }
        before = now;
        has_before = true;
    }
    double twin = apart[0];
    for (std::size_t k = 0; k + 1 < count; ++k) twin = std::min(twin, apart[k]);
    return note_derivation(id, count, points.size(), worst, twin, bound, here);
}

} // namespace flying::receipts

/// The engine's value is the closed form's, within `bound` of the latter's size. One case of equation `id`; call it in
/// a loop for many. Quantities may follow, `{"m", m}, {"\\omega", omega}`: with them, the formula as it is printed on
/// the page is evaluated too, when the book is woven, and must give the closed form's value.
#define CHECK_EQUATION(id, engine_value, closed_form, bound, ...)                                                      \
    CHECK_EQUATION_SCALED(id, engine_value, closed_form, ::flying::receipts::k_own_scale, bound, __VA_ARGS__)

/// The same, for values that may pass through zero: the error is taken as a share of `scale`, a size of the case.
#define CHECK_EQUATION_SCALED(id, engine_value, closed_form, scale, bound, ...)                                        \
    FLYING_CHECK_OUTCOME(::flying::receipts::equation(id, engine_value, closed_form, scale, bound,                     \
                                                      {__FILE__, __LINE__}, {__VA_ARGS__}))

/// The wrong twin of equation `id`: its closed form with a constant changed. Passes where CHECK_EQUATION with the same
/// bound would fail. Every equation needs one.
#define CHECK_TWIN(id, engine_value, wrong_form, bound)                                                                \
    CHECK_TWIN_SCALED(id, engine_value, wrong_form, ::flying::receipts::k_own_scale, bound)
#define CHECK_TWIN_SCALED(id, engine_value, wrong_form, scale, bound)                                                  \
    FLYING_CHECK_OUTCOME(::flying::receipts::twin(id, engine_value, wrong_form, scale, bound, {__FILE__, __LINE__}))

/// The lines of derivation `id`, as functions of a point, agree with their neighbours at every one of the points,
/// within `bound` of their size: CHECK_DERIVATION("id", points, bound, line, line, ...).
#define CHECK_DERIVATION(id, points, bound, ...)                                                                       \
    FLYING_CHECK_OUTCOME(::flying::receipts::derivation(id, points, bound, {__FILE__, __LINE__}, __VA_ARGS__))

/// A number for the text: {{value:name|%.1e}}.
#define RECORD_VALUE(name, value) ::flying::receipts::note_value(name, static_cast<double>(value))

#define FLYING_CHECK_OUTCOME(expression)                                                                               \
    do {                                                                                                               \
        const ::flying::receipts::Outcome flying_outcome = expression;                                                 \
        CHECK_MESSAGE(flying_outcome.passed, flying_outcome.text);                                                     \
    } while (false)
