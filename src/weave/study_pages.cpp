// Pages for study: glossary, index, plan, and the figures as files.

#include <algorithm>
#include <cctype>
#include <map>
#include <set>

#include <fmt/format.h>

#include "weave/pages.hpp"
#include "weave/study.hpp"
#include "weave/text.hpp"

namespace flying::weave {

namespace {

/// Places of one term that the index lists at most.
constexpr std::size_t k_places = 6;

std::string lower(std::string text)
{
    std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::tolower(c); });
    return text;
}

bool is_letter(char c)
{
    return std::isalpha(static_cast<unsigned char>(c)) != 0;
}

/// The text has the term as a word of its own, or with an s.
bool mentions(const std::string& text, const std::string& term)
{
    for (std::size_t at = text.find(term); at != std::string::npos; at = text.find(term, at + 1)) {
        if (at > 0 && is_letter(text[at - 1])) continue;
        std::size_t end = at + term.size();
        if (end < text.size() && text[end] == 's') ++end;
        if (end == text.size() || !is_letter(text[end])) return true;
    }
    return false;
}

/// Where each term is: links to sections, in the order of the chapters. The term itself leads to its line of the
/// glossary.
std::string index_of_terms(const Material& material, std::vector<Term> terms)
{
    std::sort(terms.begin(), terms.end(), [](const Term& a, const Term& b) { return lower(a.term) < lower(b.term); });
    std::map<std::string, std::vector<std::string>> places;
    for (const Chapter& chapter : material.chapters) {
        std::string title = chapter.entry.title;
        std::string anchor;
        std::set<std::string> here; // terms that this section has been listed for
        std::string before;         // the line above: a term may go on in the next
        for (const Block& block : chapter.text.blocks) {
            if (block.kind != BlockKind::text) continue;
            for (const auto& [number, line] : block.lines) {
                if (line.rfind("##", 0) == 0) {
                    title = std::string(trim(line.substr(line.find_first_not_of('#'))));
                    anchor = slug(title);
                    here.clear();
                    before.clear();
                }
                if (anchor == "further-reading" || anchor == "symbols" || anchor == "summary") continue;
                const std::string words = lower(before + " " + line);
                before = line;
                for (const auto& [term, meaning, in_glossary] : terms) {
                    if (!mentions(words, lower(term)) || !here.insert(term).second) continue;
                    places[term].push_back(fmt::format("<a href=\"{0}.html{1}\">{2}&nbsp;{3}</a>", chapter.entry.page(),
                                                       anchor.empty() ? "" : "#" + anchor, chapter.entry.label(),
                                                       escape_html(title)));
                }
            }
        }
    }
    std::string out;
    for (const auto& [term, meaning, anchor] : terms) {
        std::vector<std::string>& found = places[term];
        if (found.empty()) continue;
        if (found.size() > k_places) found.resize(k_places);
        out += fmt::format("<li><b><a href=\"glossary.html#{}\">{}</a></b>: {}</li>", anchor, escape_html(term),
                           join(found, ", "));
    }
    return "<div><ul class=\"terms\">" + out + "</ul></div>";
}

/// A table of the chapters for a plan: hours, what they need, what they are for.
std::string plan_table(const Material& material)
{
    std::string rows;
    int hours = 0;
    for (const Chapter& chapter : material.chapters) {
        const ChapterEntry& entry = chapter.entry;
        hours += entry.hours;
        std::string needs;
        for (const int need : entry.needs) needs += (needs.empty() ? "" : ", ") + material.book.label(need);
        const auto in_code = std::count_if(chapter.exercises.begin(), chapter.exercises.end(),
                                           [](const Exercise& exercise) { return exercise.in_code; });
        rows += fmt::format("<tr><td>{}</td><td><a href=\"{}.html\">{}</a></td><td>{}</td><td>{}</td><td>{}, {} in "
                            "code</td></tr>",
                            entry.label(), entry.page(), escape_html(entry.title), entry.hours, needs,
                            chapter.exercises.size(), in_code);
    }
    return fmt::format(
        "<div><table><thead><tr><th>No.</th><th>Chapter</th><th>Hours</th><th>Needs</th><th>Exercises</th></tr></thead>"
        "<tbody>{}<tr><td></td><td>All</td><td>{}</td><td></td><td></td></tr></tbody></table></div>",
        rows, hours);
}

/// Every figure as a file.
std::string figure_files(const Material& material)
{
    std::string out;
    for (const Chapter& chapter : material.chapters) {
        std::string links;
        for (const Block& block : chapter.text.blocks)
            if (block.kind == BlockKind::figure)
                links += fmt::format("{}<a href=\"figures/{}/{}.svg\">{}</a>", links.empty() ? "" : ", ",
                                     chapter.entry.name, block.name, block.name);
        out += fmt::format("<li>{}: {}</li>", escape_html(chapter.entry.title), links);
    }
    return "<div><ul>" + out + "</ul></div>";
}

/// The glossary with an anchor at each term.
ChapterText with_anchors(ChapterText glossary, const std::vector<Term>& terms, Fragments& fragments)
{
    for (Block& block : glossary.blocks)
        for (auto& [number, line] : block.lines)
            for (const Term& term : terms) {
                const std::string start = "- **" + term.term + "**:";
                if (line.rfind(start, 0) != 0) continue;
                const std::string name = fmt::format("<strong id=\"{}\">{}</strong>", term.anchor,
                                                     replace_all(escape_html(term.term), "'", "\u2019"));
                line = "- " + fragments.add_html(name) + ":" + line.substr(start.size());
            }
    return glossary;
}

} // namespace

void add_study_pages(const Material& material, TextWriter& writer, Pages& pages)
{
    const auto add = [&](std::string name, std::string title, std::string markdown) {
        Page page;
        page.name = std::move(name);
        page.title = std::move(title);
        page.markdown = std::move(markdown);
        page.sections = writer.take_sections();
        pages.list.push_back(std::move(page));
    };
    std::string answers;
    for (const Chapter& chapter : material.chapters) answers += writer.answers(chapter);
    add("answers", "Answers to the exercises", answers);

    const Chapter none;
    for (const auto& [name, text] : material.extras) {
        const std::vector<Term> terms = name == "glossary" ? terms_of(text) : std::vector<Term>();
        std::string markdown = writer.blocks(none, with_anchors(text, terms, pages.fragments));
        if (name == "teachers") {
            markdown +=
                writer.heading(2, "Chapters and hours") + pages.fragments.add_html(plan_table(material)) + "\n\n";
            markdown +=
                writer.heading(2, "Figures as files") + pages.fragments.add_html(figure_files(material)) + "\n\n";
        }
        if (name == "about" && !material.book.version.empty())
            markdown += fmt::format("\n\nThis is version {}.\n", material.book.version);
        add(name, text.title, markdown);
        if (!terms.empty()) add("terms", "Index", pages.fragments.add_html(index_of_terms(material, terms)) + "\n");
    }
}

} // namespace flying::weave
