#pragma once

#include <optional>
#include <string>
#include <vector>

#include "scene/generate.hpp"

namespace CLI {
class App;
}

namespace flying {

/// `generate` as it stands on the command line: numbers in lists, not yet counted.
struct GenerateCommand
{
    std::string kind;
    GenerateOptions options;
    std::vector<double> radius;  ///< one or two
    std::vector<double> speed;   ///< one or two
    std::vector<double> box;     ///< xmin ymin xmax ymax
    std::vector<double> gravity; ///< x y
};

/// Add the command `generate` to the program's.
void add_generate(CLI::App& app, GenerateCommand& command);

/// Generate and print the scene; returns the exit status.
/// typed  the command line, for the scene's first line
[[nodiscard]] int run_generate(const GenerateCommand& command, const std::string& typed);

} // namespace flying
