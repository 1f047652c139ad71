#include "mass/rectangle.hpp"

#include <numbers>

namespace flying {


MassProperties rectangle_mass(double width, double height, double density)
{
    const double m = density * (width * height);
    const double moment_of_inertia = m * (width * width + height * height) / 12.0;
    return {m, moment_of_inertia};
}



MassProperties disc_mass(double radius, double density)
{
    const double m = density * (std::numbers::pi * (radius * radius));
    const double moment_of_inertia = 0.5 * m * (radius * radius);
    return {m, moment_of_inertia};
}



MassProperties annulus_mass(double inner, double outer, double density)
{
    // The difference of the squares as a product: a thin ring keeps its digits
    const double squares = (outer - inner) * (outer + inner);
    const double m = density * (std::numbers::pi * squares);
    const double moment_of_inertia = 0.5 * m * (inner * inner + outer * outer);
    return {m, moment_of_inertia};
}



double about_parallel_axis(const MassProperties& body, double distance)
{
    return body.moment_of_inertia + body.mass * (distance * distance);
}


} // namespace flying
