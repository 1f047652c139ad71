#include "weave/chapter.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <regex>
#include <set>

#include <fmt/format.h>

#include "weave/text.hpp"

namespace flying::weave {

namespace {

constexpr std::array k_directives = {
    std::pair{BlockKind::listing, "listing"},
    std::pair{BlockKind::equation, "equation"},
    std::pair{BlockKind::definition, "definition"},
    std::pair{BlockKind::derivation, "derivation"},
    std::pair{BlockKind::figure, "figure"},
    std::pair{BlockKind::output, "output"},
    std::pair{BlockKind::live, "live"},
    std::pair{BlockKind::exercise, "exercise"},
};

std::optional<BlockKind> directive_kind(std::string_view word)
{
    for (const auto& [kind, name] : k_directives)
        if (word == name) return kind;
    return std::nullopt;
}

bool has_formula(BlockKind kind)
{
    return kind == BlockKind::equation || kind == BlockKind::definition || kind == BlockKind::derivation;
}

bool is_fence(std::string_view line)
{
    return trim(line).substr(0, 3) == "```";
}

/// A directive's line: `::word name options "caption"`.
std::optional<Block> parse_directive(const std::string& line, Place place, Problems& problems)
{
    const std::size_t end = line.find_first_of(" \t");
    const std::string word = line.substr(2, end == std::string::npos ? end : end - 2);
    const std::optional<BlockKind> kind = directive_kind(word);
    if (!kind) {
        std::vector<std::string> known;
        for (const auto& directive : k_directives) known.push_back(fmt::format("::{}", directive.second));
        problems.add(place, fmt::format("unknown directive ::{}", word), "one of " + join(known, ", "));
        return std::nullopt;
    }
    Block block;
    block.kind = *kind;
    block.place = std::move(place);
    std::string rest(end == std::string::npos ? std::string_view() : trim(std::string_view(line).substr(end)));
    for (std::string* words : {&block.caption, &block.alt}) {
        const std::size_t open = rest.find('"');
        if (open == std::string::npos) break;
        const std::size_t close = rest.find('"', open + 1);
        if (close == std::string::npos) {
            problems.add(block.place, "a caption with one quotation mark", "a pair of them, on this line");
            return std::nullopt;
        }
        *words = std::string(trim(std::string_view(rest).substr(open + 1, close - open - 1)));
        rest = std::string(trim(rest.substr(0, open) + rest.substr(close + 1)));
    }
    const std::size_t space = rest.find_first_of(" \t");
    block.name = rest.substr(0, space);
    if (space != std::string::npos) block.options = std::string(trim(std::string_view(rest).substr(space)));
    if (block.name.empty()) {
        problems.add(block.place, fmt::format("::{} without a name", word), fmt::format("::{} NAME", word));
        return std::nullopt;
    }
    return block;
}

/// The cells of a table's line `| a | b |`; a bar inside dollars or backquotes is no border.
std::vector<std::string> table_cells(std::string_view line)
{
    std::vector<std::string> cells;
    std::string cell;
    char quote = 0;
    line = trim(line);
    for (const char c : line.substr(1)) {
        if (quote != 0) {
            if (c == quote) quote = 0;
        } else if (c == '$' || c == '`') {
            quote = c;
        } else if (c == '|') {
            cells.emplace_back(trim(cell));
            cell.clear();
            continue;
        }
        cell += c;
    }
    if (!trim(cell).empty()) cells.emplace_back(trim(cell));
    return cells;
}

std::string without(std::string_view text, char quote)
{
    text = trim(text);
    if (text.size() >= 2 && text.front() == quote && text.back() == quote) text = text.substr(1, text.size() - 2);
    return std::string(text);
}

/// Reads the table under `## Symbols`: symbol, meaning, unit, name in C++.
void read_symbols(ChapterText& chapter, Problems& problems)
{
    std::string section;
    int row = 0;
    for (const Block& block : chapter.blocks) {
        if (block.kind != BlockKind::text) continue;
        for (const auto& [number, line] : block.lines) {
            if (line.rfind("## ", 0) == 0) {
                section = std::string(trim(line.substr(3)));
                row = 0;
                continue;
            }
            if (section != "Symbols" || trim(line).substr(0, 1) != "|") continue;
            if (++row <= 2) continue;
            const std::vector<std::string> cells = table_cells(line);
            if (cells.size() != 4 || without(cells[0], '$') == cells[0]) {
                problems.add({chapter.path, number}, fmt::format("a line of {} cells under Symbols", cells.size()),
                             "| $symbol$ | meaning | unit | `name` |");
                continue;
            }
            chapter.symbols.push_back(
                {{chapter.path, number}, without(cells[0], '$'), cells[1], cells[2], without(cells[3], '`')});
        }
    }
}

} // namespace

Listing listing_of(const Block& block)
{
    Listing listing;
    listing.names.push_back(block.name);
    for (const std::string& word : split(block.options, ' ')) {
        if (word == "again") listing.is_again = true;
        else if (!trim(word).empty()) listing.names.push_back(word);
    }
    return listing;
}

std::optional<OutputPart> output_part(const std::string& options)
{
    static const std::regex k_part(R"(([1-9][0-9]?)(?:-([1-9][0-9]?))?)");
    if (options.empty()) return OutputPart{};
    std::smatch found;
    if (!std::regex_match(options, found, k_part)) return std::nullopt;
    const int first = std::stoi(found[1].str());
    return OutputPart{first, found[2].matched ? std::stoi(found[2].str()) : first};
}

std::vector<std::string> output_tables(const std::string& printed)
{
    std::vector<std::string> tables;
    bool is_open = false;
    for (const std::string& line : split_lines(printed)) {
        if (trim(line).empty()) {
            is_open = false;
            continue;
        }
        if (!is_open) tables.emplace_back();
        is_open = true;
        tables.back() += line + "\n";
    }
    return tables;
}

std::string part_of(const std::string& printed, const OutputPart& part)
{
    if (part.last == 0) return printed;
    const std::vector<std::string> tables = output_tables(printed);
    std::string shown;
    for (int k = part.first; k <= std::min(part.last, static_cast<int>(tables.size())); ++k)
        shown += (shown.empty() ? "" : "\n") + tables[k - 1];
    return shown;
}

std::string figure_key(const Block& block)
{
    return (block.kind == BlockKind::live ? "live-" : "") + block.name;
}

std::string directive_word(BlockKind kind)
{
    for (const auto& [known, name] : k_directives)
        if (known == kind) return name;
    return "";
}

ChapterText parse_chapter(const std::string& path, const std::string& text, Problems& problems)
{
    ChapterText chapter;
    chapter.path = path;
    const std::vector<std::string> lines = split_lines(text);
    const int count = static_cast<int>(lines.size());

    // Collect a fence that opens at line k (counted from 0); returns the line after it
    const auto read_fence = [&](int k, Block& block) {
        block.language = std::string(trim(trim(lines[k]).substr(3)));
        int at = k + 1;
        for (; at < count && !is_fence(lines[at]); ++at) block.lines.emplace_back(at + 1, lines[at]);
        if (at == count) problems.add({path, k + 1}, "a fence ``` that never closes", "``` after its last line");
        return at + 1;
    };

    Block* open = nullptr; // the text that the next line goes on with
    int k = 0;
    if (count > 0 && lines[0].rfind("# ", 0) == 0) {
        chapter.title = std::string(trim(lines[0].substr(2)));
        k = 1;
    } else {
        problems.add({path, 1}, "a first line that is no title", "`# Title`");
    }
    while (k < count) {
        const std::string& line = lines[k];
        if (is_fence(line)) {
            Block fence;
            fence.kind = BlockKind::fence;
            fence.place = {path, k + 1};
            k = read_fence(k, fence);
            chapter.blocks.push_back(std::move(fence));
            open = nullptr;
        } else if (line.rfind("::", 0) == 0) {
            std::optional<Block> block = parse_directive(line, {path, k + 1}, problems);
            ++k;
            open = nullptr;
            if (!block) continue;
            if (has_formula(block->kind)) {
                int at = k;
                while (at < count && trim(lines[at]).empty()) ++at;
                if (at < count && trim(lines[at]) == "```tex") {
                    k = read_fence(at, *block);
                } else {
                    problems.add(block->place,
                                 fmt::format("::{} {} without its formula", directive_word(block->kind), block->name),
                                 "a ```tex block on the next line");
                }
            }
            chapter.blocks.push_back(std::move(*block));
        } else {
            if (open == nullptr) {
                Block block;
                block.place = {path, k + 1};
                chapter.blocks.push_back(std::move(block));
                open = &chapter.blocks.back();
            }
            if (line.rfind("## ", 0) == 0) chapter.sections.emplace_back(trim(line.substr(3)));
            open->lines.emplace_back(k + 1, line);
            ++k;
        }
    }
    read_symbols(chapter, problems);
    return chapter;
}

} // namespace flying::weave
