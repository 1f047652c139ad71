#pragma once

#include <cstddef>
#include <span>

#include "broadphase/boxed_body.hpp"

namespace flying {

/// Call visit(a, b), ids with a < b, for every two bodies, not both static, whose boxes
/// share a point. Every two are compared: dear, and plain enough to be the oracle of
/// whatever is faster.
///
/// bodies  in the order of their ids, each id once
template <typename Visit>
void for_each_pair_of_all(std::span<const BoxedBody> bodies, Visit&& visit)
{
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        for (std::size_t k = i + 1; k < bodies.size(); ++k) {
            if (bodies[i].is_static && bodies[k].is_static) continue;
            if (overlap(bodies[i].box, bodies[k].box)) visit(bodies[i].body, bodies[k].body);
        }
    }
}

} // namespace flying
