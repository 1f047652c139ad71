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
    (void)blocks;
    return {}; // your code here
}
