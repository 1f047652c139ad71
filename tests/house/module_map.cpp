#include "module_map.hpp"

#include <algorithm>
#include <map>
#include <set>

namespace house {

namespace {

using Arrows = std::map<std::string, std::set<std::string>>;

/// The name that a header and its source have in common: "island".
std::string unit_of(const std::string& path)
{
    const std::size_t begin = path.rfind('/') + 1;
    return path.substr(begin, path.rfind('.') - begin);
}

/// All that arrows lead to from some start.
std::set<std::string> reached(const Arrows& arrows, const std::set<std::string>& start)
{
    std::set<std::string> seen;
    std::vector<std::string> waiting(start.begin(), start.end());
    while (!waiting.empty()) {
        const std::string one = waiting.back();
        waiting.pop_back();
        if (!seen.insert(one).second) continue;
        waiting.insert(waiting.end(), arrows.at(one).begin(), arrows.at(one).end());
    }
    return seen;
}

/// Whether arrows lead from one to another past at least one more that is in a ring with neither.
bool is_round_about(const Arrows& arrows, const std::string& from, const std::string& to)
{
    const auto leads = [&](const std::string& a, const std::string& b) { return reached(arrows, {a}).contains(b); };
    if (leads(to, from)) return false;
    std::set<std::string> others = arrows.at(from);
    std::erase_if(others, [&](const std::string& next) { return leads(next, from) || leads(to, next); });
    return reached(arrows, others).contains(to);
}

/// A line for each arrow that doesn't follow from others.
std::string lines_of(const Arrows& arrows)
{
    std::string text;
    for (const auto& [from, others] : arrows) {
        for (const std::string& to : others)
            if (!is_round_about(arrows, from, to)) text += "    " + from + " --> " + to + "\n";
    }
    return text;
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
    for (const auto& [module, others] : arrows)
        if (others.empty() && !is_engine(module)) text += "    " + module + "\n";
    return text + lines_of(arrows);
}

std::string file_map(const std::vector<Source>& sources, const std::string& module)
{
    Arrows arrows;
    for (const Source& source : sources) {
        if (source.module != module) continue;
        const std::string unit = unit_of(source.path);
        arrows[unit];
        for (const Include& include : includes(source)) {
            const std::string other = unit_of(include.name);
            if (!include.quoted || !include.name.starts_with(module + "/") || other == unit) continue;
            arrows[unit].insert(other);
            arrows[other];
        }
    }
    return "flowchart LR\n" + lines_of(arrows);
}

std::optional<MapPlace> find_map(const std::string& page, const std::string& heading)
{
    const std::string opening = "```mermaid\n";
    const std::size_t fence = page.find(opening, std::min(page.find(heading), page.size()));
    if (fence == std::string::npos) return std::nullopt;
    const std::size_t begin = fence + opening.size();
    const std::size_t end = page.find("```", begin);
    if (end == std::string::npos) return std::nullopt;
    return MapPlace{begin, end};
}

} // namespace house
