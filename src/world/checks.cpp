#include "world/checks.hpp"

#include <cmath>
#include <utility>

#include "math/number_text.hpp"

namespace flying {

namespace {

/// Zero, or neither too small nor too large for the engine.
bool in_range(double x)
{
    return x == 0.0 || (std::abs(x) >= k_least_number && std::abs(x) <= k_greatest_number);
}

std::string limits()
{
    return number_text(k_least_number) + " to " + number_text(k_greatest_number);
}

} // namespace

void Checks::fault(std::string_view place, std::string found, std::string expected)
{
    faults_->push_back({prefix_ + std::string(place), std::move(found), std::move(expected)});
}

bool Checks::any(std::string_view place, double x, std::string_view what)
{
    if (in_range(x)) return true;
    fault(place, number_text(x), "a " + std::string(what) + ": 0, or " + limits() + " with either sign");
    return false;
}

bool Checks::positive(std::string_view place, double x, std::string_view what)
{
    if (x > 0.0 && in_range(x)) return true;
    fault(place, number_text(x), "a positive " + std::string(what) + ", " + limits());
    return false;
}

bool Checks::not_negative(std::string_view place, double x, std::string_view what)
{
    if (x >= 0.0 && in_range(x)) return true;
    fault(place, number_text(x), "a " + std::string(what) + " that is not negative: 0, or " + limits());
    return false;
}

bool Checks::fraction(std::string_view place, double x, std::string_view what)
{
    if (x >= 0.0 && x <= 1.0 && in_range(x)) return true;
    fault(place, number_text(x),
          "a " + std::string(what) + " from 0 to 1, and not between 0 and " + number_text(k_least_number));
    return false;
}

bool Checks::vector(std::string_view place, const Vec2& a, std::string_view what)
{
    const bool x_fits = any(std::string(place) + "[0]", a.x(), what);
    const bool y_fits = any(std::string(place) + "[1]", a.y(), what);
    return x_fits && y_fits;
}

bool Checks::angle(std::string_view place, double x)
{
    if (in_range(x) && std::abs(x) <= k_greatest_angle) return true;
    fault(place, number_text(x),
          "an angle in rad: 0, or " + number_text(k_least_number) + " to " + number_text(k_greatest_angle) +
              " with either sign");
    return false;
}

} // namespace flying
