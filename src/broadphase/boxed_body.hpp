#pragma once

#include "geometry/aabb.hpp"

namespace flying {

/// A body as the search for pairs sees it.
struct BoxedBody
{
    int body = 0; ///< its id
    bool is_static = false;
    Aabb box; ///< holds all of the body [m]
};

} // namespace flying
