#pragma once

#include <string>

#include "world/scene.hpp"

namespace flying {

/// A scene as TOML text that `read_scene_text` reads back to the same bits: numbers in the fewest digits that name
/// them. Keys whose values are the defaults are left out.
///
/// scene    any values; only valid ones can be read back
/// comment  lines to put above everything, each with a "# " before it; none where empty
[[nodiscard]] std::string write_scene(const Scene& scene, const std::string& comment = {});

/// The fewest digits that read back to the same double, as TOML wants them: 1.0, -0.0, 1e-07, inf, nan.
[[nodiscard]] std::string write_number(double value);

} // namespace flying
