#include <fstream>
#include <iterator>
#include <optional>
#include <regex>

#include "house.hpp"

namespace house {

namespace {

/// The name that a line at the top of a file declares or defines: of a type, or of a function. Lines that are indented
/// use names.
std::optional<std::string> declared_by(const std::string& line)
{
    static const std::regex k_type(R"(^(?:struct|class|enum class) (?:alignas\(\d+\) )?(\w+).*)");
    static const std::regex k_function(R"(^[A-Za-z\[][^(=]*[ &*>](\w+)\(.*)");
    std::smatch match;
    if (std::regex_match(line, match, k_type) || std::regex_match(line, match, k_function)) return match[1].str();
    return std::nullopt;
}

/// Every name in a line but the one that it declares.
void add_used(const std::string& line, std::set<std::string>& used)
{
    static const std::regex k_name(R"([A-Za-z_]\w*)");
    std::optional<std::string> own = declared_by(line);
    for (std::sregex_iterator at(line.begin(), line.end(), k_name), end; at != end; ++at) {
        if (own && at->str() == *own) own.reset();
        else used.insert(at->str());
    }
}

} // namespace

std::vector<std::string> reach_faults(const std::vector<Source>& sources, const std::set<std::string>& installed)
{
    std::set<std::string> used;
    for (const Source& source : sources)
        for (const std::string& line : source.code) add_used(line, used);

    std::vector<std::string> faults;
    for (const Source& source : sources) {
        if (!source.path.ends_with(".hpp") || installed.contains(source.path)) continue;
        for (std::size_t k = 0; k < source.code.size(); ++k) {
            const std::optional<std::string> name = declared_by(source.code[k]);
            if (name && !used.contains(*name))
                faults.push_back(source.path + ":" + std::to_string(k + 1) + ": nothing in src uses " + *name);
        }
    }
    return faults;
}

std::set<std::string> installed_headers(const std::filesystem::path& root, const std::vector<Source>& sources)
{
    std::map<std::string, const Source*> by_path;
    for (const Source& source : sources) by_path[source.path] = &source;

    // The list between `set(FLYING_PUBLIC_HEADERS` and the bracket
    std::ifstream in(root / "src/public_headers.cmake");
    const std::string text{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
    const std::size_t start = text.find("set(FLYING_PUBLIC_HEADERS");
    if (start == std::string::npos) return {};
    const std::string list = text.substr(start, text.find(')', start) - start);
    static const std::regex k_header(R"(\S+\.hpp)");
    std::vector<std::string> waiting;
    for (std::sregex_iterator at(list.begin(), list.end(), k_header), end; at != end; ++at)
        waiting.push_back("src/" + at->str());

    std::set<std::string> found;
    while (!waiting.empty()) {
        const std::string path = waiting.back();
        waiting.pop_back();
        if (!by_path.contains(path) || !found.insert(path).second) continue;
        for (const Include& include : includes(*by_path[path]))
            if (include.quoted) waiting.push_back("src/" + include.name);
    }
    return found;
}

} // namespace house
