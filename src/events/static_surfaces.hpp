#pragma once

#include <span>
#include <vector>

#include "collide/seams.hpp"
#include "events/body_rows.hpp"

namespace flying {

/// Where surfaces of static bodies act as one (collide/seams.hpp), and which bodies lie beside each. Bodies are named
/// by their ids.
class StaticSurfaces
{
public:
    explicit StaticSurfaces(const BodyRows& bodies);

    /// Of a body with what lies beside it; empty for one that moves.
    [[nodiscard]] std::span<const Seam> seams_of(int id) const { return seams_[id]; }
    /// Those whose surface goes on where the body's ends.
    [[nodiscard]] std::span<const int> beside(int id) const { return beside_[id]; }

    /// The surface that a body is of: the first of all that lie beside each other in a row.
    [[nodiscard]] int surface_of(int id) const { return surface_[id]; }

private:
    void name_surfaces();
    void add(const BodyRows& bodies, int one, int two);

    std::vector<std::vector<Seam>> seams_; // by id
    std::vector<std::vector<int>> beside_; // by id
    std::vector<int> surface_;             // by id
};

} // namespace flying
