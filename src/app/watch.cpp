// The command `watch`: a window that plays scenes.

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <string_view>

#include "app/commands.hpp"
#include "app/messages.hpp"
#ifdef FLYING_WINDOW
#include "files/interrupt.hpp"
#include "window/window.hpp"
#endif

namespace flying {

#ifdef FLYING_WINDOW

namespace {

constexpr std::size_t k_most_scenes = 200; ///< to choose from

/// A whole number of pixels, or 0 where the text is none from 200 to 10000.
int pixels(std::string_view text)
{
    int value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    return error == std::errc() && end == text.data() + text.size() && value >= 200 && value <= 10000 ? value : 0;
}

/// Scenes to choose from: the one that is opened, its neighbours, and those of the course.
std::vector<std::string> scenes_near(const std::string& scene)
{
    namespace fs = std::filesystem;
    std::vector<std::string> all{scene};
    std::error_code ignored;
    for (const fs::path& folder : {fs::absolute(scene, ignored).parent_path(), fs::path(FLYING_SCENES)}) {
        std::vector<std::string> found;
        for (const fs::directory_entry& entry : fs::directory_iterator(folder, ignored)) {
            if (entry.path().extension() == ".toml") found.push_back(entry.path().string());
        }
        std::sort(found.begin(), found.end());
        for (const std::string& path : found) {
            const auto is_same = [&](const std::string& other) { return fs::equivalent(path, other, ignored); };
            if (all.size() < k_most_scenes && std::none_of(all.begin(), all.end(), is_same)) all.push_back(path);
        }
    }
    return all;
}

} // namespace

int watch(const WatchOptions& options)
{
    WindowOptions wanted;
    wanted.state = options.state;
    if (!options.size.empty()) {
        const std::string_view size = options.size;
        const std::size_t cross = size.find('x');
        wanted.width = pixels(size.substr(0, cross));
        wanted.height = cross == std::string_view::npos ? 0 : pixels(size.substr(cross + 1));
        if (wanted.width == 0 || wanted.height == 0) {
            complain(fmt::format("--size: found {}, expected two numbers from 200 to 10000 such as 1280x800", options.size));
            return status::k_usage;
        }
    }
    wanted.scene = options.scene.empty() ? FLYING_SCENES "/balls-and-polygons.toml" : options.scene;
    wanted.scenes = scenes_near(wanted.scene);
    wanted.face = options.face;
    wanted.has_panel = !options.is_bare;
    std::optional<Scene> scene = read_scene_or_complain(wanted.scene);
    if (!scene) return status::k_usage;
    Expected<Stage> stage = Stage::open(std::move(*scene));
    if (!stage) {
        complain(stage.faults());
        return status::k_usage;
    }
    stage.value().look.is_dark = options.is_dark;
    stage.value().clock.is_paused = options.is_paused;
    watch_for_interrupts();
    return run_window(std::move(stage).value(), wanted);
}

#else

int watch(const WatchOptions&)
{
    complain("this build has no window: gtkmm 4 was missing when it was made (on Debian: apt install libgtkmm-4.0-dev, then "
             "build again; ./course play does both). flying simulate SCENE --picture FILE.png or --video FILE.mp4 go without");
    return status::k_usage;
}

#endif

} // namespace flying
