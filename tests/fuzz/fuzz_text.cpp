#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "fuzz/promise.hpp"
#include "scene/fault.hpp"
#include "scene/generate_words.hpp"
#include "scene/read.hpp"
#include "scene/write.hpp"
#include "world/world.hpp"

// Any bytes as a scene file, and as the words of `flying generate`: a scene that can be run and written, or faults.

namespace flying::fuzz {

namespace {

void try_scene(std::string_view text)
{
    const Expected<Scene> scene = read_scene_text(text, "scene.toml");
    if (!scene) {
        promise(!scene.faults().empty(), "what is no scene has faults");
        for (const Fault& fault : scene.faults()) {
            const std::string line = format_fault(fault);
            promise(line.starts_with("scene.toml"), "a fault names its file", line);
            promise(line.find('\n') == std::string::npos, "a fault is one line", line);
        }
        return;
    }

    // What was written reads back to the same
    const std::string written = write_scene(scene.value());
    const Expected<Scene> again = read_scene_text(written, "written");
    promise(again.has_value(), "a scene that is written can be read", again ? "" : format_faults(again.faults()));
    promise(write_scene(again.value()) == written, "a scene is written the same again");
    promise(World::make(scene.value()).has_value(), "a scene that was read makes a world");
}

void try_words(std::string_view words)
{
    const Expected<std::string> scene = generate_from_words(words);
    if (!scene) {
        promise(!scene.faults().empty(), "what generates no scene has faults");
        return;
    }
    promise(read_scene_text(scene.value(), "generated").has_value(), "a generated scene can be read");
}

} // namespace

} // namespace flying::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    constexpr std::string_view k_words = "generate ";
    if (!text.starts_with(k_words)) {
        flying::fuzz::try_scene(text);
    } else if (size < 200) {
        flying::fuzz::try_words(text.substr(k_words.size()));
    }
    return 0;
}
