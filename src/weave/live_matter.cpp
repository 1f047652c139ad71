#include "weave/live_matter.hpp"

#include <algorithm>
#include <cstdlib>
#include <map>
#include <sstream>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "weave/text.hpp"

namespace flying::weave {

namespace {

namespace fs = std::filesystem;
using nlohmann::json;

/// The scripts that every page loads as one, in this order.
constexpr const char* k_common[] = {"engine.js",     "live/unpack.js",    "live/toml.js",
                                    "live/stage.js", "live/recording.js", "live/controls.js",
                                    "live/hands.js", "live/check.js",     "live/figure.js"};
/// Those of one page each.
constexpr const char* k_single[] = {"front.js", "playground.js"};

void write(const fs::path& file, const std::string& text, Problems& problems)
{
    if (!write_file(file, text))
        problems.add({file.string(), 0}, "a file that can't be written", "a folder to write to");
}

/// A page needs no line that is nothing but a comment, and no indents. A text between backticks stays as it is.
std::string without_indents(const std::string& script)
{
    std::string out;
    bool is_in_text = false;
    std::istringstream lines(script);
    for (std::string line; std::getline(lines, line);) {
        const std::size_t first = is_in_text ? 0 : line.find_first_not_of(' ');
        if (!is_in_text && (first == std::string::npos || line.compare(first, 2, "//") == 0)) continue;
        out += line.substr(first) + "\n";
        if (std::count(line.begin(), line.end(), '`') % 2 != 0) is_in_text = !is_in_text;
    }
    return out;
}

void write_scripts(const Woven& woven, const Folders& folders, const fs::path& html, Problems& problems)
{
    const fs::path theme = folders.kit / "theme";
    std::string common;
    for (const char* name : k_common) {
        const std::optional<std::string> script = read_file(theme / name);
        if (script) common += without_indents(*script);
        else problems.add({std::string("theme/") + name, 0}, "no such script", "the theme's scripts");
    }
    write(html / "live.js", common, problems);
    for (const char* name : k_single)
        write(html / "live" / name, read_file(theme / "live" / name).value_or(""), problems);
    for (const Chapter& chapter : woven.material.chapters) {
        const std::optional<std::string> script = read_file(folders.project / chapter.entry.folder() / "live.js");
        if (script) write(html / "live" / (chapter.entry.name + ".js"), without_indents(*script), problems);
    }
}

/// The course's scenes, for the playground.
void write_scenes(const Folders& folders, const fs::path& html, Problems& problems)
{
    std::map<std::string, std::string> scenes;
    std::error_code error;
    for (const auto& file : fs::directory_iterator(folders.project / "chapters/scenes", error))
        if (file.path().extension() == ".toml")
            scenes[file.path().stem().string()] = read_file(file.path()).value_or("");
    const auto script = [](const std::map<std::string, std::string>& some) {
        return fmt::format("window.flyingScenes = {};\n", json(some).dump());
    };
    write(html / "live/scenes.js", script(scenes), problems);

    // The first page shows but one
    const auto shown = scenes.find("balls-and-polygons");
    if (shown != scenes.end()) write(html / "live/front-scene.js", script({*shown}), problems);
}

void write_module(const Folders& folders, const Tools& tools, const fs::path& html, Problems& problems)
{
    if (tools.module.empty() || !fs::exists(tools.module)) return;
    const std::string command =
        fmt::format("{} '{}' '{}' > '{}'", tools.node, (folders.kit / "pack_module.js").string(), tools.module,
                    (html / "live/module.js").string());
    if (std::system(command.c_str()) != 0)
        problems.add({"pack_module.js", 0}, "a module that could not be packed", "node, xz, and the engine's module");
}

void write_recordings(const Woven& woven, const fs::path& html, Problems& problems)
{
    for (const Chapter& chapter : woven.material.chapters) {
        for (const ChapterText* text : texts_of(chapter)) {
            for (const Block& block : text->blocks) {
                if (block.kind != BlockKind::live) continue;
                const std::string name = chapter.entry.name + "/" + block.name;
                const std::string trace =
                    read_file(drawn_file(woven.material, chapter, block.name + ".ndjson")).value_or("");
                write(html / "traces" / (name + ".js"),
                      fmt::format("(window.flyingTraces = window.flyingTraces || {{}})[\"{}\"] = [\n{}\n];\n", name,
                                  join(split_lines(trace), ",\n")),
                      problems);
            }
        }
    }
}

} // namespace

void copy_live_matter(const Woven& woven, const Folders& folders, const Tools& tools, const fs::path& html,
                      Problems& problems)
{
    std::error_code error;
    fs::create_directories(html / "live", error);
    write_scripts(woven, folders, html, problems);
    write_scenes(folders, html, problems);
    write_module(folders, tools, html, problems);
    write_recordings(woven, html, problems);
    const fs::path still = folders.project / "docs/images/balls-and-polygons.png";
    if (fs::exists(still)) {
        fs::create_directories(html / "images", error);
        fs::copy_file(still, html / "images/balls-and-polygons.png", fs::copy_options::overwrite_existing, error);
        if (error) problems.add({still.string(), 0}, error.message(), "a file to copy into the book");
    }
}

std::string live_script(const Folders& folders, const ChapterEntry& entry)
{
    if (!fs::exists(folders.project / entry.folder() / "live.js")) return "";
    return fmt::format("<script src=\"live/{}.js\" defer></script>", entry.name);
}

std::string front_figure()
{
    // The picture is for readers without scripts or engine only: it weighs as much as all letters of a page
    return "<figure class=\"live front\" data-trace=\"front\" data-recorded=\"no\" "
           "data-still=\"images/balls-and-polygons.png\">"
           "<noscript><img class=\"still\" src=\"images/balls-and-polygons.png\" alt=\"Balls and polygons fly about in "
           "a box between fixed wedges\"><style>figure.front canvas { display: none; }</style></noscript><canvas "
           "role=\"img\" aria-label=\"Balls and polygons fly about in a box between fixed wedges, moved by the "
           "course's own engine\"></canvas><figcaption>The simulator that this course explains, running in your "
           "browser. Grab a body and throw it.</figcaption></figure>"
           "<script src=\"live/front-scene.js\" defer></script><script src=\"live/front.js\" defer></script>";
}

std::string playground_figure()
{
    return "<figure class=\"live playground\" data-trace=\"playground\" data-recorded=\"no\"><canvas role=\"img\" "
           "aria-label=\"The scene below in motion\"></canvas><figcaption>Bodies can be grabbed and "
           "thrown.</figcaption>"
           "<noscript>The playground needs scripts.</noscript></figure>"
           "<script src=\"live/scenes.js\" defer></script><script src=\"live/playground.js\" defer></script>";
}

} // namespace flying::weave
