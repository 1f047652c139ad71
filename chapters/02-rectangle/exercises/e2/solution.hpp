#pragma once

#include "02-rectangle/rectangle.hpp"

/// A rectangular frame about its centre.
/// width, height  outer sides [m]; thickness  of its bars, below half of either [m]; density [kg/m^2]
inline flying::MassProperties frame_mass(double width, double height, double thickness, double density)
{
    // Two bars along the width, above and below; two beside them that fill the rest of the height
    const flying::MassProperties flat = flying::rectangle_mass(width, thickness, density);
    const flying::MassProperties upright = flying::rectangle_mass(thickness, height - 2.0 * thickness, density);

    // All terms are positive: nothing cancels, however thin the bars
    const double moved_flat = flying::about_parallel_axis(flat, 0.5 * (height - thickness));
    const double moved_upright = flying::about_parallel_axis(upright, 0.5 * (width - thickness));
    return {2.0 * (flat.mass + upright.mass), 2.0 * (moved_flat + moved_upright)};
}
