// Code in colours, and lines that may break where they are too long.

#include <cctype>
#include <set>
#include <string>
#include <string_view>

#include "weave/finish.hpp"
#include "weave/pages.hpp"
#include "weave/text.hpp"

namespace flying::weave {

namespace {

const std::set<std::string, std::less<>>& keywords()
{
    static const std::set<std::string, std::less<>> k_words = {
        "auto",     "bool",    "break",    "case",   "char",  "class",     "const",    "constexpr",     "continue",
        "default",  "do",      "double",   "else",   "enum",  "explicit",  "false",    "float",         "for",
        "friend",   "if",      "inline",   "int",    "long",  "namespace", "noexcept", "nullptr",       "operator",
        "override", "private", "public",   "return", "short", "sizeof",    "static",   "static_assert", "static_cast",
        "struct",   "switch",  "template", "this",   "true",  "typename",  "unsigned", "using",         "virtual",
        "void",     "while"};
    return k_words;
}

std::string span(const char* kind, std::string_view text)
{
    return std::string("<span class=\"") + kind + "\">" + escape_html(text) + "</span>";
}

std::string colour_line(std::string_view line)
{
    if (trim(line).substr(0, 1) == "#") return span("preprocessor", line);
    std::string out;
    std::size_t at = 0;
    while (at < line.size()) {
        const char c = line[at];
        std::size_t end = at + 1;
        if (line.substr(at, 2) == "//") {
            out += span("comment", line.substr(at));
            break;
        }
        if (c == '"' || c == '\'') {
            while (end < line.size() && line[end] != c) end += line[end] == '\\' ? 2 : 1;
            end = std::min(end + 1, line.size());
            out += span("stringliteral", line.substr(at, end - at));
        } else if (is_word(c)) {
            while (end < line.size() && is_word(line[end])) ++end;
            const std::string_view word = line.substr(at, end - at);
            out += keywords().count(word) > 0 ? span("keyword", word) : escape_html(word);
        } else {
            out += escape_html(line.substr(at, 1));
        }
        at = end;
    }
    return out;
}

} // namespace

std::string colour_code(const std::string& code)
{
    std::string out;
    Indents indents;
    for (const std::string& line : split_lines(code))
        out += "<div class=\"line\">" + indents.mark(with_whole_words(colour_line(line))) + "</div>";
    return out;
}

std::string with_whole_words(const std::string& html)
{
    std::string out;
    std::size_t at = 0;
    while (at < html.size()) {
        if (html[at] == '<') {
            const std::size_t end = std::min(html.find('>', at), html.size() - 1) + 1;
            out += html.substr(at, end - at);
            at = end;
            continue;
        }
        const std::size_t end = std::min(html.find_first_of(" <", at), html.size());
        const std::string word = html.substr(at, end - at);
        const bool may_break = word.find_first_of("-/?|+%!") != std::string::npos;
        out += may_break ? "<span class=\"w\">" + word + "</span>" : word;
        if (end < html.size() && html[end] == ' ') out += ' ';
        at = end < html.size() && html[end] == ' ' ? end + 1 : end;
    }
    return out;
}

std::string Indents::mark(std::string line)
{
    const std::size_t indent = line.find_first_not_of(' ');
    if (indent == std::string::npos) return line;
    if (indent <= statement_ + 4) {
        statement_ = indent;
        return line;
    }
    const std::size_t enough = statement_ + 8;
    if (indent <= enough) return line;
    return line.substr(0, enough) + "<span class=\"deep\">" + line.substr(enough, indent - enough) + "</span>" +
           line.substr(indent);
}

} // namespace flying::weave
