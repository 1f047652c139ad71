#include "mass/rectangle.hpp"

#include <numbers>

namespace flying {

// [mass.rectangle]
MassProperties rectangle_mass(double width, double height, double density)
{
    const double m = density * (width * height);
    const double moment_of_inertia = m * (width * width + height * height) / 12.0;
    return {m, moment_of_inertia};
}
// [mass.rectangle]

// [mass.disc]
MassProperties disc_mass(double radius, double density)
{
    const double m = density * (std::numbers::pi * (radius * radius));
    const double moment_of_inertia = 0.5 * m * (radius * radius);
    return {m, moment_of_inertia};
}
// [mass.disc]

// [mass.annulus]
MassProperties annulus_mass(double inner, double outer, double density)
{
    // The difference of the squares as a product: a thin ring keeps its digits
    const double squares = (outer - inner) * (outer + inner);
    const double m = density * (std::numbers::pi * squares);
    const double moment_of_inertia = 0.5 * m * (inner * inner + outer * outer);
    return {m, moment_of_inertia};
}
// [mass.annulus]

// [mass.parallel-axis]
double about_parallel_axis(const MassProperties& body, double distance)
{
    return body.moment_of_inertia + body.mass * (distance * distance);
}
// [mass.parallel-axis]

} // namespace flying
