#include "weave/formula.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "weave/formula_node.hpp"
#include "weave/text.hpp"

namespace flying::weave {

namespace {

using Node = Expression::Node;
using Kind = Node::Kind;

/// Nodes and weights of Gauss and Legendre's rule of ten points on [-1, 1], by Newton's method on the polynomial.
struct GaussRule
{
    static constexpr int k_points = 10;
    std::array<double, k_points> nodes{};
    std::array<double, k_points> weights{};

    GaussRule()
    {
        for (int k = 0; k < k_points; ++k) {
            double x = std::cos(std::numbers::pi * (k + 0.75) / (k_points + 0.5));
            double slope = 0.0;
            for (int step = 0; step < 50; ++step) {
                double before = 1.0;
                double now = x;
                for (int n = 2; n <= k_points; ++n)
                    before = std::exchange(now, ((2 * n - 1) * x * now - (n - 1) * before) / n);
                slope = k_points * (x * now - before) / (x * x - 1.0);
                x -= now / slope;
            }
            nodes[k] = x;
            weights[k] = 2.0 / ((1.0 - x * x) * slope * slope);
        }
    }
};

double evaluate(const Node& node, Expression::Values& values);

/// `body` with the variable at x; the variable's value outside comes back afterwards.
double evaluate_at(const Node& body, const std::string& variable, double x, Expression::Values& values)
{
    const auto outside = values.find(variable);
    const bool was_set = outside != values.end();
    const double before = was_set ? outside->second : 0.0;
    values[variable] = x;
    const double result = evaluate(body, values);
    if (was_set) values[variable] = before;
    else values.erase(variable);
    return result;
}

double evaluate_integral(const Node& node, Expression::Values& values)
{
    static const GaussRule k_rule;
    constexpr int k_panels = 4;
    const double low = evaluate(*node.parts[0], values);
    const double high = evaluate(*node.parts[1], values);
    const double half = (high - low) / (2 * k_panels);
    double total = 0.0;
    for (int panel = 0; panel < k_panels; ++panel)
        for (int k = 0; k < GaussRule::k_points; ++k) {
            const double x = low + half * (2 * panel + 1 + k_rule.nodes[k]);
            total += half * k_rule.weights[k] * evaluate_at(*node.parts[2], node.name, x, values);
        }
    return total;
}

double evaluate_series(const Node& node, Expression::Values& values)
{
    const double first = evaluate(*node.parts[0], values);
    const double last = evaluate(*node.parts[1], values);
    if (!(last - first < 1e6)) return std::nan("");
    double total = 0.0;
    for (double k = first; k <= last + 0.5; k += 1.0) total += evaluate_at(*node.parts[2], node.name, k, values);
    return total;
}

double evaluate_function(const Node& node, Expression::Values& values)
{
    double result = evaluate(*node.parts[0], values);
    const auto known = formula_functions().find(node.name);
    if (known != formula_functions().end()) return known->second(result);
    for (const NodePtr& part : node.parts) {
        const double other = evaluate(*part, values);
        result = node.name == "\\max" ? std::max(result, other) : std::min(result, other);
    }
    return result;
}

double evaluate(const Node& node, Expression::Values& values)
{
    switch (node.kind) {
    case Kind::number:
        return node.number;
    case Kind::symbol: {
        const auto found = values.find(node.name);
        if (found != values.end()) return found->second;
        return node.name == "\\pi" ? std::numbers::pi : std::nan("");
    }
    case Kind::sum: {
        double total = 0.0;
        for (const NodePtr& part : node.parts) total += evaluate(*part, values);
        return total;
    }
    case Kind::product:
        return evaluate(*node.parts[0], values) * evaluate(*node.parts[1], values);
    case Kind::quotient:
        return evaluate(*node.parts[0], values) / evaluate(*node.parts[1], values);
    case Kind::power:
        return std::pow(evaluate(*node.parts[0], values), evaluate(*node.parts[1], values));
    case Kind::function:
        return evaluate_function(node, values);
    case Kind::integral:
        return evaluate_integral(node, values);
    case Kind::series:
        return evaluate_series(node, values);
    }
    return std::nan("");
}

void collect(const Node& node, std::set<std::string>& symbols)
{
    std::set<std::string> inside;
    for (const NodePtr& part : node.parts) collect(*part, inside);
    if (node.kind == Kind::integral || node.kind == Kind::series) inside.erase(node.name);
    symbols.merge(inside);
    if (node.kind == Kind::symbol && node.name != "\\pi") symbols.insert(node.name);
}

} // namespace

double Expression::value(const Values& values) const
{
    Values copy = values;
    return evaluate(*root_, copy);
}

std::set<std::string> Expression::symbols() const
{
    std::set<std::string> names;
    collect(*root_, names);
    return names;
}

Reading read_expression(const std::string& tex)
{
    try {
        return {Expression(parse_expression(tex)), ""};
    } catch (const std::invalid_argument& error) {
        return {std::nullopt, error.what()};
    }
}

std::vector<std::string> sides(const std::string& tex)
{
    std::vector<std::string> parts(1);
    int depth = 0;
    for (std::size_t at = 0; at < tex.size(); ++at) {
        const char c = tex[at];
        if (c == '{') ++depth;
        if (c == '}') --depth;
        if (c == '=' && depth == 0) {
            parts.emplace_back();
        } else {
            parts.back() += c;
        }
    }
    for (std::string& part : parts) part = std::string(trim(part));
    return parts;
}

std::string symbol_name(const std::string& tex)
{
    try {
        return parse_symbol(tex);
    } catch (const std::invalid_argument&) {
        return tex;
    }
}

} // namespace flying::weave
