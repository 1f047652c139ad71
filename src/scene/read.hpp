#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "math/expected.hpp"
#include "world/make_room.hpp"
#include "world/scene.hpp"

namespace flying {

/// Largest scene that is read; ten thousand bodies take two or three million bytes.  [bytes]
inline constexpr std::size_t k_largest_scene = std::size_t{64} << 20;

/// Changes a scene that isn't fit to run into one that is; false where it can't.
using SceneMender = bool (*)(Scene&);

/// A scene from TOML text, checked: what comes back is fit to run.
///
/// text      any bytes; the schema is that of `write_scene`, and keys outside it are refused
/// filename  what to call the text in faults
/// mend      is asked, where there is one, when a text that was read whole is found not fit to run
///
/// Faults come all together, in the order of the text: what is no TOML (then only the first such place), keys that are
/// unknown, missing or of the wrong type, and all that `validate` finds in the parts that could be read. Places are
/// `FILE:LINE:COLUMN` (both from 1, the column in characters), then the body, then the key:
/// `scene.toml:12:9: body "left", shape.radius`. Show them with `format_fault`.
[[nodiscard]] Expected<Scene> read_scene_text(std::string_view text, const std::string& filename,
                                              SceneMender mend = nullptr);

/// A scene from a file, as `read_scene_text` has it. Bodies that overlap by their last digits are moved apart.
/// path  what can be opened and read to its end, pipes included
/// mend  as there
/// Faults besides: no such file, a directory, not readable, longer than `k_largest_scene`.
[[nodiscard]] Expected<Scene> read_scene_file(const std::string& path, SceneMender mend = make_room_for_digits);

} // namespace flying
