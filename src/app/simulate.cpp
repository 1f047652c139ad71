// The command `simulate`: runs a scene, and records it on the way.

#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <filesystem>

#include "app/clock.hpp"
#include "app/commands.hpp"
#include "app/explain.hpp"
#include "app/messages.hpp"
#include "app/report_text.hpp"
#include "app/run.hpp"
#include "draw/image.hpp"
#include "files/interrupt.hpp"
#include "json/report_json.hpp"
#include "json/saved_run.hpp"
#include "scene/fault.hpp"

namespace flying {

namespace {

constexpr int k_picture_pixels = 1600;    ///< longer side of a PNG
constexpr int k_picture_points = 900;     ///< longer side of SVG and PDF
constexpr double k_default_lines = 100.0; ///< of a trace, where nothing is said
constexpr double k_most_lines = 1e9;
constexpr double k_most_frames = 1e7;

bool is_positive(double value)
{
    return std::isfinite(value) && value > 0.0;
}

/// Everything that is wrong with the options by themselves, a sentence each.
std::vector<std::string> usage_errors(const SimulateOptions& options)
{
    std::vector<std::string> errors;
    if (options.until && !(std::isfinite(*options.until) && *options.until >= 0.0)) {
        errors.push_back(fmt::format("--until: found {}, expected a time >= 0 [s]", *options.until));
    }
    if (options.step && !is_positive(*options.step)) {
        errors.push_back(fmt::format("--step: found {}, expected a time > 0 [s]", *options.step));
    }
    if (options.every && !is_positive(*options.every)) {
        errors.push_back(fmt::format("--every: found {}, expected a time > 0 [s]", *options.every));
    }
    if (options.every && options.trace.empty()) errors.push_back("--every: needs --trace FILE, whose lines it spaces");
    if (!options.picture.empty() && !image_format(options.picture)) {
        errors.push_back(fmt::format("--picture {}: expected a name ending in .png, .svg or .pdf", options.picture));
    }
    if (!options.video.empty() && std::filesystem::path(options.video).extension() != ".mp4") {
        errors.push_back(fmt::format("--video {}: expected a name ending in .mp4", options.video));
    }
    return errors;
}

/// One file asked for twice, or the scene itself to be overwritten.
std::vector<std::string> clashes(const SimulateOptions& options)
{
    struct Named
    {
        const char* option;
        const std::string& path;
    };
    const Named files[] = {{"the scene", options.scene},
                           {"--report", options.report},
                           {"--trace", options.trace},
                           {"--picture", options.picture},
                           {"--video", options.video},
                           {"--save", options.save}};
    const auto resolved = [](const std::string& path) {
        std::error_code ignored;
        return std::filesystem::weakly_canonical(std::filesystem::absolute(path, ignored), ignored);
    };
    std::vector<std::string> errors;
    for (std::size_t i = 1; i < std::size(files); ++i) {
        for (std::size_t j = 0; j < i && !files[i].path.empty(); ++j) {
            std::error_code ignored;
            if (files[j].path.empty() || std::filesystem::is_character_file(files[i].path, ignored)) continue;
            if (resolved(files[i].path) != resolved(files[j].path)) continue;
            errors.push_back(
                fmt::format("{} {}: the same file as {}", files[i].option, files[i].path, files[j].option));
        }
    }
    return errors;
}

/// All files of a run, opened before it starts.
struct Outputs
{
    std::optional<OutputFile> report;
    std::optional<OutputFile> picture;
    std::optional<OutputFile> save;
    Recorders recorders;
};

Expected<std::optional<OutputFile>> open_if_asked(const std::string& path)
{
    if (path.empty()) return std::optional<OutputFile>();
    Expected<OutputFile> file = OutputFile::open(path);
    if (!file) return file.faults();
    return std::optional<OutputFile>(std::move(file).value());
}

std::optional<Faults> open_outputs(const SimulateOptions& options, const World& world, double end, Outputs& outputs)
{
    Expected<std::optional<OutputFile>> report = open_if_asked(options.report);
    Expected<std::optional<OutputFile>> picture = open_if_asked(options.picture);
    Expected<std::optional<OutputFile>> save = open_if_asked(options.save);
    Expected<std::optional<OutputFile>> trace = open_if_asked(options.trace);
    Expected<std::optional<OutputFile>> video = open_if_asked(options.video);
    Faults faults;
    for (const auto* file : {&report, &picture, &save, &trace, &video}) {
        if (!*file) faults.insert(faults.end(), file->faults().begin(), file->faults().end());
    }
    if (video && video.value() && video.value()->is_special()) {
        faults.push_back({options.video, "a device or a pipe", "a file: MP4 is not written from front to back"});
    }
    if (!faults.empty()) return faults;

    outputs.report = std::move(report).value();
    outputs.picture = std::move(picture).value();
    outputs.save = std::move(save).value();
    if (outputs.picture) outputs.recorders.trails.emplace(end);
    if (trace.value()) {
        const double every = options.every ? *options.every : end > 0.0 ? end / k_default_lines : 1.0;
        outputs.recorders.trace.emplace(std::move(*std::move(trace).value()), every, world.time(), end);
    }
    if (video.value()) {
        Expected<VideoRecorder> recorder = VideoRecorder::open(std::move(*std::move(video).value()), world, end);
        if (!recorder) return recorder.faults();
        outputs.recorders.video.emplace(std::move(recorder).value());
    }
    return std::nullopt;
}

/// More lines or frames than anyone can want: a slip of the hand that would fill the disk.
std::vector<std::string> excesses(const SimulateOptions& options, double end)
{
    std::vector<std::string> errors;
    if (options.every && !(end / *options.every < k_most_lines)) {
        errors.push_back(fmt::format("--every {:g}: asks for {:.3g} lines until {:g} s, expected at most {:g}",
                                     *options.every, end / *options.every, end, k_most_lines));
    }
    if (!options.video.empty() && !(end * k_frames_per_second < k_most_frames)) {
        errors.push_back(fmt::format("--video: asks for {:.3g} frames until {:g} s, expected at most {:g}",
                                     end * k_frames_per_second, end, k_most_frames));
    }
    return errors;
}

std::optional<Fault> write_picture(OutputFile& file, const World& world, std::vector<Trail> trails)
{
    Picture picture = picture_of(world);
    picture.trails = std::move(trails);
    const ImageFormat format = *image_format(file.path());
    const int longest = format == ImageFormat::png ? k_picture_pixels : k_picture_points;
    const Expected<std::string> image = render_image(picture, format, fitting_size(picture, longest));
    if (!image) return Fault{file.path(), image.faults().front().found, ""};
    return file.write(image.value());
}

/// Finish all, and only then give them their names: all of them appear, or none.
std::optional<Fault> commit_all(const std::vector<OutputFile*>& files)
{
    for (OutputFile* file : files) {
        if (std::optional<Fault> fault = file->finish()) return fault;
    }
    for (OutputFile* file : files) {
        if (std::optional<Fault> fault = file->commit()) return fault;
    }
    return std::nullopt;
}

int fail_to_write(Fault fault)
{
    fault.place = fault.place.empty() ? "output" : fault.place;
    complain(format_fault(fault) + "; no file was written");
    return status::k_failed;
}

bool complain_of(const std::vector<std::string>& errors)
{
    for (const std::string& error : errors) complain(error);
    return !errors.empty();
}

/// After the run: write, print, and say how it went.
int conclude(const SimulateOptions& options, const WorldOptions& chosen, World& world, Outputs& outputs, const RunResult& result, double wall_seconds)
{
    if (const auto* fault = std::get_if<Fault>(&result.end)) return fail_to_write(*fault);
    std::optional<RunFailure> failure;
    if (const auto* found = std::get_if<RunFailure>(&result.end)) failure = *found;
    const Report report = world.report();

    // A failed run leaves its report alone: a trace, a film or a picture of half a run would pass for the whole
    std::vector<OutputFile*> files;
    if (outputs.report) {
        files.push_back(&*outputs.report);
        if (auto fault = outputs.report->write(report_json(report, wall_seconds, failure)))
            return fail_to_write(*fault);
    }
    Recorders& recorders = outputs.recorders;
    if (!failure && recorders.trace) files.push_back(&recorders.trace->file());
    if (!failure && outputs.picture) {
        files.push_back(&*outputs.picture);
        if (auto fault = write_picture(*outputs.picture, world, recorders.trails->take())) return fail_to_write(*fault);
    }
    if (!failure && outputs.save) {
        files.push_back(&*outputs.save);
        if (auto fault = outputs.save->write(write_saved_run(world.scene(), chosen, world.snapshot()))) return fail_to_write(*fault);
    }
    if (!failure && recorders.video) {
        files.push_back(&recorders.video->file());
        if (auto fault = recorders.video->finish()) return fail_to_write(*fault);
    }
    if (auto fault = commit_all(files)) return fail_to_write(*fault);

    const RunSeconds seconds{wall_seconds, result.engine_seconds};
    if (failure) complain("the run failed: " + failure->message);
    if (!options.quiet) fmt::print("{}", report_text(world.scene(), report, seconds, files));
    if (options.explain) fmt::print("{}", explain_plan(world.scene(), report.plan, PlanMoment::after_run));
    if (options.stats) fmt::print("{}", stats_text(report, seconds));
    return failure ? status::k_failed : status::k_done;
}

EngineChoice engine_named(const std::string& name)
{
    return name == "events" ? EngineChoice::events : name == "rest" ? EngineChoice::rest : EngineChoice::automatic;
}

const char* name_of(EngineChoice engine)
{
    return engine == EngineChoice::events ? "events" : engine == EngineChoice::rest ? "rest" : "auto";
}

WorldOptions world_options(const SimulateOptions& options)
{
    WorldOptions chosen;
    chosen.without = options.without;
    if (options.engine) chosen.engine = engine_named(*options.engine);
    if (options.step) chosen.step = *options.step;
    return chosen;
}

/// What was asked for that a saved run would have to be run without: it goes on as it began.
std::vector<std::string> disagreements(const SimulateOptions& options, double end, const SavedRun& saved)
{
    std::vector<std::string> errors;
    const WorldOptions& own = saved.options;
    if (options.engine && engine_named(*options.engine) != own.engine) {
        errors.push_back(fmt::format("--engine {}: the saved run has {}", *options.engine, name_of(own.engine)));
    }
    if (options.step && *options.step != own.step) {
        errors.push_back(fmt::format("--step {}: the saved run has {}", *options.step, own.step));
    }
    if (!options.without.empty() && options.without != own.without) {
        errors.push_back(fmt::format("--without {}: the saved run has {}", fmt::join(options.without, ", "),
                                     own.without.empty() ? "none" : fmt::format("{}", fmt::join(own.without, ", "))));
    }
    if (end < saved.snapshot.time) {
        errors.push_back(fmt::format("until {} s: found a saved run that has come to {} s, expected one to go on with", end,
                                     saved.snapshot.time));
    }
    return errors;
}

/// The world at its start, or where a saved run ended; what is wrong has been printed.
std::optional<World> make_world_or_complain(const SimulateOptions& options, const Scene& scene, double end,
                                            WorldOptions& chosen)
{
    std::optional<SavedRun> saved;
    if (!options.resume.empty()) {
        Expected<SavedRun> read = read_saved_run(options.resume, scene);
        if (!read) {
            complain(read.faults());
            return std::nullopt;
        }
        saved = std::move(read).value();
        if (complain_of(disagreements(options, end, *saved))) return std::nullopt;
        chosen = saved->options;
    }
    Expected<World> made = saved ? World::resume(scene, saved->snapshot, chosen) : World::make(scene, chosen);
    if (made) return std::move(made).value();
    complain(made.faults());
    return std::nullopt;
}

} // namespace

int simulate(const SimulateOptions& options)
{
    if (complain_of(usage_errors(options)) || complain_of(clashes(options))) return status::k_usage;
    if (!are_skip_names(options.without)) return status::k_usage;
    const std::optional<Scene> scene = read_scene_or_complain(options.scene);
    if (!scene) return status::k_usage;
    const double end = options.until.value_or(scene->until);
    if (complain_of(excesses(options, end))) return status::k_usage;

    WorldOptions chosen = world_options(options);
    std::optional<World> made = make_world_or_complain(options, *scene, end, chosen);
    if (!made) return status::k_usage;
    World& world = *made;
    watch_for_interrupts();
    Outputs outputs;
    if (const std::optional<Faults> faults = open_outputs(options, world, end, outputs)) {
        complain(*faults);
        complain("nothing was written");
        return status::k_usage;
    }
    if (options.step && chosen.engine == EngineChoice::events && !options.quiet) {
        complain("--step has no effect: the event engine takes no steps");
    }
    if (scene->bodies.empty() && !options.quiet) complain(options.scene + " has no bodies: nothing will happen");
    if (options.stats) world.set_stopwatch(seconds_now);

    const double started = seconds_now();
    RunResult result;
    {
        Progress progress(options.quiet ? Progress::Wish::quiet : Progress::Wish::show, end);
        result = run(world, end, outputs.recorders, progress);
    }
    if (const auto* interrupt = std::get_if<Interrupted>(&result.end)) {
        complain(fmt::format("stopped at {:g} s; nothing was written", world.time()));
        return 128 + interrupt->signal;
    }
    return conclude(options, chosen, world, outputs, result, seconds_now() - started);
}

} // namespace flying
