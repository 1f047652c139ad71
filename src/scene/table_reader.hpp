#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "math/expected.hpp"
#include "math/vec2.hpp"
#include "scene/toml_library.hpp"

namespace flying {

/// Faults with their places in one text.
class FaultList
{
public:
    explicit FaultList(std::string filename) : filename_(std::move(filename)) {}

    /// at        where the fault stands in the text
    /// label     what it is about, such as `body "left", shape.radius`; may be empty
    void add(const toml::source_position& at, const std::string& label, std::string found, std::string expected);
    /// The same of an unknown key: all that was asked for is there.
    void add_unknown_key(const toml::source_position& at, const std::string& label, std::string found,
                         std::string expected);

    /// Whether one of the faults from number `first` up to `end` says that there is no such value, or not all of it.
    [[nodiscard]] bool is_lost(std::string_view label, std::size_t first, std::size_t end) const;

    [[nodiscard]] std::size_t size() const { return faults_.size(); }

    /// All faults in the order of the text; those at one place in the order in which they were met.
    [[nodiscard]] Faults in_order() const;

private:
    struct Placed
    {
        toml::source_position at;
        Fault fault;
        std::string lost; ///< label of the value that could not be read
        bool loses = false;
    };
    void place(const toml::source_position& at, const std::string& label, std::string found, std::string expected,
               bool loses);

    std::string filename_;
    std::vector<Placed> faults_;
};

/// Text with a question mark for each character that can't be printed, line ends among them.
[[nodiscard]] std::string on_one_line(std::string_view text);

/// Text between quotation marks for a message: at most forty bytes of it, what can't be printed as a question mark.
[[nodiscard]] std::string in_quotes(std::string_view text);

/// A value for a message: `-1`, `"abc"`, `true`, `an array of 3 values`, `a table`.
[[nodiscard]] std::string describe(const toml::node& node);

enum class Need
{
    required,
    optional
};

/// Reads the keys of one table into values, and tells every key that is missing, of the wrong type, or unknown. A value
/// that can't be read is left as it was; of a vector, each coordinate by itself.
class TableReader
{
public:
    /// label  of the table for messages; empty for the whole text
    /// joint  stands between the label and a key
    TableReader(FaultList& faults, const toml::table& table, std::string label, std::string joint = ".");

    void number(const char* key, double& value, const char* expected, Need need);
    void number(const char* key, std::optional<double>& value, const char* expected);
    void integer(const char* key, int& value, const char* expected, Need need);
    void vector(const char* key, Vec2& value, const char* expected, Need need);
    void text(const char* key, std::string& value, const char* expected);
    void flag(const char* key, bool& value);

    /// A list of points: [[x, y], ...].
    void points(const char* key, std::vector<Vec2>& value, const char* expected, Need need);
    /// A list of lists of points.
    void rings(const char* key, std::vector<std::vector<Vec2>>& value, const char* expected);

    /// The word under `key`, one of `words`; empty where it is missing or another.
    [[nodiscard]] std::string word(const char* key, const std::vector<std::string>& words);

    /// The table under `key`; none where it is missing or no table.
    [[nodiscard]] std::optional<TableReader> table(const char* key, const char* expected, Need need);

    /// The value under `key`, which counts as known from now on; null where it is missing.
    [[nodiscard]] const toml::node* find(const char* key);

    /// Tell every key that was not asked for.
    void refuse_unknown_keys();

    /// `label joint key`
    [[nodiscard]] std::string label_of(std::string_view key) const;

    void fault(const toml::node& node, const std::string& label, std::string expected);

private:
    const toml::node* find_or_miss(const char* key, const char* expected, Need need);
    void read_vector(const toml::node& node, const std::string& label, Vec2& value, const char* expected);
    void read_points(const toml::node& node, const std::string& label, std::vector<Vec2>& value, const char* expected);

    FaultList* faults_;
    const toml::table* table_;
    std::string label_;
    std::string joint_;
    std::vector<std::string> known_;
};

/// What to say where a word or key is none of those known: the nearest, if any, then all.
[[nodiscard]] std::string one_of(std::string_view word, const std::vector<std::string>& known);

} // namespace flying
