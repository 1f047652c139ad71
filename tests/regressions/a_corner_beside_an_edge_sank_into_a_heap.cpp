// A heap looks again, where a step ends, only at pairs that may have come to overlap. Of a pair with a single point it
// was thought that all other corners were out of reach. But a corner beyond the end of the edge that it nears is
// clipped, and no point, however near: a box that span past another one sank into it by a twenty-fifth of its size, and
// nobody looked.

#include <doctest/doctest.h>

#include "scene/generate.hpp"
#include "world/world.hpp"

using namespace flying;

TEST_CASE("no corner of a box that is poured sinks into another unnoticed")
{
    struct Pile
    {
        int count;
        std::uint64_t seed;
    };
    for (const Pile& pile : {Pile{150, 48}, Pile{400, 13}}) {
        CAPTURE(pile.count);
        GenerateOptions options;
        options.count = pile.count;
        options.seed = pile.seed;
        options.shape = "box";
        options.restitution = 0.0;
        options.friction = 0.5;
        WorldOptions world_options;
        world_options.engine = EngineChoice::rest;
        World world = World::make(generate("pile", options).value(), world_options).value();
        REQUIRE_FALSE(world.advance(4.0));
        // Half a diagonal of the smallest is 0.4 m
        CHECK(world.report().max_overlap < 0.01 * 0.4);
    }
}
