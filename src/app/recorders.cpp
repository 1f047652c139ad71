#include "app/recorders.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace flying {

namespace {

constexpr int k_video_size = 1080;     ///< longer side [pixels]
constexpr int k_trail_points = 600;     ///< in each trail, where bodies are few, so that it turns where the body bounced,
constexpr int k_fewest_points = 40;     ///< where they are many,
constexpr int k_all_points = 100000;    ///< and in all trails together
constexpr double k_trail_length = 3.0; ///< of a typical trail, in typical body sizes
constexpr int k_most_trails = 4000;    ///< bodies beyond which trails would only grey the picture

/// How long the world's bodies take, at their present speeds, to fly what a trail is to show.  [s]
double trail_duration(const World& world)
{
    double squares = 0.0;
    double sizes = 0.0;
    for (int i = 0; i < world.body_count(); ++i) {
        if (world.is_static(i)) continue;
        squares += world.state(i).velocity.squaredNorm();
        sizes += 2.0 * bounding_radius(world.shape(i));
    }
    // Mean size over rms speed; both sums run over the same bodies
    const double count = static_cast<double>(world.body_count());
    return squares > 0.0 ? k_trail_length * sizes / std::sqrt(squares * count) : k_never;
}

/// A number with the 17 digits that name a double; null for what is not finite, which JSON can't say.
std::string json_number(double value)
{
    return std::isfinite(value) ? fmt::format("{:.17g}", value) : "null";
}

} // namespace

// ---- Trace ----------------------------------------------------------------------------------------------------------

TraceRecorder::TraceRecorder(OutputFile file, double every, double start, double end)
    : file_(std::move(file)), times_(every, end), end_(end)
{
    times_.skip_to(start);
}

double TraceRecorder::next() const
{
    if (!times_.is_over()) return times_.next();
    return last_ < end_ ? end_ : k_never;
}

std::optional<Fault> TraceRecorder::look(const World& world)
{
    last_ = next();
    if (!times_.is_over()) times_.advance();
    std::string line = fmt::format("{{\"time\":{},\"events\":{},\"bodies\":[", json_number(last_), world.events());
    for (int i = 0; i < world.body_count(); ++i) {
        const BodyState body = world.state(i);
        fmt::format_to(std::back_inserter(line), "{}[{},{},{},{},{},{}]", i == 0 ? "" : ",",
                       json_number(body.position.x()), json_number(body.position.y()), json_number(body.angle),
                       json_number(body.velocity.x()), json_number(body.velocity.y()), json_number(body.spin));
    }
    return file_.write(line + "]}\n");
}

// ---- Video ----------------------------------------------------------------------------------------------------------

VideoRecorder::VideoRecorder(OutputFile file, Video video, Picture picture, double end)
    : file_(std::move(file)),
      video_(std::move(video)),
      picture_(std::move(picture)),
      times_(1.0 / k_frames_per_second, end)
{
}

Expected<VideoRecorder> VideoRecorder::open(OutputFile file, const World& world, double end)
{
    Picture picture = picture_of(world);
    const SurfaceSize size = fitting_size(picture, k_video_size);
    Expected<Video> video = Video::open(file.temporary_path(), size, k_frames_per_second);
    if (!video) {
        Faults faults = video.faults();
        for (Fault& fault : faults) fault.place = file.path();
        return faults;
    }
    VideoRecorder recorder(std::move(file), std::move(video).value(), std::move(picture), end);
    recorder.times_.skip_to(world.time());
    return recorder;
}

std::optional<Fault> VideoRecorder::look(const World& world)
{
    times_.advance();
    move_bodies(picture_, world);
    picture_.view = joined(picture_.view, fitting_view(picture_));
    std::optional<Fault> fault = video_.add_frame(picture_);
    if (fault) fault->place = file_.path();
    return fault;
}

std::optional<Fault> VideoRecorder::finish()
{
    std::optional<Fault> fault = video_.finish();
    if (fault) fault->place = file_.path();
    return fault;
}

// ---- Trails ---------------------------------------------------------------------------------------------------------

void TrailRecorder::start(const World& world)
{
    start_ = world.time();
    for (int i = 0; i < world.body_count(); ++i) {
        if (!world.is_static(i)) trails_.push_back({i, trail_width(world.shape(i)), {}});
    }
}

void TrailRecorder::look(const World& world)
{
    if (world.body_count() > k_most_trails) {
        next_ = k_never;
        return;
    }
    if (samples_ == 0) {
        // Halve the way to the end, but stop where the trails are to begin; sixty halves reach the end itself
        const double left = end_ - world.time();
        const double wanted = trail_duration(world);
        if (left > wanted && ++checks_ < 60) {
            next_ = end_ - std::max(wanted, 0.5 * left);
            return;
        }
        start(world);
    }
    for (Trail& trail : trails_) trail.points.push_back(world.state(trail.colour).position);
    ++samples_;
    const int points = std::clamp(k_all_points / std::max(world.body_count(), 1), k_fewest_points, k_trail_points);
    const double share = static_cast<double>(samples_) / (points - 1);
    next_ = samples_ < points ? std::min(end_, start_ + share * (end_ - start_)) : k_never;
}

} // namespace flying
