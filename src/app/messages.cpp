#include "app/messages.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>

#include "scene/fault.hpp"
#include "scene/read.hpp"
#include "world/make_room.hpp"
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

namespace {

/// Moves bodies apart that overlap by their last digits, and says how far.
bool make_room_and_say_so(Scene& scene)
{
    const Scene typed = scene;
    if (!make_room_for_digits(scene)) return false;
    double farthest = 0.0;
    long moved = 0;
    for (std::size_t k = 0; k < scene.bodies.size(); ++k) {
        const double way = (scene.bodies[k].position - typed.bodies[k].position).norm();
        farthest = std::max(farthest, way);
        moved += way > 0.0;
    }
    complain(fmt::format("bodies overlap by their last digits: moved {} of them apart, by {:.2g} m at most", moved,
                         farthest));
    return true;
}

} // namespace

std::optional<Scene> read_scene_or_complain(const std::string& path)
{
    Expected<Scene> scene = read_scene_file(path, make_room_and_say_so);
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
