#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "weave/declarations.hpp"
#include "weave/problems.hpp"

namespace flying::weave {

/// What a line of a source file is to the book.
enum class LineKind
{
    content, ///< to be shown by some chapter
    marker,  ///< opens or closes a region
    frame,   ///< include, guard, namespace brace, blank: part of every file, shown by none
};

/// The lines between a pair of markers `// [name]`. Lines of a region inside another belong to the inner one alone: the
/// outer shows the inner's name in their place.
struct Region
{
    std::string name;
    std::string file;        ///< from the project's folder
    int first = 0;           ///< line after the opening marker
    int last = 0;            ///< line before the closing marker
    std::vector<int> inner;  ///< regions directly inside, in order: indices into Sources::regions
    bool whole_file = false; ///< not marked: stands for a file without any markers
    bool declared = false;   ///< not marked: a whole declaration
};

struct SourceFile
{
    std::string path; ///< from the project's folder
    std::vector<std::string> lines;
    std::vector<LineKind> kinds; ///< of each line
    std::vector<int> owner;      ///< innermost region of each line, or -1: an index into Sources::regions
};

/// All files that a chapter may show, and their regions.
struct Sources
{
    std::map<std::string, SourceFile> files; ///< by path
    std::vector<Region> regions;
    std::map<std::string, int> by_name;                           ///< index into regions
    std::map<std::string, std::vector<Declaration>> declarations; ///< by path

    /// The region of that name; the declaration `mass/disc.cpp:disc_mass`, comment included; or, where `name`
    /// is the path of a file without markers, a region for the whole of it. -1 where there is none.
    [[nodiscard]] int find(const std::string& name) const;
};

/// Reads the file and adds it and its regions. Broken pairs and names used twice go to `problems`.
void read_source(const std::filesystem::path& project, const std::string& path, Sources& sources, Problems& problems);

/// Reads every source of the engine and of the chapters.
[[nodiscard]] Sources read_sources(const std::filesystem::path& project, Problems& problems);

} // namespace flying::weave
