#include "weave/receipts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <random>

#include <fmt/format.h>

#include "weave/claims.hpp"
#include "weave/formula.hpp"
#include "weave/text.hpp"

namespace flying::weave {

namespace {

/// Share of their size by which two ways to evaluate a formula may differ: far above rounding, also where terms cancel,
/// and far below any slip.
constexpr double k_agreement = 1e-9;

/// Points at which the lines of a derivation are compared, drawn with this seed.
constexpr int k_points = 100;
constexpr std::uint64_t k_seed = 20240501;

bool agree(double a, double b)
{
    return std::abs(a - b) <= k_agreement * std::max(std::abs(a), std::abs(b));
}

/// A formula may end a sentence.
std::string without_stop(std::string_view tex)
{
    tex = trim(tex);
    while (!tex.empty() && (tex.back() == '.' || tex.back() == ',' || tex.back() == ';'))
        tex = trim(tex.substr(0, tex.size() - 1));
    if (tex.size() >= 2 && tex.substr(tex.size() - 1) == "\\") tex = trim(tex.substr(0, tex.size() - 1));
    return std::string(tex);
}

std::string spelled(const Expression::Values& values)
{
    std::vector<std::string> parts;
    for (const auto& [name, value] : values) parts.push_back(fmt::format("{} = {:.6g}", name, value));
    return join(parts, ", ");
}

bool knows(const Expression::Values& values, const Expression& expression)
{
    const std::set<std::string> symbols = expression.symbols();
    return std::all_of(symbols.begin(), symbols.end(), [&](const std::string& s) { return values.count(s) > 0; });
}

/// Evaluates the printed formula in the receipt's cases.
void check_printed(const Block& block, EquationReceipt& receipt, Problems& problems)
{
    std::vector<std::string> faults;
    for (const Sample& sample : receipt.samples) {
        Expression::Values values;
        for (const auto& [tex, value] : sample.quantities) values[symbol_name(tex)] = value;
        bool evaluated = false;
        faults.clear();
        for (const std::string& side : sides(without_stop(formula_of(block)))) {
            const Reading reading = read_expression(side);
            if (!reading.expression) {
                faults.push_back(fmt::format("`{}` (stops at {})", side, reading.fault));
                continue;
            }
            if (!knows(values, *reading.expression)) {
                faults.push_back(fmt::format("`{}` (needs other quantities)", side));
                continue;
            }
            evaluated = true;
            const double value = reading.expression->value(values);
            if (agree(value, sample.value)) continue;
            problems.add(block.place,
                         fmt::format("equation {}: its printed side `{}` is {:.10g} at {}", block.name, side, value,
                                     spelled(values)),
                         fmt::format("{:.10g}, the closed form of its test", sample.value));
            return;
        }
        if (!evaluated) {
            problems.add(
                block.place,
                fmt::format("equation {}: no printed side can be evaluated: {}", block.name, join(faults, ", ")),
                fmt::format("a side in the quantities of its test ({}), or a test without quantities",
                            spelled(values)));
            return;
        }
        ++receipt.printed_cases;
    }
}

void check_equation(const Block& block, Ledger& ledger, Problems& problems)
{
    const auto found = ledger.equations.find(block.name);
    if (found == ledger.equations.end() || found->second.cases == 0) {
        problems.add(block.place, fmt::format("equation {} without a receipt", block.name),
                     fmt::format("CHECK_EQUATION(\"{}\", ...) in a test that the chapter's program runs", block.name));
        return;
    }
    EquationReceipt& receipt = found->second;
    check_receipt_kind(block, receipt, problems);
    if (!receipt.passed)
        problems.add(block.place,
                     fmt::format("equation {} fails its test: relative error {:.3g} in {}", block.name, receipt.worst,
                                 receipt.where),
                     fmt::format("at most {:.3g}", receipt.bound));
    if (receipt.twins == 0)
        problems.add(block.place, fmt::format("equation {} without a wrong twin", block.name),
                     fmt::format("CHECK_TWIN(\"{}\", ...), which shows that the check can fail", block.name));
    else if (!receipt.twins_rejected)
        problems.add(block.place, fmt::format("equation {}: its test takes the wrong twin too", block.name),
                     "a bound that tells the two apart");
    else if (receipt.twin_bound < receipt.bound)
        problems.add(block.place,
                     fmt::format("equation {}: twin rejected by a bound of {:.3g}, check passed by one of {:.3g}",
                                 block.name, receipt.twin_bound, receipt.bound),
                     "the same bound for both");
    check_printed(block, receipt, problems);
}

// ---- Derivations ----------------------------------------------------------------------------------------------------

/// `m in 1..5` or `\rho = m/(w h)`.
struct Range
{
    std::string symbol;
    double low = 0.0;
    double high = 0.0;
    double step = 0.0; ///< 0: any number between; otherwise low and whole steps from it
    std::optional<Expression> expression;
};

std::optional<Range> parse_range(const std::string& text)
{
    Range range;
    const std::size_t in = text.find(" in ");
    const std::size_t equals = text.find('=');
    if (in == std::string::npos && equals == std::string::npos) return std::nullopt;
    if (in == std::string::npos) {
        range.symbol = symbol_name(text.substr(0, equals));
        range.expression = read_expression(text.substr(equals + 1)).expression;
        return range.expression ? std::optional(range) : std::nullopt;
    }
    range.symbol = symbol_name(text.substr(0, in));
    std::string bounds = text.substr(in + 4);
    const std::size_t step = bounds.find(" step ");
    if (step != std::string::npos) {
        const std::optional<double> width = to_number(bounds.substr(step + 6));
        if (!width || !(*width > 0.0)) return std::nullopt;
        range.step = *width;
        bounds = bounds.substr(0, step);
    }
    const std::size_t dots = bounds.find("..");
    if (dots == std::string::npos) return std::nullopt;
    const std::optional<double> low = to_number(bounds.substr(0, dots));
    const std::optional<double> high = to_number(bounds.substr(dots + 2));
    if (!low || !high || !(*low < *high)) return std::nullopt;
    range.low = *low;
    range.high = *high;
    return range;
}

/// The ranges after `for`, at commas outside brackets.
std::optional<std::vector<Range>> parse_ranges(const std::string& options)
{
    std::vector<std::string> parts(1);
    int depth = 0;
    for (const char c : options.substr(3)) {
        if (c == '(' || c == '{') ++depth;
        if (c == ')' || c == '}') --depth;
        if (c == ',' && depth == 0) parts.emplace_back();
        else parts.back() += c;
    }
    std::vector<Range> ranges;
    for (const std::string& part : parts) {
        const std::optional<Range> range = parse_range(std::string(trim(part)));
        if (!range) return std::nullopt;
        ranges.push_back(*range);
    }
    return ranges;
}

double draw(std::mt19937_64& random)
{
    return static_cast<double>(random() >> 11) * 0x1p-53;
}

Expression::Values draw_point(const std::vector<Range>& ranges, std::mt19937_64& random)
{
    Expression::Values point;
    for (const Range& range : ranges) {
        if (range.expression) {
            point[range.symbol] = range.expression->value(point);
        } else if (range.step > 0.0) {
            const double count = std::floor((range.high - range.low) / range.step + 0.5) + 1.0;
            point[range.symbol] = range.low + range.step * std::floor(draw(random) * count);
        } else {
            point[range.symbol] = range.low + (range.high - range.low) * draw(random);
        }
    }
    return point;
}

/// A side of a line of a derivation that stands in the chain.
struct Link
{
    Step step;
    Expression expression;
    double before = 0.0; ///< its value at the point before
    bool apart = false;  ///< differed somewhere from its successor at another point: the comparison can fail
};

/// The sides of all lines, in order. The first of all may be a mere name for what is derived.
std::optional<std::vector<Link>> read_links(const Block& block, const Expression::Values& point, Problems& problems)
{
    std::vector<Link> links;
    bool first = true;
    for (const Step& step : steps_of(block)) {
        for (const std::string& side : sides(without_stop(step.tex))) {
            if (side.empty()) continue;
            const Reading reading = read_expression(side);
            const bool is_name = first;
            first = false;
            if (reading.expression && knows(point, *reading.expression)) {
                links.push_back({step, *reading.expression});
                continue;
            }
            if (is_name) continue;
            problems.add(
                {block.place.file, step.line},
                reading.expression
                    ? fmt::format("derivation {}: `{}` has symbols without a range", block.name, side)
                    : fmt::format("derivation {}: `{}` can't be read (stops at {})", block.name, side, reading.fault),
                fmt::format("symbols named after `for`, or no `for` and CHECK_DERIVATION(\"{}\", ...) in a test",
                            block.name));
            return std::nullopt;
        }
    }
    return links;
}

void evaluate_derivation(const Block& block, Ledger& ledger, Problems& problems)
{
    const std::optional<std::vector<Range>> ranges = parse_ranges(block.options);
    if (!ranges) {
        problems.add(block.place, fmt::format("derivation {}: ranges `{}`", block.name, block.options),
                     "`for x in 1..2, n in 3..9 step 1, \\rho = m/(w h)`");
        return;
    }
    std::mt19937_64 random(k_seed);
    std::optional<std::vector<Link>> links = read_links(block, draw_point(*ranges, random), problems);
    if (!links) return;
    if (links->size() < 2) {
        problems.add(block.place, fmt::format("derivation {} with one line to evaluate", block.name), "two at least");
        return;
    }
    double worst = 0.0;
    for (int k = 0; k < k_points; ++k) {
        const Expression::Values point = draw_point(*ranges, random);
        double last = 0.0;
        for (std::size_t at = 0; at < links->size(); ++at) {
            Link& link = (*links)[at];
            const double now = link.expression.value(point);
            if (at > 0) {
                Link& before = (*links)[at - 1];
                if (!agree(last, now)) {
                    problems.add(
                        {block.place.file, link.step.line},
                        fmt::format("derivation {}: this line is {:.10g} at {}", block.name, now, spelled(point)),
                        fmt::format("{:.10g}, as the line before says", last));
                    return;
                }
                worst =
                    std::max(worst, last == now ? 0.0 : std::abs(last - now) / std::max(std::abs(last), std::abs(now)));
                if (k > 0 && !agree(before.before, now)) before.apart = true;
                before.before = last;
            }
            last = now;
        }
    }
    for (std::size_t at = 0; at + 1 < links->size(); ++at)
        if (!(*links)[at].apart) {
            problems.add({block.place.file, (*links)[at].step.line},
                         fmt::format("derivation {}: this line is the same at every point", block.name),
                         "ranges that tell right from wrong");
            return;
        }
    ledger.derivations[block.name] = {static_cast<int>(steps_of(block).size()), k_points, true, worst, ""};
}

void check_derivation(const Block& block, Ledger& ledger, Problems& problems)
{
    if (block.options.rfind("for", 0) == 0) {
        evaluate_derivation(block, ledger, problems);
        return;
    }
    const auto found = ledger.derivations.find(block.name);
    if (found == ledger.derivations.end()) {
        problems.add(block.place, fmt::format("derivation {} that nothing checks", block.name),
                     fmt::format("`for` with the ranges of its symbols, or CHECK_DERIVATION(\"{}\", ...) in a test",
                                 block.name));
        return;
    }
    const int lines = static_cast<int>(steps_of(block).size());
    if (found->second.lines != lines)
        problems.add(block.place, fmt::format("derivation {} of {} lines", block.name, lines),
                     fmt::format("{}, as many as CHECK_DERIVATION was given", found->second.lines));
    if (!found->second.passed)
        problems.add(block.place, fmt::format("derivation {} fails its test", block.name), "lines that agree");
}

} // namespace

std::vector<Step> steps_of(const Block& block)
{
    std::vector<Step> steps;
    for (const auto& [number, line] : block.lines) {
        if (trim(line).empty()) continue;
        std::size_t percent = line.find('%');
        while (percent != std::string::npos && percent > 0 && line[percent - 1] == '\\')
            percent = line.find('%', percent + 1);
        Step step;
        step.line = number;
        step.tex = std::string(trim(std::string_view(line).substr(0, percent)));
        if (percent != std::string::npos) step.reason = std::string(trim(std::string_view(line).substr(percent + 1)));
        steps.push_back(std::move(step));
    }
    return steps;
}

std::string formula_of(const Block& block)
{
    std::vector<std::string> lines;
    for (const auto& numbered : block.lines) lines.emplace_back(trim(numbered.second));
    return join(lines, " ");
}

void check_receipts(Material& material, Problems& problems)
{
    for (const auto& [id, numbered] : material.numbered) {
        if (numbered.kind == BlockKind::equation) check_equation(*numbered.block, material.ledger, problems);
        if (numbered.kind == BlockKind::derivation) check_derivation(*numbered.block, material.ledger, problems);
    }
}

} // namespace flying::weave
