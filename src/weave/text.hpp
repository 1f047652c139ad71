#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// Small things to do with text and files.
namespace flying::weave {

/// The whole file, or nothing where it can't be read.
[[nodiscard]] std::optional<std::string> read_file(const std::filesystem::path& path);

/// Writes the file whole or not at all, making the folders on its way. A file that holds the text already is left
/// alone, so that its time of change means something. False where it can't be written.
[[nodiscard]] bool write_file(const std::filesystem::path& path, std::string_view text);

/// The lines without their ends; a last line without an end counts.
[[nodiscard]] std::vector<std::string> split_lines(std::string_view text);

/// The parts between the separators, empty ones too.
[[nodiscard]] std::vector<std::string> split(std::string_view text, char separator);

[[nodiscard]] std::string_view trim(std::string_view text);
[[nodiscard]] std::string join(const std::vector<std::string>& parts, std::string_view separator);
[[nodiscard]] std::string replace_all(std::string text, std::string_view from, std::string_view to);

/// Text as it may stand in HTML, in an attribute too.
[[nodiscard]] std::string escape_html(std::string_view text);

/// Lower-case words with hyphens between them: `Where it breaks` becomes `where-it-breaks`.
[[nodiscard]] std::string slug(std::string_view text);

/// The number that the whole text is, or nothing.
[[nodiscard]] std::optional<double> to_number(std::string_view text);

/// A line of code from Doxygen with those of its links that lead where they say. Doxygen looks names up without regard
/// to where they stand, so that a variable of a function is linked to whatever else has its name somewhere. Left are
/// types, constants, calls, and what stands behind its owner.
[[nodiscard]] std::string without_guessed_links(std::string_view line);

/// Whether the character may stand in a name of C++.
[[nodiscard]] bool is_word(char c);

} // namespace flying::weave
