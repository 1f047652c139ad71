#include "draw/video.hpp"

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <spawn.h>
#include <sstream>
#include <string_view>
#include <sys/wait.h>
#include <unistd.h>
#include <utility>
#include <vector>

namespace flying {

struct Video::Parts
{
    std::string path;
    cairo_surface_t* surface = nullptr;
    cairo_t* cairo = nullptr;
    SurfaceSize size;
    Theme theme;
    int pipe = -1;                ///< our end; -1 once closed
    pid_t process = -1;           ///< ffmpeg; -1 once waited for
    std::FILE* sayings = nullptr; ///< what ffmpeg says, a file without a name

    Parts() = default;
    Parts(const Parts&) = delete;
    Parts& operator=(const Parts&) = delete;
    ~Parts();

    void close_pipe();
    /// Wait for ffmpeg's end; true where all went well.
    bool wait();
    [[nodiscard]] std::string sayings_so_far() const;
    /// The last line that ffmpeg said.
    [[nodiscard]] std::string last_words() const;
};

Video::Parts::~Parts()
{
    if (process > 0) {
        kill(process, SIGKILL);
        wait();
    }
    close_pipe();
    if (sayings) std::fclose(sayings);
    cairo_destroy(cairo);
    cairo_surface_destroy(surface);
}

void Video::Parts::close_pipe()
{
    if (pipe >= 0) close(pipe);
    pipe = -1;
}

bool Video::Parts::wait()
{
    int status = 0;
    pid_t ended = -1;
    do ended = waitpid(process, &status, 0);
    while (ended < 0 && errno == EINTR);
    process = -1;
    return ended > 0 && WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

std::string Video::Parts::sayings_so_far() const
{
    std::string text(4096, '\0');
    std::fseek(sayings, 0, SEEK_SET);
    text.resize(std::fread(text.data(), 1, text.size(), sayings));
    return text;
}

std::string Video::Parts::last_words() const
{
    // Indented lines only count repetitions
    std::string last;
    std::istringstream lines(sayings_so_far());
    for (std::string line; std::getline(lines, line);) {
        if (!line.empty() && line.front() != ' ') last = line;
    }
    // A part of ffmpeg and its address come first on some lines: "[mp4 @ 0x55d0] "
    if (const auto end = last.find("] "); last.starts_with('[') && end != std::string::npos) last.erase(0, end + 2);
    // The caller knows the file, perhaps by a better name
    const std::string name = "file:" + path;
    if (const auto at = last.find(name); at != std::string::npos) last.replace(at, name.size(), "the video");
    return last.empty() ? "it gave no reason" : last;
}

namespace {

/// The end of the name of `program` in a folder of PATH; empty where there is none.
std::string found_in_path(std::string_view program)
{
    const char* path = std::getenv("PATH");
    std::string_view rest = path ? path : "/usr/bin:/bin";
    while (true) {
        const std::size_t end = rest.find(':');
        const std::string candidate = std::string(rest.substr(0, end)) + "/" + std::string(program);
        if (access(candidate.c_str(), X_OK) == 0) return candidate;
        if (end == std::string_view::npos) return {};
        rest.remove_prefix(end + 1);
    }
}

std::vector<std::string> ffmpeg_arguments(const std::string& path, SurfaceSize size, int frames_per_second)
{
    const std::string geometry = std::to_string(size.width) + "x" + std::to_string(size.height);
    // Without "file:", a name such as "a:b.mp4" would be taken for a protocol
    return {"ffmpeg",
            "-hide_banner",
            "-loglevel",
            "error",
            "-nostdin",
            "-y",
            "-f",
            "rawvideo",
            "-pixel_format",
            "bgr0",
            "-video_size",
            geometry,
            "-framerate",
            std::to_string(frames_per_second),
            "-i",
            "pipe:0",
            "-an",
            "-c:v",
            "libx264",
            "-preset",
            "veryfast",
            "-crf",
            "20",
            "-pix_fmt",
            "yuv420p",
            "-movflags",
            "+faststart",
            "-f",
            "mp4",
            "file:" + path};
}

/// Start `program` with its standard input from `input` and its messages to `errors`; 0 and the process, or errno.
int start(const std::string& program, const std::vector<std::string>& arguments, int input, int errors, pid_t& process)
{
    posix_spawn_file_actions_t files;
    posix_spawn_file_actions_init(&files);
    posix_spawn_file_actions_adddup2(&files, input, STDIN_FILENO);
    posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_adddup2(&files, errors, STDERR_FILENO);

    // A group of its own: Ctrl-C is for this program, which then ends ffmpeg itself
    posix_spawnattr_t attributes;
    posix_spawnattr_init(&attributes);
    posix_spawnattr_setpgroup(&attributes, 0);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);

    std::vector<char*> argv;
    for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
    argv.push_back(nullptr);
    const int error = posix_spawn(&process, program.c_str(), &files, &attributes, argv.data(), environ);
    posix_spawnattr_destroy(&attributes);
    posix_spawn_file_actions_destroy(&files);
    return error;
}

} // namespace

Expected<Video> Video::open(const std::string& path, SurfaceSize size, int frames_per_second, const Theme& theme)
{
    const std::string program = found_in_path("ffmpeg");
    if (program.empty()) {
        return Fault{"", "no program ffmpeg on this machine", "ffmpeg, which writes the video (apt install ffmpeg)"};
    }
    auto parts = std::make_unique<Parts>();
    parts->path = path;
    parts->size = size;
    parts->theme = theme;
    parts->surface = cairo_image_surface_create(CAIRO_FORMAT_RGB24, size.width, size.height);
    parts->cairo = cairo_create(parts->surface);
    parts->sayings = std::tmpfile();
    int ends[2] = {-1, -1};
    if (!parts->sayings || pipe2(ends, O_CLOEXEC) != 0) return Fault{"", std::strerror(errno), ""};

    parts->pipe = ends[1];
    const int error = start(program, ffmpeg_arguments(path, size, frames_per_second), ends[0], fileno(parts->sayings),
                            parts->process);
    close(ends[0]);
    if (error != 0) {
        parts->process = -1;
        return Fault{"", "ffmpeg does not start: " + std::string(std::strerror(error)), ""};
    }
    return Video(std::move(parts));
}

Video::Video(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
Video::Video(Video&&) noexcept = default;
Video& Video::operator=(Video&&) noexcept = default;
Video::~Video() = default;

std::optional<Fault> Video::add_frame(const Picture& picture)
{
    paint(parts_->cairo, picture, parts_->size, parts_->theme);
    cairo_surface_flush(parts_->surface);
    const unsigned char* next = cairo_image_surface_get_data(parts_->surface);
    if (!next) return Fault{"", cairo_status_to_string(cairo_surface_status(parts_->surface)), ""};

    std::size_t left = static_cast<std::size_t>(cairo_image_surface_get_stride(parts_->surface)) *
                       static_cast<std::size_t>(parts_->size.height);
    while (left > 0) {
        const ssize_t written = write(parts_->pipe, next, left);
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) {
            parts_->close_pipe();
            parts_->wait();
            return Fault{"", "ffmpeg has stopped: " + parts_->last_words(), ""};
        }
        next += written;
        left -= static_cast<std::size_t>(written);
    }
    return std::nullopt;
}

std::optional<Fault> Video::finish()
{
    parts_->close_pipe();
    // On a full disk ffmpeg 5 complains, leaves half a file, and still ends with status 0
    if (parts_->process > 0 && parts_->wait() && parts_->sayings_so_far().empty()) return std::nullopt;
    return Fault{"", "ffmpeg could not finish: " + parts_->last_words(), ""};
}

} // namespace flying
