#include "program.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <sys/wait.h>

namespace flying::ui {

namespace {

std::string contents(const std::filesystem::path& file)
{
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

} // namespace

Folder::Folder()
{
    std::string name = (std::filesystem::temp_directory_path() / "flying-ui-XXXXXX").string();
    REQUIRE(mkdtemp(name.data()) != nullptr);
    path_ = name;
    std::filesystem::create_directory(path_ / "here");
}

Folder::~Folder()
{
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
}

Outcome Folder::run(const std::string& command) const
{
    // What was said is kept beside the folder, so that `names` shows only what the program left
    const std::string script = "cd '" + (path_ / "here").string() + "' && export FLYING='" FLYING_PROGRAM "' && { " +
                               command + "\n} >../output 2>../errors </dev/null";
    const int status = std::system(script.c_str());
    Outcome outcome;
    if (WIFEXITED(status)) outcome.status = WEXITSTATUS(status);
    outcome.output = contents(path_ / "output");
    outcome.errors = contents(path_ / "errors");
    return outcome;
}

void Folder::write(const std::string& name, const std::string& text) const
{
    std::ofstream(path_ / "here" / name, std::ios::binary) << text;
}

std::string Folder::read(const std::string& name) const
{
    return contents(path_ / "here" / name);
}

std::vector<std::string> Folder::names() const
{
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(path_ / "here")) {
        names.push_back(entry.path().filename().string());
    }
    std::sort(names.begin(), names.end());
    return names;
}

std::string two_discs()
{
    return R"(title = "two discs"
until = 2.0
[world]
box = { min = [0.0, 0.0], max = [10.0, 5.0] }
[[body]]
name = "left"
shape = { kind = "disc", radius = 0.5 }
position = [2.0, 2.5]
velocity = [3.0, 0.0]
[[body]]
shape = { kind = "disc", radius = 0.5 }
position = [8.0, 2.5]
velocity = [-3.0, 1.0]
)";
}

bool has_program(const std::string& name)
{
    return std::system(("command -v " + name + " >/dev/null 2>&1").c_str()) == 0;
}

} // namespace flying::ui
