#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "weave/problems.hpp"

namespace flying::weave {

/// What stands in a chapter between two blank places.
enum class BlockKind
{
    text,       ///< Markdown: paragraphs, headings, lists, tables
    fence,      ///< quoted matter that is no code of the project: ```text, ```sh, ```toml
    listing,    ///< listing region... [again]
    equation,   ///< equation id [kind of receipt], then a ```tex block
    definition, ///< definition id, then a ```tex block
    derivation, ///< derivation id [for m in 1..2, ...], then a ```tex block, one formula a line, its reason after %
    figure,     ///< figure name "what to see" ["what there is"]
    output,     ///< output program [N[-M]]: all that it printed, or from the N-th table to the M-th
    live,       ///< live name "what to see" ["what there is"]
    exercise,   ///< exercise eK
};

struct Block
{
    BlockKind kind = BlockKind::text;
    Place place;
    std::string name;     ///< first word after the directive
    std::string options;  ///< what follows the name, caption taken out
    std::string caption;  ///< between double quotes: what to see
    std::string alt;      ///< between the next pair: what there is, for those who don't see it
    std::string language; ///< of a fence
    std::vector<std::pair<int, std::string>> lines; ///< line number and text: of a text, a fence, a formula
};

/// A line of the table of symbols.
struct Symbol
{
    Place place;
    std::string tex;     ///< without its dollars
    std::string meaning; ///< Markdown
    std::string unit;    ///< Markdown
    std::string code;    ///< name in C++, without backquotes; empty where it has none
};

/// A file of the book's text, taken apart.
struct ChapterText
{
    std::string path;
    std::string title; ///< of its first line, `# Title`
    std::vector<Block> blocks;
    std::vector<Symbol> symbols;
    std::vector<std::string> sections; ///< titles of the headings `## ...`
};

/// What a listing shows: one region or several, as new or once more.
struct Listing
{
    std::vector<std::string> names;
    bool is_again = false;
};
[[nodiscard]] Listing listing_of(const Block& block);

/// Which of the tables that a program printed are shown, counted from 1: what stands between empty lines.
struct OutputPart
{
    int first = 1;
    int last = 0; ///< 0: to the end
};
/// Of the options of an output; nothing where they are neither empty, nor `N`, nor `N-M`.
[[nodiscard]] std::optional<OutputPart> output_part(const std::string& options);

/// The tables of an output, each with its lines; no empty lines between.
[[nodiscard]] std::vector<std::string> output_tables(const std::string& printed);

/// What that part of an output has, its tables one empty line apart.
[[nodiscard]] std::string part_of(const std::string& printed, const OutputPart& part);

/// What a figure's anchor and number go by: a live one may have the name of a
/// drawn one.
[[nodiscard]] std::string figure_key(const Block& block);

/// The word that starts a directive's line, without its colons.
[[nodiscard]] std::string directive_word(BlockKind kind);

/// Takes the text apart. What can't be understood goes to `problems`.
[[nodiscard]] ChapterText parse_chapter(const std::string& path, const std::string& text, Problems& problems);

} // namespace flying::weave
