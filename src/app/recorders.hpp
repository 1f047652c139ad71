#pragma once

// What looks at a world while it runs: the trace, pictures, a video. Each says when it wants to look next, and is then
// shown the world at that time. To look changes nothing.

#include <optional>
#include <string>
#include <vector>

#include "files/output_file.hpp"
#include "app/output_times.hpp"
#include "draw/picture.hpp"
#include "draw/video.hpp"
#include "math/roots.hpp"
#include "world/world.hpp"

namespace flying {

/// Frames of a video for each second of the simulation: it plays in real time.
inline constexpr int k_frames_per_second = 60;

/// The trace: one JSON object a line, {"time": t, "events": n, "bodies": [[x, y, angle, vx, vy, spin], ...]}, bodies in
/// the scene's order.
class TraceRecorder
{
public:
    /// start  no line is for an earlier time  [s]
    /// end    the last line's time, also where it is no multiple of the step  [s]
    TraceRecorder(OutputFile file, double every, double start, double end);

    [[nodiscard]] double next() const;
    [[nodiscard]] std::optional<Fault> look(const World& world);
    [[nodiscard]] OutputFile& file() { return file_; }

private:
    OutputFile file_;
    OutputTimes times_;
    double end_;
    double last_ = -1.0;
};

/// The video: where no box holds the bodies, the view widens as they fly out of it.
class VideoRecorder
{
public:
    /// world  at its start
    /// Faults as `Video::open`.
    [[nodiscard]] static Expected<VideoRecorder> open(OutputFile file, const World& world, double end);

    [[nodiscard]] double next() const { return times_.is_over() ? k_never : times_.next(); }
    [[nodiscard]] std::optional<Fault> look(const World& world);
    /// No more frames.
    [[nodiscard]] std::optional<Fault> finish();
    [[nodiscard]] OutputFile& file() { return file_; }

private:
    VideoRecorder(OutputFile file, Video video, Picture picture, double end);
    OutputFile file_;
    Video video_;
    Picture picture_;
    OutputTimes times_;
};

/// Where bodies were shortly before the end, for the picture. How shortly follows from their speeds, which only the run
/// itself tells: it looks ever more often as the end comes near, until what is left is what trails are to show.
class TrailRecorder
{
public:
    explicit TrailRecorder(double end) : end_(end) {}

    [[nodiscard]] double next() const { return next_; }
    void look(const World& world);
    [[nodiscard]] std::vector<Trail> take() { return std::move(trails_); }

private:
    void start(const World& world);
    double end_;
    double next_ = 0.0;
    double start_ = 0.0; ///< of the samples [s]
    int samples_ = 0;
    int checks_ = 0;
    std::vector<Trail> trails_;
};

} // namespace flying
