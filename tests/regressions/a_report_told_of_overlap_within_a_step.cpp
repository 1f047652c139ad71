#include "math/random.hpp"
#include "support/effort.hpp"
#include "support/overlap.hpp"
#include "support/worlds.hpp"
#include "world/step_length.hpp"

using namespace flying;
using namespace flying::testing;

// The deepest overlap that a report tells was that with which some part of a step had begun, in the middle of it, and
// not any with which a step begins: 0.0058 m of a heap that began no step with half as much.

namespace {

/// A body goes so far in a step that the world shortens it, or will soon.
bool is_fast(const World& world, double step)
{
    for (int k = 0; k < world.body_count(); ++k) {
        if (!world.is_static(k) &&
            step * pace_of(world.state(k), world.shape(k), bounding_radius(world.shape(k)), {}) > 0.25)
            return true;
    }
    return false;
}

} // namespace

TEST_CASE("the overlap that is reported is the deepest with which any step begins")
{
    constexpr double k_size = 0.2;
    constexpr double k_step = 1.0 / 120.0;
    for (const int count : {12, 40}) {
        for (int trial = 0; trial < tried(6); ++trial) {
            const auto seed = static_cast<std::uint64_t>(15 + trial);
            Random random(seed);
            Scene scene;
            scene.world.field = UniformField{{0.0, -9.81}};
            scene.world.restitution = 0.0;
            scene.world.box = BoxDef{{0.0, 0.0}, {2.0, 20.0}};
            for (int k = 0; k < count; ++k) {
                BodyDef body;
                body.shape = RegularDef{3 + random.below(5), k_size};
                body.position = {0.3 + 0.45 * (k % 4), 0.3 + 0.45 * (k / 4)};
                body.angle = random.uniform(0.0, 6.0);
                body.velocity = {random.uniform(-2.0, 2.0), random.uniform(-2.0, 2.0)};
                scene.bodies.push_back(body);
            }
            // Steps begin at multiples of their length; where bodies are handed over, or are fast, in between
            World first = with_step(scene, k_step);
            World world = with_step(scene, k_step);
            double seen = 0.0;        // where steps begin for sure [m]
            double seen_nearly = 0.0; // near to where they do [m]
            for (int k = 1; k <= 240; ++k) {
                const std::size_t handed_over = first.handovers().size();
                const bool was_fast = is_fast(first, k_step);
                run(first, k * k_step);
                const bool is_whole = first.handovers().size() == handed_over && !was_fast && !is_fast(first, k_step);
                const int looks = is_whole ? 1 : 64;
                for (int look = 1; look <= looks; ++look) {
                    run(world, (k - 1 + static_cast<double>(look) / looks) * k_step);
                    double& deepest = look == looks ? seen : seen_nearly;
                    deepest = std::max(deepest, k_size * deepest_overlap(world));
                }
            }
            CAPTURE(count);
            CAPTURE(seed);
            CHECK(world.report().max_overlap <= std::max(seen, 1.02 * seen_nearly) + 1e-9);
        }
    }
}
