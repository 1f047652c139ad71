#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "weave/material.hpp"
#include "weave/pages.hpp"
#include "weave/problems.hpp"

namespace flying::weave {

/// What Doxygen knows of the program, from its tag file.
struct Manual
{
    std::map<std::string, std::string> names;   ///< page and anchor of a name, with and without `flying::`
    std::map<std::string, std::string> sources; ///< page with the text of a source file, by its path
    std::map<std::string, std::string> files;   ///< page about a source file, by its path
};

/// Reads the tag file; paths come back from the project's folder on.
[[nodiscard]] Manual read_manual(const std::filesystem::path& tag_file, const std::filesystem::path& project);

/// Puts the fragments in the place of their tokens and writes every page to `html`. The manual is in `html/manual`: its
/// pages get links to the chapters.
void finish_pages(const Material& material, const Pages& pages, const std::vector<std::string>& formulas,
                  const Manual& manual, const std::filesystem::path& html, Problems& problems);

/// The lines of Doxygen's page of a source, by number, with the links that lead where they say, without their numbers.
[[nodiscard]] std::map<int, std::string> linked_lines(const std::filesystem::path& page);

/// Keeps words of code in one line: a browser would go on in the next one behind the hyphen of `1e-12`.
[[nodiscard]] std::string with_whole_words(const std::string& html);

/// Takes the lines of a listing in order. Where a line goes on with a statement, marks what it is indented by beyond
/// two levels: a narrow screen leaves that out.
class Indents
{
public:
    [[nodiscard]] std::string mark(std::string line);

private:
    std::size_t statement_ = 0; ///< indent of the last line that began a statement
};

/// Every link of every page leads somewhere: to a file that is there and to an anchor in it.
void check_links(const std::filesystem::path& html, Problems& problems);

} // namespace flying::weave
