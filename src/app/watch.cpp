#include <fmt/format.h>

#include <charconv>
#include <string_view>

#include "app/commands.hpp"
#include "app/messages.hpp"
#ifdef FLYING_WINDOW
#include "window/window.hpp"
#endif

namespace flying {

#ifdef FLYING_WINDOW

namespace {

/// A whole number of pixels, or 0 where the text is none from 200 to 10000.
int pixels(std::string_view text)
{
    int value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    return error == std::errc() && end == text.data() + text.size() && value >= 200 && value <= 10000 ? value : 0;
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
    std::optional<Scene> scene = read_scene_or_complain(wanted.scene);
    if (!scene) return status::k_usage;
    Expected<Stage> stage = Stage::open(std::move(*scene));
    if (!stage) {
        complain(stage.faults());
        return status::k_usage;
    }
    stage.value().look.is_dark = options.is_dark;
    stage.value().clock.is_paused = options.is_paused;
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
