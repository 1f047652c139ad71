#pragma once

#include <string>

#include "world/world.hpp"

namespace flying {

/// A run that was stopped, with all that it takes to go on with the same bits.
struct SavedRun
{
    WorldOptions options;
    Snapshot snapshot;
};

/// The text of a file that `read_saved_run` reads back to the same bits.
///
/// scene  the one that runs: its fingerprint is in the file, so that no other is gone on with
[[nodiscard]] std::string write_saved_run(const Scene& scene, const WorldOptions& options, const Snapshot& snapshot);

/// Faults, placed at the path: no such file, none of this program's, one of another version, cut short or changed since
/// it was written, or of another scene.
[[nodiscard]] Expected<SavedRun> read_saved_run(const std::string& path, const Scene& scene);

/// The same from the text of such a file.
/// place  what to call it in faults
[[nodiscard]] Expected<SavedRun> read_saved_run_text(const std::string& text, const std::string& place,
                                                     const Scene& scene);

} // namespace flying
