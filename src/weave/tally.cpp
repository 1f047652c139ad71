#include "weave/tally.hpp"

#include <algorithm>
#include <cctype>
#include <regex>

#include <fmt/format.h>

#include "weave/claims.hpp"
#include "weave/inline.hpp"

namespace flying::weave {

namespace {

/// Words of running text: what stands between blanks and has a letter.
int word_count(const std::vector<std::pair<int, std::string>>& lines)
{
    int words = 0;
    for (const Piece& piece : pieces_of(lines)) {
        if (piece.kind != PieceKind::prose) continue;
        bool inside = false;
        for (const char c : piece.text) {
            const bool letter = std::isalpha(static_cast<unsigned char>(c)) != 0;
            const bool blank = std::isspace(static_cast<unsigned char>(c)) != 0;
            if (letter && !inside) ++words;
            inside = !blank && (inside || letter);
        }
    }
    return words;
}

/// The task or the hint names a source.
bool names_source(const ChapterText& text)
{
    static const std::regex k_source(R"((`|\{\{file:)(src/|chapters/[^`}]*\.[ch]pp))");
    return std::any_of(text.blocks.begin(), text.blocks.end(), [](const Block& block) {
        return std::any_of(block.lines.begin(), block.lines.end(),
                           [](const auto& line) { return std::regex_search(line.second, k_source); });
    });
}

void count_equation(const Block& block, const Ledger& ledger, Tally& tally)
{
    const ReceiptKind kind = receipt_kind(block).value_or(ReceiptKind::oracle);
    if (kind == ReceiptKind::measured) ++tally.measured;
    if (kind == ReceiptKind::same) ++tally.same;
    if (kind == ReceiptKind::measured || kind == ReceiptKind::same) return;
    ++tally.oracle;
    const auto receipt = ledger.equations.find(block.name);
    if (receipt == ledger.equations.end() || receipt->second.worst <= tally.worst) return;
    tally.worst = receipt->second.worst;
    tally.worst_name = block.name;
}

Tally tally_of(const Material& material, const Chapter& chapter)
{
    Tally tally;
    tally.chapter = &chapter;
    tally.exercises = exercise_count(chapter);
    for (const Block& block : chapter.text.blocks) {
        switch (block.kind) {
        case BlockKind::text:
            tally.words += word_count(block.lines);
            break;
        case BlockKind::listing:
            ++tally.listings;
            break;
        case BlockKind::figure:
            ++tally.figures;
            break;
        case BlockKind::live:
            ++tally.live;
            break;
        case BlockKind::equation:
            count_equation(block, material.ledger, tally);
            break;
        case BlockKind::derivation:
            ++tally.derivations;
            break;
        case BlockKind::definition:
            ++tally.definitions;
            break;
        default:
            break;
        }
    }
    return tally;
}

/// `2e-16` as a formula.
std::string rounded(double value)
{
    const std::string digits = fmt::format("{:.0e}", value);
    const std::size_t e = digits.find('e');
    return fmt::format("${} \\cdot 10^{{{}}}$", digits.substr(0, e), std::stoi(digits.substr(e + 1)));
}

/// Of one chapter; a sum has none, and neither has a chapter without files.
std::string told_percent(const Tally& tally)
{
    if (tally.chapter == nullptr || tally.chapter->entry.files.empty()) return "";
    return fmt::format("{:.0f}\u00a0%", 100.0 * tally.told);
}

std::string counts_row(const std::string& title, const Tally& t)
{
    return fmt::format("| {} | {} | {} | {} | {} | {} | {} | {} | {} | {} |\n", title, t.words, t.listings,
                       told_percent(t), t.figures, t.live, t.exercises.all, t.exercises.in_code, t.exercises.hard,
                       t.exercises.changes);
}

} // namespace

ExerciseCount exercise_count(const Chapter& chapter)
{
    ExerciseCount count;
    for (const Exercise& exercise : chapter.exercises) {
        const std::string& title = exercise.text.title;
        ++count.all;
        if (exercise.in_code) ++count.in_code;
        if (title.size() > 6 && title.compare(title.size() - 6, 6, "(hard)") == 0) ++count.hard;
        if (names_source(exercise.text) || (exercise.hint && names_source(*exercise.hint))) ++count.changes;
    }
    return count;
}

std::vector<Tally> tallies(const Material& material, const Coverage& coverage)
{
    std::vector<Tally> all;
    for (const Chapter& chapter : material.chapters) {
        Tally tally = tally_of(material, chapter);
        for (const Share& share : coverage.shares)
            if (share.chapter == chapter.entry.number) tally.told = share.part();
        all.push_back(tally);
    }
    return all;
}

Tally sum_of(const std::vector<Tally>& tallies)
{
    Tally sum;
    for (const Tally& each : tallies) {
        sum.words += each.words;
        sum.listings += each.listings;
        sum.figures += each.figures;
        sum.live += each.live;
        sum.oracle += each.oracle;
        sum.measured += each.measured;
        sum.same += each.same;
        sum.derivations += each.derivations;
        sum.definitions += each.definitions;
        sum.exercises.all += each.exercises.all;
        sum.exercises.in_code += each.exercises.in_code;
        sum.exercises.hard += each.exercises.hard;
        sum.exercises.changes += each.exercises.changes;
        if (each.worst <= sum.worst) continue;
        sum.worst = each.worst;
        sum.worst_name = each.worst_name;
    }
    return sum;
}

void check_exercises(const Material& material, Problems& problems)
{
    const ExerciseCount& least = material.book.least_exercises;
    for (const Chapter& chapter : material.chapters) {
        const ExerciseCount count = exercise_count(chapter);
        if (count.has(least)) continue;
        problems.add({chapter.text.path, 0},
                     fmt::format("{} exercises, {} in code, {} hard, {} that change a source", count.all, count.in_code,
                                 count.hard, count.changes),
                     fmt::format("{}, {}, {} and {} at least, as book.toml has it ([exercises])", least.all,
                                 least.in_code, least.hard, least.changes));
    }
}

std::string tally_tables(const std::vector<Tally>& tallies)
{
    Tally sum = sum_of(tallies);
    std::string counts =
        "| Chapter | Words | Listings | Told | Figures | Live | Exercises | in code | hard | change a source |\n"
        "|:--|--:|--:|--:|--:|--:|--:|--:|--:|--:|\n";
    std::string checks =
        "| Chapter | By an oracle | Measured | Same expression | Derivations | Definitions | Worst error | in |\n"
        "|:--|--:|--:|--:|--:|--:|--:|:--|\n";
    const auto row = [&](const std::string& title, const Tally& t) {
        const std::string worst = t.worst_name.empty() ? "0" : rounded(t.worst);
        const std::string where = t.worst_name.empty() ? "" : fmt::format("{{{{eq:{}}}}}", t.worst_name);
        checks += fmt::format("| {} | {} | {} | {} | {} | {} | {} | {} |\n", title, t.oracle, t.measured, t.same,
                              t.derivations, t.definitions, worst, where);
    };
    for (const Tally& tally : tallies) {
        const ChapterEntry& entry = tally.chapter->entry;
        const std::string title = fmt::format("{{{{ch:{}|{}}}}}", entry.name.substr(3), page_title(entry));
        counts += counts_row(title, tally);
        row(title, tally);
    }
    counts += counts_row("All", sum);
    row("All", sum);
    return fmt::format(
        "What each chapter has. *Told* is the share of the lines of its files that its story lists; a chapter "
        "without files of the engine has none. Words are those of the text, without formulas, code and "
        "exercises.\n\n{}\n\nHow its equations are checked. The worst error is the largest, as a share, that a "
        "test found between the engine and an independent oracle; exact equations have none. The derivations in the "
        "answers are not counted here; *Equations and receipts* counts them too.\n\n{}\n",
        counts, checks);
}

std::string tally_lines(const std::vector<Tally>& tallies)
{
    std::string out;
    for (const Tally& t : tallies)
        out +=
            fmt::format("{}: {} words, {} listings, {:.1f} % told, {} figures, {} live; equations {} by an oracle, {} "
                        "measured, {} same; {} exercises, {} in code, {} hard\n",
                        t.chapter->entry.called(), t.words, t.listings, 100.0 * t.told, t.figures, t.live, t.oracle,
                        t.measured, t.same, t.exercises.all, t.exercises.in_code, t.exercises.hard);
    return out;
}

} // namespace flying::weave
