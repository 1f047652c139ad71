#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "weave/book.hpp"
#include "weave/chapter.hpp"
#include "weave/ledger.hpp"
#include "weave/problems.hpp"
#include "weave/sources.hpp"

namespace flying::weave {

/// The folders that the book is made from.
struct Folders
{
    std::filesystem::path project; ///< holds `chapters`, `src`, `docs`
    std::filesystem::path kit;     ///< holds Doxyfile.in, the theme and the scripts: `docs` of this project, or installed
    std::filesystem::path build;   ///< holds `receipts`, `outputs`, `figures`, which the programs of the chapters leave
};

/// An exercise's folder.
struct Exercise
{
    std::string name;   ///< `e1`
    std::string folder; ///< from the project's folder
    bool in_code = false;
    ChapterText text;
    std::optional<ChapterText> hint;
    std::optional<ChapterText> solution; ///< of an exercise without code
};

/// A chapter whose text is written.
struct Chapter
{
    ChapterEntry entry;
    ChapterText text;
    std::vector<Exercise> exercises; ///< in the order of their names
};

/// Where an equation, a definition or a derivation stands.
struct Numbered
{
    BlockKind kind = BlockKind::equation;
    std::string number; ///< `4.7`
    std::string page;   ///< name of the page, without .html
    std::string anchor; ///< on it
    const Block* block = nullptr;
};

/// Everything that the pages are made from.
struct Material
{
    Folders folders;
    Book book;
    Sources sources;
    Ledger ledger;
    std::vector<Chapter> chapters;              ///< those that are written, in order
    std::map<std::string, ChapterText> extras;  ///< pages beside the chapters: about, glossary, teachers
    std::map<std::string, std::string> outputs; ///< `02-rectangle/demo`: what that program printed
    std::map<std::string, Numbered> numbered;   ///< by id
    std::map<std::string, std::string> figures; ///< number of each, by chapter and name: `07-impulse/push` is `7.2`
};

/// Reads it all. What is wrong goes to `problems`.
[[nodiscard]] Material read_material(const Folders& folders, Problems& problems);

/// The file that a chapter's program drew or recorded, such as `mass-element.svg`.
[[nodiscard]] std::filesystem::path drawn_file(const Material& material, const Chapter& chapter,
                                               const std::string& name);

/// The heading over a page, with the chapter's number.
[[nodiscard]] std::string page_title(const ChapterEntry& entry);

} // namespace flying::weave
