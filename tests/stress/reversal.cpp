#include "stress/reversal.hpp"

#include <algorithm>
#include <vector>

#include "literature/disc_gas.hpp"

namespace flying::stress {

Reversal reverse_gas(int side, double collisions_a_disc, std::uint64_t seed)
{
    gas::Gas out = gas::make_gas({side, 0.3, 1.0, seed});
    std::vector<Vec2> start;
    for (int disc = 0; disc < out.count; ++disc) start.push_back(out.engine.flyer(disc).state.position);
    gas::mix(out, collisions_a_disc);
    const double time = out.engine.time();

    // The same bodies, with every velocity turned round and the clock at zero
    std::vector<EventBody> bodies;
    for (int k = 0; k < out.engine.body_count(); ++k) {
        Flyer flyer = out.engine.flyer(k);
        const bool is_wall = k >= out.count;
        if (!is_wall) {
            flyer.state = state_at(flyer, time);
            flyer.state.velocity = -flyer.state.velocity;
            flyer.state.spin = -flyer.state.spin;
        }
        flyer.state.time = 0.0;
        bodies.push_back({out.engine.shape(k), flyer, out.engine.inertia(k), {1.0, 0.0}, is_wall});
    }
    EventEngine back(std::move(bodies), {});
    Reversal found;
    found.discs = out.count;
    found.collisions = 2.0 * static_cast<double>(out.engine.counts().impacts) / out.count;
    found.failed = back.advance(time, -1).has_value();
    for (int disc = 0; disc < out.count; ++disc) {
        const Vec2 end = state_at(back.flyer(disc), time).position;
        found.farthest = std::max(found.farthest, (end - start[static_cast<std::size_t>(disc)]).norm());
    }
    return found;
}

} // namespace flying::stress
