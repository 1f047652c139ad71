#include "scene/generate.hpp"

#include <algorithm>
#include <cmath>

#include "scene/fault.hpp"
#include "scene/generators.hpp"
#include "scene/write.hpp"

namespace flying {

namespace {

/// Lengths, speeds and the like that a generator takes: far outside of these, areas and energies overflow.
constexpr double k_smallest = 1e-60;
constexpr double k_greatest = 1e60;
constexpr int k_most_bodies = 1000000;

/// One kind with its generator.
struct Generator
{
    GeneratorKind kind;
    Expected<Scene> (*generate)(const GenerateOptions&);
};

const std::vector<Generator>& generators()
{
    static const std::vector<Generator> all = {
        {{"balls",
          "discs with radii and speeds between bounds, in a box",
          {"seed", "count", "radius", "speed", "rms_speed", "max_spin", "packing", "box", "gravity", "restitution",
           "friction", "density", "until"}},
         generate_balls},
        {{"gas",
          "equal discs, polygons or dumbbells with velocities as in a gas",
          {"seed", "count", "radius", "speed", "rms_speed", "max_spin", "packing", "box", "gravity", "restitution",
           "friction", "density", "until", "min_sides", "max_sides", "shape"}},
         generate_gas},
        {{"polygons",
          "polygons of all sorts flying about in a box",
          {"seed", "count", "radius", "speed", "rms_speed", "max_spin", "packing", "box", "gravity", "restitution",
           "friction", "density", "until", "min_sides", "max_sides"}},
         generate_polygons},
        {{"pile",
          "bodies that fall onto a heap",
          {"seed", "count", "radius", "packing", "box", "gravity", "restitution", "friction", "density", "until",
           "min_sides", "max_sides", "shape"}},
         generate_pile},
        {{"stack",
          "unit boxes one on the other",
          {"seed", "count", "gap", "mass_ratio", "gravity", "restitution", "friction", "density", "until"}},
         generate_stack},
        {{"pyramid",
          "unit boxes in rows, each a box shorter than the one below",
          {"seed", "count", "gap", "gravity", "restitution", "friction", "density", "until"}},
         generate_pyramid},
        {{"cradle",
          "equal balls in a row between two walls, struck by the first",
          {"seed", "count", "radius", "gap", "speed", "restitution", "density", "until"}},
         generate_cradle},
        {{"billiard",
          "two balls and a wall that count the digits of pi, or one ball in a box",
          {"seed", "billiard", "exponent", "radius", "speed", "box", "until"}},
         generate_billiard},
    };
    return all;
}

std::vector<std::string> given_options(const GenerateOptions& options)
{
    std::vector<std::string> given;
    const auto note = [&](bool is_given, const char* name) {
        if (is_given) given.emplace_back(name);
    };
    note(options.count.has_value(), "count");
    note(options.radius.has_value(), "radius");
    note(options.speed.has_value(), "speed");
    note(options.rms_speed.has_value(), "rms_speed");
    note(options.max_spin.has_value(), "max_spin");
    note(options.packing.has_value(), "packing");
    note(options.box.has_value(), "box");
    note(options.gravity.has_value(), "gravity");
    note(options.restitution.has_value(), "restitution");
    note(options.friction.has_value(), "friction");
    note(options.density.has_value(), "density");
    note(options.until.has_value(), "until");
    note(options.min_sides.has_value(), "min_sides");
    note(options.max_sides.has_value(), "max_sides");
    note(options.shape.has_value(), "shape");
    note(options.mass_ratio.has_value(), "mass_ratio");
    note(options.gap.has_value(), "gap");
    note(options.billiard.has_value(), "billiard");
    note(options.exponent.has_value(), "exponent");
    return given;
}

/// Every option against its own range, and against those that it excludes.
class OptionCheck
{
public:
    Faults faults;

    void positive(const char* name, const std::optional<double>& value)
    {
        if (value && !is_positive(*value)) add(name, write_number(*value), "a positive number");
    }

    void not_negative(const char* name, const std::optional<double>& value)
    {
        if (value && !is_zero_or_more(*value)) add(name, write_number(*value), "a number of 0 or more");
    }

    void at_most_one(const char* name, const std::optional<double>& value)
    {
        if (value && !(*value >= 0.0 && *value <= 1.0)) add(name, write_number(*value), "a number, 0 ... 1");
    }

    void count(const char* name, const std::optional<int>& value, int least, int most)
    {
        if (!value || (*value >= least && *value <= most)) return;
        add(name, std::to_string(*value), "a whole number, " + std::to_string(least) + " ... " + std::to_string(most));
    }

    void bounds(const char* name, const std::optional<Bounds>& value, bool zero_is_allowed)
    {
        if (!value) return;
        const bool fit = zero_is_allowed ? is_zero_or_more(value->min) && is_zero_or_more(value->max)
                                         : is_positive(value->min) && is_positive(value->max);
        if (fit && value->min <= value->max) return;
        const std::string found = write_number(value->min) + " ... " + write_number(value->max);
        const std::string expected = zero_is_allowed ? "0 <= min <= max" : "0 < min <= max";
        add(name, found, expected);
    }

    void gravity(const std::optional<Vec2>& value)
    {
        if (!value || (is_moderate(value->x()) && is_moderate(value->y()))) return;
        add("gravity", write_number(value->x()) + ", " + write_number(value->y()), "two numbers, far from overflow");
    }

    void box(const std::optional<BoxDef>& value)
    {
        if (!value) return;
        const bool moderate = is_moderate(value->min.x()) && is_moderate(value->min.y()) &&
                              is_moderate(value->max.x()) && is_moderate(value->max.y());
        const Vec2 size = value->max - value->min;
        if (moderate && size.x() >= k_smallest && size.y() >= k_smallest) return;
        add("box",
            write_number(value->min.x()) + ", " + write_number(value->min.y()) + " ... " +
                write_number(value->max.x()) + ", " + write_number(value->max.y()),
            "a lower left and an upper right corner");
    }

    void word(const char* name, const std::optional<std::string>& value, const std::vector<std::string>& words)
    {
        if (!value || std::find(words.begin(), words.end(), *value) != words.end()) return;
        std::string expected;
        for (const std::string& candidate : words) expected += (expected.empty() ? "one of " : ", ") + candidate;
        const std::string nearest = nearest_word(*value, words);
        if (!nearest.empty()) expected += " (did you mean " + nearest + "?)";
        add(name, "\"" + *value + "\"", expected);
    }

    void not_both(const char* name, bool is_given, const char* other, bool other_is_given)
    {
        if (is_given && other_is_given) add(name, std::string(other) + " as well", "one of the two");
    }

    void add(const char* name, std::string found, std::string expected)
    {
        faults.push_back({name, std::move(found), std::move(expected)});
    }

private:
    static bool is_moderate(double value) { return std::abs(value) <= k_greatest; }
    static bool is_positive(double value) { return value >= k_smallest && value <= k_greatest; }
    static bool is_zero_or_more(double value) { return value == 0.0 || is_positive(value); }
};

Faults check_options(const Generator& generator, const GenerateOptions& options)
{
    OptionCheck check;

    // Refuse what this kind has no use for, rather than ignore it
    const std::vector<std::string>& known = generator.kind.options;
    std::string names;
    for (const std::string& name : known) names += (names.empty() ? "one of " : ", ") + name;
    for (const std::string& name : given_options(options)) {
        if (std::find(known.begin(), known.end(), name) != known.end()) continue;
        check.add(name.c_str(), "an option that " + generator.kind.name + " does not know", names);
    }

    const int most = generator.kind.name == "pyramid" ? 1000 : k_most_bodies;
    check.count("count", options.count, 1, most);
    check.bounds("radius", options.radius, false);
    check.bounds("speed", options.speed, true);
    check.not_negative("rms_speed", options.rms_speed);
    check.not_both("rms_speed", options.rms_speed.has_value(), "speed", options.speed.has_value());
    check.not_negative("max_spin", options.max_spin);
    check.positive("packing", options.packing);
    check.not_both("packing", options.packing.has_value(), "box", options.box.has_value());
    check.box(options.box);
    check.gravity(options.gravity);
    check.at_most_one("restitution", options.restitution);
    check.not_negative("friction", options.friction);
    check.positive("density", options.density);
    check.not_negative("until", options.until);
    check.count("min_sides", options.min_sides, 3, 1000);
    check.count("max_sides", options.max_sides, 3, 1000);
    check.positive("mass_ratio", options.mass_ratio);
    check.not_negative("gap", options.gap);
    check.count("exponent", options.exponent, 0, 8);
    const bool is_pile = generator.kind.name == "pile";
    check.word("shape", options.shape,
               is_pile ? std::vector<std::string>{"disc", "box", "polygon"}
                       : std::vector<std::string>{"disc", "polygon", "dumbbell"});
    check.word("billiard", options.billiard, {"pi", "rectangle"});
    return check.faults;
}

} // namespace

const std::vector<GeneratorKind>& generator_kinds()
{
    static const std::vector<GeneratorKind> kinds = [] {
        std::vector<GeneratorKind> list;
        for (const Generator& generator : generators()) list.push_back(generator.kind);
        return list;
    }();
    return kinds;
}

Expected<Scene> generate(const std::string& kind, const GenerateOptions& options)
{
    // Find the generator by its name
    std::vector<std::string> names;
    const Generator* generator = nullptr;
    for (const Generator& candidate : generators()) {
        names.push_back(candidate.kind.name);
        if (candidate.kind.name == kind) generator = &candidate;
    }
    if (!generator) {
        OptionCheck check;
        check.word("kind", kind, names);
        return check.faults;
    }

    Faults faults = check_options(*generator, options);
    if (!faults.empty()) return faults;

    // Hand out nothing that can't run
    Expected<Scene> scene = generator->generate(options);
    if (!scene) return scene;
    faults = validate(scene.value());
    if (!faults.empty()) return faults;
    return scene;
}

} // namespace flying
