// Sources as Doxygen is given them: with the comments of this project turned into its syntax.

#include <string>
#include <vector>

#include "weave/run.hpp"
#include "weave/text.hpp"

namespace flying::weave {

namespace {

/// Whether a comment's line starts a list entry: a name or several, then two blanks, then what it is.
bool is_entry(std::string_view text, std::size_t& name_end)
{
    if (text.empty() || text.front() == ' ') return false;
    const std::size_t gap = text.find("  ");
    if (gap == std::string_view::npos || gap == 0) return false;
    for (std::size_t k = 0; k < gap; ++k) {
        const bool after_comma = k > 0 && text[k] == ' ' && text[k - 1] == ',';
        if (!is_word(text[k]) && text[k] != ',' && !after_comma) return false;
    }
    name_end = gap;
    return true;
}

/// A line that only marks where a region begins or ends.
bool is_marker(std::string_view code)
{
    return code.substr(0, 4) == "// [" && code.back() == ']';
}

} // namespace

std::string without_markers(const std::vector<std::string>& lines)
{
    std::string out;
    for (const std::string& line : lines) out += (is_marker(trim(line)) ? "" : line) + "\n";
    return out;
}

std::string comment_markdown(const std::vector<std::string>& lines)
{
    std::string out;
    bool in_list = false;
    bool in_formula = false;
    for (const std::string& line : lines) {
        std::size_t name_end = 0;
        const bool is_indented = line.substr(0, 4) == "    ";
        if (is_indented && !in_list) {
            if (!in_formula) out += "\n```\n";
            in_formula = true;
            out += line.substr(4) + "\n";
            continue;
        }
        if (in_formula) out += "```\n";
        in_formula = false;
        if (is_entry(line, name_end)) {
            if (!in_list) out += "\n";
            out += "- **" + line.substr(0, name_end) + "** " + std::string(trim(line.substr(name_end))) + "\n";
            in_list = true;
        } else if (in_list && line.substr(0, 1) == " ") {
            out += "  " + std::string(trim(line)) + "\n";
        } else {
            out += (in_list ? "\n" : "") + line + "\n";
            in_list = false;
        }
    }
    return out + (in_formula ? "```\n" : "");
}

std::string filter_source(const std::vector<std::string>& lines)
{
    std::string out;
    bool in_list = false;
    for (const std::string& line : lines) {
        const std::string_view code = trim(line);
        const bool marker = is_marker(code);
        if (code.substr(0, 4) != "/// " || marker) {
            in_list = false;
            out += (marker ? "" : line) + "\n";
            continue;
        }
        const std::string_view text = code.substr(4);
        std::size_t name_end = 0;
        if (is_entry(text, name_end)) {
            out += "/// - <b>" + std::string(text.substr(0, name_end)) +
                   "</b>: " + std::string(trim(text.substr(name_end))) + "\n";
            in_list = true;
        } else if (in_list && text.front() == ' ') {
            out += "///   " + std::string(trim(text)) + "\n";
        } else {
            // A line that is no list ends the list
            out += (in_list ? "/// <br>" : "/// ") + std::string(trim(text)) + "\n";
            in_list = false;
        }
    }
    // The stop of `eq. 4` ends no sentence; for Doxygen it would end the brief description
    return replace_all(out, "eq. ", "equation ");
}

} // namespace flying::weave
