#pragma once

namespace flying {

// [geometry.disc]
/// A full disc about its own origin.
struct Disc
{
    double radius = 1.0; ///< positive [m]
};
// [geometry.disc]

} // namespace flying
