#pragma once

#include <map>
#include <string>
#include <vector>

#include "weave/problems.hpp"

namespace flying::weave {

/// What a fragment stands for.
enum class FragmentKind
{
    html,    ///< finished HTML, in which other fragments' tokens may stand
    formula, ///< TeX, rendered before the pages are finished
    code,    ///< a name of the program, linked to its page of the manual where it has one
    lines,   ///< lines of a source file, taken with their links from Doxygen's page of the file
    source,  ///< link target: Doxygen's page of a source file
};

struct Fragment
{
    FragmentKind kind = FragmentKind::html;
    std::string text; ///< HTML, TeX, name, or path of the file
    Place place;
    bool display = false;               ///< a formula on its own line
    std::vector<int> lines;             ///< numbers of the lines of a listing, in order
    std::map<int, std::string> instead; ///< before which line stands what HTML
};

/// A token as a block of its own in Markdown.
[[nodiscard]] std::string block_token(const std::string& token);

/// HTML that Doxygen must not touch. While Doxygen works, a token, a word like any other, stands in its place.
class Fragments
{
public:
    /// Keeps the fragment and returns its token.
    std::string add(Fragment fragment);
    std::string add_html(std::string html);
    std::string add_formula(std::string tex, bool display, Place place);

    [[nodiscard]] const std::vector<Fragment>& list() const { return list_; }
    [[nodiscard]] std::vector<Fragment>& list() { return list_; }

    /// The number of the fragment whose token starts at `at`, and how long the token is; -1 where none does.
    struct Found
    {
        int index = -1;
        std::size_t length = 0;
    };
    [[nodiscard]] static Found token_at(const std::string& text, std::size_t at);

private:
    std::vector<Fragment> list_;
};

} // namespace flying::weave
