#include "house.hpp"

#include <algorithm>
#include <fstream>
#include <map>
#include <regex>
#include <set>

namespace house {

namespace {

// The arrows of the design: a module and those it points to. A module reaches all that these reach.
const std::map<std::string, std::vector<std::string>> k_arrows = {
    {"math", {}},
    {"motion", {"math"}},
    {"geometry", {"math"}},
    {"mass", {"geometry"}},
    {"collide", {"geometry"}},
    {"broadphase", {"geometry"}},
    {"response", {"motion"}},
    {"toi", {"collide", "motion"}},
    {"events", {"toi", "broadphase", "response"}},
    {"rest", {"collide", "broadphase", "response"}},
    {"world", {"events", "rest", "mass"}},
    {"draw", {"world"}},
    {"scene", {"world"}},
    {"files", {"math"}},
    {"json", {"scene"}},
    {"play", {"draw", "scene"}},
    {"window", {"play", "files"}},
    {"app", {"draw", "json", "files", "window"}},
    {"python", {"json"}},
    {"live", {"scene"}},
    {"weave", {}},
};

const std::set<std::string> k_engine = {"math",     "motion", "geometry", "mass", "collide", "broadphase",
                                        "response", "toi",    "events",   "rest", "world"};

// Standard headers without output, clock, thread, chance or platform. No unordered containers: order comes from ids.
const std::set<std::string> k_headers = {
    "algorithm", "array",   "bit",         "charconv",    "cmath",      "compare",  "concepts",     "cstddef",
    "cstdint",   "cstring", "cstdlib",     "deque",       "functional", "iterator", "limits",       "map",
    "memory",    "numbers", "numeric",     "optional",    "queue",      "set",      "span",         "string",
    "tuple",     "utility", "string_view", "type_traits", "variant",    "vector",   "system_error", "initializer_list"};

// Words that mean the same wherever they stand. `long` has 64 bits here and 32 in WebAssembly: std::int64_t says it.
const std::set<std::string> k_words = {"throw", "try", "catch", "thread_local", "Rotation2D", "Rotation2Dd", "long"};

// Words forbidden as functions: preceded by neither a dot nor an arrow, followed by a parenthesis
const std::set<std::string> k_functions = {
    "sin",    "cos",   "tan",    "asin",    "acos",   "atan",    "atan2",   "sinh",    "cosh", "tanh",
    "exp",    "exp2",  "expm1",  "log",     "log2",   "log10",   "pow",     "log1p",   "cbrt", "hypot",
    "sincos", "erf",   "tgamma", "getenv",  "system", "exit",    "abort",   "strtod",  "atof", "qsort",
    "rand",   "srand", "printf", "fprintf", "puts",   "putchar", "sprintf", "snprintf"};

// Names forbidden after std::
const std::set<std::string> k_standard = {"cout",          "cerr",       "clog",          "cin",
                                          "chrono",        "thread",     "jthread",       "mutex",
                                          "atomic",        "async",      "future",        "format",
                                          "random_device", "mt19937",    "mt19937_64",    "source_location",
                                          "views",         "ranges",     "filesystem", "unordered_map", "unordered_set",
                                          "ofstream",      "ifstream",   "fopen"};

std::set<std::string> reach(const std::string& module)
{
    std::set<std::string> reached = {module};
    for (const std::string& next : k_arrows.at(module)) reached.merge(reach(next));
    return reached;
}

std::string at(const Source& source, int line)
{
    return source.path + ":" + std::to_string(line) + ": ";
}

// The words of a line of code, each with what stands before and behind it
struct Word
{
    std::string text;
    std::string before; ///< the two characters before it, blanks left out
    char behind = ' ';  ///< the next character that isn't blank
};

std::vector<Word> words_of(const std::string& line)
{
    static const std::regex k_word(R"([A-Za-z_][A-Za-z0-9_]*)");
    std::vector<Word> words;
    for (std::sregex_iterator it(line.begin(), line.end(), k_word), end; it != end; ++it) {
        Word word{it->str(), "", ' '};
        std::string before = line.substr(0, static_cast<std::size_t>(it->position()));
        before.erase(before.find_last_not_of(" \t") + 1);
        word.before = before.substr(before.size() - std::min<std::size_t>(before.size(), 2));
        const std::string behind = it->suffix().str();
        const std::size_t next = behind.find_first_not_of(" \t");
        if (next != std::string::npos) word.behind = behind[next];
        words.push_back(word);
    }
    return words;
}

bool is_forbidden(const Word& word, const std::string& previous)
{
    if (k_words.contains(word.text)) return true;
    const bool standard = word.before.ends_with("::") && previous == "std";
    if (standard && k_standard.contains(word.text)) return true;
    const bool member = word.before.ends_with(".") || word.before.ends_with("->");
    return k_functions.contains(word.text) && word.behind == '(' && !member;
}

// True for a line `/name/` or `/name*/` of a .gitignore that covers an entry of the root
bool covers(std::string pattern, const std::string& name)
{
    if (pattern.size() < 3 || !pattern.starts_with("/") || !pattern.ends_with("/")) return false;
    pattern = pattern.substr(1, pattern.size() - 2);
    if (pattern.ends_with("*")) return name.starts_with(pattern.substr(0, pattern.size() - 1));
    return name == pattern;
}

} // namespace

bool is_engine(const std::string& module)
{
    return k_engine.contains(module);
}

std::vector<std::string> arrow_faults(const std::vector<Source>& sources)
{
    std::vector<std::string> faults;
    for (const Source& source : sources) {
        if (!k_arrows.contains(source.module)) {
            faults.push_back(source.path + ": belongs to no module of the design");
            continue;
        }
        const std::set<std::string> reached = reach(source.module);
        for (const Include& include : includes(source)) {
            if (!include.quoted) continue;
            const std::string module = include.name.substr(0, include.name.find('/'));
            if (!k_arrows.contains(module) || module == include.name)
                faults.push_back(at(source, include.line) + "\"" + include.name + "\" is not written module/file.hpp");
            else if (!reached.contains(module))
                faults.push_back(at(source, include.line) + "no arrow leads from " + source.module + " to " + module);
        }
    }
    return faults;
}

std::vector<std::string> header_faults(const std::vector<Source>& sources)
{
    std::vector<std::string> faults;
    for (const Source& source : sources) {
        if (!is_engine(source.module)) continue;
        for (const Include& include : includes(source)) {
            const bool allowed = k_headers.contains(include.name) || include.name.starts_with("Eigen/");
            if (include.quoted || allowed) continue;
            faults.push_back(at(source, include.line) + "the engine does without <" + include.name + ">");
        }
    }
    return faults;
}

std::vector<std::string> word_faults(const std::vector<Source>& sources)
{
    std::vector<std::string> faults;
    for (const Source& source : sources) {
        if (!is_engine(source.module)) continue;
        for (std::size_t i = 0; i < source.code.size(); ++i) {
            std::string previous;
            for (const Word& word : words_of(source.code[i])) {
                if (is_forbidden(word, previous))
                    faults.push_back(at(source, static_cast<int>(i) + 1) + "the engine does without '" + word.text +
                                     "'");
                previous = word.text;
            }
        }
    }
    return faults;
}

std::vector<std::string> length_faults(const std::vector<Source>& sources, int most)
{
    std::vector<std::string> faults;
    for (const Source& source : sources) {
        const int length = static_cast<int>(source.lines.size());
        if (length <= most) continue;
        faults.push_back(source.path + ": " + std::to_string(length) + " lines, at most " + std::to_string(most));
    }
    return faults;
}

std::vector<std::string> marker_faults(const std::vector<Source>& sources)
{
    static const std::regex k_marker(R"(^\s*// \[([A-Za-z0-9_.-]+)\]\s*$)");
    std::vector<std::string> faults;
    for (const Source& source : sources) {
        std::map<std::string, std::vector<int>> places;
        for (std::size_t i = 0; i < source.lines.size(); ++i) {
            std::smatch match;
            if (std::regex_match(source.lines[i], match, k_marker))
                places[match[1].str()].push_back(static_cast<int>(i) + 1);
        }
        for (const auto& [name, lines] : places) {
            if (lines.size() == 2) continue;
            faults.push_back(at(source, lines.back()) + "region [" + name + "] has " + std::to_string(lines.size()) +
                             " markers; a region has two");
        }
    }
    return faults;
}

std::vector<std::string> book_faults(const std::vector<Source>& sources, const Book& book)
{
    std::vector<std::string> faults;
    std::set<std::string> there;
    for (const Source& source : sources) {
        there.insert(source.path);
        const auto entry = book.find(source.path);
        const std::size_t chapters = entry == book.end() ? 0 : entry->second.size();
        if (!is_engine(source.module) || chapters == 1) continue;
        faults.push_back(source.path + ": belongs to " + (chapters == 0 ? "no" : std::to_string(chapters)) +
                         " chapters instead of one");
    }
    for (const auto& [path, chapters] : book) {
        if (there.contains(path)) continue;
        faults.push_back("chapters/book.toml: chapter " + std::to_string(chapters.front()) + " lists " + path +
                         ", which isn't there");
    }
    return faults;
}

std::vector<std::string> later_faults(const std::vector<Source>& sources, const Book& book)
{
    std::vector<std::string> faults;
    for (const Source& source : sources) {
        const auto own = book.find(source.path);
        if (!is_engine(source.module) || own == book.end()) continue;
        for (const Include& include : includes(source)) {
            const auto other = book.find("src/" + include.name);
            if (!include.quoted || other == book.end() || other->second.front() <= own->second.front()) continue;
            faults.push_back(at(source, include.line) + "a file of chapter " + std::to_string(own->second.front()) +
                             " includes " + include.name + " of chapter " + std::to_string(other->second.front()));
        }
    }
    return faults;
}

std::vector<std::string> name_faults(const std::vector<Source>& sources)
{
    static const std::regex k_namespace(R"(^namespace (\w+(?:::\w+)*) \{.*)");
    static const std::regex k_type(R"(^(?:enum )?(?:class|struct|union) (\w+(?:::\w+)*)(?: final)?(?: ?:.*)?(?: ?\{.*)?\s*)");
    std::vector<std::string> faults;
    std::map<std::string, std::string> defined; // by the name with its namespace, the first file
    for (const Source& source : sources) {
        if (!source.path.ends_with(".hpp")) continue;
        std::string scope;
        for (std::size_t k = 0; k < source.code.size(); ++k) {
            const std::string& line = source.code[k];
            std::smatch match;
            if (std::regex_match(line, match, k_namespace)) scope = match[1].str();
            if (!std::regex_match(line, match, k_type) || (line.find('{') == std::string::npos && line.ends_with(";")))
                continue;
            const std::string name = scope + "::" + match[1].str();
            const auto [first, is_new] = defined.emplace(name, source.path);
            if (!is_new && first->second != source.path)
                faults.push_back(at(source, static_cast<int>(k) + 1) + name + " is defined in " + first->second +
                                 ", too");
        }
    }
    return faults;
}

std::vector<std::string> top_level_faults(const std::filesystem::path& root)
{
    static const std::set<std::string> k_entries = {
        "CMakeLists.txt", "CMakePresets.json", "README.md", "LICENSE", "course", ".ci",  ".clang-format",
        ".clang-tidy",    "chapters",          "src",       "tests",   "docs",   ".git", ".gitignore"};

    std::vector<std::string> ignored;
    std::ifstream in(root / ".gitignore");
    for (std::string line; std::getline(in, line);) ignored.push_back(line);

    std::vector<std::string> faults;
    for (const auto& entry : std::filesystem::directory_iterator(root)) {
        const std::string name = entry.path().filename().string();
        const bool listed = k_entries.contains(name);
        const bool made = std::any_of(ignored.begin(), ignored.end(),
                                      [&](const std::string& pattern) { return covers(pattern, name); });
        if (!listed && !made) faults.push_back(name + ": the design lists no such file or folder at the top");
    }
    std::sort(faults.begin(), faults.end());
    return faults;
}

} // namespace house
