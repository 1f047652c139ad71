#pragma once

#include <cmath>
#include <vector>

#include "events/event_engine.hpp"
#include "math/random.hpp"

// A gas of discs in a box, run by the event engine that the next chapter explains.
namespace flying {


/// n discs of radius 0.5 m, covering a tenth of a square box, with velocities up to 5 m/s.
inline std::vector<EventBody> gas(int n)
{
    Random random(91);
    const double side = std::sqrt(n * 0.785398 / 0.1);
    const int columns = static_cast<int>(std::ceil(std::sqrt(n)));
    const double spacing = side / columns;
    std::vector<EventBody> bodies;
    for (int k = 0; k < n; ++k) {
        EventBody body{Disc{0.5}, {}, {1.0, 8.0}, {1.0, 0.0}, false};
        body.flyer.state.position = spacing * Vec2(k % columns + 0.5, k / columns + 0.5);
        body.flyer.state.velocity =
            Vec2{random.uniform(-5.0, 5.0), random.uniform(-5.0, 5.0)};
        bodies.push_back(body);
    }
    const auto wall = [&](const Vec2& normal, double offset) {
        bodies.push_back({HalfPlane{normal, offset}, {}, {}, {1.0, 0.0}, true});
    };
    wall({1.0, 0.0}, 0.0);
    wall({-1.0, 0.0}, -side);
    wall({0.0, 1.0}, 0.0);
    wall({0.0, -1.0}, -side);
    return bodies;
}



/// What a run of a thousand impacts counts.
inline EventCounts count_work(int n, PairFinder finder)
{
    EventEngineOptions options;
    options.pair_finder = finder;
    EventEngine engine(gas(n), options);
    while (engine.counts().impacts < 1000) {
        if (engine.advance(engine.time() + 0.01, 1'000'000)) break;
    }
    return engine.counts();
}



/// Work in comparisons. To find a body's next border and to enter it into another cell took
/// as many instructions as six comparisons of two discs, when we counted them.
inline double work(const EventCounts& counts)
{
    constexpr double k_cell_change = 6.0;
    return static_cast<double>(counts.predictions) +
           k_cell_change * static_cast<double>(counts.cells);
}


} // namespace flying
