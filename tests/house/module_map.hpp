#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "house.hpp"

namespace house {

/// Which module includes which, as a diagram in Mermaid's words: arrows that follow from others are left out.
[[nodiscard]] std::string module_map(const std::vector<Source>& sources);

/// Where the diagram stands in a page: from its first letter to one past its last.
struct MapPlace
{
    std::size_t begin = 0;
    std::size_t end = 0;
};

/// None where the page has no block of Mermaid.
[[nodiscard]] std::optional<MapPlace> find_map(const std::string& page);

} // namespace house
