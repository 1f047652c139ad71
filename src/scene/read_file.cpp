// A scene from a file.

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "scene/read.hpp"

namespace flying {

Expected<Scene> read_scene_file(const std::string& path, SceneMender mend)
{
    const std::string expected = "a scene file";
    std::error_code error;
    const std::filesystem::file_status status = std::filesystem::status(path, error);
    if (!std::filesystem::exists(status)) {
        const bool missing = !error || error == std::errc::no_such_file_or_directory;
        return Fault{path, missing ? "no such file" : error.message(), expected};
    }
    if (std::filesystem::is_directory(status)) return Fault{path, "a directory", expected};

    errno = 0;
    std::ifstream file(path, std::ios::binary);
    if (!file) return Fault{path, "a file that can't be opened (" + std::string(std::strerror(errno)) + ")", expected};

    // Read piece by piece: a pipe doesn't know its length, and what never ends must not fill the memory
    std::string text;
    std::string piece(std::size_t{1} << 16, '\0');
    while (file && text.size() <= k_largest_scene) {
        file.read(piece.data(), static_cast<std::streamsize>(piece.size()));
        text.append(piece, 0, static_cast<std::size_t>(file.gcount()));
    }
    if (file.bad()) return Fault{path, "a file that can't be read to its end", expected};
    return read_scene_text(text, path, mend);
}

} // namespace flying
