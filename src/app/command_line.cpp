#include "app/command_line.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <regex>

#include "app/commands.hpp"
#include "app/generate_options.hpp"
#include "app/messages.hpp"
#include "app/option_checks.hpp"
#include "scene/fault.hpp"

namespace flying {

namespace {

constexpr const char* k_about = "Discs and polygons that fly and collide, exactly.\n"
                                "Scenes are TOML files; units are SI, angles in radians, y points up.";

constexpr const char* k_examples = R"(
Examples:
  flying generate balls --count 40 > balls.toml
  flying simulate balls.toml --picture balls.png --video balls.mp4
  flying simulate balls.toml --until 60 --report balls.json --trace balls.ndjson --every 0.1
  flying check balls.toml && flying explain balls.toml

Exit status: 0 done; 1 the run failed, or a result could not be written; 2 bad usage or bad scene, and nothing was
written; 130 stopped by Ctrl-C. "flying COMMAND --help" tells more.
)";

constexpr const char* k_simulate_notes = R"(
Output files appear whole or not at all: they take their names when everything is done. A failed run leaves only its
report, with the key "failure".

Report: JSON, numbers with 17 digits: time, engine, events, collisions, handovers, handover_log, energy {kinetic,
potential, total, initial_total}, energy_changes {impacts, steps, handovers}, momentum, angular_momentum, max_overlap,
hash, plan, stages, wall_seconds, bodies [{name, position, angle, velocity, spin, mass, inertia}]; where bodies leant on
others, rest {islands, solved, swept, unsolved, parts, projected, limited, energy_limited, elastic_ended,
elastic_braked}: how their steps were made; warnings, if any.
Trace: one JSON object a line, at the times 0, DT, 2 DT, ... and at the end:
  {"time": t, "events": n, "bodies": [[x, y, angle, vx, vy, spin], ...]}     bodies in the scene's order
Looking never changes a run: the same hash comes out whatever is traced, drawn or filmed. Nor does saving and resuming.
A resumed run foresees everything anew, in cells that fit where the bodies are by then: how often pairs are looked at
again and cells are left is another number, and so is "events", which counts both beside impacts and steps.
"collisions" counts impacts alone and is the same. plan, stages, rest, warnings and wall_seconds tell of the resumed
part only.

Examples:
  flying simulate scene.toml
  flying simulate scene.toml --until 100 --report run.json --picture end.svg
  flying simulate scene.toml --trace run.ndjson --every 0.01
  flying simulate scene.toml --without grid --stats
  flying simulate scene.toml --until 10 --save ten.json
  flying simulate scene.toml --until 20 --resume ten.json
)";

/// Read a scene's path: a positional argument that every command but `generate` has.
void add_scene(CLI::App& command, std::string& path)
{
    command.add_option("SCENE", path, "Scene file, TOML; /dev/stdin for a pipe")->required()->check(is_file_name());
}

void add_without(CLI::App& command, std::vector<std::string>& names)
{
    command
        .add_option("--without", names, "Do the work that this skip leaves out; again for more (names: flying explain)")
        ->type_name("SKIP")
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
}

void add_simulate(CLI::App& app, SimulateOptions& options)
{
    CLI::App* command = app.add_subcommand("simulate", "Run a scene and report; on demand trace, draw and film it");
    command->footer(k_simulate_notes);
    add_scene(*command, options.scene);
    command->add_option("--until", options.until, "End of the run in place of the scene's [s]")
        ->type_name("T")
        ->check(is_number());
    command
        ->add_option("--engine", options.engine,
                     "events: from impact to impact, exactly; rest: by small steps, for contacts that last; auto, where not "
                     "given: both at once, each where it is needed")
        ->type_name("NAME")
        ->check(is_one_of({"auto", "events", "rest"}));
    command->add_option("--step", options.step, "Step of the resting engine, 1/60 where not given; the event engine takes none [s]")
        ->type_name("DT")
        ->check(is_number());
    add_without(*command, options.without);
    command->add_option("--report", options.report, "Write the report there")
        ->type_name("FILE.json")
        ->check(is_file_name());
    command->add_option("--trace", options.trace, "Write the motion there, a line for each moment")
        ->type_name("FILE.ndjson")
        ->check(is_file_name());
    command
        ->add_option("--every", options.every, "Time between lines of the trace [s]; by default a hundredth of the run")
        ->type_name("DT")
        ->check(is_number());
    command->add_option("--picture", options.picture, "Draw the end of the run, with trails")
        ->type_name("FILE.{png,svg,pdf}")
        ->check(is_file_name());
    command->add_option("--video", options.video, "Film the run in real time, 60 frames a second (needs ffmpeg)")
        ->type_name("FILE.mp4")
        ->check(is_file_name());
    command->add_option("--save", options.save, "Write there, at the end, what it takes to go on with the run later")
        ->type_name("FILE.json")
        ->check(is_file_name());
    command
        ->add_option("--resume", options.resume,
                     "Go on with a run of this scene that was saved, with its engine, step and skips: the same bits come "
                     "out as of a run that never stopped")
        ->type_name("FILE.json")
        ->check(is_file_name());
    command->add_flag("--explain", options.explain, "Print what was skipped, why, and the work it saved");
    command->add_flag("--stats", options.stats, "Print what each stage cost");
    command->add_flag("--quiet", options.quiet, "No report on standard output, no progress");
}

void add_window(CLI::App& app, WatchOptions& options)
{
    CLI::App* command = app.add_subcommand("window", "Play with a scene in a window; F1 there shows all keys");
    command->add_option("SCENE", options.scene, "Scene file, TOML; the course's first scene where none is given");
    command->add_option("--size", options.size, "Of the window, 1280x800 where not given [pixels]")->type_name("WxH");
    command->add_option("--face", options.face, "A picture on every ball that moves")
        ->type_name("FILE.png")
        ->check(is_file_name());
    command->add_flag("--bare", options.is_bare, "Without the controls at the side; F9 brings them");
    command->add_flag("--dark", options.is_dark, "Light on dark; D changes it");
    command->add_flag("--paused", options.is_paused, "Time stands still at first; P lets it run");
    command->add_option("--state", options.state, "Where F8 writes what the window knows, flying-state.json where not given")
        ->type_name("FILE.json")
        ->check(is_file_name());
}

/// The command line as typed, from the command on.
std::string as_typed(int argc, char** argv)
{
    std::string text = "flying";
    for (int i = 1; i < argc; ++i) text += std::string(" ") + argv[i];
    // It becomes a comment of one line
    for (char& c : text) c = static_cast<unsigned char>(c) < ' ' ? ' ' : c;
    return text;
}

/// What to say of a command or an option that doesn't exist, with the one that was meant; nothing where all exist.
std::optional<std::string> unknown_word(const CLI::App& app, const std::vector<char*>& words)
{
    const auto meant = [](const std::string& word, const std::vector<std::string>& known) {
        const std::string near = nearest_word(word, known);
        return near.empty() ? "" : fmt::format("; did you mean {}?", near);
    };
    const std::string name = words[1];
    if (name.starts_with('-')) return std::nullopt;
    std::vector<std::string> commands;
    for (const CLI::App* command : app.get_subcommands(nullptr)) commands.push_back(command->get_name());
    if (std::find(commands.begin(), commands.end(), name) == commands.end()) {
        return fmt::format("no command {}{} (there are: {})", name, meant(name, commands), fmt::join(commands, ", "));
    }
    const CLI::App* command = app.get_subcommand(name);
    std::vector<std::string> options;
    for (const CLI::Option* option : command->get_options()) options.push_back(option->get_name());
    for (std::size_t i = 2; i < words.size(); ++i) {
        const std::string typed = words[i];
        const std::string word = typed.substr(0, typed.find('='));
        if (!word.starts_with("--") || word == "--" || command->get_option_no_throw(word)) continue;
        return fmt::format("flying {} has no option {}{}", name, word, meant(word, options));
    }
    return std::nullopt;
}

/// What the parser says of too few or too many words behind an option, in the words of the other complaints.
std::string of_count(const std::string& text)
{
    static const std::regex none("(.+): \\d+ required (.+) missing");
    static const std::regex other("(.+): At (Most|least) (\\d+) required but received (\\d+)");
    std::smatch part;
    if (std::regex_match(text, part, none)) return fmt::format("{}: found nothing, expected {}", part.str(1), part.str(2));
    if (!std::regex_match(text, part, other)) return text;
    return fmt::format("{}: found {}, expected at {} {}", part.str(1),
                       counted(std::stol(part.str(4)), "value", "values"), part.str(2) == "Most" ? "most" : "least",
                       part.str(3));
}

/// `flying help COMMAND` is `flying COMMAND --help`.
std::vector<char*> without_help_first(int argc, char** argv)
{
    static char option[] = "--help";
    std::vector<char*> words(argv, argv + argc);
    if (words[1] != std::string("help")) return words;
    words.erase(words.begin() + 1);
    words.push_back(option);
    return words;
}

} // namespace

int run_command_line(int argc, char** argv)
{
    CLI::App app(k_about, "flying");
    app.set_version_flag("--version", "flying " FLYING_VERSION, "Print the version and exit");
    app.footer(k_examples);
    app.require_subcommand(1);
    app.option_defaults()->multi_option_policy(CLI::MultiOptionPolicy::Throw);

    SimulateOptions simulate_options;
    add_simulate(app, simulate_options);
    std::string scene;
    std::vector<std::string> without;
    CLI::App* check_command =
        app.add_subcommand("check", "Say whether a scene is fit to run, and all that is wrong with it");
    add_scene(*check_command, scene);
    CLI::App* explain_command =
        app.add_subcommand("explain", "Say what a run of this scene skips, and why, without running it");
    add_scene(*explain_command, scene);
    add_without(*explain_command, without);
    GenerateCommand generate_command;
    add_generate(app, generate_command);
    WatchOptions watch_options;
    add_window(app, watch_options);

    if (argc < 2) {
        std::fputs(app.help().c_str(), stderr);
        return status::k_usage;
    }
    std::vector<char*> words = without_help_first(argc, argv);
    const std::optional<std::string> unknown = unknown_word(app, words);
    try {
        if (unknown) throw CLI::ExtrasError({words[1]});
        app.parse(static_cast<int>(words.size()), words.data());
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() == 0) return app.exit(error);
        complain(unknown.value_or(of_count(error.what())));
        const bool is_command = !app.get_subcommands([&](const CLI::App* one) { return one->get_name() == words[1]; }).empty();
        fmt::print(stderr, "Run flying {} --help.\n", is_command ? words[1] : "--help, or flying COMMAND");
        return status::k_usage;
    }
    if (app.got_subcommand("simulate")) return simulate(simulate_options);
    if (app.got_subcommand(check_command)) return check(scene);
    if (app.got_subcommand(explain_command)) return explain(scene, without);
    if (app.got_subcommand("window")) return watch(watch_options);
    return run_generate(generate_command, as_typed(argc, argv));
}

} // namespace flying
