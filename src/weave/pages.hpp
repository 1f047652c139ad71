#pragma once

#include <string>
#include <vector>

#include "weave/fragments.hpp"
#include "weave/material.hpp"
#include "weave/problems.hpp"
#include "weave/rules.hpp"

namespace flying::weave {

/// A page for Doxygen.
struct Page
{
    std::string name; ///< Doxygen's id of the page, and its file's name without .html
    std::string markdown;
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

/// Writes every page: the chapters, the rest of their code, and what is generated.
[[nodiscard]] Pages make_pages(const Material& material, const Counts& counts, Problems& problems);

/// A text's blocks as Markdown for Doxygen.
class TextWriter
{
public:
    TextWriter(const Material& material, Fragments& fragments, Problems& problems)
        : material_(material), fragments_(fragments), problems_(problems)
    {
    }

    /// All blocks. `chapter` is the one they belong to; `page` the name of the page they go to.
    [[nodiscard]] std::string blocks(const Chapter& chapter, const ChapterText& text, const std::string& page);

    /// Running text.
    [[nodiscard]] std::string inline_text(const std::vector<std::pair<int, std::string>>& lines,
                                          const std::string& file);

private:
    [[nodiscard]] std::string block(const Chapter& chapter, const Block& block, const std::string& page);
    [[nodiscard]] std::string text(const Chapter& chapter, const Block& block, const std::string& page);
    [[nodiscard]] std::string listing(const Block& block);
    [[nodiscard]] std::string formula(const Block& block);
    [[nodiscard]] std::string derivation(const Block& block);
    [[nodiscard]] std::string figure(const Chapter& chapter, const Block& block);
    [[nodiscard]] std::string live(const Chapter& chapter, const Block& block);
    [[nodiscard]] std::string output(const Chapter& chapter, const Block& block);
    [[nodiscard]] std::string exercise(const Chapter& chapter, const Block& block, const std::string& page);
    /// Where an insert stands.
    enum class Site
    {
        prose,
        sentence_start,
        formula
    };
    [[nodiscard]] std::string insert(const std::string& text, Site site, const Place& place);
    [[nodiscard]] std::string math(const std::string& tex, const Place& place);
    [[nodiscard]] std::string caption(const Block& block);
    /// The words for those who don't see the figure: without dollars and backquotes, its inserts as text.
    [[nodiscard]] std::string plain_words(const Block& block);

    const Material& material_;
    Fragments& fragments_;
    Problems& problems_;
};

/// What stands under an equation or a derivation: how it was checked. HTML, with tokens.
[[nodiscard]] std::string receipt_line(const Material& material, const Numbered& numbered);

/// Pages made from the whole: contents, map, equations, symbols, what is left out.
void add_generated_pages(const Material& material, const Counts& counts, TextWriter& writer, Pages& pages);

/// A program's text with its words coloured, as HTML: for files that Doxygen doesn't read.
[[nodiscard]] std::string colour_code(const std::string& code);

} // namespace flying::weave
