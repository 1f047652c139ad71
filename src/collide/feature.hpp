#pragma once

namespace flying {

/// Which parts of two bodies A and B meet.
enum class FeatureKind {
    surface,        ///< two smooth surfaces: discs and half-planes
    vertex_of_a,    ///< a vertex of A on an edge (or the surface) of B
    vertex_of_b,    ///< a vertex of B on an edge (or the surface) of A
    corner,         ///< a vertex of A on a vertex of B
};

/// One pair of features. Indices that the kind doesn't use are -1.
struct Feature
{
    FeatureKind kind = FeatureKind::surface;
    int vertex = -1; ///< of the body that the kind names; of A for a corner
    int edge = -1;   ///< of the other body; its vertex for a corner

    friend bool operator==(const Feature&, const Feature&) = default;
};

} // namespace flying
