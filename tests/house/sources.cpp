#include "house.hpp"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <regex>
#include <sstream>
#include <string_view>

#include <toml++/toml.h>

namespace house {

namespace {

std::string read_text(const std::filesystem::path& file)
{
    std::ifstream in(file, std::ios::binary);
    std::ostringstream text;
    text << in.rdbuf();
    return text.str();
}

std::vector<std::string> split_lines(const std::string& text)
{
    std::vector<std::string> lines;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);) lines.push_back(line);
    return lines;
}

std::string module_of(const std::string& path)
{
    constexpr std::string_view k_src = "src/";
    if (!path.starts_with(k_src)) return "";
    const std::size_t slash = path.find('/', k_src.size());
    return slash == std::string::npos ? "" : path.substr(k_src.size(), slash - k_src.size());
}

bool is_word(char c)
{
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

// Where a comment or literal that begins at `at` ends: one past its last character; `at` itself where none begins
std::size_t end_of_silent(const std::string& text, std::size_t at)
{
    const auto end_after = [&](std::string_view closing, std::size_t from) {
        const std::size_t found = text.find(closing, from);
        return found == std::string::npos ? text.size() : found + closing.size();
    };

    if (text.compare(at, 2, "//") == 0) return std::min(text.find('\n', at), text.size());
    if (text.compare(at, 2, "/*") == 0) return end_after("*/", at + 2);
    if (text.compare(at, 2, "R\"") == 0 && (at == 0 || !is_word(text[at - 1]))) {
        const std::size_t open = std::min(text.find('(', at), text.size());
        return end_after(")" + text.substr(at + 2, open - at - 2) + "\"", open);
    }

    // An apostrophe after a digit or letter separates digits
    const bool opens = text[at] == '"' || (text[at] == '\'' && (at == 0 || !is_word(text[at - 1])));
    if (!opens) return at;
    for (std::size_t i = at + 1; i < text.size(); ++i) {
        if (text[i] == '\\') ++i;
        else if (text[i] == text[at] || text[i] == '\n') return i + 1;
    }
    return text.size();
}

} // namespace

std::string code_only(const std::string& text)
{
    std::string code;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = end_of_silent(text, at);
        if (end == at) {
            code += text[at++];
            continue;
        }
        // Keep that a literal stood there, that a comment parts words, and the line breaks
        code += text[at] == '/' ? " " : "\"\"";
        code.append(static_cast<std::size_t>(std::count(text.begin() + static_cast<std::ptrdiff_t>(at),
                                                        text.begin() + static_cast<std::ptrdiff_t>(end), '\n')),
                    '\n');
        at = end;
    }
    return code;
}

std::vector<Source> read_sources(const std::filesystem::path& root, const std::string& folder)
{
    std::vector<Source> sources;
    if (!std::filesystem::is_directory(root / folder)) return sources;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(root / folder)) {
        const std::string extension = entry.path().extension().string();
        if (!entry.is_regular_file() || (extension != ".hpp" && extension != ".cpp")) continue;
        const std::string path = entry.path().lexically_relative(root).generic_string();
        const std::string text = read_text(entry.path());
        sources.push_back({path, module_of(path), split_lines(text), split_lines(code_only(text))});
    }
    std::sort(sources.begin(), sources.end(), [](const Source& a, const Source& b) { return a.path < b.path; });
    return sources;
}

Book read_book(const std::filesystem::path& file)
{
    Book book;
    const toml::table table = toml::parse(read_text(file));
    const toml::array* chapters = table["chapter"].as_array();
    if (chapters == nullptr) return book;
    std::map<int, int> places; // in the order of the file, from 1, by the numbers of their folders
    for (const toml::node& node : *chapters) {
        const toml::table* chapter = node.as_table();
        if (chapter == nullptr) continue;
        int place = 0;
        if (!chapter->contains("appendix")) {
            place = static_cast<int>(places.size()) + 1;
            places[(*chapter)["number"].value_or(0)] = place;
        } else if (const toml::array* needs = (*chapter)["needs"].as_array()) {
            for (const toml::node& need : *needs) place = std::max(place, places[need.value_or(0)]);
        }
        const toml::array* files = (*chapter)["files"].as_array();
        if (files == nullptr) continue;
        for (const toml::node& path : *files) book[path.value_or(std::string())].push_back(place);
    }
    return book;
}

std::vector<Include> includes(const Source& source)
{
    static const std::regex k_directive(R"re(^\s*#\s*include\s*(["<])([^">]+)[">].*)re");
    static const std::regex k_alive(R"re(^\s*#\s*include.*)re");
    std::vector<Include> found;
    for (std::size_t i = 0; i < source.lines.size(); ++i) {
        std::smatch match;
        const bool alive = i < source.code.size() && std::regex_match(source.code[i], k_alive);
        if (!alive || !std::regex_match(source.lines[i], match, k_directive)) continue;
        found.push_back({match[2].str(), static_cast<int>(i) + 1, match[1].str() == "\""});
    }
    return found;
}

} // namespace house
