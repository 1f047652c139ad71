#pragma once

#include <optional>
#include <string>
#include <vector>

#include "math/expected.hpp"
#include "world/scene.hpp"

namespace flying {

/// One line "flying: TEXT" on standard error.
void complain(const std::string& text);

/// Every fault on a line of its own, on standard error.
void complain(const Faults& faults);

/// A scene that is fit to run; otherwise its faults have been printed.
[[nodiscard]] std::optional<Scene> read_scene_or_complain(const std::string& path);

/// Whether all names are names of skips; otherwise the first that is none, and the one that was meant, have been
/// printed.
[[nodiscard]] bool are_skip_names(const std::vector<std::string>& names);

/// "1 body", "2 bodies"
[[nodiscard]] std::string counted(long count, const std::string& one, const std::string& many);

} // namespace flying
