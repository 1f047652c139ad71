#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace flying::ui {

/// What became of a command.
struct Outcome
{
    int status = -1;    ///< as the shell has it: 128 + signal where a signal ended it
    std::string output; ///< standard output
    std::string errors; ///< standard error
};

/// A folder of its own for one test, gone after it.
class Folder
{
public:
    Folder();
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;
    ~Folder();

    /// Run a shell command in the folder; $FLYING is the program.
    [[nodiscard]] Outcome run(const std::string& command) const;
    void write(const std::string& name, const std::string& text) const;
    [[nodiscard]] std::string read(const std::string& name) const;
    /// Names of all that it holds, hidden ones too, sorted.
    [[nodiscard]] std::vector<std::string> names() const;
    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path path_;
};

/// Two discs in a box without gravity, that meet each other and the walls; 2 s.
[[nodiscard]] std::string two_discs();

[[nodiscard]] inline bool contains(const std::string& text, const std::string& part)
{
    return text.find(part) != std::string::npos;
}

/// A program of this name can be started.
[[nodiscard]] bool has_program(const std::string& name);

} // namespace flying::ui
