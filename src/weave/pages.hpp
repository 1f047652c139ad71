#pragma once

#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "weave/fragments.hpp"
#include "weave/material.hpp"
#include "weave/problems.hpp"
#include "weave/rules.hpp"

namespace flying::weave {

/// A heading of a page.
struct Section
{
    int level = 2; ///< 2 or 3: h2 or h3
    std::string title;
    std::string anchor;
};

/// A page of the book.
struct Page
{
    std::string name;     ///< of its file, without .html
    std::string title;    ///< its only h1
    std::string over;     ///< HTML over the title: the part of the book
    std::string under;    ///< HTML under the title: the question, what it builds on
    std::string markdown; ///< with tokens of fragments
    std::string foot;     ///< HTML after it
    std::vector<Section> sections;
};

/// All pages of the book, and what their tokens stand for.
struct Pages
{
    std::vector<Page> list;
    Fragments fragments;
};

/// Numbers that the appendix prints.
struct Counts
{
    Coverage coverage;
    int given = 0;
};

/// Writes every page: the chapters, and what is generated.
[[nodiscard]] Pages make_pages(const Material& material, const Counts& counts, Problems& problems);

/// A text's blocks as Markdown, in which tokens stand for what is more than that.
class TextWriter
{
public:
    TextWriter(const Material& material, Fragments& fragments, Problems& problems)
        : material_(material), fragments_(fragments), problems_(problems)
    {
    }

    /// All blocks. `chapter` is the one they belong to.
    [[nodiscard]] std::string blocks(const Chapter& chapter, const ChapterText& text);

    /// Running text.
    [[nodiscard]] std::string inline_text(const std::vector<std::pair<int, std::string>>& lines,
                                          const std::string& file);

    /// The answers to a chapter's exercises, under a heading.
    [[nodiscard]] std::string answers(const Chapter& chapter);

    /// A heading, as a token. Two of one page with the same words get different anchors.
    [[nodiscard]] std::string heading(int level, const std::string& title);

    /// The headings since the last call, and the end of a page.
    [[nodiscard]] std::vector<Section> take_sections();

private:
    [[nodiscard]] std::string block(const Chapter& chapter, const Block& block);
    [[nodiscard]] std::string text(const Chapter& chapter, const Block& block);
    [[nodiscard]] std::string listing(const Block& block);
    /// Its lines without what lies folded in it; `longest` grows to the longest of them.
    [[nodiscard]] std::string region_lines(const Region& region, const Place& place, std::size_t& longest);
    [[nodiscard]] std::string formula(const Block& block);
    /// `result` is the equation behind it that only numbers its last line, or null.
    [[nodiscard]] std::string derivation(const Block& block, const Block* result);
    [[nodiscard]] std::string figure(const Chapter& chapter, const Block& block);
    [[nodiscard]] std::string live(const Chapter& chapter, const Block& block);
    [[nodiscard]] std::string output(const Chapter& chapter, const Block& block);
    [[nodiscard]] std::string exercise(const Chapter& chapter, const Block& block);
    [[nodiscard]] static std::string answer_anchor(const Chapter& chapter, const Exercise& exercise);
    /// Where an insert stands.
    enum class Site
    {
        prose,
        sentence_start,
        formula
    };
    [[nodiscard]] std::string insert(const std::string& text, Site site, const Place& place);
    [[nodiscard]] std::string math(const std::string& tex, const Place& place);
    /// The figure's number, and what to see in it.
    [[nodiscard]] std::string caption(const Chapter& chapter, const Block& block);
    /// What a figure shows, for those who don't see it: without dollars and backquotes, its inserts as text.
    [[nodiscard]] std::string plain_caption(const Block& block);

    const Material& material_;
    Fragments& fragments_;
    Problems& problems_;
    std::vector<Section> sections_;
    std::set<std::string> anchors_; // of the page
};

/// Beside an equation or a derivation: a tick with the worst error, and on demand how it was checked. HTML.
[[nodiscard]] std::string receipt_note(const Material& material, const Numbered& numbered);
/// How it was checked, in a sentence of HTML; empty for a definition.
[[nodiscard]] std::string receipt_sentence(const Material& material, const Numbered& numbered);

/// Pages for those who study and teach: answers, glossary, index of terms, what a teacher needs, about the book.
void add_study_pages(const Material& material, TextWriter& writer, Pages& pages);

/// Pages made from the whole: contents, map, equations, symbols, what is left out.
void add_generated_pages(const Material& material, const Counts& counts, TextWriter& writer, Pages& pages);

/// A program's text with its words coloured, as HTML: for files that Doxygen doesn't read.
[[nodiscard]] std::string colour_code(const std::string& code);

} // namespace flying::weave
