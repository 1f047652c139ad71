#include "weave/run.hpp"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <map>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "weave/annotated.hpp"
#include "weave/claims.hpp"
#include "weave/finish.hpp"
#include "weave/light_svg.hpp"
#include "weave/live_matter.hpp"
#include "weave/manual_front.hpp"
#include "weave/receipts.hpp"
#include "weave/rules.hpp"
#include "weave/search_index.hpp"
#include "weave/tally.hpp"
#include "weave/text.hpp"

namespace flying::weave {

namespace {

namespace fs = std::filesystem;
using nlohmann::json;

std::string quoted(const fs::path& path)
{
    return "'" + replace_all(path.string(), "'", "'\\''") + "'";
}

bool run(const std::string& command, const fs::path& log)
{
    return std::system((command + " > " + quoted(log) + " 2>&1").c_str()) == 0;
}

/// The last lines of a file, for a message.
std::string tail(const fs::path& log)
{
    std::vector<std::string> lines = split_lines(read_file(log).value_or(""));
    if (lines.size() > 12) lines.erase(lines.begin(), lines.end() - 12);
    return join(lines, "\n    ");
}

void copy(const fs::path& from, const fs::path& to, Problems& problems)
{
    std::error_code error;
    fs::create_directories(to.parent_path(), error);
    fs::copy(from, to, fs::copy_options::overwrite_existing | fs::copy_options::recursive, error);
    if (error) problems.add({from.string(), 0}, error.message(), "a file to copy into the book");
}

// ---- Doxygen --------------------------------------------------------------------------------------------------------

/// Doxygen's own header with the book's scripts and sheets in it.
bool write_header(const Folders& folders, const Tools& tools, Problems& problems)
{
    const fs::path header = folders.build / "header.html";
    const fs::path log = folders.build / "header.log";
    const bool made =
        run(fmt::format("cd {} && {} -w html header.html footer.html sheet.css", quoted(folders.build), tools.doxygen),
            log);
    const std::optional<std::string> text = read_file(header);
    const std::optional<std::string> ours = read_file(folders.kit / "theme/manual.html");
    if (!made || !text || !ours) {
        problems.add({"theme/manual.html", 0}, "no header for the pages: " + tail(log), "doxygen, and the theme");
        return false;
    }
    const std::string with_theme = replace_all(*text, "</head>", *ours + "</head>");
    return write_file(header,
                      replace_all(with_theme, "<div id=\"projectname\">$projectname",
                                  "<div id=\"projectname\"><a href=\"$relpath^../index.html\">$projectname</a>"));
}

/// Patterns of the sources whose comments read otherwise for Doxygen, each with the filter to start for it: to start it
/// for all of them takes longer than all the rest.
std::string filter_patterns(const Folders& folders, const Sources& sources, const std::string& weave)
{
    std::string patterns;
    for (const auto& [path, file] : sources.files) {
        const bool is_read = path.ends_with(".hpp") || path.ends_with(".cpp");
        if (!is_read || filter_source(file.lines) == without_markers(file.lines)) continue;
        patterns += fmt::format(" \"{}={} filter\"", (folders.project / path).string(), weave);
    }
    return patterns;
}

bool run_doxygen(const Folders& folders, const Tools& tools, const Woven& woven, const fs::path& html,
                 Problems& problems)
{
    std::error_code error;
    fs::remove_all(html, error);
    fs::create_directories(html, error);

    std::string settings = read_file(folders.kit / "Doxyfile.in").value_or("");
    settings = replace_all(settings, "@PROJECT@", folders.project.string());
    settings = replace_all(settings, "@KIT@", folders.kit.string());
    settings = replace_all(settings, "@BUILD@", folders.build.string());
    settings = replace_all(settings, "@HTML@", html.filename().string() + "/manual");
    const std::string weave = fs::read_symlink("/proc/self/exe", error).string();
    settings = replace_all(settings, "@FILTERS@", filter_patterns(folders, woven.material.sources, weave));
    settings = replace_all(settings, "@TITLE@", woven.material.book.title);
    settings = replace_all(settings, "@BRIEF@", woven.material.book.brief);
    write_manual_front(woven.material, folders.project, folders.build / "manual.md", problems);
    if (!problems.empty()) return false;
    if (!write_file(folders.build / "Doxyfile", settings) || !write_header(folders, tools, problems)) return false;

    const fs::path log = folders.build / "doxygen.log";
    const bool made = run(fmt::format("cd {} && {} Doxyfile", quoted(folders.build), tools.doxygen), log);
    int warnings = 0;
    for (const std::string& line : split_lines(read_file(log).value_or(""))) {
        if (line.find("warning:") == std::string::npos && line.find("error:") == std::string::npos) continue;
        ++warnings;
        problems.add({"doxygen", 0}, replace_all(line, folders.project.string() + "/", ""), "no warning");
    }
    if (!made && warnings == 0) problems.add({"doxygen", 0}, "failed: " + tail(log), "doxygen 1.9");
    return made && warnings == 0;
}

/// The letters of the text and of its formulas: of Debian's fonts the signs that the pages have.
void make_letters(const Folders& folders, const fs::path& html, Problems& problems)
{
    const fs::path log = folders.build / "letters.log";
    if (!run(fmt::format("/usr/bin/python3 {} {} {}", quoted(folders.kit / "letters.py"), quoted(html),
                         quoted(folders.build / "letters")),
             log))
        problems.add({"letters.py", 0}, "fonts that can't be made small: " + tail(log),
                     "katex, fonts-sil-charis, fonts-inter, fonts-jetbrains-mono, python3-fonttools, python3-brotli");
}

/// What the pages load, beside what Doxygen itself copies: sheets, scripts, figures.
void copy_matter(const Woven& woven, const Folders& folders, const fs::path& html, Problems& problems)
{
    const fs::path katex = "/usr/share/javascript/katex";
    copy(katex / "katex.min.css", html / "katex/katex.min.css", problems);
    for (const char* name : {"book.css", "page.js", "search.js"})
        copy(folders.kit / "theme" / name, html / "theme" / name, problems);

    for (const Chapter& chapter : woven.material.chapters) {
        for (const ChapterText* text : texts_of(chapter)) {
            for (const Block& block : text->blocks) {
                const std::string name = chapter.entry.name + "/" + block.name;
                if (block.kind != BlockKind::figure) continue;
                const fs::path drawn = drawn_file(woven.material, chapter, block.name + ".svg");
                const fs::path made = html / "figures" / (name + ".svg");
                if (!write_file(made, light_svg(read_file(drawn).value_or(""))))
                    problems.add({made.string(), 0}, "can't be written", "a figure of the book");
            }
        }
    }
}

} // namespace

std::vector<std::string> render_formulas(const Fragments& fragments, const Folders& folders, const Tools& tools,
                                         Problems& problems)
{
    const std::vector<Fragment>& list = fragments.list();
    const auto key = [](const Fragment& f) { return (f.display ? "display " : "inline ") + f.text; };

    // Ask for those that were not rendered before
    const fs::path store = folders.build / "formulas.json";
    json known = json::parse(read_file(store).value_or("{}"), nullptr, false);
    if (!known.is_object()) known = json::object();
    json wanted = json::object();
    for (const Fragment& f : list)
        if (f.kind == FragmentKind::formula && !known.contains(key(f)))
            wanted[key(f)] = {{"tex", f.text}, {"display", f.display}};
    json errors = json::object();
    if (!wanted.empty()) {
        const fs::path question = folders.build / "formulas-new.json";
        const fs::path answer = folders.build / "formulas-out.json";
        const bool asked = write_file(question, wanted.dump());
        const bool answered =
            asked && std::system(fmt::format("{} {} {} > {}", tools.node, quoted(folders.kit / "formulas.js"),
                                             quoted(question), quoted(answer))
                                     .c_str()) == 0;
        const json result = json::parse(read_file(answer).value_or(""), nullptr, false);
        if (!answered || !result.is_object()) {
            problems.add({"formulas.js", 0}, "formulas that could not be rendered", "node, and KaTeX (Debian: katex)");
            return std::vector<std::string>(list.size());
        }
        known.update(result.at("html"));
        errors = result.at("errors");
        (void)write_file(store, known.dump());
    }

    std::vector<std::string> html(list.size());
    for (std::size_t k = 0; k < list.size(); ++k) {
        if (list[k].kind != FragmentKind::formula) continue;
        const std::string name = key(list[k]);
        if (errors.contains(name))
            problems.add(list[k].place, fmt::format("bad TeX `{}`: {}", list[k].text, errors[name].get<std::string>()),
                         "TeX that KaTeX reads");
        else html[k] = known.value(name, "");
    }
    return html;
}

Woven weave_pages(const Folders& folders, const Tools& tools, Problems& problems)
{
    Woven woven;
    woven.material = read_material(folders, problems);
    check_receipts(woven.material, problems);
    woven.counts.coverage = check_coverage(woven.material, problems);
    woven.counts.given = check_prose(woven.material, problems);
    check_completeness(woven.material, problems);
    check_exercises(woven.material, problems);
    check_other_words(woven.material, problems);
    check_needs(woven.material, problems);
    woven.pages = make_pages(woven.material, woven.counts, problems);
    woven.formulas = render_formulas(woven.pages.fragments, folders, tools, problems);
    return woven;
}

void make_book(const Folders& folders, const Tools& tools, Problems& problems)
{
    const Woven woven = weave_pages(folders, tools, problems);
    if (!problems.empty()) return;
    const fs::path html = folders.build / "html.new";
    if (!run_doxygen(folders, tools, woven, html, problems)) return;
    copy_matter(woven, folders, html, problems);
    copy_live_matter(woven, folders, tools, html, problems);
    const Manual manual = read_manual(folders.build / "names.tag", folders.project);
    finish_pages(woven.material, woven.pages, woven.formulas, manual, html, problems);
    write_annotated(woven.material, manual, html, problems);
    write_module_maps(woven.material, manual, html, problems);
    if (!write_file(html / "theme/search-index.js", search_index(woven.material, manual)))
        problems.add({"search-index.js", 0}, "a file that can't be written", "a folder to write to");
    make_letters(folders, html, problems);
    check_links(html, problems);
    if (!problems.empty()) return;
    std::error_code error;
    fs::remove_all(folders.build / "html", error);
    fs::rename(html, folders.build / "html", error);
    if (error) problems.add({"html", 0}, error.message(), "a folder that can be replaced");
}

} // namespace flying::weave
