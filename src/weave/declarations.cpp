#include "weave/declarations.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <regex>
#include <set>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "weave/text.hpp"

namespace flying::weave {

namespace {

namespace fs = std::filesystem;

/// What a command prints.
std::string printed_by(const std::string& command)
{
    std::string out;
    std::FILE* pipe = ::popen(command.c_str(), "r");
    if (pipe == nullptr) return out;
    std::array<char, 1 << 16> part{};
    for (std::size_t size = 0; (size = std::fread(part.data(), 1, part.size(), pipe)) > 0;)
        out.append(part.data(), size);
    ::pclose(pipe);
    return out;
}

/// The line where the declaration that has its name in `line` begins: above stand its comment, its template's
/// parameters, its attributes.
int first_line(const std::vector<std::string>& lines, int line)
{
    int first = line;
    while (first > 1) {
        const std::string_view above = trim(lines[first - 2]);
        const bool is_comment = above.substr(0, 2) == "//";
        const bool is_mark = is_comment && above.back() == ']' && above.substr(0, 4) == "// [";
        if (above.empty() || is_mark || above.front() == '#' || above.substr(0, 7) == "// ----") break;
        if (!is_comment && std::string_view(";{}:,(").find(above.back()) != std::string_view::npos) break;
        --first;
    }
    return first;
}

} // namespace

std::map<std::string, std::vector<Declaration>> read_declarations(const fs::path& project, Problems& problems)
{
    static const std::set<std::string> k_kinds = {"function", "prototype", "class",   "struct",
                                                  "enum",     "variable",  "typedef", "alias"};
    static const std::regex k_nameless("__anon[0-9a-f]+(::)?");
    std::map<std::string, std::vector<Declaration>> all;
    const std::string command =
        fmt::format("cd '{}' && ctags -R --languages=C++ --langmap=C++:.hpp.cpp --kinds-C++=+p --fields=+neKs "
                    "--output-format=json -f - $(ls -d src chapters 2>/dev/null) 2>/dev/null",
                    project.string());
    const std::vector<std::string> tags = split_lines(printed_by(command));
    if (tags.empty() || tags.front().empty())
        problems.add({"src", 0}, "no declarations", "universal-ctags, and sources");
    std::map<std::string, std::vector<std::string>> lines;
    for (const std::string& tag : tags) {
        const nlohmann::json entry = nlohmann::json::parse(tag, nullptr, false);
        if (!entry.is_object() || k_kinds.count(entry.value("kind", "")) == 0) continue;
        const std::string path = entry.value("path", "");
        if (lines.count(path) == 0) lines[path] = split_lines(read_file(project / path).value_or(""));
        Declaration one;
        one.kind = entry.value("kind", "");
        one.scope = std::regex_replace(entry.value("scope", ""), k_nameless, "");
        if (one.scope.rfind("flying", 0) == 0) one.scope = one.scope.substr(std::min<std::size_t>(8, one.scope.size()));
        if (one.scope.size() > 1 && one.scope.substr(one.scope.size() - 2) == "::")
            one.scope.resize(one.scope.size() - 2);
        one.name = (one.scope.empty() ? "" : one.scope + "::") + entry.value("name", "");
        one.own = entry.value("line", 0);
        one.last = entry.value("end", one.own);
        const auto& text = lines[path];
        if (one.own < 1 || one.last > static_cast<int>(text.size()) || one.last < one.own) continue;
        // A constant ends with its semicolon
        if (one.kind == "variable")
            while (one.last < static_cast<int>(text.size()) && text[one.last - 1].find(';') == std::string::npos)
                ++one.last;
        one.first = first_line(text, one.own);
        all[path].push_back(std::move(one));
    }
    for (auto& [path, some] : all)
        std::sort(some.begin(), some.end(), [](const Declaration& a, const Declaration& b) {
            return std::pair(a.first, -a.last) < std::pair(b.first, -b.last);
        });
    return all;
}

} // namespace flying::weave
