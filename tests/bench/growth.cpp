#include "growth.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "machine.hpp"
#include "scenes.hpp"
#include "world/world.hpp"

namespace flying::bench {
namespace {

/// Let the gas mix for an event a body, then count what it does in so many seconds of computing.
Rate measure(int size, const GenerateOptions& options, double seconds)
{
    const Scene scene = scene_of("gas", options);
    Expected<World> made = World::make(scene);
    if (!made) return {size, 0.0, 0.0};
    World& world = made.value();
    const double forever = 1e9;
    const long portion = std::max<long>(200, static_cast<long>(scene.bodies.size()) / 10);
    if (world.advance(forever, static_cast<long>(scene.bodies.size()))) return {size, 0.0, 0.0};

    const long events = world.events();
    const long collisions = world.collisions();
    const double start = cpu_seconds();
    double passed = 0.0;
    while (passed < seconds) {
        if (world.advance(forever, portion)) break;
        passed = cpu_seconds() - start;
    }
    return {size, static_cast<double>(world.events() - events) / passed,
            static_cast<double>(world.collisions() - collisions) / passed};
}

PowerLaw fit(std::span<const Rate> rates)
{
    double count = 0.0, sum_x = 0.0, sum_y = 0.0, sum_xx = 0.0, sum_xy = 0.0;
    for (const Rate& rate : rates) {
        if (rate.collisions <= 0.0) continue;
        const double x = std::log(static_cast<double>(rate.size));
        const double y = std::log(rate.collisions);
        count += 1.0;
        sum_x += x;
        sum_y += y;
        sum_xx += x * x;
        sum_xy += x * y;
    }
    if (count < 2.0) return {};
    const double slope = (count * sum_xy - sum_x * sum_y) / (count * sum_xx - sum_x * sum_x);
    return {std::exp((sum_y - slope * sum_x) / count), slope};
}

} // namespace

std::vector<Growth> measure_growth(Extent extent, const std::function<void(const std::string&)>& tell)
{
    const double seconds = extent == Extent::full ? 2.0 : 0.4;
    std::vector<Growth> growths = {{"bodies-discs", "discs at packing 0.3, against their number", {}, {}, {}},
                                   {"bodies-pentagons", "pentagons at packing 0.3, against their number", {}, {}, {}},
                                   {"vertices", "200 regular polygons at packing 0.2, against vertices", {}, {}, {}}};
    const auto add = [&](Growth& growth, int size, const GenerateOptions& options) {
        tell(growth.name + " " + std::to_string(size));
        growth.rates.push_back(measure(size, options, seconds));
    };
    const int most = extent == Extent::full ? 1000000 : 100000;
    for (const int size : {10, 32, 100, 316, 1000, 3162, 10000, 31623, 100000, 316228, 1000000}) {
        if (size <= most) add(growths[0], size, gas(size, 0.3));
        if (size <= most / 10) add(growths[1], size, gas(size, 0.3, "polygon", 5, 5));
    }
    for (const int size : {3, 4, 5, 7, 10, 14, 20, 30, 50, 70, 100}) {
        add(growths[2], size, gas(200, 0.2, "polygon", size, size));
    }
    for (Growth& growth : growths) {
        const std::span<const Rate> rates = growth.rates;
        growth.all = fit(rates);
        growth.end = fit(rates.subspan(rates.size() / 2));
    }
    return growths;
}

} // namespace flying::bench
