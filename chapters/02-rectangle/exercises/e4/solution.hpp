#pragma once

#include <vector>

/// An upright rectangle.
struct Block
{
    double x, y;          ///< its middle [m]
    double width, height; ///< [m]
    double density;       ///< negative for a hole [kg/m^2]
};

struct Plate
{
    double mass = 0.0; ///< [kg]
    double x = 0.0;    ///< centre of mass [m]
    double y = 0.0;
    double inertia = 0.0; ///< about the centre of mass [kg m^2]
};

inline Plate blocks_mass(const std::vector<Block>& blocks)
{
    // About the middle of the first block, which is near wherever the plate is
    Plate plate;
    double first_x = 0.0;
    double first_y = 0.0;
    for (const Block& b : blocks) {
        const double m = b.density * (b.width * b.height);
        const double x = b.x - blocks.front().x;
        const double y = b.y - blocks.front().y;
        plate.mass += m;
        first_x += m * x;
        first_y += m * y;
        plate.inertia += m * ((b.width * b.width + b.height * b.height) / 12.0 + (x * x + y * y));
    }

    // Back to the centre of mass: parallel axes, the other way round
    const double x = first_x / plate.mass;
    const double y = first_y / plate.mass;
    plate.inertia -= plate.mass * (x * x + y * y);
    plate.x = blocks.front().x + x;
    plate.y = blocks.front().y + y;
    return plate;
}
