#pragma once

#include "play/stage.hpp"

namespace flying {

/// Layers that lie over the bodies, in the world: cells, boxes, islands, centroids, arrows, contacts, impacts, what comes
/// next, labels, the ship.
void paint_layers(cairo_t* cairo, const Stage& stage, const ViewMap& map, const Theme& theme);

/// Pictures on bodies, and the light on balls.
void paint_faces(cairo_t* cairo, const Stage& stage, const ViewMap& map);

} // namespace flying
