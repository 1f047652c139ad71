#pragma once

#include <optional>
#include <string>
#include <vector>

#include "draw/video.hpp"
#include "files/output_file.hpp"
#include "play/stage.hpp"

namespace flying {

/// What is recorded while a scene is played. Files take their names when a record is ended.
class Recorder
{
public:
    [[nodiscard]] bool is_filming() const { return video_.has_value(); }
    [[nodiscard]] long frames() const { return video_ ? video_->frames : 0; } ///< of the present film
    [[nodiscard]] bool is_tracing() const { return trace_.has_value(); }

    /// Begin, or end; what to tell of it. Faults as `OutputFile` and `Video` have them.
    [[nodiscard]] Expected<std::string> toggle_video(const std::string& path, SurfaceSize size);
    [[nodiscard]] Expected<std::string> toggle_trace(const std::string& path);

    /// End what is being recorded, as when the window goes: for each file, what was written or why not.
    [[nodiscard]] std::vector<Expected<std::string>> finish();
    /// What is seen now, where anything is recorded. A record that can't go on is given up: its fault.
    /// wall  since the last call: a film has as many frames of it as keep its pace, whatever that of the display [s]
    [[nodiscard]] std::optional<Fault> add(const Stage& stage, cairo_surface_t* surface, double wall);

private:
    struct Film
    {
        OutputFile file;
        Video video;
        long frames = 0;
        double owed = 0.0; ///< time that no frame shows yet [s]
    };
    std::optional<Film> video_;
    std::optional<OutputFile> trace_;
    long lines_ = 0;
};

/// A file written at once, whole or not at all.
[[nodiscard]] std::optional<Fault> write_whole(const std::string& path, const std::string& text);

/// A name in the present folder that is free: "STEM.ENDING", "STEM-2.ENDING", ...
[[nodiscard]] std::string free_name(const std::string& stem, const std::string& ending);

} // namespace flying
