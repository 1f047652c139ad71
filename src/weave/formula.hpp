#pragma once

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

/// Reads formulas as they are printed and evaluates them, so that a slip in the TeX is found like any other. It knows
/// what school algebra and analysis need: sums, products written side by side, fractions, powers, roots, sines and
/// their kin, absolute values, integrals between bounds, finite sums. What it doesn't know it says.
namespace flying::weave {

/// A formula, or a side of one, taken apart.
class Expression
{
public:
    using Values = std::map<std::string, double>;

    struct Node; ///< defined in formula.cpp

    explicit Expression(std::shared_ptr<const Node> root) : root_(std::move(root)) {}

    /// Its value, given those of its symbols; NaN where one is missing.
    [[nodiscard]] double value(const Values& values) const;

    /// The symbols whose values it needs, as symbol_name() spells them.
    [[nodiscard]] std::set<std::string> symbols() const;

private:
    std::shared_ptr<const Node> root_;
};

/// What reading a piece of TeX came to: the expression, or the reason why there is none.
struct Reading
{
    std::optional<Expression> expression;
    std::string fault;
};

/// Reads an expression, without any sign of equality.
[[nodiscard]] Reading read_expression(const std::string& tex);

/// The sides of a formula: the pieces between its signs of equality, outside all braces.
[[nodiscard]] std::vector<std::string> sides(const std::string& tex);

/// One spelling for every way to write a symbol in TeX: `v_{a}` and `v_a` are the same.
[[nodiscard]] std::string symbol_name(const std::string& tex);

} // namespace flying::weave
