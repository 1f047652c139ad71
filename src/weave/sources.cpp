#include "weave/sources.hpp"

#include <algorithm>
#include <optional>
#include <set>

#include <fmt/format.h>

#include "weave/text.hpp"

namespace flying::weave {

namespace {

namespace fs = std::filesystem;

/// The name in a line that is a marker and nothing else: `// [name]`, or `# [name]` in scenes and scripts.
std::optional<std::string> marker_name(std::string_view line)
{
    line = trim(line);
    if (line.substr(0, 2) == "//") {
        line.remove_prefix(2);
    } else if (line.substr(0, 1) == "#") {
        line.remove_prefix(1);
    } else {
        return std::nullopt;
    }
    line = trim(line);
    if (line.size() < 3 || line.front() != '[' || line.back() != ']') return std::nullopt;
    line = line.substr(1, line.size() - 2);
    const auto allowed = [](char c) { return is_word(c) || c == '.' || c == '-'; };
    if (!std::all_of(line.begin(), line.end(), allowed)) return std::nullopt;
    return std::string(line);
}

/// Whether the line is part of the frame that every file has: nothing that a chapter could explain.
bool is_frame(std::string_view line)
{
    line = trim(line);
    if (line.empty()) return true;
    for (const std::string_view start : {"#include", "#pragma once"})
        if (line.substr(0, start.size()) == start) return true;
    const bool opens = line.substr(0, 9) == "namespace" && line.back() == '{';
    const bool closes = line.substr(0, 1) == "}" && line.find("// namespace") != std::string_view::npos;
    return opens || closes;
}

bool is_source(const fs::path& path)
{
    const std::set<std::string> kinds = {".hpp", ".cpp", ".h", ".toml", ".js", ".cmake"};
    return kinds.count(path.extension().string()) > 0 || path.filename() == "CMakeLists.txt";
}

} // namespace

int Sources::find(const std::string& name) const
{
    for (const char* folder : {"", "src/", "chapters/"})
        if (const auto found = by_name.find(folder + name); found != by_name.end()) return found->second;
    return -1;
}

void read_source(const fs::path& project, const std::string& path, Sources& sources, Problems& problems)
{
    const std::optional<std::string> text = read_file(project / path);
    if (!text) {
        problems.add({path, 0}, "no such file", "a source that can be read");
        return;
    }
    SourceFile file;
    file.path = path;
    file.lines = split_lines(*text);

    // Give each line to the innermost region that is open there
    std::vector<int> open;
    bool has_markers = false;
    for (std::size_t k = 0; k < file.lines.size(); ++k) {
        const int line = static_cast<int>(k) + 1;
        const std::optional<std::string> name = marker_name(file.lines[k]);
        if (!name) {
            file.kinds.push_back(is_frame(file.lines[k]) ? LineKind::frame : LineKind::content);
            file.owner.push_back(open.empty() ? -1 : open.back());
            continue;
        }
        has_markers = true;
        file.kinds.push_back(LineKind::marker);
        file.owner.push_back(-1);
        if (!open.empty() && sources.regions[open.back()].name == *name) {
            sources.regions[open.back()].last = line - 1;
            open.pop_back();
            continue;
        }
        const int before = sources.find(*name);
        if (before >= 0) {
            const Region& other = sources.regions[before];
            problems.add({path, line},
                         fmt::format("marker [{}], which stands at {}:{} too", *name, other.file, other.first),
                         "names used for one region only, each opened and closed once, inner ones first");
        }
        const int index = static_cast<int>(sources.regions.size());
        sources.regions.push_back({*name, path, line + 1, line, {}, false, false});
        if (before < 0) sources.by_name[*name] = index;
        if (!open.empty()) sources.regions[open.back()].inner.push_back(index);
        open.push_back(index);
    }
    for (const int index : open)
        problems.add({path, sources.regions[index].first - 1},
                     fmt::format("region [{}] opened and never closed", sources.regions[index].name),
                     "the same marker again after its last line");

    // A file without markers is one region, named by its path
    if (!has_markers && !file.lines.empty()) {
        const int index = static_cast<int>(sources.regions.size());
        const auto is_content = [](LineKind kind) { return kind == LineKind::content; };
        const auto first = std::find_if(file.kinds.begin(), file.kinds.end(), is_content);
        const auto last = std::find_if(file.kinds.rbegin(), file.kinds.rend(), is_content);
        if (first != file.kinds.end()) {
            sources.regions.push_back({path,
                                       path,
                                       static_cast<int>(first - file.kinds.begin()) + 1,
                                       static_cast<int>(file.kinds.rend() - last),
                                       {},
                                       true,
                                       false});
            sources.by_name[path] = index;
            std::fill(file.owner.begin(), file.owner.end(), index);
        }
    }
    sources.files[path] = std::move(file);
}

namespace {

/// Every declaration as a region of its own, named by its file and by itself; the second of a name is `name#2`.
void add_declarations(Sources& sources)
{
    const int marked = static_cast<int>(sources.regions.size());
    for (const auto& [path, declarations] : sources.declarations) {
        const auto file = sources.files.find(path);
        if (file == sources.files.end()) continue;
        for (const Declaration& one : declarations) {
            Region region{path + ":" + one.name, path, one.first, one.last, {}, false, true};
            for (int k = 2; sources.by_name.count(region.name) > 0; ++k)
                region.name = fmt::format("{}:{}#{}", path, one.name, k);
            for (int k = 0; k < marked; ++k) {
                const Region& part = sources.regions[k];
                const bool inside = part.file == path && one.first <= part.first && part.last <= one.last;
                const bool nested = !region.inner.empty() && sources.regions[region.inner.back()].last >= part.last;
                if (inside && !part.whole_file && !nested) region.inner.push_back(k);
            }
            sources.by_name[region.name] = static_cast<int>(sources.regions.size());
            sources.regions.push_back(std::move(region));
        }
    }
}

} // namespace

Sources read_sources(const fs::path& project, Problems& problems)
{
    std::vector<std::string> paths;
    for (const char* top : {"src", "chapters", "tests/support"}) {
        std::error_code error;
        for (fs::recursive_directory_iterator at(project / top, error), end; !error && at != end; at.increment(error)) {
            const std::string path = fs::relative(at->path(), project).generic_string();
            if (at->is_regular_file() && is_source(at->path()) && path != "chapters/book.toml") paths.push_back(path);
        }
    }
    std::sort(paths.begin(), paths.end());
    Sources sources;
    for (const std::string& path : paths) read_source(project, path, sources, problems);
    sources.declarations = read_declarations(project, problems);
    add_declarations(sources);
    return sources;
}

} // namespace flying::weave
