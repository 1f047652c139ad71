#include <doctest/doctest.h>

#include <algorithm>

#include "stress/random_pairs.hpp"
#include "support/effort.hpp"

using namespace flying;
using namespace flying::stress;

TEST_CASE("no first impact is missed, late or early in a hundred thousand random pairs, against a dense search of its own")
{
    // ./course stress roots goes on with further seeds
    const int count = flying::testing::tried(100'000);
    int impacts = 0;
    int grazing = 0;
    for (int seed = 1; seed <= count; ++seed) {
        const RandomPair pair = random_pair(seed);
        const Verdict verdict = judge(pair, foresee(pair));
        if (!verdict.right) FAIL_CHECK("pair " << seed << ": " << verdict.why);
        impacts += verdict.impact ? 1 : 0;
        grazing += pair.is_grazing ? 1 : 0;
    }
    MESSAGE(impacts << " impacts, " << grazing << " pairs made to graze");
    CHECK(impacts > count / 2);
    CHECK(grazing > count / 100);
}

TEST_CASE("corners that go by a tip far from the origin, nearer than a vertex may lie below an edge, don't strike it")
{
    for (const std::uint64_t seed : {4'310'118, 4'929'312}) {
        const RandomPair pair = random_pair(seed);
        const Verdict verdict = judge(pair, foresee(pair));
        INFO("pair " << seed << ": " << verdict.why);
        CHECK(verdict.right);
    }
}

TEST_CASE("a body that has passed a centre closely, and is placed with more noise than its tolerance, doesn't fall through an edge")
{
    const RandomPair pair = random_pair(201'319'863);
    const Verdict verdict = judge(pair, foresee(pair));
    INFO(verdict.why);
    CHECK(verdict.impact);
    CHECK(verdict.right);
}

TEST_CASE("roots stay where they are, to rounding, when all times are a million seconds later")
{
    // ./course stress shift goes on with further seeds
    for (int seed = 1; seed <= flying::testing::tried(20'000); ++seed) {
        const double error = shifted_root_error(random_pair(seed), 1e6);
        INFO("pair " << seed);
        CHECK(error <= 1.0);
    }
}

namespace {

/// The same shape smaller by a share; a wall farther back.
Shape shrunk(const Shape& shape, double share)
{
    if (const auto* disc = std::get_if<Disc>(&shape)) return Disc{(1.0 - share) * disc->radius};
    if (const auto* wall = std::get_if<HalfPlane>(&shape)) return HalfPlane{wall->normal, wall->offset};
    const auto& polygon = std::get<Polygon>(shape);
    std::vector<std::vector<Vec2>> rings;
    for (std::size_t k = 0; k + 1 < polygon.ring_starts().size(); ++k) {
        auto& ring = rings.emplace_back();
        for (int v = polygon.ring_starts()[k]; v < polygon.ring_starts()[k + 1]; ++v)
            ring.push_back((1.0 - share) * polygon.vertices()[v]);
    }
    return Polygon(rings);
}

} // namespace

TEST_CASE("the dense search notices an answer that is late by a hair, and one that forgets the impact")
{
    // Bodies foreseen as if they were smaller by 1e-10 meet late; far from the origin rounding covers that
    int late = 0;
    int noticed_late = 0;
    int grazes = 0;
    int noticed_forgotten = 0;
    int forgotten = 0;
    const int count = flying::testing::tried(4000);
    for (int seed = 1; seed <= count; ++seed) {
        RandomPair pair = random_pair(seed);
        const Prediction right = foresee(pair);
        if (right.kind != Prediction::Kind::impact || right.time >= pair.horizon) continue;

        Prediction none;
        ++forgotten;
        noticed_forgotten += judge(pair, none).right ? 0 : 1;
        grazes += pair.is_grazing ? 1 : 0;

        if (pair.flying.flyer_a.state.position.norm() > 100.0) continue;
        const Shape shape_a = pair.shape_a;
        pair.shape_a = shrunk(pair.shape_a, 1e-10);
        const Prediction wrong = foresee(pair);
        pair.shape_a = shape_a;
        if (wrong.kind != Prediction::Kind::impact || wrong.time >= pair.horizon) continue;
        ++late;
        noticed_late += judge(pair, wrong).right ? 0 : 1;
    }
    MESSAGE(noticed_late << " of " << late << " late answers noticed, " << noticed_forgotten << " of " << forgotten
                         << " forgotten impacts, " << grazes << " grazes among them");
    CHECK(late > count / 2);
    CHECK(noticed_late > 0.95 * late);
    CHECK(noticed_forgotten > 0.98 * forgotten);
}
