#include "weave/formula_node.hpp"

#include <cctype>
#include <cmath>
#include <optional>
#include <set>
#include <stdexcept>
#include <utility>

#include "weave/text.hpp"

namespace flying::weave {

namespace {

using Node = Expression::Node;
using Kind = Node::Kind;

NodePtr make(Kind kind, std::vector<NodePtr> parts, std::string name = "")
{
    return std::make_shared<const Node>(Node{kind, 0.0, std::move(name), std::move(parts)});
}

NodePtr make(double number)
{
    return std::make_shared<const Node>(Node{Kind::number, number, "", {}});
}

// ---- Tokens ---------------------------------------------------------------------------------------------------------

/// Commands that only place things.
bool is_spacing(const std::string& token)
{
    static const std::set<std::string> k_spacing = {
        "\\,",     "\\;",     "\\:",    "\\!",    "\\ ",     "\\quad", "\\qquad", "\\left", "\\right",
        "\\big",   "\\Big",   "\\bigg", "\\Bigg", "\\bigl",  "\\bigr", "\\Bigl",  "\\Bigr", "\\displaystyle",
        "\\biggl", "\\biggr", "&",      "~",      "\\limits"};
    return k_spacing.count(token) > 0;
}

std::vector<std::string> tokens_of(const std::string& tex)
{
    std::vector<std::string> tokens;
    std::size_t at = 0;
    while (at < tex.size()) {
        std::size_t end = at + 1;
        const char c = tex[at];
        if (std::isspace(static_cast<unsigned char>(c))) {
            at = end;
            continue;
        }
        if (c == '\\') {
            while (end < tex.size() && std::isalpha(static_cast<unsigned char>(tex[end]))) ++end;
            if (end == at + 1) ++end;
        } else if (std::isdigit(static_cast<unsigned char>(c))) {
            while (end < tex.size() && (std::isdigit(static_cast<unsigned char>(tex[end])) || tex[end] == '.')) ++end;
        }
        std::string token = tex.substr(at, end - at);
        if (token == "\\lvert" || token == "\\rvert" || token == "\\vert") token = "|";
        if (token == "\\lbrace" || token == "\\{") token = "(";
        if (token == "\\rbrace" || token == "\\}") token = ")";
        if (!is_spacing(token)) tokens.push_back(token);
        at = end;
    }
    return tokens;
}

bool is_greek(const std::string& token)
{
    static const std::set<std::string> k_greek = {
        "\\alpha",  "\\beta",   "\\gamma", "\\delta", "\\epsilon", "\\varepsilon", "\\zeta",  "\\eta",    "\\theta",
        "\\kappa",  "\\lambda", "\\mu",    "\\nu",    "\\xi",      "\\rho",        "\\sigma", "\\tau",    "\\phi",
        "\\varphi", "\\chi",    "\\psi",   "\\omega", "\\Delta",   "\\Gamma",      "\\Theta", "\\Lambda", "\\Phi",
        "\\Psi",    "\\Omega",  "\\Sigma", "\\pi",    "\\ell",     "\\vartheta"};
    return k_greek.count(token) > 0;
}

bool is_letter(const std::string& token)
{
    return token.size() == 1 && std::isalpha(static_cast<unsigned char>(token[0]));
}

// ---- Parser ---------------------------------------------------------------------------------------------------------

class Parser
{
public:
    explicit Parser(std::vector<std::string> tokens) : tokens_(std::move(tokens)) {}

    NodePtr whole()
    {
        NodePtr node = sum();
        if (at_ < tokens_.size()) fail("`" + tokens_[at_] + "`");
        return node;
    }

    std::string whole_symbol()
    {
        std::string name = symbol();
        if (at_ < tokens_.size()) fail("`" + tokens_[at_] + "` after a symbol");
        return name;
    }

private:
    [[noreturn]] static void fail(const std::string& what) { throw std::invalid_argument(what); }

    [[nodiscard]] const std::string& peek(std::size_t ahead = 0) const
    {
        static const std::string k_end;
        return at_ + ahead < tokens_.size() ? tokens_[at_ + ahead] : k_end;
    }

    bool take(const std::string& token)
    {
        if (peek() != token) return false;
        ++at_;
        return true;
    }

    void need(const std::string& token)
    {
        if (!take(token)) fail(peek().empty() ? "end before `" + token + "`" : "`" + peek() + "` for `" + token + "`");
    }

    NodePtr sum()
    {
        std::vector<NodePtr> parts;
        double sign = 1.0;
        if (take("-")) sign = -1.0;
        else take("+");
        while (true) {
            NodePtr part = product();
            parts.push_back(sign > 0.0 ? part : make(Kind::product, {make(-1.0), part}));
            if (take("+")) sign = 1.0;
            else if (take("-")) sign = -1.0;
            else break;
        }
        return parts.size() == 1 ? parts[0] : make(Kind::sum, std::move(parts));
    }

    NodePtr product()
    {
        NodePtr left = power();
        while (true) {
            if (take("\\cdot") || take("\\times")) {
                left = make(Kind::product, {left, power()});
            } else if (take("/")) {
                left = make(Kind::quotient, {left, power()});
            } else if (starts_factor()) {
                left = make(Kind::product, {left, power()});
            } else {
                return left;
            }
        }
    }

    /// `d` before a symbol, in an integral: its end.
    [[nodiscard]] bool at_differential() const
    {
        return integrals_ > 0 && peek() == "d" && (is_letter(peek(1)) || is_greek(peek(1)));
    }

    [[nodiscard]] bool starts_factor() const
    {
        const std::string& token = peek();
        if (token.empty() || at_differential()) return false;
        if (token == "|") return bars_ == 0;
        if (std::isdigit(static_cast<unsigned char>(token[0])) || is_letter(token) || is_greek(token)) return true;
        static const std::set<std::string> k_starts = {
            "(",     "[",     "{",       "\\frac",   "\\tfrac", "\\dfrac", "\\sqrt", "\\int",   "\\sum",   "\\bar",
            "\\hat", "\\dot", "\\tilde", "\\mathrm", "\\text",  "\\max",   "\\min",  "\\lceil", "\\lfloor"};
        return k_starts.count(token) > 0 || formula_functions().count(token) > 0;
    }

    NodePtr power()
    {
        NodePtr base = atom();
        while (take("^")) base = make(Kind::power, {base, argument()});
        return base;
    }

    /// What a command or an exponent takes: a group, or one token.
    NodePtr argument()
    {
        if (peek() == "{") return group("{", "}");
        if (peek().size() > 1 && std::isdigit(static_cast<unsigned char>(peek()[0]))) {
            // TeX takes the first digit alone
            const std::string digits = peek();
            tokens_[at_] = digits.substr(1);
            return make(digits[0] - '0');
        }
        if (peek() == "-" || peek() == "+") fail("a sign as exponent");
        return atom();
    }

    NodePtr group(const char* open, const char* close)
    {
        need(open);
        const int bars = std::exchange(bars_, 0);
        NodePtr node = sum();
        bars_ = bars;
        need(close);
        return node;
    }

    NodePtr atom()
    {
        const std::string token = peek();
        if (token.empty()) fail("end of the formula where a quantity should stand");
        if (token == "(") return group("(", ")");
        if (token == "[") return group("[", "]");
        if (token == "{") return group("{", "}");
        if (token == "\\lceil") return make(Kind::function, {group("\\lceil", "\\rceil")}, "ceil");
        if (token == "\\lfloor") return make(Kind::function, {group("\\lfloor", "\\rfloor")}, "floor");
        if (std::isdigit(static_cast<unsigned char>(token[0]))) {
            ++at_;
            const std::optional<double> number = to_number(token);
            if (!number) fail("number `" + token + "`");
            return make(*number);
        }
        if (take("|")) {
            ++bars_;
            NodePtr inside = sum();
            --bars_;
            need("|");
            return make(Kind::function, {inside}, "abs");
        }
        if (take("\\frac") || take("\\tfrac") || take("\\dfrac")) {
            NodePtr above = argument();
            return make(Kind::quotient, {above, argument()});
        }
        if (take("\\sqrt")) {
            if (peek() != "[") return make(Kind::function, {argument()}, "sqrt");
            NodePtr degree = group("[", "]");
            return make(Kind::power, {argument(), make(Kind::quotient, {make(1.0), degree})});
        }
        if (take("\\max") || take("\\min")) return extreme(token);
        if (formula_functions().count(token) > 0) return function();
        if (take("\\int")) return integral();
        if (take("\\sum")) return series();
        return make(Kind::symbol, {}, symbol());
    }

    /// `\sin x`, `\sin^2 x`, `\sin(x)`: without brackets the argument is all that follows up to a sign or a function.
    NodePtr function()
    {
        const std::string name = tokens_[at_++];
        NodePtr exponent;
        if (take("^")) exponent = argument();
        NodePtr inside;
        if (peek() == "(" || peek() == "[") {
            inside = atom();
        } else {
            inside = power();
            while (starts_factor() && formula_functions().count(peek()) == 0 && peek() != "(")
                inside = make(Kind::product, {inside, power()});
        }
        NodePtr node = make(Kind::function, {inside}, name);
        return exponent ? make(Kind::power, {node, exponent}) : node;
    }

    NodePtr extreme(const std::string& name)
    {
        need("(");
        std::vector<NodePtr> parts{sum()};
        while (take(",")) parts.push_back(sum());
        need(")");
        return make(Kind::function, std::move(parts), name);
    }

    NodePtr integral()
    {
        NodePtr low;
        NodePtr high;
        for (int k = 0; k < 2; ++k) {
            if (take("_")) low = argument();
            else if (take("^")) high = argument();
        }
        if (!low || !high) fail("an integral without bounds");
        ++integrals_;
        NodePtr inside = at_differential() ? make(1.0) : sum();
        if (!at_differential()) fail("an integral without its differential");
        ++at_;
        const std::string variable = symbol();
        --integrals_;
        return make(Kind::integral, {low, high, inside}, variable);
    }

    NodePtr series()
    {
        NodePtr first;
        NodePtr last;
        std::string variable;
        for (int k = 0; k < 2; ++k) {
            if (take("_")) {
                need("{");
                variable = symbol();
                need("=");
                first = sum();
                need("}");
            } else if (take("^")) {
                last = argument();
            }
        }
        if (!first || !last) fail("a sum without bounds");
        return make(Kind::series, {first, last, product()}, variable);
    }

    /// A letter, Greek or Latin, with what hangs on it: accents before, an index, primes and signs after.
    std::string symbol()
    {
        std::string name = peek();
        if (name == "\\bar" || name == "\\hat" || name == "\\dot" || name == "\\tilde" || name == "\\mathrm" ||
            name == "\\text") {
            ++at_;
            name += raw_group();
        } else if (is_letter(name) || is_greek(name)) {
            ++at_;
        } else {
            fail(name.empty() ? "end of the formula" : "`" + name + "`");
        }
        while (true) {
            if (take("_")) {
                name += "_" + raw_group();
            } else if (take("'")) {
                name += "'";
            } else if (peek() == "^" && (peek(1) == "+" || peek(1) == "-" || peek(1) == "*" || peek(1) == "\\prime")) {
                name += "^" + peek(1);
                at_ += 2;
            } else if (peek() == "^" && peek(1) == "{" && peek(3) == "}" && (peek(2) == "+" || peek(2) == "-")) {
                name += "^" + peek(2);
                at_ += 4;
            } else {
                return name;
            }
        }
    }

    /// The tokens of a group as they stand; braces round a single one go.
    std::string raw_group()
    {
        if (!take("{")) {
            if (peek().empty()) fail("end of the formula");
            return tokens_[at_++];
        }
        std::vector<std::string> inside;
        int depth = 1;
        while (true) {
            if (peek().empty()) fail("end before `}`");
            if (peek() == "{") ++depth;
            if (peek() == "}" && --depth == 0) break;
            inside.push_back(tokens_[at_++]);
        }
        ++at_;
        return inside.size() == 1 ? inside[0] : "{" + join(inside, "") + "}";
    }

    std::vector<std::string> tokens_;
    std::size_t at_ = 0;
    int integrals_ = 0; ///< that are open here
    int bars_ = 0;      ///< absolute values that are open here
};

} // namespace

const std::map<std::string, double (*)(double)>& formula_functions()
{
    static const std::map<std::string, double (*)(double)> k_functions = {
        {"\\sin", [](double x) { return std::sin(x); }},     {"\\cos", [](double x) { return std::cos(x); }},
        {"\\tan", [](double x) { return std::tan(x); }},     {"\\cot", [](double x) { return 1.0 / std::tan(x); }},
        {"\\arcsin", [](double x) { return std::asin(x); }}, {"\\arccos", [](double x) { return std::acos(x); }},
        {"\\arctan", [](double x) { return std::atan(x); }}, {"\\ln", [](double x) { return std::log(x); }},
        {"\\log", [](double x) { return std::log(x); }},     {"\\exp", [](double x) { return std::exp(x); }},
        {"\\sinh", [](double x) { return std::sinh(x); }},   {"\\cosh", [](double x) { return std::cosh(x); }},
        {"\\tanh", [](double x) { return std::tanh(x); }},   {"sqrt", [](double x) { return std::sqrt(x); }},
        {"abs", [](double x) { return std::abs(x); }},       {"ceil", [](double x) { return std::ceil(x); }},
        {"floor", [](double x) { return std::floor(x); }},
    };
    return k_functions;
}

NodePtr parse_expression(const std::string& tex)
{
    return Parser(tokens_of(tex)).whole();
}

std::string parse_symbol(const std::string& tex)
{
    return Parser(tokens_of(tex)).whole_symbol();
}

} // namespace flying::weave
