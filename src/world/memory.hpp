#pragma once

#include "world/hybrid.hpp"
#include "world/world.hpp"

namespace flying {

/// What the integrators need to go on with the same bits, beside the bodies' flights: for a snapshot that is kept elsewhere.
struct EngineMemory
{
    Hybrid::Memory hybrid;
};

} // namespace flying
