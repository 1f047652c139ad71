#pragma once

#include <string>

#include <pybind11/pybind11.h>

namespace flying {

/// A scene as TOML text. A text is taken as it is; of a dict each body goes on a line of its own, which is where faults
/// then say they are. Dicts hold bool, int, float, str, lists, tuples, dicts, and NumPy's numbers and arrays.
///
/// Raises TypeError for what is neither, and for what TOML has no word for, named by its path: "body[2].shape".
[[nodiscard]] std::string scene_text(const pybind11::object& scene);

} // namespace flying
