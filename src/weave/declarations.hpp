#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "weave/problems.hpp"

namespace flying::weave {

/// A function, a type or a constant, with the comment above it.
struct Declaration
{
    std::string name;  ///< with its class, without the namespace: `Polygon::area`
    std::string kind;  ///< as ctags calls it: function, prototype, class, struct, enum, variable, alias
    std::string scope; ///< the class that it belongs to, or nothing
    int first = 0;     ///< line, its comment's where it has one
    int own = 0;       ///< line of the name itself
    int last = 0;
};

/// The declarations of every source of C++ in `src` and `chapters`, by path, in the order of their lines.
[[nodiscard]] std::map<std::string, std::vector<Declaration>> read_declarations(const std::filesystem::path& project,
                                                                                Problems& problems);

} // namespace flying::weave
