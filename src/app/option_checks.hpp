#pragma once

// What the words behind an option have to be. Each check says what was found and what was expected; the program's
// parser puts the option's name before it.

#include <string>
#include <vector>

namespace CLI {
class Validator;
}

namespace flying {

/// Any number; its bounds are looked at where it is used.
[[nodiscard]] CLI::Validator is_number();

/// A whole number that fits into `int`.
[[nodiscard]] CLI::Validator is_whole_number();

/// A whole number from 0 to 2^64 - 1.
[[nodiscard]] CLI::Validator is_seed();

/// A name that isn't empty, as "$FILE" is in a shell where FILE was never set.
[[nodiscard]] CLI::Validator is_file_name();

/// One of these words; the help lists them behind the option.
[[nodiscard]] CLI::Validator is_one_of(const std::vector<std::string>& words);

} // namespace flying
