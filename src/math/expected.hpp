#pragma once

#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace flying {

/// One thing that is wrong with an input: where it stands, what was found there, what was expected.
/// `place` is a path into the value, such as `body[3].shape.vertices[0]`; empty for the value as a whole.
struct Fault
{
    std::string place;
    std::string found;
    std::string expected;

    friend bool operator==(const Fault&, const Fault&) = default;
};

/// All that is wrong, in the order in which it was met.
using Faults = std::vector<Fault>;

/// A value, or every reason why there is none. Never holds an empty list of reasons.
template <typename T>
class Expected
{
public:
    Expected(T value) : content_(std::in_place_index<0>, std::move(value)) {}
    Expected(Faults faults) : content_(std::in_place_index<1>, std::move(faults)) {}
    Expected(Fault fault) : content_(std::in_place_index<1>, Faults{std::move(fault)}) {}

    [[nodiscard]] bool has_value() const { return content_.index() == 0; }
    explicit operator bool() const { return has_value(); }

    /// The value. Only where has_value().
    [[nodiscard]] const T& value() const& { return *std::get_if<0>(&content_); }
    [[nodiscard]] T& value() & { return *std::get_if<0>(&content_); }
    [[nodiscard]] T&& value() && { return std::move(*std::get_if<0>(&content_)); }

    /// The reasons. Only where !has_value().
    [[nodiscard]] const Faults& faults() const { return *std::get_if<1>(&content_); }

private:
    std::variant<T, Faults> content_;
};

} // namespace flying
