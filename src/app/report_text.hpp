#pragma once

#include <string>
#include <vector>

#include "files/output_file.hpp"
#include "world/report.hpp"
#include "world/scene.hpp"

namespace flying {

/// What a run took.  [s]
struct RunSeconds
{
    double wall = 0.0;   ///< from the first event to the last frame
    double engine = 0.0; ///< in the world itself, without drawing and writing
};

/// A report for people, a line for each fact.
/// files  that were written
[[nodiscard]] std::string report_text(const Scene& scene, const Report& report, const RunSeconds& seconds,
                                      const std::vector<OutputFile*>& files);

/// What each stage of a run cost, as a table.
[[nodiscard]] std::string stats_text(const Report& report, const RunSeconds& seconds);

} // namespace flying
