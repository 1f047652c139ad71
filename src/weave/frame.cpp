#include "weave/frame.hpp"

#include <fmt/format.h>

#include "weave/text.hpp"

namespace flying::weave {

namespace {

/// The headings of a page as nested lists.
std::string section_list(const std::vector<Section>& sections)
{
    std::string out;
    int level = 1;
    for (const Section& section : sections) {
        if (section.level > level) {
            for (; level < section.level; ++level) out += "<ul>";
        } else {
            out += "</li>";
            for (; level > section.level; --level) out += "</ul></li>";
        }
        out += fmt::format("<li><a href=\"#{}\">{}</a>", section.anchor, escape_html(section.title));
    }
    for (; level > 1; --level) out += "</li></ul>";
    return out;
}

std::string entry(const Page& page, const std::string& name, const std::string& number, const std::string& title,
                  const std::string& root)
{
    const bool here = page.name == name;
    return fmt::format("<li{}><a href=\"{}{}.html\"{}><span class=\"n\">{}</span>{}</a>{}</li>",
                       here ? " class=\"here\"" : "", root, name, here ? " aria-current=\"page\"" : "", number,
                       escape_html(title), here ? section_list(page.sections) : "");
}

/// The contents of the book, and of the page in its place.
std::string book_list(const Material& material, const Page& page, const std::string& root)
{
    std::string out;
    std::string part;
    for (const ChapterEntry& chapter : material.book.chapters) {
        if (!chapter.written) continue;
        if (chapter.part != part)
            out += fmt::format("{}<p>{}</p><ol>", part.empty() ? "" : "</ol>", escape_html(chapter.part));
        part = chapter.part;
        out += entry(page, chapter.page(), chapter.label(), chapter.title, root);
    }
    if (!part.empty()) out += "</ol>";
    out += "<p>Study</p><ol>";
    const std::pair<const char*, const char*> study[] = {{"answers", "Answers"},
                                                         {"glossary", "Glossary"},
                                                         {"teachers", "For teachers"},
                                                         {"about", "About, licence, citing"}};
    for (const auto& [name, title] : study) {
        if (name != std::string_view("answers") && material.extras.count(name) == 0) continue;
        out += entry(page, name, "", title, root);
        if (name == std::string_view("glossary")) out += entry(page, "terms", "", "Index", root);
    }
    out += "</ol><p>Reference</p><ol>";
    const std::pair<const char*, const char*> others[] = {{"playground", "Playground"},
                                                          {"equations", "Equations and receipts"},
                                                          {"symbols", "Symbols"},
                                                          {"told", "What is told, and what is not"},
                                                          {"numbers", "The book in numbers"},
                                                          {"sources", "The sources"},
                                                          {"manual/index", "Manual of the code"}};
    for (const auto& [name, title] : others)
        if (material.book.is_playable || std::string_view(name) != "playground")
            out += entry(page, name, "", title, root);
    return out + "</ol>";
}

} // namespace

std::string framed(const Material& material, const Page& page, const std::string& body, const std::string& root)
{
    const std::string book = escape_html(material.book.title);
    const bool is_front = page.name == "index";
    const bool is_live = body.find("<figure class=\"live") != std::string::npos;
    std::string out =
        fmt::format("<!DOCTYPE html>\n<html lang=\"en-GB\">\n<head>\n<meta charset=\"utf-8\">\n<title>{0}</title>\n"
                    "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
                    "<link rel=\"stylesheet\" href=\"{1}katex/katex.min.css\">\n<link rel=\"stylesheet\" "
                    "href=\"{1}theme/book.css\">\n"
                    "<script src=\"{1}theme/page.js\" data-root=\"{1}\"></script>\n{2}</head>\n<body>\n",
                    is_front ? book : escape_html(page.title) + " \u00b7 " + book, root,
                    is_live ? fmt::format("<script src=\"{}live.js\" defer></script>\n", root) : "");
    out += fmt::format("<a class=\"skip\" href=\"#text\">To the text</a>\n<header class=\"bar\">"
                       "<button type=\"button\" class=\"menu\" aria-label=\"Contents\" aria-expanded=\"false\" "
                       "aria-controls=\"contents\">"
                       "\u2630</button><a class=\"home\" href=\"{0}index.html\">{1}</a>"
                       "<button type=\"button\" class=\"find\" title=\"Search (/)\">Search</button>"
                       "<button type=\"button\" class=\"shade\" aria-label=\"Dark or light\" title=\"Dark or "
                       "light\">\u25d0</button></header>\n"
                       "<nav class=\"contents\" id=\"contents\" aria-label=\"Contents of the book\">{2}</nav>\n",
                       root, book, book_list(material, page, root));
    // The path of a source may go on below at its signs
    const std::string title = replace_all(replace_all(escape_html(page.title), "/", "/<wbr>"), "_", "_<wbr>");
    out += fmt::format("<main id=\"text\"><article>\n<header class=\"chapter\">{}<h1>{}</h1>{}</header>\n", page.over,
                       title, page.under);
    if (page.sections.size() > 2)
        out += fmt::format("<details class=\"onpage\"><summary>On this page</summary>{}</details>\n",
                           section_list(page.sections));
    const std::string version = material.book.version.empty() ? "" : " " + material.book.version;
    const std::string about = material.extras.count("about") == 0
                                  ? ""
                                  : fmt::format(" \u00b7 <a href=\"{}about.html\">licence, citing</a>", root);
    return out + body + "\n</article>" + page.foot +
           fmt::format("<footer class=\"imprint\">{}{}{}</footer></main>\n</body>\n</html>\n", book, version, about);
}

} // namespace flying::weave
