#include "module_map.hpp"

#include <map>
#include <set>

namespace house {

namespace {

using Arrows = std::map<std::string, std::set<std::string>>;

/// Whether arrows lead from a module to another, past at least one more.
bool is_round_about(const Arrows& arrows, const std::string& from, const std::string& to)
{
    std::set<std::string> seen;
    std::vector<std::string> waiting;
    for (const std::string& next : arrows.at(from))
        if (next != to) waiting.push_back(next);
    while (!waiting.empty()) {
        const std::string module = waiting.back();
        waiting.pop_back();
        if (!seen.insert(module).second) continue;
        if (module == to) return true;
        waiting.insert(waiting.end(), arrows.at(module).begin(), arrows.at(module).end());
    }
    return false;
}

} // namespace

std::string module_map(const std::vector<Source>& sources)
{
    Arrows arrows;
    for (const Source& source : sources) {
        if (source.module.empty()) continue;
        arrows[source.module];
        for (const Include& include : includes(source)) {
            const std::string module = include.name.substr(0, include.name.find('/'));
            if (!include.quoted || module == include.name || module == source.module) continue;
            arrows[source.module].insert(module);
            arrows[module];
        }
    }
    std::string text = "flowchart TD\n    subgraph engine\n";
    for (const auto& [module, others] : arrows)
        if (is_engine(module)) text += "        " + module + "\n";
    text += "    end\n";
    for (const auto& [module, others] : arrows) {
        for (const std::string& other : others)
            if (!is_round_about(arrows, module, other)) text += "    " + module + " --> " + other + "\n";
        if (others.empty() && !is_engine(module)) text += "    " + module + "\n";
    }
    return text;
}

std::optional<MapPlace> find_map(const std::string& page)
{
    const std::string opening = "```mermaid\n";
    const std::size_t fence = page.find(opening);
    if (fence == std::string::npos) return std::nullopt;
    const std::size_t begin = fence + opening.size();
    const std::size_t end = page.find("```", begin);
    if (end == std::string::npos) return std::nullopt;
    return MapPlace{begin, end};
}

} // namespace house
