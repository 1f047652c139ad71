#include <algorithm>
#include <map>
#include <set>
#include <tuple>
#include <utility>

#include <fmt/format.h>

#include "weave/claims.hpp"
#include "weave/live_matter.hpp"
#include "weave/pages.hpp"
#include "weave/receipts.hpp"
#include "weave/tally.hpp"
#include "weave/text.hpp"

namespace flying::weave {

namespace {

// ---- The map of chapters --------------------------------------------------------------------------------------------

constexpr int k_box_width = 216;
constexpr int k_box_height = 58;
constexpr int k_column_width = 264;
constexpr int k_row = 92;
constexpr int k_margin = 76;

/// What a chapter builds on, without what follows from the others.
std::set<int> direct_needs(const Book& book, const ChapterEntry& entry)
{
    std::map<int, std::set<int>> below; // all that a chapter builds on
    for (const ChapterEntry& other : book.chapters)
        for (const int need : other.needs) {
            below[other.number].insert(need);
            below[other.number].insert(below[need].begin(), below[need].end());
        }
    std::set<int> direct(entry.needs.begin(), entry.needs.end());
    for (const int need : entry.needs)
        for (const int under : below[need]) direct.erase(under);
    return direct;
}

struct Spot
{
    int column = 0;
    int row = 0;
    [[nodiscard]] int x() const { return k_margin + column * k_column_width; }
    [[nodiscard]] int y() const { return 8 + row * k_row; }
};

std::string arrow(const Spot& from, const Spot& to)
{
    const int low = from.y() + k_box_height;
    if (to.row == from.row + 1) {
        const int x0 = from.x() + k_box_width / 2;
        const int x1 = to.x() + k_box_width / 2;
        return fmt::format("<path d=\"M{0},{1} C{0},{2} {3},{1} {3},{4}\"/>", x0, low, to.y() - 6, x1, to.y() - 5);
    }
    if (from.column > to.column) {
        // Down the gap between the columns
        const int gap = from.x() - (k_column_width - k_box_width) / 2;
        const int y0 = from.y() + k_box_height / 2;
        const int y1 = to.y() + k_box_height / 2;
        return fmt::format("<path d=\"M{0},{1} C{2},{1} {2},{1} {2},{3} L{2},{4} C{2},{5} {2},{5} {6},{5}\"/>",
                           from.x(), y0, gap, y0 + 22, y1 - 22, y1, to.x() + k_box_width + 5);
    }
    // Round what lies between, on the outer side
    const int side = from.column == 0 ? -1 : 1;
    const int x0 = from.x() + (side < 0 ? 0 : k_box_width);
    const int x1 = to.x() + (side < 0 ? -5 : k_box_width + 5);
    const int y0 = from.y() + k_box_height / 2;
    const int y1 = to.y() + k_box_height / 2;
    const int out = (side < 0 ? std::min(x0, x1) - 64 : std::max(x0, x1) + 64);
    return fmt::format("<path d=\"M{},{} C{},{} {},{} {},{}\"/>", x0, y0, out, y0, out, y1, x1, y1);
}

/// A picture of what builds on what: a chapter stands below all that it needs.
std::string chapter_map(const Book& book)
{
    std::map<int, Spot> spots;
    std::map<int, int> taken; // boxes in a row
    int rows = 0;
    int columns = 1;
    for (const ChapterEntry& entry : book.chapters) {
        int row = 0;
        for (const int need : entry.needs) row = std::max(row, spots[need].row + 1);
        const int column = taken[row]++;
        spots[entry.number] = {column, row};
        rows = std::max(rows, row + 1);
        columns = std::max(columns, column + 1);
    }
    std::string paths;
    std::string boxes;
    for (const ChapterEntry& entry : book.chapters) {
        const Spot& spot = spots[entry.number];
        for (const int need : direct_needs(book, entry)) paths += arrow(spots[need], spot);
        const std::string box = fmt::format(
            "<g class=\"{0}\"><title>{1}</title><rect x=\"{2}\" y=\"{3}\" width=\"{4}\" height=\"{5}\" rx=\"9\"/>"
            "<text class=\"name\" x=\"{6}\" y=\"{7}\">{8} \u00b7 {9}</text><text class=\"part\" x=\"{6}\" "
            "y=\"{10}\">{11}</text></g>",
            entry.written ? "written" : "planned", escape_html(entry.question), spot.x(), spot.y(), k_box_width,
            k_box_height, spot.x() + k_box_width / 2, spot.y() + 25, entry.label(), escape_html(entry.title),
            spot.y() + 45, entry.written ? escape_html(entry.part) : "not written yet");
        boxes += entry.written ? fmt::format("<a href=\"{}.html\">{}</a>", entry.page(), box) : box;
    }
    const int width = 2 * k_margin + (columns - 1) * k_column_width + k_box_width;
    return fmt::format(
        "<figure class=\"map\"><svg viewBox=\"0 0 {0} {1}\" role=\"group\" aria-label=\"Which chapter builds on which; "
        "the list "
        "below says the same in words\"><defs><marker id=\"head\" viewBox=\"0 0 8 8\" refX=\"5\" refY=\"4\" "
        "markerWidth=\"7\" "
        "markerHeight=\"7\" orient=\"auto\"><path d=\"M0,0 L8,4 L0,8 z\"/></marker></defs><g class=\"arrows\" "
        "marker-end=\"url(#head)\">{2}</g>{3}</svg></figure>",
        width, 8 + rows * k_row, replace_all(paths, "/>", " marker-end=\"url(#head)\"/>"), boxes);
}

// ---- Contents -------------------------------------------------------------------------------------------------------

std::string contents(const Material& material)
{
    std::string out;
    std::string part;
    for (const ChapterEntry& entry : material.book.chapters) {
        if (entry.part != part)
            out += fmt::format("{}<h2>{}</h2><ol{}>", part.empty() ? "" : "</ol>", escape_html(entry.part),
                               entry.appendix.empty() ? "" : " type=\"A\"");
        part = entry.part;
        const std::string title = escape_html(entry.title);
        std::string needs;
        for (const int need : entry.needs) needs += (needs.empty() ? "builds on " : ", ") + material.book.label(need);
        out +=
            fmt::format("<li value=\"{}\">{} <span class=\"question\">{}</span> <span class=\"needs\">{}{}</span></li>",
                        entry.appendix.empty() ? entry.place : entry.appendix[0] - 'A' + 1,
                        entry.written ? fmt::format("<a href=\"{}.html\">{}</a>", entry.page(), title) : title,
                        escape_html(entry.question), needs,
                        entry.written ? "" : (needs.empty() ? "" : "; ") + std::string("not written yet"));
    }
    return "<div class=\"contents-list\">" + out + "</ol></div>";
}

// ---- Index of equations ---------------------------------------------------------------------------------------------

std::string equation_index(const Material& material, Fragments& fragments)
{
    std::vector<const Numbered*> all;
    for (const auto& [id, numbered] : material.numbered) all.push_back(&numbered);
    std::sort(all.begin(), all.end(), [](const Numbered* a, const Numbered* b) {
        const auto place = [](const Numbered* n) { // appendices have letters, which come after the chapters
            const std::size_t dot = n->number.find('.');
            const std::string label = n->number.substr(0, dot);
            const bool is_appendix = label.find_first_not_of("0123456789") != std::string::npos;
            return std::tuple(is_appendix, is_appendix ? label[0] : std::stoi(label),
                              std::stoi(n->number.substr(dot + 1)));
        };
        return place(a) < place(b);
    });
    int equations = 0;
    int definitions = 0;
    int derivations = 0;
    int printed = 0;
    int measured = 0;
    int same = 0;
    std::string rows;
    for (const Numbered* numbered : all) {
        const Block& block = *numbered->block;
        std::string tex;
        std::string what;
        switch (numbered->kind) {
        case BlockKind::equation: {
            ++equations;
            const auto receipt = material.ledger.equations.find(block.name);
            if (receipt != material.ledger.equations.end() && receipt->second.printed_cases > 0) ++printed;
            const ReceiptKind kind = receipt_kind(block).value_or(ReceiptKind::oracle);
            measured += kind == ReceiptKind::measured ? 1 : 0;
            same += kind == ReceiptKind::same ? 1 : 0;
            tex = formula_of(block);
            break;
        }
        case BlockKind::definition:
            ++definitions;
            what = "Defines; nothing to check.";
            tex = formula_of(block);
            break;
        default: {
            ++derivations;
            const std::vector<Step> steps = steps_of(block);
            if (!steps.empty()) {
                const std::string& last = steps.back().tex;
                tex = steps.front().tex.substr(0, steps.front().tex.find('=')) +
                      (last.substr(0, 1) == "=" ? last : "= " + last);
                if (steps.front().tex.find('=') == std::string::npos && steps.size() > 1)
                    tex = steps.front().tex + last;
            }
        }
        }
        rows += fmt::format(
            "<li id=\"receipt-{1}\"><a class=\"number\" href=\"{0}.html#{1}\">({2})</a><div class=\"entry\">{3}"
            "<p class=\"sentence\">{4}</p><code>{5}</code></div></li>",
            numbered->page, numbered->anchor, numbered->number, fragments.add_formula(tex, false, block.place),
            what.empty() ? receipt_sentence(material, *numbered) : what, escape_html(block.name));
    }
    return fmt::format(
        "<p>{} equations were held against an independent oracle, {} against what the engine measured. {} more only "
        "repeat the code's own expression, which checks nothing and counts as no check. {} of all these were also "
        "evaluated as they are printed. {} derivations were checked line by line; {} formulas define. Every receipt "
        "was written by the tests of this build.</p><ol class=\"equations\">{}</ol>",
        equations - measured - same, measured, same, printed, derivations, definitions, rows);
}

// ---- Symbols --------------------------------------------------------------------------------------------------------

/// Where a symbol stands in the alphabet: x with a bar beside x, and varphi as phi.
std::string alphabetical(const std::string& tex)
{
    for (const std::string_view over : {"\\bar{", "\\mathbf{"})
        if (tex.starts_with(over)) return tex.substr(over.size());
    return tex.starts_with("\\var") ? "\\" + tex.substr(4) : tex;
}

std::string symbol_table(const Material& material, TextWriter& writer)
{
    struct Row
    {
        const Symbol* symbol;
        std::vector<const Chapter*> chapters;
    };
    std::map<std::tuple<std::string, std::string, std::string>, Row> rows; // by alphabet, symbol and meaning
    for (const Chapter& chapter : material.chapters)
        for (const Symbol& symbol : chapter.text.symbols) {
            const std::tuple key(alphabetical(symbol.tex), symbol.tex, symbol.meaning);
            Row& row = rows.try_emplace(key, Row{&symbol, {}}).first->second;
            row.chapters.push_back(&chapter);
        }
    std::string out = "| Symbol | Meaning | Unit | Chapters | In the code |\n|:--|:--|:--|:--|:--|\n";
    for (const auto& [key, row] : rows) {
        const Symbol& symbol = *row.symbol;
        std::string line = fmt::format("| ${}$ | {} | {} |", symbol.tex, symbol.meaning, symbol.unit);
        for (const Chapter* chapter : row.chapters)
            line += fmt::format(" {{{{ch:{}|{}}}}}", chapter->entry.name.substr(3), chapter->entry.label());
        // A name has lost its backquotes; words with a name among them have kept theirs
        const bool is_name = !symbol.code.empty() && symbol.code.front() != '`' && symbol.code.back() != '`';
        line += fmt::format(" | {} |", is_name ? "`" + symbol.code + "`" : symbol.code);
        out += writer.inline_text({{symbol.place.line, line}}, symbol.place.file);
    }
    return out;
}

// ---- What is told ---------------------------------------------------------------------------------------------------

std::string told(const Material& material, const Counts& counts)
{
    const Share sum = counts.coverage.sum();
    int definitions = 0;
    for (const auto& [id, numbered] : material.numbered) definitions += numbered.kind == BlockKind::definition ? 1 : 0;
    int planned = 0;
    for (const ChapterEntry& entry : material.book.chapters) planned += entry.written ? 0 : 1;

    std::string out = fmt::format("The stories tell {} of the {} lines of the engine that belong to written chapters. "
                                  "Each file is there whole, on [a page of its own](sources.html).\n\n"
                                  "| Chapter | Lines of its files | Told | Share | At least |\n"
                                  "|:--|--:|--:|--:|--:|\n",
                                  sum.told, sum.lines);
    for (const Share& share : counts.coverage.shares) {
        const ChapterEntry* entry = material.book.chapter(share.chapter);
        if (share.lines == 0 || entry == nullptr) continue;
        out += fmt::format("| [{}]({}.html) | {} | {} | {:.0f}\u00a0% | {:.0f}\u00a0% |\n", page_title(*entry), entry->page(),
                           share.lines, share.told, 100.0 * share.part(), 100.0 * entry->told);
    }
    const std::string later = planned == 0 ? "" : fmt::format(" {} chapters are planned and not written yet.", planned);
    return out + fmt::format("\n{} formulas are definitions. {} numbers of the text are given, not computed.{}\n",
                             definitions, counts.given, later);
}

} // namespace

void add_generated_pages(const Material& material, const Counts& counts, TextWriter& writer, Pages& pages)
{
    Fragments& fragments = pages.fragments;
    const std::string map = fragments.add_html(chapter_map(material.book));
    const std::string list = fragments.add_html(contents(material));

    const ChapterEntry* first = material.book.chapters.empty() ? nullptr : &material.book.chapters.front();
    const std::string start =
        first == nullptr || !first->written
            ? std::string()
            : fragments.add_html(fmt::format("<p class=\"start\"><a href=\"{}.html\">Start with chapter {}: {}</a></p>",
                                             first->page(), first->label(), escape_html(first->title)));
    const auto add = [&](std::string name, std::string title, std::string markdown) {
        Page page;
        page.name = std::move(name);
        page.title = std::move(title);
        page.markdown = std::move(markdown);
        page.sections = writer.take_sections();
        pages.list.push_back(std::move(page));
    };
    std::string front = material.book.is_playable ? fragments.add_html(front_figure()) + "\n\n" : "";
    front += fmt::format("{}\n\n{}\n\n{}\n\n", material.book.front, start, list);
    front += writer.heading(2, "What builds on what") +
             fmt::format("A chapter stands below all that it needs.\n\n{}\n\n", map);
    add("index", material.book.title, front);
    if (material.book.is_playable)
        add("playground", "Playground",
            fmt::format("Every scene of the course, and your own. A scene is a text: change it, and the page says what "
                        "is wrong with it, by line and column.\n\n{}\n",
                        fragments.add_html(playground_figure())));
    add("equations", "Equations and their receipts", fragments.add_html(equation_index(material, fragments)) + "\n");
    add("symbols", "Symbols", symbol_table(material, writer));
    std::vector<std::pair<int, std::string>> lines;
    for (const std::string& line : split_lines(tally_tables(tallies(material, counts.coverage))))
        lines.emplace_back(0, line);
    add("numbers", "The book in numbers", writer.inline_text(lines, "numbers"));
    add("told", "What is told, and what is not", told(material, counts));
}

} // namespace flying::weave
