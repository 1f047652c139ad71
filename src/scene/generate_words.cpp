#include "scene/generate_words.hpp"

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <functional>
#include <map>
#include <vector>

#include "scene/write.hpp"

namespace flying {

namespace {

/// An option as it was typed, with what stands behind it.
struct Option
{
    std::string name; ///< without hyphens before it
    std::vector<std::string> values;
};

std::vector<std::string> split(std::string_view words)
{
    std::vector<std::string> list;
    std::string word;
    for (const char c : words) {
        if (c != ' ') {
            word += c;
        } else if (!word.empty()) {
            list.push_back(std::exchange(word, ""));
        }
    }
    if (!word.empty()) list.push_back(word);
    return list;
}

/// The whole word as a number, if it is one.
bool read(const std::string& word, double& value)
{
    char* end = nullptr;
    value = std::strtod(word.c_str(), &end);
    return !word.empty() && end == word.c_str() + word.size();
}

template <typename Integer>
bool read_integer(const std::string& word, Integer& value)
{
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    return error == std::errc() && end == word.data() + word.size();
}

bool read(const std::string& word, int& value) { return read_integer(word, value); }
bool read(const std::string& word, std::uint64_t& value) { return read_integer(word, value); }

bool read(const std::string& word, std::string& value)
{
    value = word;
    return true;
}

// How one option is put into the options: true where its values are what it takes
using Values = std::vector<std::string>;
using Setter = std::function<bool(GenerateOptions&, const Values&)>;

template <typename T>
Setter one(std::optional<T> GenerateOptions::*member)
{
    return [member](GenerateOptions& options, const Values& values) {
        T value{};
        if (values.size() != 1 || !read(values.front(), value)) return false;
        options.*member = value;
        return true;
    };
}

/// One value that is both bounds, or two.
Setter bounds(std::optional<Bounds> GenerateOptions::*member)
{
    return [member](GenerateOptions& options, const Values& values) {
        Bounds read_bounds;
        const bool is_good = (values.size() == 1 || values.size() == 2) && read(values.front(), read_bounds.min) &&
                             read(values.back(), read_bounds.max);
        if (is_good) options.*member = read_bounds;
        return is_good;
    };
}

bool set_box(GenerateOptions& options, const Values& values)
{
    BoxDef box;
    const bool is_good = values.size() == 4 && read(values[0], box.min.x()) && read(values[1], box.min.y()) &&
                         read(values[2], box.max.x()) && read(values[3], box.max.y());
    if (is_good) options.box = box;
    return is_good;
}

bool set_gravity(GenerateOptions& options, const Values& values)
{
    Vec2 gravity = Vec2::Zero();
    const bool is_good = values.size() == 2 && read(values[0], gravity.x()) && read(values[1], gravity.y());
    if (is_good) options.gravity = gravity;
    return is_good;
}

bool set_seed(GenerateOptions& options, const Values& values)
{
    return values.size() == 1 && read(values.front(), options.seed);
}

std::map<std::string, Setter> setters()
{
    using G = GenerateOptions;
    return {{"seed", set_seed},
            {"count", one(&G::count)},
            {"radius", bounds(&G::radius)},
            {"speed", bounds(&G::speed)},
            {"rms-speed", one(&G::rms_speed)},
            {"max-spin", one(&G::max_spin)},
            {"packing", one(&G::packing)},
            {"box", set_box},
            {"gravity", set_gravity},
            {"restitution", one(&G::restitution)},
            {"friction", one(&G::friction)},
            {"density", one(&G::density)},
            {"until", one(&G::until)},
            {"min-sides", one(&G::min_sides)},
            {"max-sides", one(&G::max_sides)},
            {"shape", one(&G::shape)},
            {"mass-ratio", one(&G::mass_ratio)},
            {"gap", one(&G::gap)},
            {"billiard", one(&G::billiard)},
            {"exponent", one(&G::exponent)}};
}

/// The words behind the kind. A word with two hyphens starts an option; one with a single hyphen may be a number.
std::vector<Option> options_of(const std::vector<std::string>& words, Faults& faults)
{
    std::vector<Option> options;
    for (std::size_t k = 1; k < words.size(); ++k) {
        if (words[k].starts_with("--")) {
            options.push_back({words[k].substr(2), {}});
        } else if (options.empty()) {
            faults.push_back({words[k], "a value without an option", "--name before it"});
        } else {
            options.back().values.push_back(words[k]);
        }
    }
    return options;
}

std::string joined(const std::vector<std::string>& words)
{
    std::string text;
    for (const std::string& word : words) text += (text.empty() ? "" : " ") + word;
    return text;
}

} // namespace

Expected<std::string> generate_text(const std::string& kind, const GenerateOptions& options, const std::string& comment,
                                    std::size_t largest)
{
    const Expected<Scene> scene = generate(kind, options);
    if (!scene) return scene.faults();
    std::string text = write_scene(scene.value(), comment);
    if (text.size() <= largest) return text;

    // Round down: bodies in a larger box have longer numbers
    const std::size_t bodies = scene.value().bodies.size();
    const std::size_t most = largest / (text.size() / bodies + 1);
    return Fault{"count", std::to_string(bodies) + " bodies, a scene of " + std::to_string(text.size()) + " bytes",
                 "at most " + std::to_string(largest) + " bytes: " + std::to_string(most) + " such bodies"};
}

Expected<std::string> generate_from_words(std::string_view words)
{
    const std::vector<std::string> list = split(words);
    const std::map<std::string, Setter> known = setters();
    GenerateOptions options;
    Faults faults;
    if (list.empty()) return Fault{"", "no words", "the kind of scene to generate"};
    for (const Option& option : options_of(list, faults)) {
        const auto setter = known.find(option.name);
        if (setter == known.end()) {
            faults.push_back({"--" + option.name, "no such option", ""});
        } else if (!setter->second(options, option.values)) {
            faults.push_back({"--" + option.name, "\"" + joined(option.values) + "\"", "the values that it takes"});
        }
    }
    if (!faults.empty()) return faults;

    Expected<std::string> text = generate_text(list.front(), options, "flying generate " + joined(list));
    if (text) return text;
    faults = text.faults();
    for (Fault& fault : faults) {
        std::replace(fault.place.begin(), fault.place.end(), '_', '-');
        std::replace(fault.expected.begin(), fault.expected.end(), '_', '-');
        if (!fault.place.empty()) fault.place = "--" + fault.place;
    }
    return faults;
}

} // namespace flying
