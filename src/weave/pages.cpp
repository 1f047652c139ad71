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
    out += "<a class=\"up\" href=\"course.html\">All chapters</a>";
    if (at + 1 < chapters.size())
        out += link(chapters[at + 1].entry, escape_html(page_title(chapters[at + 1].entry)) + " \u2192", "next");
    return out + "</nav>";
}

/// What stands over a chapter: its part, its question, what it builds on.
std::string masthead(const Material& material, const ChapterEntry& entry)
{
    std::string needs;
    for (const int number : entry.needs) {
        const ChapterEntry* other = material.book.chapter(number);
        if (other == nullptr) continue;
        const std::string words = fmt::format("{} {}", number, escape_html(other->title));
        needs += (needs.empty() ? "" : ", ") + (other->written ? link(*other, words, "reference") : words);
    }
    return fmt::format("<header class=\"chapter\"><p class=\"part\">{}{}</p><p class=\"question\">{}</p></header>",
                       escape_html(entry.part), needs.empty() ? "" : " \u00b7 builds on " + needs,
                       escape_html(entry.question));
}

} // namespace

std::string receipt_line(const Material& material, const Numbered& numbered)
{
    const auto number = [](double value) {
        const std::string shown = value == 0.0 ? "0" : format_value(value, "%.1e").value_or("?");
        return "<span class=\"value\">" + shown + "</span>";
    };
    const std::string& id = numbered.block->name;
    if (numbered.kind == BlockKind::definition) return "";
    if (numbered.kind == BlockKind::derivation) {
        const auto found = material.ledger.derivations.find(id);
        if (found == material.ledger.derivations.end()) return "";
        const DerivationReceipt& receipt = found->second;
        return fmt::format(
            "<p class=\"receipt\" title=\"{}\">checked: {} lines agree at {} points, worst relative "
            "difference {}</p>",
            escape_html(receipt.where.empty() ? "the printed lines, evaluated as they stand" : receipt.where),
            receipt.lines, receipt.points, number(receipt.worst));
    }
    const auto found = material.ledger.equations.find(id);
    if (found == material.ledger.equations.end()) return "";
    const EquationReceipt& receipt = found->second;
    const std::string cases = fmt::format("{} case{}", receipt.cases, receipt.cases == 1 ? "" : "s");
    const char* const printed = receipt.printed_cases > 0 ? "; evaluated as printed" : "";
    const auto line = [&](const char* kind, const std::string& words) {
        return fmt::format("<p class=\"receipt {}\" title=\"worst in {}\">{}{}</p>", kind, escape_html(receipt.where),
                           words, printed);
    };
    switch (receipt_kind(*numbered.block).value_or(ReceiptKind::oracle)) {
    case ReceiptKind::same:
        return line("same", fmt::format("same expression: the code's own line, repeated in {}", cases));
    case ReceiptKind::measured:
        return line("measured", fmt::format("engine measured: {}, worst relative error {}; wrong twin rejected", cases,
                                            number(receipt.worst)));
    case ReceiptKind::exact:
        return line("oracle", fmt::format("independent oracle: {}, equal to the last bit; wrong twin rejected", cases));
    case ReceiptKind::oracle:
        break;
    }
    return line("oracle", fmt::format("independent oracle: {}, worst relative error {}; wrong twin rejected", cases,
                                      number(receipt.worst)));
}

Pages make_pages(const Material& material, const Counts& counts, Problems& problems)
{
    Pages pages;
    TextWriter writer(material, pages.fragments, problems);
    for (std::size_t k = 0; k < material.chapters.size(); ++k) {
        const Chapter& chapter = material.chapters[k];
        const std::string name = chapter.entry.page();
        const std::string around = pages.fragments.add_html(neighbours(material, k));
        std::string text = fmt::format("# {} {{#{}}}\n\n[TOC]\n\n{}\n\n", page_title(chapter.entry), name,
                                       pages.fragments.add_html(masthead(material, chapter.entry)));
        text += writer.blocks(chapter, chapter.text, name);
        if (chapter.rest) {
            text += fmt::format("\n\n- \\subpage {}_rest\n", name);
            pages.list.push_back(
                {name + "_rest",
                 fmt::format("# The rest of the code of chapter {} {{#{}_rest}}\n\n{}\n\n{}\n", chapter.entry.number,
                             name, writer.blocks(chapter, *chapter.rest, name + "_rest"), around)});
        }
        text += "\n" + around + "\n" + pages.fragments.add_html(live_script(material.folders, chapter.entry)) + "\n";
        pages.list.push_back({name, text});
    }
    add_generated_pages(material, counts, writer, pages);
    return pages;
}

} // namespace flying::weave
