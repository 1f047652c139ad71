#pragma once

#include <string>
#include <string_view>
#include <utility>

#include "math/expected.hpp"
#include "math/vec2.hpp"

namespace flying {

/// Numbers that a scene may hold, zero aside: from here to `k_greatest_number`, in SI units, either sign. The engine
/// multiplies up to four lengths or speeds with one another (the discriminant of the time of impact, the second moment
/// of an area); within these limits no such product overflows or loses digits to underflow. It isn't a scale: nothing
/// between the limits is treated in a special way.
inline constexpr double k_least_number = 1e-70;
inline constexpr double k_greatest_number = 1e70;

/// Angles that a scene may hold. [rad] Sines and cosines are good for up to 2^53, and the angle must have room to grow.
inline constexpr double k_greatest_angle = 1e15;

/// Sides of a regular polygon: more than this only costs time.
inline constexpr int k_most_sides = 1000000;

/// Collects faults whose places share a beginning.
class Checks
{
public:
    /// prefix  put before every place, such as `body[3].`; may be empty
    explicit Checks(Faults& faults, std::string prefix = {}) : faults_(&faults), prefix_(std::move(prefix)) {}

    void fault(std::string_view place, std::string found, std::string expected);

    /// Each of these adds a fault where x is not as the name says, and returns whether it is. NaN is nothing of all.
    /// what  in words, with its unit, such as "length in m"
    bool any(std::string_view place, double x, std::string_view what);
    bool positive(std::string_view place, double x, std::string_view what);
    bool not_negative(std::string_view place, double x, std::string_view what);
    bool fraction(std::string_view place, double x, std::string_view what); ///< 0 ... 1
    bool vector(std::string_view place, const Vec2& a, std::string_view what);
    bool angle(std::string_view place, double x);

private:
    Faults* faults_;
    std::string prefix_;
};

} // namespace flying
