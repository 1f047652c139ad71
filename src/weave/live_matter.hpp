#pragma once

#include <filesystem>
#include <string>

#include "weave/run.hpp"

namespace flying::weave {

/// What live figures need beside the page: scripts, the engine's module, scenes, recordings.
///
/// Where the tools name no module of the engine, or one that is not there, the pages go without and play recordings.
void copy_live_matter(const Woven& woven, const Folders& folders, const Tools& tools, const std::filesystem::path& html,
                      Problems& problems);

/// The tag that loads a chapter's experiments; empty where it has none.
[[nodiscard]] std::string live_script(const Folders& folders, const ChapterEntry& entry);

/// The first page's moving picture, and the playground's frame.
[[nodiscard]] std::string front_figure();
[[nodiscard]] std::string playground_figure();

} // namespace flying::weave
