#pragma once

#include <cairo.h>

#include "draw/paint.hpp"

namespace flying {

/// How the outline of a body is best drawn.
enum class OutlineKind
{
    by_inset,  ///< fill the body darkly, then its inset
    by_stroke, ///< the inset of such a shape may cross itself: stroke the path
    too_thin   ///< nothing is left of the body inside the outline
};

/// Add a body's edge to the current path, to be filled by the even-odd rule (which this sets).
/// inset  how far inside the edge; over zero only for shapes that are drawn `by_inset`  [pixels]
/// A path that reaches far beyond any surface is cut there: Cairo's coordinates have 24 bits before the point.
OutlineKind add_body_path(cairo_t* cairo, const DrawnBody& body, const ViewMap& map, double inset);

} // namespace flying
