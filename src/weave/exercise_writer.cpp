// Exercises and their answers as HTML.

#include <filesystem>

#include <fmt/format.h>

#include "weave/pages.hpp"
#include "weave/text.hpp"

namespace flying::weave {

namespace {

std::string exercise_title(const Chapter& chapter, const Exercise& exercise)
{
    return fmt::format("{}.{} \u00b7 {}", chapter.entry.label(), exercise.name.substr(1), exercise.text.title);
}

} // namespace

std::string TextWriter::exercise(const Chapter& chapter, const Block& block)
{
    for (const Exercise& exercise : chapter.exercises) {
        if (exercise.name != block.name) continue;
        std::string out = block_token(
            fragments_.add_html(fmt::format("<section class=\"exercise\" id=\"exercise-{}\"><h3>Exercise {}</h3>",
                                            exercise.name, escape_html(exercise_title(chapter, exercise)))));
        out += blocks(chapter, exercise.text);
        if (exercise.in_code && std::filesystem::exists(material_.folders.project / "course"))
            out +=
                block_token(fragments_.add_html(fmt::format("<p class=\"try\"><code>./course start {0}</code> puts "
                                                            "the beginning into <code>my/{1}/{2}.hpp</code>; "
                                                            "<code>./course check {0}</code> tries it.</p>",
                                                            chapter.entry.command_name(), chapter.entry.name, exercise.name)));
        if (exercise.hint) {
            out += block_token(fragments_.add_html("<details><summary>Hint</summary>"));
            out += blocks(chapter, *exercise.hint) + block_token(fragments_.add_html("</details>"));
        }
        if (exercise.in_code || exercise.solution)
            out += block_token(fragments_.add_html(fmt::format(
                "<p class=\"try\"><a href=\"answers.html#{}\">Answer</a></p>", answer_anchor(chapter, exercise))));
        return out + block_token(fragments_.add_html("</section>"));
    }
    return "";
}

std::string TextWriter::answer_anchor(const Chapter& chapter, const Exercise& exercise)
{
    return fmt::format("answer-{:02}-{}", chapter.entry.number, exercise.name);
}

std::string TextWriter::answers(const Chapter& chapter)
{
    std::string out = heading(2, fmt::format("{}: {}", chapter.entry.called_first(), chapter.entry.title));
    for (const Exercise& exercise : chapter.exercises) {
        out += block_token(fragments_.add_html(fmt::format("<section class=\"exercise\" id=\"{}\"><h3>{}</h3>",
                                                           answer_anchor(chapter, exercise),
                                                           escape_html(exercise_title(chapter, exercise)))));
        if (exercise.in_code) {
            const std::string code =
                read_file(material_.folders.project / exercise.folder / "solution.hpp").value_or("");
            out += block_token(fragments_.add_html("<p class=\"try\">As it passed the tests of this build:</p>"
                                                   "<div class=\"fragment\">" +
                                                   colour_code(code) + "</div>"));
        } else if (exercise.solution) {
            out += blocks(chapter, *exercise.solution);
        }
        out += block_token(fragments_.add_html(
            fmt::format("<p class=\"try\"><a href=\"{}.html#exercise-{}\">The exercise</a></p></section>",
                        chapter.entry.page(), exercise.name)));
    }
    return out;
}

} // namespace flying::weave
