#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "weave/formula.hpp"

namespace flying::weave {

/// An operation of a formula and what it applies to.
struct Expression::Node
{
    enum class Kind
    {
        number,
        symbol,
        sum,
        product,
        quotient,
        power,
        function,
        integral,
        series
    };

    Kind kind = Kind::number;
    double number = 0.0;
    std::string name; ///< of a symbol, a function, the variable of an integral or a series
    std::vector<std::shared_ptr<const Node>> parts;
};

using NodePtr = std::shared_ptr<const Expression::Node>;

/// What the functions of one number do, by the names that nodes give them.
[[nodiscard]] const std::map<std::string, double (*)(double)>& formula_functions();

/// The tree of a piece of TeX. Throws std::invalid_argument, with the place where reading stopped, where it is none
/// that is known here.
[[nodiscard]] NodePtr parse_expression(const std::string& tex);

/// The one spelling of a piece of TeX that is a symbol; throws like parse_expression().
[[nodiscard]] std::string parse_symbol(const std::string& tex);

} // namespace flying::weave
