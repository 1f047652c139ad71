#include "weave/study.hpp"

#include <fmt/format.h>

#include "weave/text.hpp"

namespace flying::weave {

std::string goals_box(const ChapterEntry& entry)
{
    std::string goals;
    for (const std::string& goal : entry.goals) goals += fmt::format("<li>{}</li>", escape_html(goal));
    return fmt::format("<section class=\"goals\"><p>About {} hour{}, with the exercises. Afterwards you can</p>"
                       "<ul>{}</ul></section>",
                       entry.hours, entry.hours == 1 ? "" : "s", goals);
}

std::string run_box(const ChapterEntry& entry, const std::string& program)
{
    const auto row = [&](const std::string& options, const std::string& what) {
        return fmt::format("<li><code>./course chapter {}{}</code> {}</li>", entry.command_name(),
                           options.empty() ? "" : " " + escape_html(options), escape_html(what));
    };
    std::string rows = row(program, "this output");
    if (program == "demo") {
        rows += row("", "the chapter's tests first, then this output");
        for (const Run& run : entry.runs) rows += row(run.options, run.what);
    }
    return fmt::format("<details class=\"run\"><summary>How to run this</summary><p>In the folder of the project; the "
                       "program is <code>{}/{}.cpp</code>. Change it and run it again.</p><ul>{}</ul></details>",
                       entry.folder(), escape_html(program), rows);
}

std::vector<Term> terms_of(const ChapterText& glossary)
{
    constexpr std::string_view k_start = "- **";
    constexpr std::string_view k_end = "**:";
    std::vector<Term> terms;
    for (const Block& block : glossary.blocks)
        for (const auto& [number, line] : block.lines) {
            const std::size_t end = line.find(k_end);
            if (line.rfind(k_start, 0) != 0 || end == std::string::npos) continue;
            Term term;
            term.term = line.substr(k_start.size(), end - k_start.size());
            term.meaning = trim(std::string_view(line).substr(end + k_end.size()));
            term.anchor = "term-" + slug(term.term);
            terms.push_back(std::move(term));
        }
    return terms;
}

} // namespace flying::weave
