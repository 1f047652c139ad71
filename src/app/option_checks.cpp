#include "app/option_checks.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <cstdint>
#include <cstdlib>

#include "scene/fault.hpp"

namespace flying {

namespace {

std::string found(const std::string& word, const std::string& expected)
{
    return fmt::format("found {}, expected {}", word.empty() ? "nothing" : word, expected);
}

/// A check that all of a word is a number of this type.
template <typename Number>
CLI::Validator reads_as(const char* expected)
{
    return CLI::Validator(
        [expected](const std::string& word) {
            Number number{};
            const char* end = word.data() + word.size();
            const auto [stop, error] = std::from_chars(word.data(), end, number);
            return error == std::errc() && stop == end ? std::string() : found(word, expected);
        },
        "");
}

} // namespace

CLI::Validator is_number()
{
    // What strtod reads is what the parser converts afterwards: also 1e400, which is infinite, and whose bounds are
    // then told
    return CLI::Validator(
        [](const std::string& word) {
            char* stop = nullptr;
            std::strtod(word.c_str(), &stop);
            return !word.empty() && *stop == '\0' ? std::string() : found(word, "a number");
        },
        "");
}

CLI::Validator is_whole_number()
{
    return reads_as<int>("a whole number of at most 2147483647");
}

CLI::Validator is_seed()
{
    return reads_as<std::uint64_t>("a whole number from 0 to 18446744073709551615");
}

CLI::Validator is_file_name()
{
    return CLI::Validator(
        [](const std::string& word) {
            return word.empty() ? found("an empty name", "the name of a file") : std::string();
        },
        "");
}

CLI::Validator is_one_of(const std::vector<std::string>& words)
{
    return CLI::Validator(
        [words](const std::string& word) {
            if (std::find(words.begin(), words.end(), word) != words.end()) return std::string();
            const std::string near = nearest_word(word, words);
            return found(word, fmt::format("one of {}", fmt::join(words, ", "))) +
                   (near.empty() ? "" : fmt::format("; did you mean {}?", near));
        },
        fmt::format("{{{}}}", fmt::join(words, ",")));
}

} // namespace flying
