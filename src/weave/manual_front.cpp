#include "weave/manual_front.hpp"

#include <fmt/format.h>

#include "weave/text.hpp"

namespace flying::weave {

namespace {

/// The first block of the text with these words behind its backquotes, as a block of the language that they begin with.
std::string example_of(const ManualFront& front, const std::filesystem::path& project, Problems& problems)
{
    std::string block;
    bool inside = false;
    for (const std::string& line : split_lines(read_file(project / front.example).value_or(""))) {
        if (inside && line == "```") return block + "```\n\n";
        if (inside) block += line + "\n";
        if (!inside && line == "```" + front.fence) {
            inside = true;
            block = "```" + front.fence.substr(0, front.fence.find(' ')) + "\n";
        }
    }
    problems.add({front.example, 0}, fmt::format("no block that begins with ```{}", front.fence),
                 "the example of the manual's first page, as `[manual]` of book.toml names it");
    return "";
}

/// Is there a folder of src by this name?
bool is_there(const Material& material, const std::string& module)
{
    const std::string folder = "src/" + module + "/";
    const auto first = material.sources.files.lower_bound(folder);
    return first != material.sources.files.end() && first->first.rfind(folder, 0) == 0;
}

} // namespace

void write_manual_front(const Material& material, const std::filesystem::path& project,
                        const std::filesystem::path& file, Problems& problems)
{
    const Book& book = material.book;
    std::string text = fmt::format("# {}: the manual\n\n{}\n", book.title, book.manual.says);
    if (!book.manual.example.empty()) text += example_of(book.manual, project, problems);

    std::string rows;
    for (const Module& module : book.modules)
        if (is_there(material, module.name))
            rows += fmt::format("| <a href=\"../module_{0}.html\">{0}</a> | {1} |\n", module.name, module.says);
    if (!rows.empty()) text += "## Modules\n\n| module | what it does |\n|---|---|\n" + rows + "\n";

    text += book.manual.next;
    if (!write_file(file, text)) problems.add({file.string(), 0}, "can't be written", "a file in the build folder");
}

} // namespace flying::weave
