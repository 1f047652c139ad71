#include "window/recorder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <utility>

#include "play/state.hpp"

namespace flying {

namespace {

constexpr int k_frames_per_second = 60;

std::optional<Fault> complete(OutputFile& file)
{
    if (std::optional<Fault> fault = file.finish()) return fault;
    return file.commit();
}

} // namespace

Expected<std::string> Recorder::toggle_video(const std::string& path, SurfaceSize size)
{
    if (video_) {
        Film film = std::move(*video_);
        video_.reset();
        if (std::optional<Fault> fault = film.video.finish()) return *fault;
        if (std::optional<Fault> fault = complete(film.file)) return *fault;
        return fmt::format("{}: {} frames", film.file.path(), film.frames);
    }
    Expected<OutputFile> file = OutputFile::open(path);
    if (!file) return file.faults();
    const SurfaceSize even{std::max(2, size.width / 2 * 2), std::max(2, size.height / 2 * 2)};
    Expected<Video> video = Video::open(file.value().temporary_path(), even, k_frames_per_second);
    if (!video) return video.faults();
    video_.emplace(Film{std::move(file).value(), std::move(video).value()});
    return "Recording " + path + "; F6 ends it";
}

Expected<std::string> Recorder::toggle_trace(const std::string& path)
{
    if (trace_) {
        OutputFile file = std::move(*trace_);
        trace_.reset();
        if (std::optional<Fault> fault = complete(file)) return *fault;
        return fmt::format("{}: {} lines", file.path(), std::exchange(lines_, 0));
    }
    Expected<OutputFile> file = OutputFile::open(path);
    if (!file) return file.faults();
    trace_.emplace(std::move(file).value());
    return "Tracing to " + path + "; F7 ends it";
}

std::vector<Expected<std::string>> Recorder::finish()
{
    std::vector<Expected<std::string>> outcomes;
    if (video_) outcomes.push_back(toggle_video({}, {}));
    if (trace_) outcomes.push_back(toggle_trace({}));
    return outcomes;
}

std::optional<Fault> Recorder::add(const Stage& stage, cairo_surface_t* surface, double wall)
{
    if (video_ && surface) video_->owed += std::min(wall, k_longest_wall);
    while (video_ && surface && video_->owed * k_frames_per_second >= 0.5) {
        video_->owed -= 1.0 / k_frames_per_second;
        ++video_->frames;
        if (std::optional<Fault> fault = video_->video.add_surface(surface)) {
            video_.reset();
            return fault;
        }
    }
    if (trace_) {
        ++lines_;
        if (std::optional<Fault> fault = trace_->write(trace_line(stage))) {
            trace_.reset();
            return fault;
        }
    }
    return std::nullopt;
}

std::optional<Fault> write_whole(const std::string& path, const std::string& text)
{
    Expected<OutputFile> file = OutputFile::open(path);
    if (!file) return file.faults().front();
    if (std::optional<Fault> fault = file.value().write(text)) return fault;
    return complete(file.value());
}

std::string free_name(const std::string& stem, const std::string& ending)
{
    std::string name = stem + ending;
    std::error_code ignored;
    for (int k = 2; std::filesystem::exists(name, ignored); ++k) name = fmt::format("{}-{}{}", stem, k, ending);
    return name;
}

} // namespace flying
