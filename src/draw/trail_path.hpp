#pragma once

#include <cairo.h>

#include "draw/paint.hpp"
#include "draw/picture.hpp"

namespace flying {

/// A comet's tail, added to the path, to be filled by the winding rule: from nothing at the oldest point to the trail's
/// whole width at the newest, which is round.
void add_trail_path(cairo_t* cairo, const Trail& trail, const ViewMap& map);

} // namespace flying
