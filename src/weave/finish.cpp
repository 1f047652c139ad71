#include "weave/finish.hpp"

#include <algorithm>
#include <optional>
#include <set>
#include <tuple>

#include <fmt/format.h>

#include "weave/frame.hpp"
#include "weave/markdown.hpp"
#include "weave/print.hpp"
#include "weave/text.hpp"

namespace flying::weave {

namespace {

namespace fs = std::filesystem;

/// The text between `open` and `close`, from `at` on; `at` moves behind it.
std::optional<std::string> between(const std::string& text, std::string_view open, std::string_view close,
                                   std::size_t& at)
{
    const std::size_t start = text.find(open, at);
    if (start == std::string::npos) return std::nullopt;
    const std::size_t from = start + open.size();
    const std::size_t end = text.find(close, from);
    if (end == std::string::npos) return std::nullopt;
    at = end + close.size();
    return text.substr(from, end - from);
}

std::string first_between(const std::string& text, std::string_view open, std::string_view close)
{
    std::size_t at = 0;
    return between(text, open, close, at).value_or("");
}

/// All pages, those of the manual in its folder too.
std::vector<fs::path> html_files(const fs::path& folder)
{
    std::vector<fs::path> files;
    std::error_code error;
    for (const auto& entry : fs::recursive_directory_iterator(folder, error))
        if (entry.path().extension() == ".html") files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    return files;
}

/// Whether HTML can't stand inside a paragraph.
bool is_block(const std::string& html)
{
    for (const char* start : {"<figure", "<div", "<pre", "<details", "</details", "<section", "</section", "<nav",
                              "<header", "<script", "<ol", "<p", "</div", "<h2", "<h3", "<h4"})
        if (html.rfind(start, 0) == 0) return true;
    return false;
}

/// Takes `count` blanks away from the start of a line, inside its tags too.
std::string dedent(const std::string& html, int count)
{
    std::string out;
    bool in_tag = false;
    for (const char c : html) {
        if (c == '<') in_tag = true;
        if (!in_tag && count > 0) {
            if (c != ' ') count = 0;
            else if (--count >= 0) continue;
        }
        out += c;
        if (c == '>') in_tag = false;
    }
    return out;
}

/// A formula in the text with the unit and the punctuation behind it, which must not begin a line; `at` moves behind
/// that. Between its parts the formula may still go on in the next line.
std::string with_mark(std::string formula, const std::string& text, std::size_t& at)
{
    constexpr std::string_view k_fixed_blank = "\u00a0";
    std::size_t end = at;
    if (text.compare(at, k_fixed_blank.size(), k_fixed_blank) == 0) end = text.find_first_of(" \n<.,;:?!)", at);
    end = std::min(text.find_first_not_of(".,;:?!)", end), text.size());
    if (end == at) return formula;
    constexpr std::string_view k_part = "</span><span class=\"base\">";
    const std::string mark = text.substr(at, end - at);
    at = end;
    return "<span class=\"marked\">" + replace_all(std::move(formula), k_part, "</span><wbr><span class=\"base\">") +
           mark + "</span>";
}

/// Code in the text: a long name may go on in the next line behind one of its dashes, an option or a short command may
/// not.
std::string breakable(const std::string& code)
{
    constexpr std::size_t k_short = 20;
    if (code.size() <= k_short && code.find(' ') != std::string::npos)
        return "<span class=\"option\">" + escape_html(code) + "</span>";
    std::string out;
    for (std::size_t at = 0; at < code.size();) {
        const std::size_t end = std::min(code.find(' ', at), code.size());
        const std::string word = code.substr(at, end - at);
        const std::string shown = replace_all(escape_html(word), "_", "_<wbr>");
        out += word.rfind("--", 0) == 0 ? "<span class=\"option\">" + shown + "</span>" : shown;
        if (end < code.size()) out += ' ';
        at = end + 1;
    }
    return out;
}

class Finisher
{
public:
    Finisher(const Material& material, const std::vector<Fragment>& fragments, const std::vector<std::string>& formulas,
             const Manual& manual, const fs::path& html, Problems& problems)
        : material_(material),
          fragments_(fragments),
          formulas_(formulas),
          manual_(manual),
          html_(html),
          problems_(problems)
    {
    }

    /// The text with every token replaced, and those in what replaces them.
    std::string replace(const std::string& text)
    {
        std::string out;
        std::size_t at = 0;
        while (true) {
            const std::size_t next = text.find("wv0x", at);
            out.append(text, at, next == std::string::npos ? std::string::npos : next - at);
            if (next == std::string::npos) return out;
            const Fragments::Found found = Fragments::token_at(text, next);
            if (found.index < 0 || found.index >= static_cast<int>(fragments_.size())) {
                out += "wv0x";
                at = next + 4;
                continue;
            }
            at = next + found.length;
            std::string html = resolve(static_cast<std::size_t>(found.index));
            const Fragment& fragment = fragments_[static_cast<std::size_t>(found.index)];
            if (fragment.kind == FragmentKind::formula && !fragment.display)
                html = with_mark(std::move(html), text, at);
            if (is_block(html)) unwrap(out, text, at);
            out += html;
        }
    }

private:
    /// Takes the paragraph away that Markdown put round a token.
    static void unwrap(std::string& before, const std::string& text, std::size_t& at)
    {
        const std::size_t open = before.rfind("<p");
        if (open == std::string::npos) return;
        const std::size_t close = before.find('>', open);
        if (close == std::string::npos || !trim(std::string_view(before).substr(close + 1)).empty()) return;
        std::size_t end = at;
        while (end < text.size() && (text[end] == ' ' || text[end] == '\n')) ++end;
        if (text.compare(end, 4, "</p>") != 0) return;
        before.resize(open);
        at = end + 4;
    }

    std::string resolve(std::size_t index)
    {
        const Fragment& fragment = fragments_[index];
        switch (fragment.kind) {
        case FragmentKind::html:
            return replace(fragment.text);
        case FragmentKind::formula:
            return formulas_[index];
        case FragmentKind::code:
            return code(fragment);
        case FragmentKind::lines:
            return lines(fragment);
        case FragmentKind::source: {
            const auto page = manual_.sources.find(fragment.text);
            if (page != manual_.sources.end()) return "manual/" + page->second;
            problems_.add(fragment.place, fmt::format("link to {}", fragment.text),
                          "a source that Doxygen has a page of");
            return "";
        }
        }
        return "";
    }

    std::string code(const Fragment& fragment)
    {
        const std::string shown = "<code>" + breakable(fragment.text) + "</code>";
        std::string name = fragment.text;
        if (name.size() > 2 && name.substr(name.size() - 2) == "()") name.resize(name.size() - 2);
        const auto page = manual_.names.find(name);
        if (page == manual_.names.end()) return shown;
        return fmt::format("<a class=\"name\" href=\"manual/{}\">{}</a>", page->second, shown);
    }

    /// The lines of a source, with links that start from the pages of the chapters.
    const std::map<int, std::string>& source_lines(const std::string& path)
    {
        const auto known = source_lines_.find(path);
        if (known != source_lines_.end()) return known->second;
        std::map<int, std::string>& lines = source_lines_[path];
        const auto page = manual_.sources.find(path);
        if (page == manual_.sources.end()) return lines;
        lines = linked_lines(html_ / "manual" / page->second);
        for (auto& [number, line] : lines) line = replace_all(line, " href=\"", " href=\"manual/");
        return lines;
    }

    std::string lines(const Fragment& fragment)
    {
        const std::map<int, std::string>& html = source_lines(fragment.text);
        const SourceFile& file = material_.sources.files.at(fragment.text);
        std::size_t indent = 200;
        for (const int number : fragment.lines) {
            const std::string& line = file.lines[number - 1];
            if (!trim(line).empty()) indent = std::min(indent, line.find_first_not_of(' '));
        }
        std::string out;
        Indents indents;
        auto instead = fragment.instead.begin();
        for (const int number : fragment.lines) {
            for (; instead != fragment.instead.end() && instead->first <= number; ++instead)
                out += replace(instead->second);
            const auto line = html.find(number);
            // Doxygen puts a blank between the number and the line
            const std::string body = line != html.end() ? line->second : escape_html(file.lines[number - 1]);
            out += "<div class=\"line\">" + indents.mark(with_whole_words(dedent(body, static_cast<int>(indent)))) +
                   "</div>\n";
        }
        for (; instead != fragment.instead.end(); ++instead) out += replace(instead->second);
        return out;
    }

    const Material& material_;
    const std::vector<Fragment>& fragments_;
    const std::vector<std::string>& formulas_;
    const Manual& manual_;
    const fs::path& html_;
    Problems& problems_;
    std::map<std::string, std::map<int, std::string>> source_lines_;
};

// ---- From the manual to the chapters --------------------------------------------------------------------------------

/// What stands on the manual's pages about a file, by the file's path: which chapter tells of it, and where.
std::map<std::string, std::string> chapter_notes(const Material& material)
{
    std::map<std::string, std::string> notes;
    for (const Chapter& chapter : material.chapters) {
        std::map<std::string, std::vector<std::string>> listings;
        for (const Block& block : chapter.text.blocks) {
            if (block.kind != BlockKind::listing) continue;
            const Listing listing = listing_of(block);
            const int index = material.sources.find(listing.names.front());
            if (index < 0 || listing.is_again) continue;
            const std::string& name = listing.names.front();
            listings[material.sources.regions[index].file].push_back(
                fmt::format("<a href=\"../{}.html#listing-{}\">{}</a>", chapter.entry.page(), slug(name),
                            escape_html(name.substr(name.find(':') + 1))));
        }
        for (const std::string& file : chapter.entry.files)
            if (listings.count(file) > 0)
                notes[file] = fmt::format("<p class=\"told\">Told in <a href=\"../{}.html\">chapter {}</a>: {}</p>",
                                          chapter.entry.page(), escape_html(page_title(chapter.entry)),
                                          join(listings[file], ", "));
    }
    return notes;
}

/// Doxygen's pages have neither language nor landmarks, and arrows that only a pointer can press; those who read by ear
/// or by keyboard need more.
std::string with_landmarks(std::string page)
{
    if (page.find("<div id=\"doc-content\">") == std::string::npos) return page;
    const std::string key = "tabindex=\"0\" role=\"button\" onkeydown=\"if (event.key === 'Enter') this.click()\" ";
    const std::pair<std::string, std::string> better_words[] = {
        {"<html xmlns=\"http://www.w3.org/1999/xhtml\">",
         "<html xmlns=\"http://www.w3.org/1999/xhtml\" lang=\"en-GB\">"},
        {"<div id=\"top\">", "<div id=\"top\" role=\"banner\">"},
        {"<div id=\"side-nav\" ", "<div id=\"side-nav\" role=\"navigation\" aria-label=\"The manual\" "},
        {"<div id=\"nav-path\" ", "<div id=\"nav-path\" role=\"navigation\" aria-label=\"Where this page is\" "},
        {"<div id=\"doc-content\">", "<div id=\"doc-content\" role=\"main\">"},
        {"<div class=\"title\">", "<div class=\"title\" role=\"heading\" aria-level=\"1\">"},
        {"<h1>", "<h2>"}, // the sections of its first page, below that title
        {"</h1>", "</h2>"},
        {"onclick=\"javascript:toggleLevel(", key + "onclick=\"javascript:toggleLevel("},
        {"onclick=\"toggleFolder(", key + "aria-label=\"Open or close\" onclick=\"toggleFolder("},
    };
    for (const auto& [found, better] : better_words) page = replace_all(std::move(page), found, better);
    return page;
}

/// Doxygen's row of links over a page names lists that it leaves out: those links go.
std::string with_true_row(std::string page)
{
    std::size_t at = page.find("<div class=\"summary\">");
    if (at == std::string::npos) return page;
    const std::string separator = " &#124;\n";
    while (true) {
        const std::size_t end = page.find("</div>", at);
        const std::size_t link = page.find("<a href=\"#", at);
        if (link >= end) return page;
        const std::size_t name = link + 10;
        const std::string anchor = page.substr(name, page.find('"', name) - name);
        at = page.find("</a>", link) + 4;
        if (page.find("name=\"" + anchor + "\"") != std::string::npos ||
            page.find("id=\"" + anchor + "\"") != std::string::npos)
            continue;
        const std::size_t after = page.compare(at, separator.size(), separator) == 0 ? separator.size() : 0;
        page.erase(link, at + after - link);
        at = link;
    }
}

/// Doxygen makes variables of file names. Where the name begins with a digit, no browser reads the line, and the tree
/// beside the page stays shut: such variables get a letter in front, and so does the one place that looks for them.
void mend_tree_scripts(const fs::path& html, Problems& problems)
{
    const auto rewrite = [&](const fs::path& path, const std::string& text) {
        if (!write_file(path, text))
            problems.add({path.filename().string(), 0}, "a script that can't be written", "a folder to write to");
    };
    std::error_code error;
    for (const auto& file : fs::directory_iterator(html, error)) {
        const fs::path& path = file.path();
        if (path.extension() != ".js" || std::isdigit(static_cast<unsigned char>(path.filename().string()[0])) == 0)
            continue;
        const std::string text = read_file(path).value_or("");
        if (text.rfind("var ", 0) == 0 && text.rfind("var _", 0) != 0) rewrite(path, "var _" + text.substr(4));
    }
    const std::tuple<const char*, std::string, std::string> k_mended[] = {
        {"navtree.js", "eval(n.replace(/\\-/g,'_'))", "eval(n.replace(/\\-/g,'_').replace(/^(?=[0-9])/,'_'))"},
        {"menu.js", "id=\"MSearchField\"", "id=\"MSearchField\" aria-label=\"Search the manual\""}};
    for (const auto& [name, found, better] : k_mended) {
        const std::string script = read_file(html / name).value_or("");
        if (script.find(found) != std::string::npos) rewrite(html / name, replace_all(script, found, better));
    }
}

std::string with_note(std::string page, const std::string& note)
{
    const std::string mark = "<div class=\"contents\">";
    const std::size_t at = page.find(mark);
    if (at != std::string::npos) page.insert(at + mark.size(), note);
    return page;
}

} // namespace

std::map<int, std::string> linked_lines(const fs::path& page)
{
    std::map<int, std::string> lines;
    const std::string text = read_file(page).value_or("");
    std::size_t at = 0;
    while (const std::optional<std::string> line = between(text, "<div class=\"line\">", "</div>\n", at)) {
        const std::string number = first_between(*line, "name=\"l", "\"");
        std::size_t start = line->find("<span class=\"lineno\">");
        if (number.empty() || start == std::string::npos) continue;
        start = line->find("</span>", start);
        lines[std::stoi(number)] = without_guessed_links(std::string_view(*line).substr(start + 7));
    }
    return lines;
}

Manual read_manual(const fs::path& tag_file, const fs::path& project)
{
    Manual manual;
    const std::string top = project.string() + "/";
    const std::string text = read_file(tag_file).value_or("");
    std::size_t at = 0;
    while (const std::optional<std::string> compound = between(text, "<compound kind=", "</compound>", at)) {
        const std::string kind = first_between(*compound, "\"", "\"");
        const std::string name = first_between(*compound, "<name>", "</name>");
        const std::string page = first_between(*compound, "<filename>", "</filename>");
        const auto note = [&](const std::string& full, const std::string& target) {
            manual.names.emplace(full, target);
            if (full.rfind("flying::", 0) == 0) manual.names.emplace(full.substr(8), target);
        };
        if (kind == "file") {
            std::string path = first_between(*compound, "<path>", "</path>") + name;
            if (path.rfind(top, 0) == 0) path = path.substr(top.size());
            const std::string html = page.size() > 5 && page.substr(page.size() - 5) == ".html" ? page : page + ".html";
            manual.files[path] = html;
            manual.sources[path] = html.substr(0, html.size() - 5) + "_source.html";
        } else if (kind == "class" || kind == "struct" || kind == "namespace") {
            if (kind != "namespace") note(name, page);
            std::size_t inside = 0;
            while (const std::optional<std::string> member = between(*compound, "<member", "</member>", inside)) {
                const std::string own = first_between(*member, "<name>", "</name>");
                note(name + "::" + own, first_between(*member, "<anchorfile>", "</anchorfile>") + "#" +
                                            first_between(*member, "<anchor>", "</anchor>"));
            }
        }
    }
    return manual;
}

void finish_pages(const Material& material, const Pages& pages, const std::vector<std::string>& formulas,
                  const Manual& manual, const fs::path& html, Problems& problems)
{
    const auto write = [&](const fs::path& path, const std::string& text) {
        if (!write_file(path, text))
            problems.add({path.filename().string(), 0}, "a page that can't be written", "a folder to write to");
    };
    Finisher finisher(material, pages.fragments.list(), formulas, manual, html, problems);
    std::vector<FinishedPage> finished_pages;
    for (const Page& page : pages.list) {
        finished_pages.push_back({&page, finisher.replace(markdown_to_html(page.markdown))});
        write(html / (page.name + ".html"), framed(material, page, finished_pages.back().body, ""));
    }
    write(html / fmt::format("{}.html", k_print_page), page_for_print(material, finished_pages));

    const std::map<std::string, std::string> notes = chapter_notes(material);
    std::map<std::string, std::string> by_page; // note by page of the manual
    for (const auto& [file, note] : notes) {
        if (manual.files.count(file) > 0) by_page[manual.files.at(file)] = note;
    }
    for (const fs::path& path : html_files(html / "manual")) {
        const std::string text = read_file(path).value_or("");
        std::string finished = text;
        auto note = by_page.find(path.filename().string());
        if (note == by_page.end() && finished.find("was generated from the following file") != std::string::npos) {
            // A page about a type: it names its file at its end
            const std::size_t end = finished.find("was generated from the following file");
            for (const auto& [page, words] : by_page)
                if (finished.find("href=\"" + page + "\"", end) != std::string::npos) note = by_page.find(page);
        }
        if (note != by_page.end()) finished = with_note(finished, note->second);
        finished = with_landmarks(with_true_row(finished));
        if (finished != text) write(path, finished);
    }
    mend_tree_scripts(html / "manual", problems);
}

void check_links(const fs::path& html, Problems& problems)
{
    std::map<std::string, std::set<std::string>> anchors; // of each page
    std::map<std::string, std::set<std::string>> links;
    for (const fs::path& path : html_files(html)) {
        const std::string name = fs::relative(path, html).generic_string();
        const std::string text = read_file(path).value_or("");
        std::set<std::string>& own = anchors[name];
        for (const char* attribute : {" id=\"", " name=\""}) {
            std::size_t at = 0;
            while (const std::optional<std::string> value = between(text, attribute, "\"", at)) own.insert(*value);
        }
        for (const char* attribute : {"href=\"", "src=\""}) {
            std::size_t at = 0;
            while (const std::optional<std::string> value = between(text, attribute, "\"", at))
                links[name].insert(*value);
        }
    }
    for (const auto& [page, targets] : links) {
        for (const std::string& target : targets) {
            const std::size_t hash = target.find('#');
            std::string file = target.substr(0, hash);
            if (file.rfind("file:", 0) == 0)
                problems.add({page, 0}, fmt::format("link to {}", target), "no path of this machine");
            if (file.find(':') != std::string::npos) continue; // another scheme, or the web
            file = file.substr(0, file.find('?'));
            if (file.empty()) file = page;
            else file = (fs::path(page).parent_path() / file).lexically_normal().generic_string();
            const std::string anchor = hash == std::string::npos ? "" : target.substr(hash + 1);
            const auto known = anchors.find(file);
            if (known == anchors.end()) {
                if (!fs::exists(html / file))
                    problems.add({page, 0}, fmt::format("link to {}", target), "a page or file that is there");
            } else if (!anchor.empty() && known->second.count(anchor) == 0) {
                problems.add({page, 0}, fmt::format("link to {}", target), "an anchor that is there");
            }
        }
    }
}

} // namespace flying::weave
