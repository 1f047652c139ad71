#pragma once

#include <filesystem>

#include "weave/material.hpp"
#include "weave/problems.hpp"

namespace flying::weave {

/// Writes the first page of the manual as Doxygen reads it: what book.toml says of the library, the example from the
/// text that it names, the modules in their order, and where to go next. A book without words for it gets its title and
/// its modules.
void write_manual_front(const Material& material, const std::filesystem::path& project,
                        const std::filesystem::path& file, Problems& problems);

} // namespace flying::weave
