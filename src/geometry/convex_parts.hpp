#pragma once

#include <vector>

#include "geometry/polygon.hpp"

namespace flying {

/// A polygon cut into convex polygons along straight lines between its own vertices: the parts overlap nowhere,
/// together they cover the polygon and its holes stay free. A polygon that is convex to rounding comes back
/// as its only part.
///
/// Holes are joined to the outer ring by bridges, the ring is cut into triangles ear by ear, and triangles are put
/// together again wherever the result stays convex (Hertel, Mehlhorn, "Fast triangulation of simple polygons", 1983):
/// at most four times as many parts as the fewest possible, but for the next rule. All decisions on convexity are exact
/// (math/orientation.hpp); vertices that stand on one line but for rounding leave no slivers between them. The time
/// grows with the square of the number of vertices.
///
/// No part has a side of the polygon and a cut in one line, one after the other: what lies on such a line would lie on
/// both, and a search for contacts with sides alone could not tell the two apart by their normals. A plus sign is
/// cut into five and not into three.
///
/// polygon  as `make_polygon` returns it; the parts lie in its frame
[[nodiscard]] std::vector<Polygon> convex_parts(const Polygon& polygon);

} // namespace flying
