#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

/// The rules by which the sources are laid out, as functions from what is there to what is wrong with it. Every fault
/// is one sentence that begins with the file, and the line where there is one; an empty list means that the rule is
/// kept.
namespace house {

/// One file of C++.
struct Source
{
    std::string path;               ///< from the root, with slashes: "src/math/vec2.hpp"
    std::string module;             ///< "math"; empty outside src and for a file directly in it
    std::vector<std::string> lines; ///< as written
    std::vector<std::string> code;  ///< the same lines with comments and the contents of literals left out
};

/// One `#include` of a source.
struct Include
{
    std::string name; ///< between the quotes or brackets
    int line = 0;     ///< from 1
    bool quoted = false;
};

/// Which chapters claim a file such as "src/math/vec2.hpp".
using Book = std::map<std::string, std::vector<int>>;

/// Every .hpp and .cpp below a folder of the root, in the order of their paths; none where there is no such folder.
[[nodiscard]] std::vector<Source> read_sources(const std::filesystem::path& root, const std::string& folder);

/// The list `files` of every `[[chapter]]`. Throws toml::parse_error where the file isn't TOML.
[[nodiscard]] Book read_book(const std::filesystem::path& file);

/// The text without comments, and with nothing between quotes; lines stay lines.
[[nodiscard]] std::string code_only(const std::string& text);

[[nodiscard]] std::vector<Include> includes(const Source& source);

/// True for the modules from math to world.
[[nodiscard]] bool is_engine(const std::string& module);

/// Includes of a module that no arrow leads to; modules and folders that the design doesn't know.
[[nodiscard]] std::vector<std::string> arrow_faults(const std::vector<Source>& sources);

/// Headers between angle brackets that an engine file may not include: all but Eigen's and a list of standard ones.
[[nodiscard]] std::vector<std::string> header_faults(const std::vector<Source>& sources);

/// Words that an engine file may not use: exceptions, printing, clocks, threads, functions whose bits differ by
/// platform.
[[nodiscard]] std::vector<std::string> word_faults(const std::vector<Source>& sources);

/// Files longer than a number of lines.
[[nodiscard]] std::vector<std::string> length_faults(const std::vector<Source>& sources, int most);

/// Classes with more private functions or more members than that.
[[nodiscard]] std::vector<std::string> class_faults(const std::vector<Source>& sources, int most_functions,
                                                    int most_members);

/// Types of one name in one namespace that two headers define: a program with both would have either, and which is chance.
[[nodiscard]] std::vector<std::string> name_faults(const std::vector<Source>& sources);

/// Region markers `// [name]` that don't come as a pair within their file.
[[nodiscard]] std::vector<std::string> marker_faults(const std::vector<Source>& sources);

/// Engine files in no chapter or in several; files in the book that aren't there.
[[nodiscard]] std::vector<std::string> book_faults(const std::vector<Source>& sources, const Book& book);

/// Engine files that include a file of a later chapter.
[[nodiscard]] std::vector<std::string> later_faults(const std::vector<Source>& sources, const Book& book);

/// Functions and types at the top of a header of src that nothing else in src uses: what only chapters or tests call stands
/// with them. Headers in `installed` are for others to use.
[[nodiscard]] std::vector<std::string> reach_faults(const std::vector<Source>& sources,
                                                    const std::set<std::string>& installed);

/// The paths, from the root, of the headers that the library installs: those that src/public_headers.cmake lists, and what
/// they include.
[[nodiscard]] std::set<std::string> installed_headers(const std::filesystem::path& root,
                                                      const std::vector<Source>& sources);

/// Files and folders beside the ones that the design lists and .gitignore names.
[[nodiscard]] std::vector<std::string> top_level_faults(const std::filesystem::path& root);

} // namespace house
