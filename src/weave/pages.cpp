#include "weave/pages.hpp"

#include <fmt/format.h>

#include "weave/claims.hpp"
#include "weave/live_matter.hpp"
#include "weave/text.hpp"

namespace flying::weave {

namespace {

std::string link(const ChapterEntry& entry, const std::string& words, const char* place)
{
    return fmt::format("<a class=\"{}\" rel=\"{}\" href=\"{}.html\">{}</a>", place, place, entry.page(), words);
}

/// Links to the chapters before and after.
std::string neighbours(const Material& material, std::size_t at)
{
    const std::vector<Chapter>& chapters = material.chapters;
    std::string out = "<nav class=\"neighbours\">";
    if (at > 0)
        out += link(chapters[at - 1].entry, "\u2190 " + escape_html(page_title(chapters[at - 1].entry)), "prev");
    out += "<a class=\"up\" href=\"index.html\">All chapters</a>";
    if (at + 1 < chapters.size())
        out += link(chapters[at + 1].entry, escape_html(page_title(chapters[at + 1].entry)) + " \u2192", "next");
    return out + "</nav>";
}

/// What stands under a chapter's title: its question, what it builds on.
std::string masthead(const Material& material, const ChapterEntry& entry)
{
    std::string needs;
    for (const int number : entry.needs) {
        const ChapterEntry* other = material.book.chapter(number);
        if (other == nullptr) continue;
        const std::string words = fmt::format("{} {}", other->label(), escape_html(other->title));
        needs += (needs.empty() ? "" : ", ") + (other->written ? link(*other, words, "reference") : words);
    }
    return fmt::format("<p class=\"question\">{}</p>{}", escape_html(entry.question),
                       needs.empty() ? "" : "<p class=\"needs\">Builds on " + needs + "</p>");
}

} // namespace

namespace {

std::string shown_error(double value)
{
    const std::string shown = value == 0.0 ? "0" : format_value(value, "%.1e").value_or("?");
    return "<span class=\"value\">" + shown + "</span>";
}

/// Where a test stands, as its program has written it: `test "name" (path:line)`. A compiler that was called beside the
/// project may have known the file by a path from there.
std::string shown_place(const std::string& where)
{
    std::string out = where;
    while (out.find("(../") != std::string::npos) out.replace(out.find("(../"), 4, "(");
    const std::size_t opens = out.find('"');
    const std::size_t closes = out.rfind('"');
    if (opens == closes) return escape_html(out);
    return escape_html(out.substr(0, opens)) + "\u201c" + escape_html(out.substr(opens + 1, closes - opens - 1)) +
           "\u201d" + escape_html(out.substr(closes + 1));
}

} // namespace

std::string receipt_sentence(const Material& material, const Numbered& numbered)
{
    const std::string& id = numbered.block->name;
    if (numbered.kind == BlockKind::derivation) {
        const auto found = material.ledger.derivations.find(id);
        if (found == material.ledger.derivations.end()) return "";
        const DerivationReceipt& receipt = found->second;
        return fmt::format("{} lines agree at {} points, worst relative difference {}; {}.", receipt.lines,
                           receipt.points, shown_error(receipt.worst),
                           receipt.where.empty() ? "the printed lines were evaluated as they stand"
                                                 : "tested in " + shown_place(receipt.where));
    }
    const auto found = material.ledger.equations.find(id);
    if (numbered.kind != BlockKind::equation || found == material.ledger.equations.end()) return "";
    const EquationReceipt& receipt = found->second;
    const char* const printed = receipt.printed_cases > 0 ? "; evaluated as printed" : "";
    const std::string cases = fmt::format("{} case{}", receipt.cases, receipt.cases == 1 ? "" : "s");
    const std::string where = "in " + shown_place(receipt.where);
    switch (receipt_kind(*numbered.block).value_or(ReceiptKind::oracle)) {
    case ReceiptKind::same:
        return fmt::format("Same expression: the test repeats the code's own line, {}, {}. That is no check of the "
                           "formula{}.",
                           cases, where, printed);
    case ReceiptKind::measured:
        return fmt::format("Engine measured: {}, worst relative error {}, {}; a wrong twin was rejected{}.", cases,
                           shown_error(receipt.worst), where, printed);
    case ReceiptKind::exact:
        return fmt::format("Independent oracle: {}, equal to the last bit, {}; a wrong twin was rejected{}.", cases,
                           where, printed);
    case ReceiptKind::oracle:
        break;
    }
    return fmt::format("Independent oracle: {}, worst relative error {}, {}; a wrong twin was rejected{}.", cases,
                       shown_error(receipt.worst), where, printed);
}

std::string receipt_note(const Material& material, const Numbered& numbered)
{
    const std::string sentence = receipt_sentence(material, numbered);
    if (sentence.empty()) return "";
    const std::string& id = numbered.block->name;
    std::string kind;
    std::string summary;
    if (numbered.kind == BlockKind::derivation) {
        kind = "lines";
        summary = "error " + shown_error(material.ledger.derivations.at(id).worst);
    } else {
        const std::string error = shown_error(material.ledger.equations.at(id).worst);
        switch (receipt_kind(*numbered.block).value_or(ReceiptKind::oracle)) {
        case ReceiptKind::same:
            kind = "same";
            summary = "same expression";
            break;
        case ReceiptKind::measured:
            kind = "measured";
            summary = "measured, error " + error;
            break;
        default:
            kind = "oracle";
            summary = "error " + error;
        }
    }
    return fmt::format("<details class=\"receipt {}\"><summary>{}</summary><p>{} "
                       "<a href=\"equations.html#receipt-{}\">All receipts</a></p></details>",
                       kind, summary, sentence, numbered.anchor);
}

namespace {

/// Takes the table of symbols out of a chapter's text, with its heading: readers want it at the end. What else the
/// section says stays where it is.
ChapterText without_symbols(const ChapterText& text, Block& table)
{
    ChapterText rest = text;
    bool inside = false;
    for (Block& block : rest.blocks) {
        if (block.kind != BlockKind::text) continue;
        std::vector<std::pair<int, std::string>> kept;
        for (const auto& [number, line] : block.lines) {
            const bool is_heading = line.rfind("## ", 0) == 0;
            if (is_heading) inside = trim(line.substr(3)) == "Symbols";
            const bool is_row = inside && trim(line).substr(0, 1) == "|";
            if (is_row) table.lines.emplace_back(number, line);
            else if (!inside || !is_heading) kept.emplace_back(number, line);
        }
        block.lines = std::move(kept);
    }
    table.place = table.lines.empty() ? Place{text.path, 0} : Place{text.path, table.lines.front().first};
    return rest;
}

} // namespace

Pages make_pages(const Material& material, const Counts& counts, Problems& problems)
{
    Pages pages;
    TextWriter writer(material, pages.fragments, problems);
    for (std::size_t k = 0; k < material.chapters.size(); ++k) {
        const Chapter& chapter = material.chapters[k];
        Page page;
        page.name = chapter.entry.page();
        page.title = chapter.entry.title;
        page.over = fmt::format("<p class=\"part\">{} \u00b7 {}</p>", escape_html(chapter.entry.part),
                                chapter.entry.called_first());
        page.under = masthead(material, chapter.entry);
        page.foot = neighbours(material, k);
        Block symbols;
        page.markdown = writer.blocks(chapter, without_symbols(chapter.text, symbols));
        page.markdown += writer.heading(2, "Symbols") + writer.inline_text(symbols.lines, chapter.text.path);
        page.sections = writer.take_sections();
        page.foot += live_script(material.folders, chapter.entry);
        pages.list.push_back(std::move(page));
    }
    add_generated_pages(material, counts, writer, pages);
    add_study_pages(material, writer, pages);
    return pages;
}

} // namespace flying::weave
