// A map of each module: its files, a line on each, and who calls whom.

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
    std::string says; ///< HTML: the first sentence of a comment of the header
    int lines = 0;
    std::set<std::string> named;                         ///< units whose headers it includes itself
    std::set<std::string> includes;                      ///< units, those that come along as well
    std::map<std::string, std::set<std::string>> calls;  ///< names, by the unit that declares them
    std::map<std::string, std::set<std::string>> called; ///< names, by the unit that calls them
};

/// Whether the word at `at` belongs to an object, a type or the standard library, such as `is_over` in `times.is_over`
/// and `Event` in `Gdk::Event`: it is no name of a header then.
bool is_member(std::string_view line, std::size_t at)
{
    const std::string_view before = line.substr(0, at);
    if (before.ends_with('.') || before.ends_with("->")) return true;
    if (!before.ends_with("::")) return false;
    std::size_t begin = at - 2;
    while (begin > 0 && is_word(line[begin - 1])) --begin;
    const std::string_view owner = line.substr(begin, at - 2 - begin);
    return owner.empty() || owner == "std" || (owner.front() >= 'A' && owner.front() <= 'Z');
}

/// The words of a line of code that may be names of a header: none of a comment, and none of what is included.
void collect_words(std::string_view line, std::set<std::string, std::less<>>& words)
{
    line = line.substr(0, line.find("//"));
    if (line.starts_with('#')) return;
    for (std::size_t at = 0; at < line.size();) {
        std::size_t end = at;
        while (end < line.size() && is_word(line[end])) ++end;
        if (end > at && !is_member(line, at)) words.emplace(line.substr(at, end - at));
        at = end + 1;
    }
}

/// Whether a line has `name` as a whole word.
bool has_word(std::string_view line, std::string_view name)
{
    for (std::size_t at = line.find(name); at != std::string_view::npos; at = line.find(name, at + 1)) {
        const std::size_t end = at + name.size();
        if ((at == 0 || !is_word(line[at - 1])) && (end == line.size() || !is_word(line[end]))) return true;
    }
    return false;
}

/// The name of a type after that of its file: `EventQueue` for `event_queue`.
std::string type_of(std::string_view stem)
{
    std::string name;
    bool starts = true;
    for (const char c : stem) {
        if (c != '_') name += starts && c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
        starts = c == '_';
    }
    return name;
}

/// The comment that a file opens with, if it does. Its lines begin with `//`, as it is about no declaration.
std::string opening_comment(const SourceFile& file)
{
    std::size_t at = 0;
    while (at < file.lines.size() && (file.lines[at].empty() || file.lines[at] == "#pragma once")) ++at;
    std::vector<std::string> comment;
    for (; at < file.lines.size() && file.lines[at].starts_with("// "); ++at)
        comment.push_back(file.lines[at].substr(3));
    return join(comment, " ");
}

/// The comment that a file opens with; else that of what has the file's name, as a type or a function; else the first,
/// that of a constant last.
std::string chosen_comment(const SourceFile& file, const std::string& stem)
{
    if (std::string opening = opening_comment(file); !opening.empty()) return opening;
    constexpr int k_named = 3, k_other = 2, k_constant = 1;
    const std::string type = type_of(stem);
    std::string best;
    int best_rank = 0;
    for (std::size_t at = 0; at < file.lines.size(); ++at) {
        if (trim(file.lines[at]).substr(0, 4) != "/// ") continue;
        const bool is_inner = file.lines[at].front() == ' ';
        std::vector<std::string> comment;
        for (; at < file.lines.size() && trim(file.lines[at]).substr(0, 4) == "/// "; ++at)
            comment.emplace_back(trim(file.lines[at]).substr(4));
        // What follows on the rest of the comment is declared
        while (at < file.lines.size() && trim(file.lines[at]).substr(0, 3) == "///") ++at;
        if (at < file.lines.size() && file.lines[at].rfind("template", 0) == 0) ++at;
        const std::string_view declared = at < file.lines.size() ? std::string_view(file.lines[at]) : "";
        const bool is_named =
            !is_inner && (has_word(declared, type) || has_word(declared.substr(0, declared.find('(')), stem));
        const bool is_constant =
            declared.find("constexpr") != std::string_view::npos && declared.find('(') == std::string_view::npos;
        const int rank = is_named ? k_named : is_constant || is_inner ? k_constant : k_other;
        if (rank <= best_rank) continue;
        best_rank = rank;
        best = join(comment, " ");
    }
    return best;
}

/// The first sentence of the comment that says what a file is. A full stop ends it behind a word, not behind a blank or
/// another stop, where it is a product or a range.
std::string first_sentence(const Material& material, const SourceFile& file, const std::string& stem)
{
    std::string all = chosen_comment(file, stem);
    const auto goes_on = [&](std::size_t stop) {
        return stop > 0 &&
               (all[stop - 1] == ' ' || all[stop - 1] == '.' || (stop >= 2 && all.compare(stop - 2, 2, "eq") == 0));
    };
    std::size_t stop = all.find(". ");
    while (stop != std::string::npos && goes_on(stop)) stop = all.find(". ", stop + 1);
    if (stop != std::string::npos) all.resize(stop + 1);
    // What would follow a colon, a list, is not in the table
    if (all.ends_with(':')) all.back() = '.';
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
            if (line.rfind("#include \"", 0) == 0) unit.named.insert(line.substr(10, line.find('.', 10) - 10));
        unit.includes = unit.named;
        if (unit.says.empty() || path.ends_with(".hpp")) {
            const std::size_t from = path.rfind('/') + 1;
            unit.says = first_sentence(material, file, path.substr(from, path.rfind('.') - from));
        }
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

    // Functions and types that a header declares for others, by name. Scopes in small letters are namespaces
    std::map<std::string, std::set<std::string>, std::less<>> declared;
    for (const auto& [path, declarations] : material.sources.declarations) {
        if (path.rfind("src/", 0) != 0 || !path.ends_with(".hpp")) continue;
        for (const Declaration& one : declarations)
            if (one.scope.empty() || (one.scope.front() >= 'a' && one.scope.find("::") == std::string::npos))
                declared[one.name.substr(one.scope.empty() ? 0 : one.scope.size() + 2)].insert(unit_of(path));
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
                // A single small word, such as `add`, is also what a variable or a lambda is called, and files may
                // have a constant of one name
                const bool is_single = word.front() >= 'a' && word.find('_') == std::string::npos;
                const bool is_common = is_single || word.starts_with("k_");
                if (is_common && unit.named.count(other) == 0) continue;
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

/// Other units with the names that go between: the title of each says which. Those behind the first ones are folded.
std::string neighbours(const std::map<std::string, std::set<std::string>>& others,
                       const std::map<std::string, Unit>& units, const Manual& manual)
{
    constexpr std::size_t k_shown = 8; // of more than k_most
    constexpr std::size_t k_most = 12;
    const bool is_folded = others.size() > k_most;
    std::string out;
    std::size_t count = 0;
    for (const auto& [unit, names] : others) {
        const std::vector<std::string> list(names.begin(), names.end());
        if (is_folded && count == k_shown)
            out += fmt::format(" <details><summary>and {} more</summary>", others.size() - k_shown);
        else if (count > 0) out += ", ";
        ++count;
        out += fmt::format("<span title=\"{}\">{}</span>", escape_html(join(list, ", ")), link_to(unit, units, manual));
    }
    return is_folded ? out + "</details>" : out;
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
