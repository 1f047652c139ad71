#include <cstdio>

#include "gas.hpp"
#include "room.hpp"

using namespace flying;

namespace {

/// A ball in a rectangular room, compared with the straight way of the unfolded one.
void bounce_about()
{
    const Room room;
    EventEngine engine = room_of(room);
    std::printf("bounces          time   off the unfolded way\n");
    for (double bounces = 100.0; bounces <= 1e6; bounces *= 10.0) {
        const double time = bounces / (room.v.x() / room.width + room.v.y() / room.height);
        if (engine.advance(time, -1)) return;
        const BodyState ball = state_at(engine.flyer(0), time);
        const Vec2 straight = room.x + time * room.v;
        const Vec2 place(folded(straight.x(), room.width),
                         folded(straight.y(), room.height));
        const double off = (ball.position - Vec2(0.125, 0.125) - place).norm();
        std::printf("%7ld %11.0f s %16.0e m\n", engine.counts().impacts, time, off);
    }
}

/// The same gas with cells and without.
void look_around()
{
    std::printf(
        "\ndiscs   impacts   looks an impact: all pairs   by cells   same to the bit\n");
    for (const int side : {10, 20, 40}) {
        EventEngine all = gas_of(side, 0.1, 7, PairFinder::all_pairs);
        EventEngine near = gas_of(side, 0.1, 7, PairFinder::grid);
        if (all.advance(20.0, -1) || near.advance(20.0, -1)) return;
        const auto looks = [](const EventEngine& engine) {
            const EventCounts& counts = engine.counts();
            return static_cast<double>(counts.predictions) /
                   static_cast<double>(counts.impacts);
        };
        std::printf("%5d %9ld %28.0f %10.0f %17s\n", side * side, near.counts().impacts,
                    looks(all), looks(near),
                    all.log_hash() == near.log_hash() ? "yes" : "no");
    }
}

/// Four hundred discs, and what is known of the whole of them.
void fill_a_room()
{
    EventEngine gas = gas_of(20, 0.29, 109);
    GasWatch watch(gas, 400);
    watch.follow(12.0);
    const GasMeasure m = watch.measure(20.0, 20);
    const double z = compressibility(m.packing.mean);
    std::printf("\ngas of 400 discs: %ld impacts in %.0f s\n", gas.counts().impacts,
                gas.time());
    std::printf("packing in the middle = %.4f +- %.4f\n", m.packing.mean, m.packing.error);
    std::printf("impacts of a disc = %.3f +- %.3f 1/s\n", m.rate.mean, m.rate.error);
    std::printf("  by the theory = %.3f 1/s\n", gas_rate(z, 0.5, 1.0, 1.0));
    std::printf("Z from the impacts = %.3f +- %.3f\n", m.from_rate.mean, m.from_rate.error);
    std::printf("Z from the walls = %.3f +- %.3f\n", m.from_walls.mean, m.from_walls.error);
    std::printf("  by the series = %.3f\n", z);
}

} // namespace

int main()
{
    bounce_about();
    look_around();
    fill_a_room();
}
