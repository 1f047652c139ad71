#include <doctest/doctest.h>

#include <algorithm>
#include <vector>

#include "bench/reference_discs.hpp"
#include "scene/generate.hpp"
#include "world/world.hpp"

using namespace flying;

TEST_CASE("a thousand discs at packing 0.1 are where long doubles have them after a second, within 1e-11 m")
{
    GenerateOptions options;
    options.seed = 20;
    options.count = 1000;
    options.packing = 0.1;
    options.rms_speed = 5.0;
    options.radius = Bounds{0.5, 0.5};
    const auto scene = generate("gas", options);
    REQUIRE(scene);
    REQUIRE(bench::has_reference(scene.value()));
    auto world = World::make(scene.value());
    REQUIRE(world);
    REQUIRE_FALSE(world.value().advance(1.0).has_value());
    CHECK(world.value().collisions() > 500);

    const std::vector<BodyState> exact = bench::reference_discs(scene.value(), 1.0);
    std::vector<double> errors;
    for (std::size_t k = 0; k < exact.size(); ++k) {
        errors.push_back((world.value().state(static_cast<int>(k)).position - exact[k].position).norm());
    }
    std::sort(errors.begin(), errors.end());
    MESSAGE("median " << errors[errors.size() / 2] << " m, worst " << errors.back() << " m");
    CHECK(errors[errors.size() / 2] <= 1e-11);
    CHECK(errors.back() <= 1e-9); // of those that have met others most often
}
