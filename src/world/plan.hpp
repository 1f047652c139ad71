#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "broadphase/pair_finder.hpp"
#include "world/scene.hpp"

namespace flying {

/// What a skip may do to the results. Neutral: not one bit changes. Ordered: neutral
/// because order comes from ids. Altering: results change, and the price is measured.
enum class SkipClass
{
    neutral,
    ordered,
    altering
};

/// One kind of work that a scene may not need.
struct Skip
{
    std::string name; ///< as `--without NAME` takes it
    SkipClass kind = SkipClass::neutral;
    bool active = false;    ///< the work is left out in this scene
    bool has_work = true;   ///< there is such work in this scene to leave out
    std::string reason;     ///< why it is, or why it is not
    std::int64_t saved = 0; ///< after a run: how often the work was left out
    std::string saved_unit; ///< what `saved` counts, such as "pairs"
};

/// What becomes of the work: "skipped", "done", or "none" where there is none to do.
[[nodiscard]] const char* fate_of(const Skip& skip);

/// What a scene needs, and why the rest is skipped.
struct Plan
{
    PairFinder pair_finder = PairFinder::grid;
    bool skips_static_pairs = true; ///< two static bodies are never compared
    bool skips_far_features = true; ///< turning features wait until bounding circles meet
    bool skips_search = true;       ///< movers under one acceleration need no search
    bool skips_absent_field = true; ///< without a uniform field, flights are straight lines
    bool skips_apart_rings = true;  ///< bodies on rings that don't overlap are left alone
    bool skips_far_vertices = true; ///< vertices out of reach are not followed
    bool sleeps = true;             ///< what a step leaves as it was, to the bit, is left out of the next
    bool warm_starts = true;        ///< contact impulses are sought from those of the step before
    std::vector<Skip> skips;        ///< every skip this program knows, active or not
};

/// The plan for a valid scene; a pure function.
/// without  names of skips to leave inactive; unknown names are ignored here (`skip_names`
/// tells those that are known)
[[nodiscard]] Plan make_plan(const Scene& scene,
                             const std::vector<std::string>& without = {});

/// All names that `without` may hold.
[[nodiscard]] std::vector<std::string> skip_names();

} // namespace flying
