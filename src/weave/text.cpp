#include "weave/text.hpp"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <system_error>

namespace flying::weave {

std::optional<std::string> read_file(const std::filesystem::path& path)
{
    std::error_code error;
    if (!std::filesystem::is_regular_file(path, error)) return std::nullopt;
    std::ifstream in(path, std::ios::binary);
    if (!in) return std::nullopt;
    std::ostringstream text;
    text << in.rdbuf();
    return text.str();
}

bool write_file(const std::filesystem::path& path, std::string_view text)
{
    if (read_file(path) == text) return true;
    std::error_code error;
    std::filesystem::create_directories(path.parent_path(), error);
    std::filesystem::path part = path;
    part += ".part";
    {
        std::ofstream out(part, std::ios::binary);
        out << text;
        if (!out.flush()) return false;
    }
    std::filesystem::rename(part, path, error);
    return !error;
}

std::vector<std::string> split_lines(std::string_view text)
{
    std::vector<std::string> lines = split(text, '\n');
    if (lines.back().empty()) lines.pop_back();
    for (std::string& line : lines)
        if (!line.empty() && line.back() == '\r') line.pop_back();
    return lines;
}

std::vector<std::string> split(std::string_view text, char separator)
{
    std::vector<std::string> parts;
    while (true) {
        const std::size_t end = text.find(separator);
        parts.emplace_back(text.substr(0, end));
        if (end == std::string_view::npos) return parts;
        text.remove_prefix(end + 1);
    }
}

std::string_view trim(std::string_view text)
{
    const char* blanks = " \t\r\n";
    const std::size_t first = text.find_first_not_of(blanks);
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

std::string join(const std::vector<std::string>& parts, std::string_view separator)
{
    std::string text;
    for (std::size_t k = 0; k < parts.size(); ++k) {
        if (k > 0) text += separator;
        text += parts[k];
    }
    return text;
}

std::string replace_all(std::string text, std::string_view from, std::string_view to)
{
    for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
        text.replace(at, from.size(), to);
    return text;
}

std::string escape_html(std::string_view text)
{
    std::string out;
    out.reserve(text.size());
    for (const char c : text) {
        switch (c) {
        case '&':
            out += "&amp;";
            break;
        case '<':
            out += "&lt;";
            break;
        case '>':
            out += "&gt;";
            break;
        case '"':
            out += "&quot;";
            break;
        default:
            out += c;
        }
    }
    return out;
}

std::string slug(std::string_view text)
{
    std::string out;
    for (const char c : text) {
        const auto u = static_cast<unsigned char>(c);
        if (std::isalnum(u)) {
            out += static_cast<char>(std::tolower(u));
        } else if (!out.empty() && out.back() != '-') {
            out += '-';
        }
    }
    while (!out.empty() && out.back() == '-') out.pop_back();
    return out;
}

std::optional<double> to_number(std::string_view text)
{
    const std::string copy(trim(text));
    if (copy.empty()) return std::nullopt;
    char* end = nullptr;
    const double number = std::strtod(copy.c_str(), &end);
    if (end != copy.c_str() + copy.size()) return std::nullopt;
    return number;
}

namespace {

/// Whether a name in code is surely the one that Doxygen links it to.
/// kind  Doxygen's word for what it found; before, after  the rest of the line on either side
bool is_sure_link(std::string_view kind, std::string_view name, std::string_view before, std::string_view after)
{
    if (name.find("::") != std::string_view::npos) return true;
    for (const std::string_view owner : {".", "-&gt;", "::"})
        if (before.ends_with(owner)) return true;
    if (kind == "variable") return name.starts_with("k_") || name.ends_with('_');
    if (kind == "function") return after.starts_with('(') || after.starts_with("&lt;");
    return kind != "enumvalue";
}

} // namespace

std::string without_guessed_links(std::string_view line)
{
    constexpr std::string_view k_begin = "<a class=\"code hl_";
    std::string out;
    for (;;) {
        const std::size_t start = line.find(k_begin);
        const std::size_t end = start == std::string_view::npos ? start : line.find("</a>", start);
        if (end == std::string_view::npos) return out += line;
        const std::string_view link = line.substr(start, end - start);
        const std::string_view kind = link.substr(k_begin.size(), link.find('"', k_begin.size()) - k_begin.size());
        const std::string_view name = link.substr(link.find('>') + 1);
        out += line.substr(0, start);
        line.remove_prefix(end + 4);
        if (is_sure_link(kind, name, out, line)) out += std::string(link) + "</a>";
        else out += name;
    }
}

bool is_word(char c)
{
    return std::isalnum(static_cast<unsigned char>(c)) || c == '_';
}

} // namespace flying::weave
