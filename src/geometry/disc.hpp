#pragma once

namespace flying {

/// A full disc about its own origin.
struct Disc
{
    double radius = 1.0; ///< positive [m]
};

} // namespace flying
