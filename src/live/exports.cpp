#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

#include "scene/generate_words.hpp"
#include "live/pieces.hpp"
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

/// The names that `open_run` counts by, a line each.
FLYING_EXPORT(skips) LiveText* skips()
{
    std::string lines;
    for (const std::string& name : skip_names()) lines += name + "\n";
    return new LiveText{true, lines};
}

FLYING_EXPORT(drop_text) void drop_text(LiveText* text)
{
    delete text;
}

// ---- Pieces of the engine --------------------------------------------------------------------------------------------

/// What a piece answered, as JavaScript reads it: how many numbers are the engine's, those, then those on paper.
struct LiveAnswer
{
    bool is_good = false;
    std::uint64_t hash = 0;
    std::vector<double> numbers;
};

FLYING_EXPORT(ask)
LiveAnswer* ask(const char* name, std::size_t size, const double* numbers, std::size_t count)
{
    const std::optional<Answer> answer = answer_of(std::string_view(name, size), {numbers, count});
    if (!answer) return new LiveAnswer{};
    auto* out = new LiveAnswer{true, answer->hash(), {static_cast<double>(answer->engine.size())}};
    out->numbers.insert(out->numbers.end(), answer->engine.begin(), answer->engine.end());
    out->numbers.insert(out->numbers.end(), answer->paper.begin(), answer->paper.end());
    return out;
}

FLYING_EXPORT(answer_is_good) int answer_is_good(const LiveAnswer* answer)
{
    return answer->is_good ? 1 : 0;
}

FLYING_EXPORT(answer_hash) std::uint64_t answer_hash(const LiveAnswer* answer)
{
    return answer->hash;
}

FLYING_EXPORT(answer_data) const double* answer_data(const LiveAnswer* answer)
{
    return answer->numbers.data();
}

FLYING_EXPORT(answer_size) std::size_t answer_size(const LiveAnswer* answer)
{
    return answer->numbers.size();
}

FLYING_EXPORT(drop_answer) void drop_answer(LiveAnswer* answer)
{
    delete answer;
}

// ---- Runs ------------------------------------------------------------------------------------------------------------

/// engine   0 automatic, 1 events, 2 rest
/// step     of the resting integrator; its default where not positive [s]
/// without  bit k: leave skip number k of `skip_names` inactive
FLYING_EXPORT(open_run)
LiveRun* open_run(const char* scene, std::size_t size, int engine, double step, std::uint32_t without)
{
    WorldOptions options;
    const std::vector<std::string> names = skip_names();
    for (std::size_t k = 0; k < names.size(); ++k)
        if ((without >> k & 1u) != 0) options.without.push_back(names[k]);
    if (engine == 1) options.engine = EngineChoice::events;
    if (engine == 2) options.engine = EngineChoice::rest;
    if (step > 0.0) options.step = step;
    return new LiveRun(std::string_view(scene, size), options);
}

/// Give a body another velocity, now. 1 where it was done, 0 where the body is static or where bodies that lean on each
/// other can't start anew.
FLYING_EXPORT(steer) int steer(LiveRun* run, int body, double velocity_x, double velocity_y)
{
    return run->steer(body, Vec2(velocity_x, velocity_y)) ? 1 : 0;
}

/// What the plan skips and saved so far: a line for each skip, its parts apart by tabs: name, class, 1 where it is active,
/// how much it saved, of what, why.
FLYING_EXPORT(plan_text) LiveText* plan_text(LiveRun* run)
{
    return new LiveText{true, run->plan_lines()};
}

/// 0 nothing, 1 events, 2 rest, 3 asleep
FLYING_EXPORT(mover) int mover(const LiveRun* run, int body)
{
    return static_cast<int>(run->world().mover(body));
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
    return run->time();
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
