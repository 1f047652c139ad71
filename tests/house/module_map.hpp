#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "house.hpp"

namespace house {

/// Which module includes which, as a diagram in Mermaid's words: arrows that follow from others are left out.
[[nodiscard]] std::string module_map(const std::vector<Source>& sources);

/// The same within one module: which file includes which. A header and its source are one; arrows within a ring are all
/// there.
[[nodiscard]] std::string file_map(const std::vector<Source>& sources, const std::string& module);

/// Where a diagram stands in a page: from its first letter to one past its last.
struct MapPlace
{
    std::size_t begin = 0;
    std::size_t end = 0;
};

/// The first one below a heading. None where the page has no such heading, or no block of Mermaid below it.
[[nodiscard]] std::optional<MapPlace> find_map(const std::string& page, const std::string& heading);

/// The headings in docs/HOUSE.md.
inline constexpr const char* k_modules_heading = "## The map\n";
inline constexpr const char* k_rest_heading = "## Inside the resting integrator\n";

} // namespace house
