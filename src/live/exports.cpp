#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

#include "live/generate_words.hpp"
#include "live/run.hpp"
#include "scene/fault.hpp"

// What the module offers to JavaScript (docs/theme/engine.js wraps it). Built for WebAssembly only. Pointers go out as
// numbers; what they point to belongs to the run or the text that they were asked of. There is no state outside those.

#define FLYING_EXPORT(name) __attribute__((export_name(#name)))

namespace flying::live {

/// A text that JavaScript asked for, or why there is none.
struct LiveText
{
    bool is_good = false;
    std::string text;
};

// ---- Text on its way in ----------------------------------------------------------------------------------------------

FLYING_EXPORT(take_memory) char* take_memory(std::size_t size)
{
    return static_cast<char*>(std::malloc(size));
}

FLYING_EXPORT(give_memory_back) void give_memory_back(char* memory)
{
    std::free(memory);
}

// ---- Scenes to run ---------------------------------------------------------------------------------------------------

FLYING_EXPORT(generate) LiveText* generate(const char* words, std::size_t size)
{
    const Expected<std::string> scene = generate_from_words(std::string_view(words, size));
    return new LiveText{scene.has_value(), scene ? scene.value() : format_faults(scene.faults())};
}

FLYING_EXPORT(text_is_good) int text_is_good(const LiveText* text)
{
    return text->is_good ? 1 : 0;
}

FLYING_EXPORT(text_data) const char* text_data(const LiveText* text)
{
    return text->text.data();
}

FLYING_EXPORT(text_size) std::size_t text_size(const LiveText* text)
{
    return text->text.size();
}

FLYING_EXPORT(drop_text) void drop_text(LiveText* text)
{
    delete text;
}

// ---- Runs ------------------------------------------------------------------------------------------------------------

/// engine  0 automatic, 1 events, 2 rest
/// step    of the resting integrator; its default where not positive [s]
FLYING_EXPORT(open_run) LiveRun* open_run(const char* scene, std::size_t size, int engine, double step)
{
    WorldOptions options;
    if (engine == 1) options.engine = EngineChoice::events;
    if (engine == 2) options.engine = EngineChoice::rest;
    if (step > 0.0) options.step = step;
    return new LiveRun(std::string_view(scene, size), options);
}

FLYING_EXPORT(close_run) void close_run(LiveRun* run)
{
    delete run;
}

FLYING_EXPORT(is_ready) int is_ready(const LiveRun* run)
{
    return run->is_ready() ? 1 : 0;
}

FLYING_EXPORT(message_data) const char* message_data(const LiveRun* run)
{
    return run->message().data();
}

FLYING_EXPORT(message_size) std::size_t message_size(const LiveRun* run)
{
    return run->message().size();
}

/// 0 there, 1 on the way, 2 stopped
FLYING_EXPORT(advance) int advance(LiveRun* run, double time, int most)
{
    return static_cast<int>(run->advance(time, most));
}

FLYING_EXPORT(time) double time(const LiveRun* run)
{
    return run->world().time();
}

FLYING_EXPORT(until) double until(const LiveRun* run)
{
    return run->world().scene().until;
}

FLYING_EXPORT(body_count) int body_count(const LiveRun* run)
{
    return run->world().body_count();
}

FLYING_EXPORT(is_static) int is_static(const LiveRun* run, int body)
{
    return run->world().is_static(body) ? 1 : 0;
}

FLYING_EXPORT(states) const double* states(LiveRun* run)
{
    return run->states().data();
}

FLYING_EXPORT(outline_data) const double* outline_data(LiveRun* run, int body)
{
    return run->outline(body).data();
}

FLYING_EXPORT(outline_size) std::size_t outline_size(LiveRun* run, int body)
{
    return run->outline(body).size();
}

/// Null where there is no box.
FLYING_EXPORT(box) const double* box(LiveRun* run)
{
    const std::vector<double>& corners = run->box();
    return corners.empty() ? nullptr : corners.data();
}

FLYING_EXPORT(events) double events(const LiveRun* run)
{
    return static_cast<double>(run->world().events());
}

FLYING_EXPORT(collisions) double collisions(const LiveRun* run)
{
    return static_cast<double>(run->world().collisions());
}

FLYING_EXPORT(log_hash) std::uint64_t log_hash(const LiveRun* run)
{
    return run->world().log_hash();
}

FLYING_EXPORT(hash) std::uint64_t hash(LiveRun* run)
{
    return run->world().report().hash;
}

FLYING_EXPORT(energy) double energy(LiveRun* run)
{
    return run->world().report().energy.total();
}

} // namespace flying::live
