#include "world/plan.hpp"

#include <algorithm>

namespace flying {
namespace {

// [plan.fewest]
/// Below this number of moving bodies, looking at all pairs costs less than keeping cells: measured with discs at packing
/// 0.1, where the two break even between 20 and 40.
constexpr int k_fewest_for_grid = 32;
// [plan.fewest]

// [plan.names]
constexpr const char* k_grid = "grid";
constexpr const char* k_static_pairs = "static-pairs";
constexpr const char* k_far_features = "far-features";

[[nodiscard]] std::string count_of(int count, const std::string& one, const std::string& many)
{
    return std::to_string(count) + " " + (count == 1 ? one : many);
}
// [plan.names]

// [plan.census]
/// What the plan looks at.
struct Census
{
    int movers = 0;
    int statics = 0;
    int movers_with_corners = 0;
    bool is_central = false;
};
// [plan.census]

// [plan.take_census]
[[nodiscard]] Census take_census(const Scene& scene)
{
    Census census;
    census.statics = scene.world.box ? 4 : 0;
    if (const auto* central = std::get_if<CentralField>(&scene.world.field)) {
        census.is_central = true;
        if (central->radius > 0.0) ++census.statics;
    }
    for (const BodyDef& body : scene.bodies) {
        if (body.is_static) ++census.statics;
        else ++census.movers;
        if (!body.is_static && !std::holds_alternative<DiscDef>(body.shape)) ++census.movers_with_corners;
    }
    return census;
}
// [plan.take_census]

// [plan.grid]
/// Pairs of bodies that can't meet as long as neither leaves its cell.
[[nodiscard]] Skip far_pairs(const Census& census)
{
    const bool pays = census.movers >= k_fewest_for_grid;
    Skip skip{k_grid, SkipClass::ordered, pays && !census.is_central, "", 0, "pairs"};
    if (census.is_central) {
        skip.reason = "a central field: when a flight leaves its cell is foreseen for straight lines and parabolas only";
        return skip;
    }
    const std::string movers = count_of(census.movers, "moving body", "moving bodies");
    const std::string limit = std::to_string(k_fewest_for_grid);
    skip.reason = skip.active ? movers + ": only those in neighbouring cells are compared"
                              : movers + ", fewer than " + limit + ": comparing all pairs costs less than keeping cells";
    return skip;
}
// [plan.grid]

// [plan.static_pairs]
[[nodiscard]] Skip static_pairs(const Census& census)
{
    Skip skip{k_static_pairs, SkipClass::neutral, census.statics >= 2, "", 0, "pairs"};
    const std::string statics = count_of(census.statics, "static body", "static bodies");
    skip.reason = skip.active ? statics + ", walls included: they never move, so no two of them ever meet"
                              : statics + ": there is no pair of them";
    return skip;
}
// [plan.static_pairs]

// [plan.far_features]
[[nodiscard]] Skip far_features(const Census& census)
{
    const bool any_corners = census.movers_with_corners > 0 || census.statics > 4;
    Skip skip{k_far_features, SkipClass::neutral, any_corners || census.is_central, "", 0, "looks at features"};
    if (census.is_central) {
        skip.reason = "bodies whose rings round the centre don't overlap never meet, and features are looked at only "
                      "while the bounding circles of a pair overlap";
        return skip;
    }
    skip.reason = any_corners ? "corners and edges are looked at only while the bounding circles of a pair overlap"
                              : "discs have no corners to look at";
    return skip;
}
// [plan.far_features]

} // namespace

// [plan.make]
std::vector<std::string> skip_names() { return {k_grid, k_static_pairs, k_far_features}; }

Plan make_plan(const Scene& scene, const std::vector<std::string>& without)
{
    const Census census = take_census(scene);
    Plan plan;
    plan.skips = {far_pairs(census), static_pairs(census), far_features(census)};

    // [plan.make.without]
    // Leave out what the user asked to leave out
    for (Skip& skip : plan.skips) {
        if (std::find(without.begin(), without.end(), skip.name) == without.end() || !skip.active) continue;
        skip.active = false;
        skip.reason = "turned off by request (" + skip.reason + ")";
    }
    const auto active = [&](const char* name) {
        return std::any_of(plan.skips.begin(), plan.skips.end(),
                           [&](const Skip& skip) { return skip.name == name && skip.active; });
    };
    // [plan.make.without]
    plan.pair_finder = active(k_grid) ? PairFinder::grid : PairFinder::all_pairs;
    plan.skips_static_pairs = active(k_static_pairs);
    plan.skips_far_features = active(k_far_features);
    return plan;
}
// [plan.make]

} // namespace flying
