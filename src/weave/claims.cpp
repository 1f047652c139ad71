#include "weave/claims.hpp"

#include <algorithm>
#include <regex>
#include <set>

#include <fmt/format.h>

#include "weave/inline.hpp"
#include "weave/text.hpp"

namespace flying::weave {

namespace {

/// Relative error above which a bound is no matter of rounding, or of a root found to many digits.
constexpr double k_coarse = 1e-6;

/// Numbers of the chapters that the section "What you need" links to.
std::set<int> named_needs(const Material& material, const Chapter& chapter)
{
    std::set<int> named;
    std::string section;
    for (const Block& block : chapter.text.blocks) {
        if (block.kind != BlockKind::text) continue;
        for (const auto& numbered : block.lines) {
            if (numbered.second.rfind("## ", 0) == 0) section = std::string(trim(numbered.second.substr(3)));
            if (section != "What you need") continue;
            for (const Piece& piece : pieces_of({numbered})) {
                const Insert insert = parse_insert(piece.text);
                if (piece.kind != PieceKind::insert || insert.kind != "ch") continue;
                for (const ChapterEntry& entry : material.book.chapters)
                    if (entry.name.size() > 3 && entry.name.substr(3) == insert.name) named.insert(entry.number);
            }
        }
    }
    return named;
}

std::string spelled(const std::set<int>& numbers)
{
    std::string words;
    for (const int number : numbers) words += (words.empty() ? "" : ", ") + std::to_string(number);
    return words.empty() ? "none" : words;
}

} // namespace

std::optional<ReceiptKind> receipt_kind(const Block& equation)
{
    if (equation.options.empty()) return ReceiptKind::oracle;
    if (equation.options == "exact") return ReceiptKind::exact;
    if (equation.options == "measured") return ReceiptKind::measured;
    if (equation.options == "same") return ReceiptKind::same;
    return std::nullopt;
}

void check_receipt_kind(const Block& equation, const EquationReceipt& receipt, Problems& problems)
{
    const std::optional<ReceiptKind> kind = receipt_kind(equation);
    if (!kind) {
        problems.add(equation.place, fmt::format("equation {} of the kind `{}`", equation.name, equation.options),
                     "`exact`, `measured`, `same`, or no word for an independent oracle");
    } else if (receipt.worst == 0.0 && *kind == ReceiptKind::oracle) {
        problems.add(equation.place,
                     fmt::format("equation {}: no error at all in {} cases", equation.name, receipt.cases),
                     "`same` after its name if the test repeats the code's own expression, `exact` if its oracle is "
                     "another way to the same number");
    } else if (receipt.bound > k_coarse && (*kind == ReceiptKind::oracle || *kind == ReceiptKind::exact)) {
        problems.add(equation.place, fmt::format("equation {}: its test allows {:.1e}", equation.name, receipt.bound),
                     "`measured` after its name, and the reason for the size of the error in the text");
    }
}

namespace {

/// Numbers from thirteen on, as words; and halves of things that clocks and rulers measure.
constexpr const char* k_number_word =
    R"((((thir|four|fif|six|seven|eigh|nine)teen|(twen|thir|for|fif|six|seven|eigh|nine)ty|hundred|thousand|million|billion|dozen)s?\b|half an? (second|minute|hour|metre)\b))";

std::optional<std::string> found_by(const std::regex& pattern, const std::string& text)
{
    std::smatch found;
    if (!std::regex_search(text, found, pattern)) return std::nullopt;
    return found.str();
}

} // namespace

std::optional<std::string> number_word(const std::string& text)
{
    static const std::regex k_word(std::string("\\b") + k_number_word, std::regex::icase);
    return found_by(k_word, text);
}

std::optional<std::string> rough_number_word(const std::string& text)
{
    static const std::regex k_rough(
        std::string(R"(\b(about|some|around|roughly|nearly|almost|more than|less than|fewer than) (an? )?([a-z]+ )?)") +
            k_number_word,
        std::regex::icase);
    return found_by(k_rough, text);
}

void check_needs(const Material& material, Problems& problems)
{
    for (const Chapter& chapter : material.chapters) {
        const std::vector<std::string>& sections = chapter.text.sections;
        if (std::find(sections.begin(), sections.end(), "What you need") == sections.end()) continue;
        const std::set<int> needs(chapter.entry.needs.begin(), chapter.entry.needs.end());
        const std::set<int> named = named_needs(material, chapter);
        if (named != needs)
            problems.add(
                {chapter.text.path, 0}, fmt::format("\"What you need\" links to the chapters {}", spelled(named)),
                fmt::format("{}, as `needs` of chapter {} in book.toml says", spelled(needs), chapter.entry.number));
    }
}

} // namespace flying::weave
