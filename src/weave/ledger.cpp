#include "weave/ledger.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <optional>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "weave/text.hpp"

namespace flying::weave {

namespace {

using nlohmann::json;

double number(const json& node, const char* key)
{
    const auto found = node.find(key);
    return found == node.end() || !found->is_number() ? std::numeric_limits<double>::quiet_NaN() : found->get<double>();
}

EquationReceipt read_equation(const json& node)
{
    EquationReceipt receipt;
    receipt.cases = node.value("cases", std::int64_t{0});
    receipt.passed = node.value("passed", false);
    receipt.worst = number(node, "worst");
    receipt.bound = number(node, "bound");
    receipt.where = node.value("where", "");
    receipt.twins = node.value("twins", std::int64_t{0});
    receipt.twins_rejected = node.value("twins_rejected", false);
    receipt.twin_bound = number(node, "twin_bound");
    const json samples = node.value("samples", json::array());
    for (const json& sample : samples) {
        Sample& added = receipt.samples.emplace_back();
        added.value = number(sample, "value");
        for (const auto& [tex, value] : sample.at("quantities").items())
            added.quantities[tex] = value.is_number() ? value.get<double>() : std::nan("");
    }
    return receipt;
}

DerivationReceipt read_derivation(const json& node)
{
    return {node.value("lines", 0), node.value("points", 0), node.value("passed", false), number(node, "worst"),
            node.value("where", "")};
}

} // namespace

Ledger read_ledger(const std::filesystem::path& folder, Problems& problems)
{
    Ledger ledger;
    std::vector<std::filesystem::path> files;
    std::error_code error;
    for (const auto& entry : std::filesystem::directory_iterator(folder, error))
        if (entry.path().extension() == ".json") files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    for (const std::filesystem::path& path : files) {
        const std::string name = path.filename().string();
        const auto once = [&](bool is_new, const char* what, const std::string& id) {
            if (!is_new)
                problems.add({name, 0}, fmt::format("{} `{}` from two test programs", what, id), "one of them");
        };
        try {
            const json root = json::parse(read_file(path).value_or(""));
            if (!root.value("passed", true))
                problems.add({name, 0}, "receipts of a test program that failed", "tests that pass");
            const json equations = root.value("equations", json::object());
            const json derivations = root.value("derivations", json::object());
            const json values = root.value("values", json::object());
            for (const auto& [id, node] : equations.items())
                once(ledger.equations.emplace(id, read_equation(node)).second, "equation", id);
            for (const auto& [id, node] : derivations.items())
                once(ledger.derivations.emplace(id, read_derivation(node)).second, "derivation", id);
            for (const auto& [id, node] : values.items())
                once(ledger.values.emplace(id, node.is_number() ? node.get<double>() : std::nan("")).second, "value",
                     id);
        } catch (const json::exception& broken) {
            problems.add({name, 0}, fmt::format("receipts that can't be read ({})", broken.what()),
                         "the JSON that a test program writes");
        }
    }
    return ledger;
}

void add_printed_values(const std::string& program, const std::string& output, Ledger& ledger)
{
    for (const std::string& line : split_lines(output)) {
        const std::size_t sign = line.find(" = ");
        if (sign == std::string::npos) continue;
        const std::string_view rest = trim(std::string_view(line).substr(sign + 3));
        const std::optional<double> value = to_number(rest.substr(0, rest.find_first_of(" \t,;")));
        const std::string label = slug(std::string_view(line).substr(0, sign));
        if (value && !label.empty()) ledger.values[program + "." + label] = *value;
    }
}

std::optional<std::string> format_value(double value, const std::string& format)
{
    // Let through `%`, flags, width, precision and one letter: nothing else may reach snprintf
    const std::string letters = "eEfFgG";
    const auto is_digit = [](char c) { return (c >= '0' && c <= '9') || c == '.' || c == '+'; };
    const bool is_format = format.size() >= 2 && format.size() <= 6 && format.front() == '%' &&
                           letters.find(format.back()) != std::string::npos &&
                           std::all_of(format.begin() + 1, format.end() - 1, is_digit);
    if (!is_format) return std::nullopt;
    std::array<char, 1500> text{};
    std::snprintf(text.data(), text.size(), format.c_str(), value);
    std::string shown = text.data();
    const std::size_t e = shown.find_first_of("eE");
    const bool has_power = e != std::string::npos && std::isfinite(value);
    if (has_power && value == 0.0) return "0";
    const int exponent = has_power ? std::stoi(shown.substr(e + 1)) : 0;
    if (has_power) shown.resize(e);
    // Digits in groups of three, from five on
    const std::size_t first = shown.front() == '-' || shown.front() == '+' ? 1 : 0;
    const std::size_t point = std::min(shown.find('.'), shown.size());
    const bool is_long = !has_power && std::isfinite(value) && point - first >= 5;
    for (std::size_t at = point; is_long && at > first + 3;) shown.insert(at -= 3, ",");
    if (shown.front() == '-') shown.replace(0, 1, "\u2212");
    if (!has_power) return shown;
    const std::string power = fmt::format("10<sup>{}{}</sup>", exponent < 0 ? "\u2212" : "", std::abs(exponent));
    return shown == "1" ? power : fmt::format("{}\u2009\u00b7\u2009{}", shown, power);
}

} // namespace flying::weave
