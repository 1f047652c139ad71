#include "world/plan.hpp"

#include <algorithm>

namespace flying {
namespace {

/// Below this number of moving bodies, looking at all pairs costs less than keeping cells:
/// measured with discs at packing 0.1, where counted instructions and processor time both
/// break even between 12 and 20.
constexpr int k_fewest_for_grid = 16;

constexpr const char* k_grid = "grid";
constexpr const char* k_static_pairs = "static-pairs";
constexpr const char* k_far_features = "far-features";
constexpr const char* k_cells = "cells";
constexpr const char* k_search = "search";
constexpr const char* k_field = "field";
constexpr const char* k_rings = "rings";
constexpr const char* k_far_vertices = "far-vertices";
constexpr const char* k_sleeping = "sleeping";
constexpr const char* k_warm_start = "warm-start";

[[nodiscard]] std::string count_of(int count, const std::string& one,
                                   const std::string& many)
{
    return std::to_string(count) + " " + (count == 1 ? one : many);
}

/// What the plan looks at.
struct Census
{
    int movers = 0;
    int statics = 0;
    int movers_with_corners = 0;
    int statics_with_corners = 0;
    bool is_central = false;
    bool falls = false;
};

[[nodiscard]] Census take_census(const Scene& scene)
{
    Census census;
    census.statics = scene.world.box ? 4 : 0;
    if (const auto* central = std::get_if<CentralField>(&scene.world.field)) {
        census.is_central = true;
        if (central->radius > 0.0) ++census.statics;
    }
    census.falls = uniform_acceleration(scene.world.field) != Vec2::Zero();
    for (const BodyDef& body : scene.bodies) {
        const bool has_corners = !std::holds_alternative<DiscDef>(body.shape);
        ++(body.is_static ? census.statics : census.movers);
        if (has_corners)
            ++(body.is_static ? census.statics_with_corners : census.movers_with_corners);
    }
    return census;
}

/// Pairs of bodies that can't meet as long as neither leaves its cell.
[[nodiscard]] Skip far_pairs(const Census& census)
{
    const bool pays = census.movers >= k_fewest_for_grid;
    Skip skip{k_grid, SkipClass::ordered, pays && !census.is_central, true, "", 0, "pairs"};
    if (census.is_central) {
        skip.reason = "a central field: when a flight leaves its cell is foreseen for "
                      "straight lines and parabolas only";
        return skip;
    }
    const std::string movers = count_of(census.movers, "moving body", "moving bodies");
    const std::string limit = std::to_string(k_fewest_for_grid);
    skip.reason = skip.active ? movers + ": only those in neighbouring cells are compared"
                              : movers + ", fewer than " + limit +
                                    ": comparing all pairs costs less than keeping cells";
    return skip;
}

[[nodiscard]] Skip static_pairs(const Census& census)
{
    const bool any = census.statics >= 2;
    Skip skip{k_static_pairs, SkipClass::neutral, any, any, "", 0, "pairs"};
    const std::string statics = count_of(census.statics, "static body", "static bodies");
    skip.reason =
        skip.active
            ? statics + ", walls included: they never move, so no two of them ever meet"
            : statics + ": there is no pair of them";
    return skip;
}

[[nodiscard]] Skip far_features(const Census& census)
{
    const bool any_corners = census.movers_with_corners + census.statics_with_corners > 0;
    const bool pays = any_corners || census.is_central;
    Skip skip{k_far_features, SkipClass::neutral, pays, pays, "", 0, "looks at features"};
    if (census.is_central) {
        skip.reason =
            "features are looked at only while the bounding circles of a pair overlap";
        return skip;
    }
    skip.reason = any_corners ? "corners and edges are looked at only while the bounding "
                                "circles of a pair overlap"
                              : "discs have no corners to look at";
    return skip;
}

/// Cells that few bodies don't need. Turned off, they are kept all the same.
[[nodiscard]] Skip cells(const Census& census)
{
    const bool few = census.movers < k_fewest_for_grid;
    const bool any = census.movers > 0 && !census.is_central;
    Skip skip{k_cells, SkipClass::ordered, few && any, any, "", 0, ""};
    const std::string limit = std::to_string(k_fewest_for_grid);
    skip.reason = few ? "fewer than " + limit + " moving bodies: no cells are kept for them"
                      : "so many moving bodies are found faster by their cells";
    if (census.is_central) skip.reason = "a central field: there are no cells to keep";
    return skip;
}

/// The door through which every pair can be foreseen: shapes by kind, flights of any kind,
/// features by windows.
[[nodiscard]] Skip search(const Census& census)
{
    const bool any = census.movers >= 2;
    Skip skip{k_search, SkipClass::neutral, any && !census.is_central, any, "", 0, "searches"};
    skip.reason = census.movers_with_corners > 0
                      ? "two moving bodies are first foreseen as circles on straight "
                        "paths, the roots of a quadratic"
                      : "discs meet at the roots of a quadratic: no code for corners is "
                        "entered for two of them";
    if (census.movers < 2) skip.reason = "no two bodies move";
    if (census.is_central) {
        skip.reason = "a central field: no two flights have a closed form together";
    }
    return skip;
}

/// The terms of an acceleration that isn't there.
[[nodiscard]] Skip field(const Census& census)
{
    const bool accelerates = census.falls || census.is_central;
    Skip skip{k_field, SkipClass::neutral, !accelerates, true, "", 0, ""};
    skip.reason = skip.active ? "no field: flights are straight lines"
                              : "a field accelerates what moves";
    return skip;
}

/// Pairs whose orbits keep them apart for ever.
[[nodiscard]] Skip rings(const Census& census)
{
    const bool any = census.is_central;
    Skip skip{k_rings, SkipClass::neutral, any, any, "", 0, ""};
    skip.reason = any ? "bodies whose rings round the centre don't overlap never meet"
                      : "no central field: there are no rings";
    return skip;
}

/// Vertices that can't come to an edge within a look.
[[nodiscard]] Skip far_vertices(const Census& census)
{
    const bool pairs = census.movers_with_corners > 1 ||
                       (census.movers_with_corners == 1 && census.statics_with_corners > 0);
    Skip skip{k_far_vertices, SkipClass::neutral, pairs, pairs, "", 0, ""};
    skip.reason = pairs ? "a vertex is followed only where it may reach the other body's "
                          "circle, and come behind all its edges"
                        : "no two bodies with corners can meet";
    return skip;
}

/// Bodies that lean on each other, and that steps leave as they are.
[[nodiscard]] Skip sleeping(const Census& census)
{
    const bool pays = census.movers > 0;
    Skip skip{k_sleeping, SkipClass::neutral, pays, pays, "", 0, "bodies in steps"};
    skip.reason = pays ? "bodies that a step leaves as they were are left out of the next, "
                         "until something touches them"
                       : "nothing moves";
    return skip;
}

/// Sweeps that begin elsewhere end elsewhere.
[[nodiscard]] Skip warm_start(const Census& census)
{
    const bool pays = census.movers > 0;
    Skip skip{k_warm_start, SkipClass::altering, pays, pays, "", 0, "solves of islands"};
    skip.reason = pays ? "impulses between bodies that lean on each other are sought from "
                         "those of the step before"
                       : "nothing moves";
    return skip;
}

} // namespace

std::vector<std::string> skip_names()
{
    return {k_grid,  k_cells, k_static_pairs, k_search,
            k_field, k_rings, k_far_features, k_far_vertices,
            k_sleeping, k_warm_start};
}

const char* fate_of(const Skip& skip)
{
    return skip.active ? "skipped" : skip.has_work ? "done" : "none";
}

Plan make_plan(const Scene& scene, const std::vector<std::string>& without)
{
    const Census census = take_census(scene);
    Plan plan;
    plan.skips = {far_pairs(census),    cells(census),       static_pairs(census),
                  search(census),       field(census),       rings(census),
                  far_features(census), far_vertices(census), sleeping(census),
                  warm_start(census)};

    // [plan.make.without]
    // Leave out what the user asked to leave out
    for (Skip& skip : plan.skips) {
        if (std::find(without.begin(), without.end(), skip.name) == without.end() ||
            !skip.active)
            continue;
        skip.active = false;
        skip.reason = "turned off by request (" + skip.reason + ")";
    }
    const auto active = [&](const char* name) {
        return std::any_of(plan.skips.begin(), plan.skips.end(), [&](const Skip& skip) {
            return skip.name == name && skip.active;
        });
    };
    // [plan.make.without]
    const bool keeps_cells = cells(census).active && !active(k_cells);
    plan.pair_finder =
        active(k_grid) || keeps_cells ? PairFinder::grid : PairFinder::all_pairs;
    plan.skips_static_pairs = active(k_static_pairs);
    plan.skips_far_features = active(k_far_features);
    plan.skips_search = active(k_search);
    plan.skips_absent_field = active(k_field);
    plan.skips_apart_rings = active(k_rings);
    plan.skips_far_vertices = active(k_far_vertices);
    plan.sleeps = active(k_sleeping) || !sleeping(census).active;
    plan.warm_starts = active(k_warm_start) || !warm_start(census).active;
    return plan;
}

} // namespace flying
