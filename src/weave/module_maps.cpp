#include <algorithm>
#include <set>

#include <fmt/format.h>

#include "weave/annotated.hpp"
#include "weave/frame.hpp"
#include "weave/text.hpp"

namespace flying::weave {

namespace {

namespace fs = std::filesystem;

/// `mass/disc` of src/mass/disc.hpp: a header and its source are one thing here.
std::string unit_of(const std::string& path)
{
    return path.substr(4, path.rfind('.') - 4);
}

std::string module_of(const std::string& unit)
{
    return unit.substr(0, unit.find('/'));
}

/// The files of src as pairs of header and source, and what each calls of the others.
struct Unit
{
    std::vector<std::string> files;
    std::string says; ///< HTML: the first sentence of the first comment of the header
    int lines = 0;
    std::set<std::string> includes;                      ///< units, those that come along as well
    std::map<std::string, std::set<std::string>> calls;  ///< names, by the unit that declares them
    std::map<std::string, std::set<std::string>> called; ///< names, by the unit that calls them
};

/// The words of a line of code, without its comment.
void collect_words(std::string_view line, std::set<std::string, std::less<>>& words)
{
    line = line.substr(0, line.find("//"));
    for (std::size_t at = 0; at < line.size();) {
        std::size_t end = at;
        while (end < line.size() && is_word(line[end])) ++end;
        if (end > at) words.emplace(line.substr(at, end - at));
        at = end + 1;
    }
}

/// The first sentence of the file's first comment.
std::string first_sentence(const Material& material, const SourceFile& file)
{
    std::vector<std::string> comment;
    for (const std::string& line : file.lines) {
        const std::string_view text = trim(line);
        if (text.substr(0, 4) == "/// ") comment.emplace_back(text.substr(4));
        else if (!comment.empty()) break;
    }
    std::string all = join(comment, " ");
    std::size_t stop = all.find(". ");
    while (stop != std::string::npos && stop >= 2 && all.compare(stop - 2, 2, "eq") == 0)
        stop = all.find(". ", stop + 1);
    if (stop != std::string::npos) all.resize(stop + 1);
    std::string html = comment_prose(material, {all}, "");
    return replace_all(replace_all(std::move(html), "<p>", ""), "</p>", "");
}

std::map<std::string, Unit> read_units(const Material& material)
{
    std::map<std::string, Unit> units;
    for (const auto& [path, file] : material.sources.files) {
        const bool is_code = path.ends_with(".hpp") || path.ends_with(".cpp");
        if (path.rfind("src/", 0) != 0 || !is_code || path.find('/', 4) == std::string::npos) continue;
        Unit& unit = units[unit_of(path)];
        unit.files.push_back(path);
        unit.lines += static_cast<int>(file.lines.size());
        for (const std::string& line : file.lines)
            if (line.rfind("#include \"", 0) == 0) unit.includes.insert(line.substr(10, line.find('.', 10) - 10));
        if (unit.says.empty() || path.ends_with(".hpp")) unit.says = first_sentence(material, file);
    }
    // What is included comes along with what includes it
    for (bool grows = true; grows;) {
        grows = false;
        for (auto& [name, unit] : units) {
            std::set<std::string> more;
            for (const std::string& other : unit.includes)
                if (const auto at = units.find(other); at != units.end())
                    more.insert(at->second.includes.begin(), at->second.includes.end());
            const std::size_t before = unit.includes.size();
            unit.includes.merge(more);
            grows = grows || unit.includes.size() > before;
        }
    }

    // Functions and types that a header declares for others, by name
    std::map<std::string, std::set<std::string>, std::less<>> declared;
    for (const auto& [path, declarations] : material.sources.declarations) {
        if (path.rfind("src/", 0) != 0 || !path.ends_with(".hpp")) continue;
        for (const Declaration& one : declarations)
            if (one.scope.empty()) declared[one.name].insert(unit_of(path));
    }
    for (auto& [name, unit] : units) {
        std::set<std::string, std::less<>> words;
        for (const std::string& path : unit.files)
            for (const std::string& line : material.sources.files.at(path).lines) collect_words(line, words);
        for (const std::string& word : words) {
            const auto found = declared.find(word);
            if (found == declared.end()) continue;
            for (const std::string& other : found->second) {
                if (other == name || unit.includes.count(other) == 0) continue;
                unit.calls[other].insert(word);
                units[other].called[name].insert(word);
            }
        }
    }
    return units;
}

std::string link_to(const std::string& unit, const std::map<std::string, Unit>& units, const Manual& manual)
{
    const Unit& of = units.at(unit);
    for (const std::string& path : of.files)
        if (const auto page = manual.sources.find(path); page != manual.sources.end())
            return fmt::format("<a href=\"manual/{}\">{}</a>", page->second, escape_html(unit));
    return escape_html(unit);
}

/// Other units with the names that go between: the title of each says which.
std::string neighbours(const std::map<std::string, std::set<std::string>>& others,
                       const std::map<std::string, Unit>& units, const Manual& manual)
{
    std::string out;
    for (const auto& [unit, names] : others) {
        const std::vector<std::string> list(names.begin(), names.end());
        out += fmt::format("{}<span title=\"{}\">{}</span>", out.empty() ? "" : ", ", escape_html(join(list, ", ")),
                           link_to(unit, units, manual));
    }
    return out;
}

std::string table_of(const std::string& module, const std::map<std::string, Unit>& units, const Manual& manual)
{
    std::string rows;
    for (const auto& [name, unit] : units) {
        if (module_of(name) != module) continue;
        std::string files;
        for (const std::string& path : unit.files) {
            const auto page = manual.sources.find(path);
            const std::string words = escape_html(path.substr(path.rfind('/') + 1));
            files += (files.empty() ? "" : "<br>") +
                     (page == manual.sources.end() ? words
                                                   : fmt::format("<a href=\"manual/{}\">{}</a>", page->second, words));
        }
        rows += fmt::format("<tr><td>{}</td><td>{}</td><td data-what=\"Lines:\">{}</td><td data-what=\"Uses\">{}</td>"
                            "<td data-what=\"Used by\">{}</td></tr>\n",
                            files, unit.says, unit.lines, neighbours(unit.calls, units, manual),
                            neighbours(unit.called, units, manual));
    }
    return "<table class=\"map\"><thead><tr><th>File</th><th>What it is</th><th>Lines</th><th>Uses</th><th>Used by</th>"
           "</tr></thead><tbody>\n" +
           rows + "</tbody></table>";
}

/// The modules as the book lists them, from below upwards, and then any others.
std::vector<std::string> in_order(const std::map<std::string, std::pair<int, int>>& sizes, const Book& book)
{
    std::vector<std::string> order;
    for (const Module& module : book.modules)
        if (sizes.count(module.name) > 0) order.push_back(module.name);
    for (const auto& [module, size] : sizes)
        if (std::find(order.begin(), order.end(), module) == order.end()) order.push_back(module);
    return order;
}

} // namespace

void write_module_maps(const Material& material, const Manual& manual, const fs::path& html, Problems& problems)
{
    const std::map<std::string, Unit> units = read_units(material);
    std::map<std::string, std::pair<int, int>> sizes; // files and lines of each module
    std::map<std::string, std::set<std::string>> arrows;
    for (const auto& [name, unit] : units) {
        auto& [files, lines] = sizes[module_of(name)];
        files += static_cast<int>(unit.files.size());
        lines += unit.lines;
        for (const auto& [other, names] : unit.calls)
            if (module_of(other) != module_of(name)) arrows[module_of(name)].insert(module_of(other));
    }
    const auto write = [&](Page& page, const std::string& body) {
        if (!write_file(html / (page.name + ".html"), framed(material, page, body, "")))
            problems.add({page.name, 0}, "a page that can't be written", "a folder to write to");
    };
    std::string rows;
    for (const std::string& module : in_order(sizes, material.book)) {
        const auto& size = sizes.at(module);
        const std::string words = escape_html(material.book.says_of(module));
        Page page;
        page.name = "module_" + module;
        page.title = "Module " + module;
        page.over = "<p class=\"part\"><a href=\"sources.html\">The sources</a></p>";
        page.under = words.empty() ? "" : "<p class=\"question\">" + words + "</p>";
        write(page, table_of(module, units, manual));
        std::string below;
        for (const std::string& other : arrows[module])
            below += fmt::format("{}<a href=\"module_{}.html\">{}</a>", below.empty() ? "" : ", ", other, other);
        rows +=
            fmt::format("<tr><td><a href=\"module_{0}.html\">{0}</a></td><td>{1}</td><td data-what=\"Files:\">{2}</td>"
                        "<td data-what=\"Lines:\">{3}</td><td data-what=\"Uses\">{4}</td></tr>\n",
                        module, words, size.first, size.second, below);
    }
    Page page;
    page.name = "sources";
    page.title = "The sources";
    write(page,
          "<p>Every file of the program has a page, whole and in order, with its comments beside the code and links "
          "to where the chapters tell of it.</p><table class=\"map\"><thead><tr><th>Module</th><th>What it does</th>"
          "<th>Files</th><th>Lines</th><th>Uses</th></tr></thead><tbody>\n" +
              rows + "</tbody></table>");
}

} // namespace flying::weave
