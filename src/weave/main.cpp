#include <chrono>
#include <filesystem>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "weave/run.hpp"
#include "weave/tally.hpp"
#include "weave/text.hpp"

namespace weave = flying::weave;

namespace {

/// Says what is wrong, or what was made. The status of the program.
int conclude(const weave::Problems& problems, const std::string& success)
{
    if (problems.empty()) {
        fmt::print("{}\n", success);
        return 0;
    }
    fmt::print(stderr, "{}{} problem{}\n", problems.report(), problems.list().size(),
               problems.list().size() == 1 ? "" : "s");
    return 1;
}

/// `share/weave` beside the folder of this program.
std::filesystem::path installed_kit()
{
    std::error_code error;
    const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", error);
    return program.parent_path().parent_path() / "share/weave";
}

} // namespace

int main(int argc, char** argv)
{
    CLI::App app("Weaves chapters, sources and receipts into the book");
    app.require_subcommand(1);
    weave::Folders folders;
    weave::Tools tools;
    std::string project = ".";
    std::string build = "build/book";
    std::string source;
    std::string kit;
    const auto add_folders = [&](CLI::App* command) {
        command->add_option("--project", project, "folder that holds chapters, src and docs")
            ->check(CLI::ExistingDirectory);
        command->add_option("--build", build, "folder with receipts, outputs and figures, and for what is made");
        command
            ->add_option("--kit", kit,
                         "folder with the theme and Doxyfile.in; without it, the one that came with weave")
            ->check(CLI::ExistingDirectory);
        command->add_option("--node", tools.node, "the program node");
        command->add_option("--doxygen", tools.doxygen, "the program doxygen");
    };
    CLI::App* book = app.add_subcommand("book", "make the whole book");
    CLI::App* check = app.add_subcommand("check", "check every rule that needs no Doxygen");
    book->add_option("--module", tools.module, "the engine for pages, flying.wasm; without it they play recordings");
    CLI::App* filter = app.add_subcommand("filter", "print a source as Doxygen is to read it");
    add_folders(book);
    add_folders(check);
    filter->add_option("source", source, "the file")->required();
    CLI11_PARSE(app, argc, argv);

    if (filter->parsed()) {
        fmt::print("{}", weave::filter_source(weave::split_lines(weave::read_file(source).value_or(""))));
        return 0;
    }
    std::error_code error;
    std::filesystem::create_directories(build, error);
    folders.project = std::filesystem::canonical(project);
    folders.kit = kit.empty() ? installed_kit() : std::filesystem::canonical(kit);
    folders.build = std::filesystem::canonical(build);
    const auto start = std::chrono::steady_clock::now();
    weave::Problems problems;
    if (check->parsed()) {
        const weave::Woven woven = weave::weave_pages(folders, tools, problems);
        fmt::print("{}", weave::tally_lines(weave::tallies(woven.material, woven.counts.coverage)));
        return conclude(problems, fmt::format("{} pages, no problem", woven.pages.list.size()));
    }
    weave::make_book(folders, tools, problems);
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return conclude(problems, fmt::format("{} ({:.1f} s)", (folders.build / "html/index.html").string(), seconds));
}
