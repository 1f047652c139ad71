#include "scene/table_reader.hpp"

#include <algorithm>
#include <limits>

#include "scene/fault.hpp"
#include "scene/write.hpp"

namespace flying {

namespace {

/// One label is the other, or names a part of it: `shape` has `shape.radius` and `shape[0]`, but not `shapes`.
bool has_part(std::string_view whole, std::string_view part)
{
    if (!part.starts_with(whole)) return false;
    return part.size() == whole.size() || whole.empty() || part[whole.size()] == '.' || part[whole.size()] == '[' ||
           part[whole.size()] == ',';
}

} // namespace

void FaultList::add(const toml::source_position& at, const std::string& label, std::string found, std::string expected)
{
    place(at, label, std::move(found), std::move(expected), true);
}

void FaultList::add_unknown_key(const toml::source_position& at, const std::string& label, std::string found,
                                std::string expected)
{
    place(at, label, std::move(found), std::move(expected), false);
}

bool FaultList::is_lost(std::string_view label, std::size_t first, std::size_t end) const
{
    return std::any_of(faults_.begin() + static_cast<std::ptrdiff_t>(first),
                       faults_.begin() + static_cast<std::ptrdiff_t>(end), [&](const Placed& fault) {
                           return fault.loses && (has_part(fault.lost, label) || has_part(label, fault.lost));
                       });
}

void FaultList::place(const toml::source_position& at, const std::string& label, std::string found,
                      std::string expected, bool loses)
{
    std::string place = filename_ + ":" + std::to_string(at.line) + ":" + std::to_string(at.column);
    if (!label.empty()) place += ": " + label;
    faults_.push_back({at, {std::move(place), std::move(found), std::move(expected)}, label, loses});
}

Faults FaultList::in_order() const
{
    std::vector<Placed> placed = faults_;
    std::stable_sort(placed.begin(), placed.end(), [](const Placed& a, const Placed& b) { return a.at < b.at; });
    Faults faults;
    for (Placed& fault : placed) faults.push_back(std::move(fault.fault));
    return faults;
}

std::string on_one_line(std::string_view text)
{
    std::string shown;
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        shown += byte < 0x20 || byte == 0x7f ? '?' : c;
    }
    return shown;
}

std::string in_quotes(std::string_view text)
{
    constexpr std::size_t k_longest = 40;
    std::string shown = on_one_line(text.substr(0, k_longest));

    // Don't cut a character of several bytes in two
    if (text.size() > k_longest) {
        while (!shown.empty() && (static_cast<unsigned char>(shown.back()) & 0xc0) == 0x80) shown.pop_back();
        if (!shown.empty() && static_cast<unsigned char>(shown.back()) >= 0xc0) shown.pop_back();
        shown += "...";
    }
    return "\"" + shown + "\"";
}

std::string describe(const toml::node& node)
{
    if (const auto* text = node.as_string()) return in_quotes(text->get());
    if (const auto* number = node.as_integer()) return std::to_string(number->get());
    if (const auto* number = node.as_floating_point()) return write_number(number->get());
    if (const auto* flag = node.as_boolean()) return flag->get() ? "true" : "false";
    if (const auto* array = node.as_array()) {
        const std::size_t size = array->size();
        if (size == 0) return "an empty array";
        return "an array of " + std::to_string(size) + (size == 1 ? " value" : " values");
    }
    if (node.is_table()) return "a table";
    return "a date or time";
}

namespace {

/// Words that others use, with the word of ours that stands in their place, and what to write.
struct OtherWord
{
    std::string_view word;
    std::string_view known;
    std::string_view written;
};
constexpr std::string_view k_gravity = "field = { kind = \"uniform\", gravity = [x, y] }";
constexpr std::string_view k_disc = "shape = { kind = \"disc\", radius = r }";
constexpr std::string_view k_polygon = "shape = { kind = \"polygon\", vertices = [[x, y], ...] }";
constexpr OtherWord k_other_words[] = {{"gravity", "field", k_gravity},
                                       {"gravity", "uniform", "uniform"},
                                       {"gravity", "world", "field, under [world]"},
                                       {"field", "world", "field, under [world]"},
                                       {"box", "world", "box, under [world]"},
                                       {"bodies", "body", "[[body]]"},
                                       {"until", "position", "until, above the first [[body]]"},
                                       {"title", "position", "title, above the first [[body]]"},
                                       {"radius", "shape", k_disc},
                                       {"vertices", "shape", k_polygon},
                                       {"circle", "disc", "disc"},
                                       {"ball", "disc", "disc"},
                                       {"box", "rectangle", "rectangle"},
                                       {"hexagon", "regular", "regular"},
                                       {"pentagon", "regular", "regular"},
                                       {"type", "kind", "kind"},
                                       {"points", "vertices", "vertices"},
                                       {"size", "side", "side"},
                                       {"fixed", "static", "static"},
                                       {"rotation", "angle", "angle"},
                                       {"omega", "spin", "spin"},
                                       {"angular_velocity", "spin", "spin"},
                                       {"mu", "friction", "friction"},
                                       {"elasticity", "restitution", "restitution"},
                                       {"bounce", "restitution", "restitution"}};

/// What to write in place of a word, as far as that can be guessed.
std::string meant_by(std::string_view word, const std::vector<std::string>& known)
{
    for (const OtherWord& other : k_other_words) {
        if (word == other.word && std::find(known.begin(), known.end(), other.known) != known.end())
            return std::string(other.written);
    }
    return nearest_word(word, known);
}

} // namespace

std::string one_of(std::string_view word, const std::vector<std::string>& known)
{
    const std::string nearest = meant_by(word, known);
    std::string text;
    for (const std::string& candidate : known) text += (text.empty() ? "one of " : ", ") + candidate;
    if (known.size() == 1) text = known.front();
    if (!nearest.empty()) text += " (did you mean " + nearest + "?)";
    return text;
}

namespace {

/// The number that a node holds; whole ones count too.
std::optional<double> number_in(const toml::node& node)
{
    if (const auto* number = node.as_floating_point()) return number->get();
    if (const auto* number = node.as_integer()) return static_cast<double>(number->get());
    return std::nullopt;
}

} // namespace

TableReader::TableReader(FaultList& faults, const toml::table& table, std::string label, std::string joint)
    : faults_(&faults), table_(&table), label_(std::move(label)), joint_(std::move(joint))
{
}

std::string TableReader::label_of(std::string_view key) const
{
    return label_.empty() ? std::string(key) : label_ + joint_ + std::string(key);
}

void TableReader::fault(const toml::node& node, const std::string& label, std::string expected)
{
    faults_->add(node.source().begin, label, describe(node), std::move(expected));
}

const toml::node* TableReader::find(const char* key)
{
    if (std::find(known_.begin(), known_.end(), key) == known_.end()) known_.emplace_back(key);
    return table_->get(key);
}

const toml::node* TableReader::find_or_miss(const char* key, const char* expected, Need need)
{
    const toml::node* node = find(key);
    if (!node && need == Need::required) faults_->add(table_->source().begin, label_of(key), "nothing", expected);
    return node;
}

void TableReader::number(const char* key, double& value, const char* expected, Need need)
{
    const toml::node* node = find_or_miss(key, expected, need);
    if (!node) return;
    if (const std::optional<double> found = number_in(*node)) {
        value = *found;
    } else {
        fault(*node, label_of(key), expected);
    }
}

void TableReader::number(const char* key, std::optional<double>& value, const char* expected)
{
    if (!table_->contains(key)) {
        known_.emplace_back(key);
        return;
    }
    double found = 0.0;
    const std::size_t faults_before = faults_->size();
    number(key, found, expected, Need::optional);
    if (faults_->size() == faults_before) value = found;
}

void TableReader::integer(const char* key, int& value, const char* expected, Need need)
{
    const toml::node* node = find_or_miss(key, expected, need);
    if (!node) return;
    const auto* found = node->as_integer();
    if (found && found->get() >= std::numeric_limits<int>::min() && found->get() <= std::numeric_limits<int>::max()) {
        value = static_cast<int>(found->get());
    } else {
        fault(*node, label_of(key), expected);
    }
}

void TableReader::read_vector(const toml::node& node, const std::string& label, Vec2& value, const char* expected)
{
    const toml::array* array = node.as_array();
    if (!array || array->size() != 2) {
        fault(node, label, expected);
        return;
    }
    for (int k = 0; k < 2; ++k) {
        const toml::node& element = *array->get(static_cast<std::size_t>(k));
        const std::optional<double> coordinate = number_in(element);
        if (!coordinate) fault(element, label + "[" + std::to_string(k) + "]", "a number");
        value[k] = coordinate.value_or(value[k]);
    }
}

void TableReader::vector(const char* key, Vec2& value, const char* expected, Need need)
{
    const toml::node* node = find_or_miss(key, expected, need);
    if (node) read_vector(*node, label_of(key), value, expected);
}

void TableReader::text(const char* key, std::string& value, const char* expected)
{
    const toml::node* node = find(key);
    if (!node) return;
    if (const auto* found = node->as_string()) {
        value = found->get();
    } else {
        fault(*node, label_of(key), expected);
    }
}

void TableReader::flag(const char* key, bool& value)
{
    const toml::node* node = find(key);
    if (!node) return;
    if (const auto* found = node->as_boolean()) {
        value = found->get();
    } else {
        fault(*node, label_of(key), "true or false");
    }
}

void TableReader::read_points(const toml::node& node, const std::string& label, std::vector<Vec2>& value,
                              const char* expected)
{
    const toml::array* array = node.as_array();
    if (!array) {
        fault(node, label, expected);
        return;
    }
    for (std::size_t k = 0; k < array->size(); ++k) {
        Vec2 point = Vec2::Zero();
        read_vector(*array->get(k), label + "[" + std::to_string(k) + "]", point, "two numbers [x, y] [m]");
        value.push_back(point);
    }
}

void TableReader::points(const char* key, std::vector<Vec2>& value, const char* expected, Need need)
{
    const toml::node* node = find_or_miss(key, expected, need);
    if (node) read_points(*node, label_of(key), value, expected);
}

void TableReader::rings(const char* key, std::vector<std::vector<Vec2>>& value, const char* expected)
{
    const toml::node* node = find(key);
    if (!node) return;
    const toml::array* array = node->as_array();
    if (!array) {
        fault(*node, label_of(key), expected);
        return;
    }
    for (std::size_t k = 0; k < array->size(); ++k) {
        const std::string label = label_of(key) + "[" + std::to_string(k) + "]";
        read_points(*array->get(k), label, value.emplace_back(), "a list of points [[x, y], ...] [m]");
    }
}

std::string TableReader::word(const char* key, const std::vector<std::string>& words)
{
    const toml::node* node = find(key);
    if (!node) {
        faults_->add(table_->source().begin, label_of(key), "nothing", one_of("", words));
        return {};
    }
    const auto* found = node->as_string();
    if (found && std::find(words.begin(), words.end(), found->get()) != words.end()) return found->get();
    fault(*node, label_of(key), one_of(found ? std::string_view(found->get()) : std::string_view(), words));
    return {};
}

std::optional<TableReader> TableReader::table(const char* key, const char* expected, Need need)
{
    const toml::node* node = find_or_miss(key, expected, need);
    if (!node) return std::nullopt;
    if (const toml::table* found = node->as_table()) return TableReader(*faults_, *found, label_of(key));
    fault(*node, label_of(key), expected);
    return std::nullopt;
}

void TableReader::refuse_unknown_keys()
{
    for (const auto& [key, node] : *table_) {
        if (std::find(known_.begin(), known_.end(), key.str()) != known_.end()) continue;
        faults_->add_unknown_key(key.source().begin, label_, "the unknown key " + in_quotes(key.str()),
                                 one_of(key.str(), known_));
    }
}

} // namespace flying
