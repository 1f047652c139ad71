#include "support/receipts.hpp"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <iomanip>
#include <limits>
#include <map>
#include <sstream>
#include <utility>
#include <vector>

#include "support/listener.hpp"

namespace flying::receipts {

namespace {

/// Cases of one equation whose quantities are kept for the printed formula.
constexpr std::size_t k_samples = 16;

struct Equation
{
    std::int64_t cases = 0;
    double worst = 0.0;
    double bound = 0.0;
    std::string where; ///< of the worst case
    bool passed = true;
    std::int64_t twins = 0;
    double twin_bound = std::numeric_limits<double>::infinity();
    bool twins_rejected = true;
    std::vector<std::pair<std::vector<std::pair<std::string, double>>, double>> samples;
};

struct Derivation
{
    std::size_t lines = 0;
    std::size_t points = 0;
    double worst = 0.0;
    double bound = 0.0;
    std::string where;
    bool passed = true;
};

struct Ledger
{
    std::map<std::string, Equation, std::less<>> equations;
    std::map<std::string, Derivation, std::less<>> derivations;
    std::map<std::string, double, std::less<>> values;
};

Ledger& ledger()
{
    static Ledger one;
    return one;
}

template <typename Map>
auto& entry(Map& map, std::string_view key)
{
    const auto found = map.find(key);
    return found != map.end() ? found->second : map[std::string(key)];
}

/// `test "a square turns" (chapters/02-rectangle/tests.cpp:41)`
std::string place(Here here)
{
    std::string file = here.file;
    const std::string top = FLYING_SOURCE_DIR "/";
    if (file.rfind(top, 0) == 0) file = file.substr(top.size());
    std::ostringstream text;
    const auto* test = doctest::getContextOptions()->currentTest;
    if (test != nullptr) text << "test \"" << test->m_name << "\" ";
    text << "(" << file << ":" << here.line << ")";
    return text.str();
}

std::string quoted(std::string_view text)
{
    std::string out = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') out += '\\';
        out += static_cast<unsigned char>(c) < ' ' ? ' ' : c;
    }
    return out + '"';
}

/// JSON knows no infinity and no NaN: they become null.
std::string number(double value)
{
    if (!std::isfinite(value)) return "null";
    std::ostringstream text;
    text << std::setprecision(17) << value;
    return text.str();
}

const char* truth(bool value)
{
    return value ? "true" : "false";
}

std::string text_of(const Equation& equation)
{
    std::ostringstream out;
    out << "{\"cases\": " << equation.cases << ", \"passed\": " << truth(equation.passed)
        << ", \"worst\": " << number(equation.worst) << ", \"bound\": " << number(equation.bound)
        << ", \"where\": " << quoted(equation.where) << ", \"twins\": " << equation.twins
        << ", \"twins_rejected\": " << truth(equation.twins_rejected)
        << ", \"twin_bound\": " << number(equation.twin_bound) << ", \"samples\": [";
    const char* separator = "";
    for (const auto& [quantities, value] : equation.samples) {
        out << separator << "{\"value\": " << number(value) << ", \"quantities\": {";
        separator = "";
        for (const auto& [tex, amount] : quantities) {
            out << separator << quoted(tex) << ": " << number(amount);
            separator = ", ";
        }
        out << "}}";
        separator = ", ";
    }
    out << "]}";
    return out.str();
}

std::string text_of(const Derivation& derivation)
{
    std::ostringstream out;
    out << "{\"lines\": " << derivation.lines << ", \"points\": " << derivation.points
        << ", \"passed\": " << truth(derivation.passed) << ", \"worst\": " << number(derivation.worst)
        << ", \"bound\": " << number(derivation.bound) << ", \"where\": " << quoted(derivation.where) << "}";
    return out.str();
}

std::string text_of(double value)
{
    return number(value);
}

template <typename Map>
void write(std::ostream& out, const char* name, const Map& map)
{
    out << ",\n " << quoted(name) << ": {";
    const char* separator = "\n  ";
    for (const auto& [key, value] : map) {
        out << separator << quoted(key) << ": " << text_of(value);
        separator = ",\n  ";
    }
    out << "}";
}

/// Writes the ledger when the program's tests are over.
struct Writer : testing::Listener
{
    explicit Writer(const doctest::ContextOptions&) {}

    void test_run_end(const doctest::TestRunStats& stats) override
    {
        const char* path = std::getenv("FLYING_RECEIPTS");
        if (path == nullptr) return;
        std::ofstream out(path);
        out << "{\"passed\": " << truth(stats.numTestCasesFailed == 0);
        write(out, "equations", ledger().equations);
        write(out, "derivations", ledger().derivations);
        write(out, "values", ledger().values);
        out << "\n}\n";
    }
};

DOCTEST_REGISTER_LISTENER("receipts", 1, Writer);

} // namespace

Outcome note_equation(std::string_view id, double error, double bound, double value, Here here,
                      std::initializer_list<Quantity> quantities)
{
    Equation& equation = entry(ledger().equations, id);
    ++equation.cases;
    equation.bound = std::max(equation.bound, bound);
    if (equation.cases == 1 || (!std::isnan(equation.worst) && !(error <= equation.worst))) {
        equation.worst = error;
        equation.where = place(here);
    }
    if (quantities.size() > 0 && equation.samples.size() < k_samples) {
        auto& sample = equation.samples.emplace_back();
        for (const Quantity& quantity : quantities) sample.first.emplace_back(quantity.tex, quantity.value);
        sample.second = value;
    }
    if (error <= bound) return {};
    equation.passed = false;
    return {false, "equation " + std::string(id) + ": relative error " + number(error) + "; expected at most " +
                       number(bound)};
}

Outcome note_twin(std::string_view id, double error, double bound, Here)
{
    Equation& equation = entry(ledger().equations, id);
    ++equation.twins;
    equation.twin_bound = std::min(equation.twin_bound, bound);
    if (!(error <= bound)) return {};
    equation.twins_rejected = false;
    return {false, "wrong twin of equation " + std::string(id) + " not noticed: relative error " + number(error) +
                       "; expected more than " + number(bound)};
}

Outcome note_derivation(std::string_view id, std::size_t lines, std::size_t points, double worst, double twin,
                        double bound, Here here)
{
    Derivation& derivation = entry(ledger().derivations, id);
    derivation = {lines, points, worst, bound, place(here), false};
    if (!(worst <= bound))
        return {false, "derivation " + std::string(id) + ": neighbouring lines differ by " + number(worst) +
                           " of their size; expected at most " + number(bound)};
    if (!(twin > bound))
        return {false, "derivation " + std::string(id) + ": two lines agree at different points too; expected " +
                           "points that tell the lines apart"};
    derivation.passed = true;
    return {};
}

void note_value(std::string_view name, double value)
{
    entry(ledger().values, name) = value;
}

} // namespace flying::receipts
