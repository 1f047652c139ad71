#include "app/messages.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>

#include "scene/fault.hpp"
#include "scene/read.hpp"
#include "world/plan.hpp"

namespace flying {

void complain(const std::string& text)
{
    fmt::print(stderr, "flying: {}\n", text);
}

void complain(const Faults& faults)
{
    std::fputs(format_faults(faults).c_str(), stderr);
}

std::optional<Scene> read_scene_or_complain(const std::string& path)
{
    Expected<Scene> scene = read_scene_file(path);
    if (!scene) {
        complain(scene.faults());
        return std::nullopt;
    }
    return std::move(scene).value();
}

bool are_skip_names(const std::vector<std::string>& names)
{
    const std::vector<std::string> known = skip_names();
    for (const std::string& name : names) {
        if (std::find(known.begin(), known.end(), name) != known.end()) continue;
        const std::string near = nearest_word(name, known);
        complain(fmt::format("--without {}: no such skip{} (there are: {})", name,
                             near.empty() ? "" : fmt::format("; did you mean {}?", near), fmt::join(known, ", ")));
        return false;
    }
    return true;
}

std::string counted(long count, const std::string& one, const std::string& many)
{
    return fmt::format("{} {}", count, count == 1 ? one : many);
}

} // namespace flying
