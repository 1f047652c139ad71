#pragma once

#include <filesystem>
#include <string>

#include <doctest/doctest.h>
#include <unistd.h>

#include "weave/run.hpp"
#include "weave/text.hpp"

/// The example chapter in a folder of its own, where a test may break it.
class ExampleTree
{
public:
    ExampleTree()
    {
        namespace fs = std::filesystem;
        static int count = 0;
        root_ = fs::temp_directory_path() / ("weave-" + std::to_string(::getpid()) + "-" + std::to_string(count++));
        fs::create_directories(root_ / "docs");
        fs::copy(WEAVE_EXAMPLE, root_, fs::copy_options::recursive);
        fs::copy(fs::path(FLYING_SOURCE_DIR) / "docs/formulas.js", root_ / "docs/formulas.js");

        // What the chapter's programs leave behind
        write("build/receipts/chapter_01.json",
              R"({"passed": true, "equations": {"hinge.end": {"cases": 210, "passed": true,
            "worst": 2e-16, "bound": 1e-15, "where": "test", "twins": 210, "twins_rejected": true, "twin_bound": 1e-15,
            "samples": [{"value": 4.0, "quantities": {"m": 3.0, "l": 2.0}}, {"value": 9.0, "quantities": {"m": 3.0, "l": 3.0}}]}},
            "derivations": {}, "values": {}})");
        write("build/outputs/01-hinge/demo.txt", "inertia = 4.000 kg m^2\n");
        write("build/figures/01-hinge/rod.svg", "<svg xmlns=\"http://www.w3.org/2000/svg\"/>\n");
    }
    ~ExampleTree()
    {
        std::error_code error;
        std::filesystem::remove_all(root_, error);
    }
    ExampleTree(const ExampleTree&) = delete;
    ExampleTree& operator=(const ExampleTree&) = delete;

    [[nodiscard]] const std::filesystem::path& root() const { return root_; }

    void write(const std::string& path, const std::string& text) const
    {
        REQUIRE(flying::weave::write_file(root_ / path, text));
    }
    [[nodiscard]] std::string read(const std::string& path) const
    {
        return flying::weave::read_file(root_ / path).value_or("");
    }
    void remove(const std::string& path) const { REQUIRE(std::filesystem::remove(root_ / path)); }

    /// Changes a file; the text to change must be there.
    void replace(const std::string& path, const std::string& from, const std::string& to) const
    {
        const std::string text = read(path);
        REQUIRE(text.find(from) != std::string::npos);
        write(path, flying::weave::replace_all(text, from, to));
    }

    [[nodiscard]] flying::weave::Woven weave(flying::weave::Problems& problems) const
    {
        return flying::weave::weave_pages({root_, root_ / "docs", root_ / "build"}, {}, problems);
    }

    /// What is wrong with the example, as it is printed.
    [[nodiscard]] std::string problems() const
    {
        flying::weave::Problems problems;
        (void)weave(problems);
        return problems.report();
    }

private:
    std::filesystem::path root_;
};
