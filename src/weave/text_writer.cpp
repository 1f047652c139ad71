#include <algorithm>
#include <cctype>
#include <optional>
#include <regex>
#include <utility>

#include <fmt/format.h>

#include "weave/inline.hpp"
#include "weave/pages.hpp"
#include "weave/receipts.hpp"
#include "weave/study.hpp"
#include "weave/text.hpp"

namespace flying::weave {

namespace {

/// Prose for Markdown: quotation marks and apostrophes are set properly, HTML stays text.
std::string escape_prose(const std::string& prose)
{
    std::string out;
    for (std::size_t k = 0; k < prose.size(); ++k) {
        const char c = prose[k];
        const char before = k > 0 ? prose[k - 1] : ' ';
        if (c == '\\' && k + 1 < prose.size()) {
            const char next = prose[++k];
            out += next == '$' || next == '"' ? std::string(1, next) : std::string("\\") + next;
        } else if (c == '<') {
            out += "&lt;";
        } else if (c == '&') {
            out += "&amp;";
        } else if (c == '\'') {
            out += "\u2019";
        } else if (c == '"') {
            const bool opens = std::isspace(static_cast<unsigned char>(before)) || before == '(';
            out += opens ? "\u201c" : "\u201d";
        } else {
            out += c;
        }
    }
    // A number stays with its unit, which may follow a formula or a value, too
    static const std::regex k_unit(R"((^|[0-9]) ((?:%|m/s²|m/s|m²|kg m²|kg|N s|mm|cm|km|rad|[mNJs])(?![A-Za-z])))");
    return std::regex_replace(out, k_unit, "$1\u00a0$2");
}

/// Characters of code that the column of the text holds in one line.
constexpr std::size_t k_line_width = 75;

/// Characters of a program's output that it holds.
constexpr std::size_t k_output_column = 72;

std::size_t longest_line(std::string_view text)
{
    std::size_t longest = 0;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = std::min(text.find('\n', at), text.size());
        longest = std::max(longest, end - at);
        at = end + 1;
    }
    return longest;
}

/// The equation says no more than the derivation's last line does: the same left side, the same end.
bool is_last_line(const Block& derivation, const Block& equation)
{
    if (derivation.kind != BlockKind::derivation || equation.kind != BlockKind::equation) return false;
    const std::vector<Step> steps = steps_of(derivation);
    if (steps.size() < 2) return false;
    const auto bare = [](std::string tex) {
        for (const char* sign : {"\\left", "\\right", "\\,", " "}) tex = replace_all(std::move(tex), sign, "");
        return tex;
    };
    const std::string first = bare(steps.front().tex);
    const std::string last = bare(steps.back().tex);
    return last.rfind('=', 0) == 0 && bare(formula_of(equation)) == first.substr(0, first.find('=')) + last;
}

} // namespace

std::string TextWriter::blocks(const Chapter& chapter, const ChapterText& text)
{
    const auto is_blank = [](const Block& block) {
        return block.kind == BlockKind::text && std::all_of(block.lines.begin(), block.lines.end(),
                                                            [](const auto& line) { return trim(line.second).empty(); });
    };
    std::string out;
    for (auto b = text.blocks.begin(); b != text.blocks.end(); ++b) {
        const auto next = std::find_if_not(b + 1, text.blocks.end(), is_blank);
        if (next != text.blocks.end() && is_last_line(*b, *next)) {
            out += derivation(*b, &*next);
            b = next;
        } else {
            out += block(chapter, *b);
        }
    }
    return out;
}

std::string TextWriter::heading(int level, const std::string& title)
{
    const std::string words = slug(title);
    std::string anchor = words;
    for (int k = 2; !anchors_.insert(anchor).second; ++k) anchor = fmt::format("{}-{}", words, k);
    sections_.push_back({level, title, anchor});
    return block_token(fragments_.add_html(
        fmt::format("<h{0} id=\"{1}\"><a href=\"#{1}\">{2}</a></h{0}>", level, anchor, escape_prose(title))));
}

std::vector<Section> TextWriter::take_sections()
{
    anchors_.clear();
    return std::exchange(sections_, {});
}

std::string TextWriter::block(const Chapter& chapter, const Block& b)
{
    switch (b.kind) {
    case BlockKind::text:
        return text(chapter, b);
    case BlockKind::fence: {
        std::string quoted;
        for (const auto& line : b.lines) quoted += "<span class=\"typed\">" + escape_html(line.second) + "</span>";
        return block_token(fragments_.add_html("<pre class=\"quoted\">" + quoted + "</pre>"));
    }
    case BlockKind::listing:
        return listing(b);
    case BlockKind::equation:
    case BlockKind::definition:
        return formula(b);
    case BlockKind::derivation:
        return derivation(b, nullptr);
    case BlockKind::figure:
        return figure(chapter, b);
    case BlockKind::output:
        return output(chapter, b);
    case BlockKind::live:
        return live(chapter, b);
    case BlockKind::exercise:
        return exercise(chapter, b);
    }
    return "";
}

std::string TextWriter::text(const Chapter& chapter, const Block& block)
{
    std::string out;
    std::vector<std::pair<int, std::string>> paragraph;
    const auto close = [&] {
        out += inline_text(paragraph, block.place.file);
        paragraph.clear();
    };
    for (const auto& [number, line] : block.lines) {
        const std::size_t level = line.find_first_not_of('#');
        if (level == 0 || level == std::string::npos || line[level] != ' ') {
            paragraph.emplace_back(number, line);
            continue;
        }
        close();
        const std::string title(trim(std::string_view(line).substr(level)));
        if (level == 1 || level > 3 || title.find_first_of("$`{") != std::string::npos)
            problems_.add({block.place.file, number}, fmt::format("heading `{}`", title),
                          "plain words after ## or ###, without formulas and code");
        out += heading(static_cast<int>(level), title);
        if (title == "What you need") out += block_token(fragments_.add_html(goals_box(chapter.entry)));
    }
    close();
    return out;
}

namespace {

/// Whether the next word after these begins a sentence.
bool begins_sentence(const std::string& words)
{
    const std::size_t last = words.find_last_not_of(" \n");
    return last == std::string::npos || words[last] == '.' || words[last] == '!' || words[last] == '?';
}

} // namespace

std::string TextWriter::inline_text(const std::vector<std::pair<int, std::string>>& lines, const std::string& file)
{
    std::string out;
    for (const Piece& piece : pieces_of(lines)) {
        const Place place{file, piece.line};
        switch (piece.kind) {
        case PieceKind::prose:
            out += escape_prose(piece.text);
            break;
        case PieceKind::math:
            out += math(piece.text, place);
            break;
        case PieceKind::insert:
            out += insert(piece.text, begins_sentence(out) ? Site::sentence_start : Site::prose, place);
            break;
        case PieceKind::code: {
            Fragment fragment;
            fragment.kind = FragmentKind::code;
            fragment.text = piece.text;
            fragment.place = place;
            out += fragments_.add(std::move(fragment));
            break;
        }
        case PieceKind::target:
            if (piece.text.rfind("https://", 0) != 0 && piece.text.rfind("http://", 0) != 0)
                problems_.add(place, fmt::format("link to `{}`", piece.text),
                              "an address of the web, or {{ch:name}}, {{eq:id}}, {{file:path}}");
            out += "(" + piece.text + ")";
            break;
        }
    }
    return out;
}

std::string TextWriter::math(const std::string& tex, const Place& place)
{
    static const std::regex k_insert(R"(\{\{([^}]*)\}\})");
    std::string filled;
    auto from = tex.cbegin();
    for (std::sregex_iterator at(tex.begin(), tex.end(), k_insert), end; at != end; ++at) {
        filled.append(from, (*at)[0].first);
        filled += insert((*at)[1].str(), Site::formula, place);
        from = (*at)[0].second;
    }
    filled.append(from, tex.cend());
    return fragments_.add_formula(filled, false, place);
}

std::string TextWriter::insert(const std::string& text, Site site, const Place& place)
{
    const Insert insert = parse_insert(text);
    if (insert.kind == "given") return insert.name;
    if (insert.kind == "value") {
        const auto found = material_.ledger.values.find(insert.name);
        if (found == material_.ledger.values.end()) {
            problems_.add(
                place, fmt::format("value `{}`, which nothing computes", insert.name),
                "RECORD_VALUE in a test, or `name = number` in a demo's output ({{value:chapter.demo.name}})");
            return "?";
        }
        const std::optional<std::string> shown =
            format_value(found->second, insert.format.empty() ? "%.3g" : insert.format);
        if (!shown) {
            problems_.add(place, fmt::format("format `{}` of a value", insert.format), "one like %.3g, %.1e, %.2f");
            return "?";
        }
        if (site != Site::formula) return fragments_.add_html("<span class=\"value\">" + *shown + "</span>");
        std::string tex = replace_all(*shown, "\u2009\u00b7\u2009", "\\cdot ");
        tex = replace_all(replace_all(tex, "\u2212", "-"), ",", "{,}");
        return replace_all(replace_all(tex, "<sup>", "^{"), "</sup>", "}");
    }
    if (insert.kind == "eq") {
        const auto found = material_.numbered.find(insert.name);
        if (found == material_.numbered.end()) {
            problems_.add(place, fmt::format("reference to formula `{}`", insert.name),
                          "the id of a formula of the book");
            return "?";
        }
        const Numbered& at = found->second;
        return fragments_.add_html(
            fmt::format("<a class=\"reference\" href=\"{}.html#{}\">({})</a>", at.page, at.anchor, at.number));
    }
    if (insert.kind == "fig") {
        for (const auto& [id, number] : material_.figures) {
            if (id.substr(id.find('/') + 1) != insert.name) continue;
            const std::string page = fmt::format("chapter_{}", id.substr(0, 2));
            const char* const word = site == Site::sentence_start ? "Figure" : "figure";
            return fragments_.add_html(fmt::format("<a class=\"reference\" href=\"{}.html#figure-{}\">{} {}</a>", page,
                                                   insert.name, word, number));
        }
        problems_.add(place, fmt::format("reference to figure `{}`", insert.name), "the name of a figure of the book");
        return "?";
    }
    if (insert.kind == "ch") {
        for (const ChapterEntry& entry : material_.book.chapters) {
            if (entry.name.substr(std::min<std::size_t>(3, entry.name.size())) != insert.name) continue;
            const std::string called = site == Site::sentence_start ? entry.called_first() : entry.called();
            const std::string words = insert.format.empty() ? called : insert.format;
            if (!entry.written) return words;
            return fragments_.add_html(fmt::format("<a class=\"reference\" title=\"{}\" href=\"{}.html\">{}</a>",
                                                   escape_html(entry.title), entry.page(), escape_html(words)));
        }
        problems_.add(place, fmt::format("reference to chapter `{}`", insert.name),
                      "the name of a chapter's folder without its number");
        return "?";
    }
    if (insert.kind == "file") {
        if (material_.sources.files.count(insert.name) == 0) {
            problems_.add(place, fmt::format("reference to file `{}`", insert.name), "a source of this project");
            return "?";
        }
        Fragment link;
        link.kind = FragmentKind::source;
        link.text = insert.name;
        link.place = place;
        const std::string target = fragments_.add(std::move(link));
        return fragments_.add_html(
            fmt::format("<a class=\"reference\" href=\"{}\"><code>{}</code></a>", target,
                        replace_all(replace_all(escape_html(insert.name), "/", "/<wbr>"), "_", "_<wbr>")));
    }
    problems_.add(place, fmt::format("insert `{{{{{}}}}}`", text),
                  "{{value:..}}, {{given:..}}, {{eq:..}}, {{fig:..}}, {{ch:..}} or {{file:..}}");
    return "?";
}

std::string TextWriter::listing(const Block& block)
{
    const Listing listing = listing_of(block);
    std::string body;
    std::string captions;
    std::size_t longest = 0;
    for (const std::string& name : listing.names) {
        const int index = material_.sources.find(name);
        if (index < 0) return "";
        const Region& region = material_.sources.regions[index];
        body += (body.empty() ? "" : "<div class=\"line\"></div>") + region_lines(region, block.place, longest);
        Fragment link;
        link.kind = FragmentKind::source;
        link.text = region.file;
        link.place = block.place;
        // From its first line on that is no marker: markers have no place on the page of the source
        const SourceFile& file = material_.sources.files.at(region.file);
        int first = region.first;
        while (first < region.last && file.kinds[first - 1] == LineKind::marker) ++first;
        captions += fmt::format("<a href=\"{}#l{:05}\">{}, {} {}{}</a> ", fragments_.add(std::move(link)), first,
                                escape_html(region.file), first == region.last ? "line" : "lines", first,
                                first == region.last ? "" : fmt::format("\u2060\u2013\u2060{}", region.last));
    }
    return block_token(fragments_.add_html(fmt::format(
        "<figure class=\"listing{}{}\"{}><figcaption>{}{}</figcaption><div class=\"fragment\">{}</div></figure>",
        listing.is_again ? " again" : "", longest > k_line_width ? " wide" : "",
        listing.is_again ? "" : fmt::format(" id=\"listing-{}\"", slug(block.name)), captions,
        listing.is_again ? "<span>once more</span>" : "", body)));
}

std::string TextWriter::region_lines(const Region& region, const Place& place, std::size_t& longest)
{
    const Sources& sources = material_.sources;
    const SourceFile& file = sources.files.at(region.file);
    Fragment lines;
    lines.kind = FragmentKind::lines;
    lines.text = region.file;
    lines.place = place;
    const auto is_folded = [&](int line) {
        return std::any_of(region.inner.begin(), region.inner.end(), [&](int inner) {
            return sources.regions[inner].first <= line && line <= sources.regions[inner].last;
        });
    };
    for (int line = region.first; line <= region.last; ++line)
        if (file.kinds[line - 1] != LineKind::marker && !is_folded(line)) lines.lines.push_back(line);
    while (!lines.lines.empty() && trim(file.lines[lines.lines.front() - 1]).empty())
        lines.lines.erase(lines.lines.begin());
    while (!lines.lines.empty() && trim(file.lines[lines.lines.back() - 1]).empty()) lines.lines.pop_back();
    std::size_t most = 0;
    std::size_t indent = k_line_width;
    for (const int line : lines.lines) {
        const std::string& words = file.lines[line - 1];
        if (trim(words).empty()) continue;
        most = std::max(most, words.size());
        indent = std::min(indent, words.find_first_not_of(' '));
    }
    longest = std::max(longest, most - std::min(indent, most));
    for (const int inner : region.inner) {
        // Folded: what another listing shows opens in place
        const Region& part = sources.regions[inner];
        Fragment folded;
        folded.kind = FragmentKind::lines;
        folded.text = region.file;
        folded.place = place;
        for (int line = part.first; line <= part.last; ++line)
            if (file.kinds[line - 1] != LineKind::marker) folded.lines.push_back(line);
        lines.instead[part.last + 2] = fmt::format(
            "<details class=\"inner\"><summary>lines {} to {}</summary><div class=\"lines\">{}</div></details>",
            part.first, part.last, fragments_.add(std::move(folded)));
    }
    return fragments_.add(std::move(lines));
}

std::string TextWriter::formula(const Block& block)
{
    const auto found = material_.numbered.find(block.name);
    if (found == material_.numbered.end()) return ""; // of an exercise that is never posed, which is a problem already
    const Numbered& numbered = found->second;
    const std::string tex = fragments_.add_formula(formula_of(block), true, block.place);
    return block_token(fragments_.add_html(fmt::format(
        "<div class=\"formula {0}\" id=\"{1}\"><div class=\"sheet\">{2}</div><a class=\"number\" "
        "href=\"#{1}\">({3})</a>"
        "{4}</div>",
        directive_word(block.kind), numbered.anchor, tex, numbered.number, receipt_note(material_, numbered))));
}

std::string TextWriter::derivation(const Block& block, const Block* result)
{
    const auto found = material_.numbered.find(block.name);
    if (found == material_.numbered.end()) return ""; // of an exercise that is never posed, which is a problem already
    const Numbered& numbered = found->second;
    const auto last = result == nullptr ? material_.numbered.end() : material_.numbered.find(result->name);
    const bool has_result = last != material_.numbered.end();
    const auto number_of = [](const Numbered& n, const char* attribute) {
        return fmt::format("<a class=\"number\"{1} href=\"#{0}\">({2})</a>", n.anchor,
                           attribute == nullptr ? "" : fmt::format(" {}=\"{}\"", attribute, n.anchor), n.number);
    };
    std::string rows;
    const std::vector<Step> steps = steps_of(block);
    for (const Step& step : steps) {
        // With a result, the chain's number stands at its first line and the result's at its last
        std::string number;
        std::string receipt;
        if (has_result && &step == &steps.front()) {
            number = number_of(numbered, nullptr);
            receipt = receipt_note(material_, numbered);
        } else if (has_result && &step == &steps.back()) {
            number = number_of(last->second, "id");
            receipt = receipt_note(material_, last->second);
        }
        // Set the left side, then the rest from its first sign of equality on
        const Place place{block.place.file, step.line};
        std::size_t sign = std::string::npos;
        int depth = 0;
        for (std::size_t k = 0; k < step.tex.size() && sign == std::string::npos; ++k) {
            if (step.tex[k] == '{') ++depth;
            if (step.tex[k] == '}') --depth;
            const bool relation = step.tex[k] == '=' || step.tex.compare(k, 7, "\\approx") == 0;
            if (relation && depth == 0) sign = k;
        }
        const std::string left(trim(step.tex.substr(0, sign == std::string::npos ? 0 : sign)));
        const std::string right = sign == std::string::npos ? step.tex : "{}" + step.tex.substr(sign);
        rows +=
            fmt::format("<div class=\"left\">{}</div><div class=\"right{}\">{}{}</div><div class=\"reason\">{}{}</div>",
                        left.empty() ? "" : fragments_.add_formula(left, true, place),
                        number.empty() ? "" : " numbered", fragments_.add_formula(right, true, place), number,
                        step.reason.empty() ? "" : inline_text({{step.line, step.reason}}, block.place.file), receipt);
    }
    const std::string foot = has_result ? "" : number_of(numbered, nullptr) + receipt_note(material_, numbered);
    return block_token(fragments_.add_html(
        fmt::format("<div class=\"formula derivation{}\" id=\"{}\"><div class=\"sheet steps\">{}</div>{}</div>",
                    has_result ? " joined" : "", numbered.anchor, rows, foot)));
}

std::string TextWriter::caption(const Chapter& chapter, const Block& block)
{
    const auto found = material_.figures.find(chapter.entry.name + "/" + figure_key(block));
    const std::string number = found == material_.figures.end() ? "?" : found->second;
    return fmt::format("<b>Figure {}.</b> ", number) +
           inline_text({{block.place.line, block.caption}}, block.place.file);
}

std::string TextWriter::plain_caption(const Block& block)
{
    std::string words;
    for (const Piece& piece : pieces_of({{block.place.line, block.alt.empty() ? block.caption : block.alt}})) {
        const Insert insert = parse_insert(piece.text);
        const auto value = material_.ledger.values.find(insert.name);
        if (piece.kind != PieceKind::insert) words += piece.text;
        else if (insert.kind == "value" && value != material_.ledger.values.end())
            words += replace_all(format_value(value->second, insert.format).value_or(""), "<sup>", "^");
        else words += insert.name;
    }
    return escape_html(trim(replace_all(words, "</sup>", "")));
}

std::string TextWriter::figure(const Chapter& chapter, const Block& block)
{
    return block_token(fragments_.add_html(
        fmt::format("<figure class=\"picture\" id=\"figure-{0}\"><img src=\"figures/{1}/{0}.svg\" "
                    "alt=\"{2}\"><figcaption>{3}</figcaption></figure>",
                    block.name, chapter.entry.name, plain_caption(block), caption(chapter, block))));
}

std::string TextWriter::live(const Chapter& chapter, const Block& block)
{
    const std::string id = chapter.entry.name + "/" + block.name;
    return block_token(fragments_.add_html(fmt::format("<figure class=\"live\" id=\"figure-{3}\" data-trace=\"{0}\">"
                                                       "<canvas role=\"img\" "
                                                       "aria-label=\"{1}\"></canvas><figcaption>{2}</figcaption>"
                                                       "<noscript>This picture moves only where scripts "
                                                       "run.</noscript></figure>",
                                                       escape_html(id), plain_caption(block), caption(chapter, block),
                                                       figure_key(block))));
}

std::string TextWriter::output(const Chapter& chapter, const Block& block)
{
    const auto found = material_.outputs.find(chapter.entry.name + "/" + block.name);
    if (found == material_.outputs.end()) return "";
    const OutputPart part = output_part(block.options).value_or(OutputPart{});
    const std::string shown = part_of(found->second, part);
    const char* const wide = longest_line(shown) > k_output_column ? " wide" : "";
    return block_token(fragments_.add_html(
        fmt::format("<figure class=\"output{}\"><figcaption>What <code>{}.cpp</code> "
                    "printed in this build{}</figcaption><pre>{}</pre>{}"
                    "</figure>",
                    wide, escape_html(block.name), part.first == 1 ? "" : ", further down", escape_html(shown),
                    part.first == 1 ? run_box(chapter.entry, block.name) : "")));
}

} // namespace flying::weave
