#include <cstdio>
#include <initializer_list>
#include <numbers>

#include "door.hpp"
#include "rectangle.hpp"
#include "pieces.hpp"

using namespace flying;

namespace {


/// A plate of 2 m by 1 m, cut into ever more pieces that are taken for points.
void cut_plate()
{
    const MassProperties plate = rectangle_mass(2.0, 1.0, 6.0);
    const double whole = plate.moment_of_inertia;
    std::printf("plate: %g kg, %g kg m^2\n\n", plate.mass, whole);
    std::printf("  pieces    as points   short by\n");
    for (const int n : {1, 2, 3, 10, 100, 1000}) {
        const double sum = inertia_by_pieces(plate.mass, 2.0, 1.0, n);
        std::printf("%8d %12.7f %10.1e\n", n * n, sum, 1.0 - sum / whole);
    }
}



/// A door of 20 kg, 1 m wide and 4 cm thick, pushed here and there.
void push_door()
{
    const double width = 1.0;
    const double thickness = 0.04;
    const double density = 20.0 / (width * thickness);
    const MassProperties door = rectangle_mass(width, thickness, density);
    const double hinged = about_parallel_axis(door, 0.5 * width);
    std::printf("\ndoor: %g kg\n", door.mass);
    std::printf("about its middle = %.4f kg m^2\n", door.moment_of_inertia);
    std::printf("about its hinge = %.4f kg m^2\n", hinged);
    std::printf("\n  finger at    feels    degrees after 1 s at 5 N\n");
    for (const double d : {1.0, 0.75, 0.5, 0.25, 0.1}) {
        const double angle = angle_turned(hinged, 5.0 * d, 1.0);
        const double degrees = angle * 180.0 / std::numbers::pi;
        std::printf("%8.2f m %7.1f kg %10.1f\n", d, mass_felt(hinged, d), degrees);
    }
    std::printf("\nfelt at the handle = %.2f kg\n", mass_felt(hinged, width));
    std::printf("felt near the hinge = %.0f kg\n", mass_felt(hinged, 0.1));
}


} // namespace


int main()
{
    cut_plate();
    push_door();
}

