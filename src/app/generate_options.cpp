#include "app/generate_options.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <utility>

#include "app/commands.hpp"
#include "app/option_checks.hpp"

namespace flying {

namespace {

constexpr const char* k_generate_examples = R"(
Same kind, options and seed: same scene, on every machine. An option that a kind doesn't know is an error.

Examples:
  flying generate balls --count 40 --seed 7 > balls.toml
  flying generate gas --count 1000 --packing 0.3 --rms-speed 1 > gas.toml
  flying generate polygons --radius 0.2 0.6 --gravity 0 -9.81 > polygons.toml
  flying generate billiard --billiard pi --exponent 3 | flying simulate /dev/stdin
)";

/// "balls  discs of ... (count, radius, speed)": one line for each kind.
std::string kinds_text()
{
    std::string text = "Kinds:\n";
    for (const GeneratorKind& kind : generator_kinds()) {
        text += fmt::format("  {:<10}{}\n", kind.name, kind.summary);
        std::string line;
        for (const std::string& option : kind.options) {
            std::string name = " --" + option;
            for (char& c : name) c = c == '_' ? '-' : c;
            if (line.size() + name.size() > 100) text += fmt::format("           {}\n", std::exchange(line, ""));
            line += name;
        }
        text += fmt::format("           {}\n", line);
    }
    return text;
}

void add_numbers(CLI::App& command, const std::string& name, std::vector<double>& numbers, int least, int most,
                 const std::string& description, const std::string& type)
{
    command.add_option(name, numbers, description)
        ->expected(least, most)
        ->delimiter(',')
        ->type_name(type)
        ->option_text(type)
        ->check(is_number());
}

std::optional<Bounds> bounds(const std::vector<double>& numbers)
{
    if (numbers.empty()) return std::nullopt;
    return Bounds{numbers.front(), numbers.back()};
}

} // namespace

void add_generate(CLI::App& app, GenerateCommand& command)
{
    CLI::App* generate = app.add_subcommand("generate", "Print a scene of some kind, by chance or by rule");
    generate->footer("\n" + kinds_text() + k_generate_examples);
    std::vector<std::string> kinds;
    for (const GeneratorKind& kind : generator_kinds()) kinds.push_back(kind.name);
    generate->add_option("KIND", command.kind, "What to make; see below")->required()->check(is_one_of(kinds));

    GenerateOptions& options = command.options;
    generate->add_option("--seed", options.seed, "Start of the random numbers; 1 by default")
        ->type_name("N")
        ->check(is_seed());
    generate->add_option("--count", options.count, "Bodies that move; of a pyramid, boxes in the lowest row")
        ->type_name("N")
        ->check(is_whole_number());
    add_numbers(*generate, "--radius", command.radius, 1, 2,
                "Of discs, or of the circle round a polygon [m]: one, or least and greatest", "R [R]");
    add_numbers(*generate, "--speed", command.speed, 1, 2, "In any direction [m/s]: one, or least and greatest",
                "V [V]");
    generate->add_option("--rms-speed", options.rms_speed, "Of all bodies together [m/s]")
        ->type_name("V")
        ->check(is_number());
    generate->add_option("--max-spin", options.max_spin, "Spins lie between this and its opposite [rad/s]")
        ->type_name("W")
        ->check(is_number());
    generate->add_option("--packing", options.packing, "Area of the bodies over that of the box, which it sizes")
        ->type_name("SHARE")
        ->check(is_number());
    add_numbers(*generate, "--box", command.box, 4, 4, "Four walls [m]", "XMIN YMIN XMAX YMAX");
    add_numbers(*generate, "--gravity", command.gravity, 2, 2, "Uniform field, 0 0 for none [m/s^2]", "X Y");
    generate->add_option("--restitution", options.restitution, "0 ... 1")->type_name("E")->check(is_number());
    generate->add_option("--friction", options.friction, "0 or more")->type_name("MU")->check(is_number());
    generate->add_option("--density", options.density, "Over 0 [kg/m^2]")->type_name("D")->check(is_number());
    generate->add_option("--until", options.until, "End of the run [s]")->type_name("T")->check(is_number());
    generate->add_option("--min-sides", options.min_sides, "Of polygons, 3 or more")
        ->type_name("N")
        ->check(is_whole_number());
    generate->add_option("--max-sides", options.max_sides, "Of polygons")->type_name("N")->check(is_whole_number());
    generate->add_option("--shape", options.shape, "gas: disc, polygon or dumbbell; pile: disc, box or polygon")
        ->type_name("NAME");
    generate->add_option("--mass-ratio", options.mass_ratio, "stack: mass of the top box over that of the others")
        ->type_name("RATIO")
        ->check(is_number());
    generate->add_option("--gap", options.gap, "Between neighbours [m]")->type_name("LENGTH")->check(is_number());
    generate->add_option("--billiard", options.billiard, "pi or rectangle")->type_name("NAME");
    generate->add_option("--exponent", options.exponent, "billiard pi: masses 1 and 100^exponent")
        ->type_name("K")
        ->check(is_whole_number());
}

int run_generate(const GenerateCommand& command, const std::string& typed)
{
    GenerateOptions options = command.options;
    options.radius = bounds(command.radius);
    options.speed = bounds(command.speed);
    const std::vector<double>& box = command.box;
    if (box.size() == 4) options.box = BoxDef{Vec2(box[0], box[1]), Vec2(box[2], box[3])};
    if (command.gravity.size() == 2) options.gravity = Vec2(command.gravity[0], command.gravity[1]);
    return generate_to_stdout(command.kind, options, typed);
}

} // namespace flying
