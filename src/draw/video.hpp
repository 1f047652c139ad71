#pragma once

#include <memory>
#include <optional>
#include <string>

#include "draw/paint.hpp"
#include "math/expected.hpp"

namespace flying {

/// Frames of a video, drawn one after another and piped raw into ffmpeg, which writes an MP4 file (H.264).
class Video
{
public:
    /// Start ffmpeg.
    ///
    /// path               file to write, replaced where it exists; the caller takes it away where a video fails
    /// size               of all frames, both sides even
    /// frames_per_second  of play, > 0
    ///
    /// Faults: no ffmpeg on this machine; no process or pipe to be had.
    [[nodiscard]] static Expected<Video> open(const std::string& path, SurfaceSize size, int frames_per_second,
                                              const Theme& theme = paper_theme());

    Video(Video&&) noexcept;
    Video& operator=(Video&&) noexcept;
    /// An unfinished video is given up: ffmpeg is stopped, what the file holds is worth nothing.
    ~Video();

    /// Draw one frame more. SIGPIPE must be ignored by the program. Fault: ffmpeg has stopped, and what it said.
    [[nodiscard]] std::optional<Fault> add_frame(const Picture& picture);

    /// The same of a picture that is drawn already; what lies outside the frame's size is cut off.
    [[nodiscard]] std::optional<Fault> add_surface(cairo_surface_t* surface);

    /// No more frames: wait for ffmpeg to end the file. Fault: it could not, and what it said.
    [[nodiscard]] std::optional<Fault> finish();

private:
    struct Parts;
    [[nodiscard]] std::optional<Fault> send_frame();
    explicit Video(std::unique_ptr<Parts> parts);
    std::unique_ptr<Parts> parts_;
};

} // namespace flying
