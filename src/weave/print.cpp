#include "weave/print.hpp"

#include <algorithm>
#include <iterator>
#include <set>
#include <string_view>

#include <fmt/format.h>

#include "weave/text.hpp"

namespace flying::weave {

namespace {

/// What follows the chapters, in this order. What isn't here is for a screen: the playground, the sources, the counts.
constexpr const char* k_behind[] = {"answers", "glossary", "terms", "symbols", "equations", "teachers", "about"};

/// Sections that every chapter has: the contents leave them out.
constexpr std::string_view k_everywhere[] = {"what-you-need", "exercises", "summary", "further-reading", "symbols"};

/// Rewrites what stands between `open` and the next quotation mark, wherever `open` occurs.
template <typename Rewrite>
std::string with_each(const std::string& html, const std::string& open, const Rewrite& rewrite)
{
    std::string out;
    std::size_t at = 0;
    for (std::size_t next = html.find(open); next != std::string::npos; next = html.find(open, at)) {
        const std::size_t from = next + open.size();
        const std::size_t end = std::min(html.find('"', from), html.size());
        out.append(html, at, next - at);
        out += rewrite(html.substr(from, end - from));
        at = std::min(end + 1, html.size());
    }
    return out + html.substr(at);
}

/// A page's HTML with its anchors and links as they are in the joined page.
std::string joined(const std::string& html, const std::string& page, const std::set<std::string>& all)
{
    const std::string with_anchors = with_each(
        html, " id=\"", [&](const std::string& id) { return fmt::format(" id=\"{}.{}\"", page, id); });
    return with_each(with_anchors, " href=\"", [&](const std::string& target) -> std::string {
        if (target.find(':') != std::string::npos) return fmt::format(" href=\"{}\"", target);
        const std::size_t hash = std::min(target.find('#'), target.size());
        const std::size_t end = target.compare(0, hash, "") == 0 ? 0 : target.rfind(".html", hash);
        const std::string other = hash == 0 ? page : target.substr(0, std::min(end, hash));
        if (all.count(other) == 0) return "";
        if (hash == target.size()) return fmt::format(" href=\"#{}\"", other);
        return fmt::format(" href=\"#{}.{}\"", other, target.substr(hash + 1));
    });
}

std::string contents_line(const std::string& target, const std::string& number, const std::string& title)
{
    return fmt::format("<a href=\"#{}\"><span class=\"n\">{}</span><span class=\"words\">{}</span></a>", target, number,
                       escape_html(title));
}

/// Parts, chapters with their sections, and what follows them.
std::string contents(const Material& material, const std::vector<const FinishedPage*>& pages)
{
    std::string out;
    std::string part;
    for (const FinishedPage* one : pages) {
        const Page& page = *one->page;
        const auto chapter = std::find_if(material.book.chapters.begin(), material.book.chapters.end(),
                                          [&](const ChapterEntry& entry) { return entry.page() == page.name; });
        const bool is_chapter = chapter != material.book.chapters.end();
        const std::string own = is_chapter ? chapter->part : "To look up";
        if (own != part)
            out += fmt::format("{}<h2>{}</h2><ol>", part.empty() ? "" : "</ol>", escape_html(own));
        part = own;
        out += "<li>" + contents_line(page.name, is_chapter ? chapter->label() : "", page.title);
        if (is_chapter) {
            out += "<ul>";
            for (const Section& section : page.sections)
                if (section.level == 2 && std::find(std::begin(k_everywhere), std::end(k_everywhere), section.anchor) ==
                                              std::end(k_everywhere))
                    out += "<li>" + contents_line(page.name + "." + section.anchor, "", section.title) + "</li>";
            out += "</ul>";
        }
        out += "</li>";
    }
    return part.empty() ? "" : out + "</ol>";
}

} // namespace

std::string page_for_print(const Material& material, const std::vector<FinishedPage>& pages)
{
    // The chapters as they come, then what follows them
    std::vector<const FinishedPage*> chosen;
    std::set<std::string> names;
    const auto choose = [&](const FinishedPage& one) {
        chosen.push_back(&one);
        names.insert(one.page->name);
    };
    for (const FinishedPage& one : pages)
        if (one.page->name.rfind("chapter_", 0) == 0) choose(one);
    for (const char* name : k_behind)
        for (const FinishedPage& one : pages)
            if (one.page->name == name) choose(one);

    std::string text;
    for (const FinishedPage* one : chosen) {
        const Page& page = *one->page;
        text += fmt::format("<article class=\"leaf\" id=\"{0}\">\n<header class=\"chapter\">{1}<h1>{2}</h1>{3}"
                            "</header>\n{4}\n</article>\n",
                            page.name, joined(page.over, page.name, names), escape_html(page.title),
                            joined(page.under, page.name, names), joined(one->body, page.name, names));
    }

    const std::string title = escape_html(material.book.title);
    const std::string version = material.book.version.empty() ? "" : "<p>Version " + material.book.version + "</p>";
    return fmt::format(
        "<!DOCTYPE html>\n<html lang=\"en-GB\">\n<head>\n<meta charset=\"utf-8\">\n<title>{0}</title>\n"
        "<link rel=\"stylesheet\" href=\"katex/katex.min.css\">\n<link rel=\"stylesheet\" href=\"theme/book.css\">\n"
        "</head>\n<body class=\"print\">\n<main>\n<header class=\"cover\"><h1>{0}</h1><p>{1}</p>{2}</header>\n"
        "<nav class=\"leaf to\" id=\"contents\" aria-label=\"Contents\"><h1>Contents</h1><div class=\"columns\">{3}</div>"
        "</nav>\n{4}</main>\n"
        "</body>\n</html>\n",
        title, escape_html(material.book.brief), version, contents(material, chosen), text);
}

} // namespace flying::weave
