#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "events/event_engine.hpp"

/// A gas of equal hard bodies in a square box, in the general event engine, and what it tells of its pressure.
/// Units: a disc's diameter, its mass, and k T at the start.
namespace flying::gas {

struct BoxOptions
{
    int side = 32;              ///< side * side bodies
    double packing = 0.3;       ///< of the bulk, nearly
    double restitution = 1.0;   ///< between bodies; walls give everything back
    std::uint64_t seed = 1;
    bool equal_speeds = false;  ///< at the start all have one speed, in any direction
    bool squares = false;       ///< of side 0.7 in place of discs, without spin at the start
};

struct Gas
{
    EventEngine engine;
    int count = 0;      ///< of bodies; the walls follow after them
    double width = 0.0; ///< of the box, from 0 to width in both coordinates
};

/// Bodies on a square lattice with velocities as Maxwell has them, scaled to a kinetic energy of 1 a body exactly.
[[nodiscard]] Gas make_gas(const BoxOptions& options);

/// Let every body collide this often, on average.
void mix(Gas& gas, double collisions_a_body);

/// A mean with its standard error from block averages.
struct Mean
{
    double value = 0.0;
    double error = 0.0;
};
[[nodiscard]] Mean mean_of(const std::vector<double>& blocks);

struct Figures
{
    double packing = 0.0; ///< found in the bulk
    Mean z_virial;        ///< Z at the packing asked for, from the momentum that collisions hand on
    Mean z_count;         ///< the same from their number
    Mean rate;            ///< collisions of a disc in unit time, over 4 (Z - 1) / sqrt(pi) with z_virial
    long collisions = 0;  ///< counted in the bulk
    double energy_change = 0.0; ///< of all since the start, as a share
};

/// Measure the bulk: what lies farther than `margin` from every wall. Nothing is asked of the walls: where discs crowd at
/// them, the bulk is thinner than the box, but its own density is measured with its own collisions. Local pressure is
/// rho k T (1 + virial), and small departures from the packing asked for are taken along the slope of the series.
///
/// margin      of the bulk [diameters]; at packing 0.3 a wall's layers have died away after five
/// blocks      how many, for the errors
/// collisions  of all discs, a block
/// progress    called after every block with its number, where given
[[nodiscard]] Figures measure(Gas& gas, double packing, double margin, int blocks, long collisions,
                              const std::function<void(int)>& progress = {});

} // namespace flying::gas
