#include "weave/rules.hpp"

#include <algorithm>
#include <filesystem>
#include <map>
#include <optional>
#include <regex>

#include <fmt/format.h>

#include "weave/claims.hpp"
#include "weave/inline.hpp"
#include "weave/receipts.hpp"
#include "weave/text.hpp"

namespace flying::weave {

namespace {

namespace fs = std::filesystem;

/// Where each line of each file is shown as new.
using Shown = std::map<std::string, std::map<int, Place>>;

void note_region(const Sources& sources, const Region& region, const Place& place, Shown& shown, Problems& problems)
{
    const SourceFile& file = sources.files.at(region.file);
    std::map<int, Place>& of_file = shown[region.file];
    bool twice = false;
    for (int line = region.first; line <= region.last; ++line) {
        const bool folded = std::any_of(region.inner.begin(), region.inner.end(), [&](int inner) {
            return sources.regions[inner].first <= line && line <= sources.regions[inner].last;
        });
        if (folded || file.kinds[line - 1] != LineKind::content) continue;
        const auto [first, is_new] = of_file.emplace(line, place);
        if (!is_new && !twice)
            problems.add(place,
                         fmt::format("region `{}` shown as new for the second time, after {}:{}", region.name,
                                     first->second.file, first->second.line),
                         "`again` after its name");
        twice = twice || !is_new;
    }
}

/// Notes what a text lists, and which regions it uses so.
void note_listings(const Material& material, const Chapter& chapter, const ChapterText& text, Shown& shown,
                   std::set<int>& used, Problems& problems)
{
    const std::set<std::string> own(chapter.entry.files.begin(), chapter.entry.files.end());
    for (const Block& block : text.blocks) {
        if (block.kind != BlockKind::listing) continue;
        const Listing listing = listing_of(block);
        for (const std::string& name : listing.names) {
            const int index = material.sources.find(name);
            if (index < 0) {
                problems.add(block.place, fmt::format("listing of `{}`, which is no region", name),
                             "`folder/file.hpp:declaration`, the name of a marked region, or the path of a file "
                             "without markers");
                continue;
            }
            const Region& region = material.sources.regions[index];
            used.insert(index);
            used.insert(region.inner.begin(), region.inner.end());
            if (listing.is_again) continue;
            const bool is_engine = region.file.rfind("src/", 0) == 0;
            if (is_engine && own.count(region.file) == 0)
                problems.add(
                    block.place,
                    fmt::format("listing of `{}` as new, though {} belongs to another chapter", name, region.file),
                    "`again` after its name");
            note_region(material.sources, region, block.place, shown, problems);
        }
    }
}

// ---- Prose ----------------------------------------------------------------------------------------------------------

/// A decimal number that is no version: 1.5, 2e-9, but not 1.9.4.
std::optional<std::string> typed_decimal(const std::string& text)
{
    static const std::regex k_number(R"(\d+(\.\d+)+|\b\d+e-?\d+\b)");
    for (std::sregex_iterator at(text.begin(), text.end(), k_number), end; at != end; ++at) {
        const std::string number = at->str();
        if (std::count(number.begin(), number.end(), '.') <= 1) return number;
    }
    return std::nullopt;
}

using Lines = std::vector<std::pair<int, std::string>>;

void check_text(const Block& block, const Lines& words, int& given, Problems& problems)
{
    static const std::regex k_insert(R"(\{\{[^}]*\}\})");
    for (const Piece& piece : pieces_of(words)) {
        const Place place{block.place.file, piece.line};
        if (piece.kind == PieceKind::insert && parse_insert(piece.text).kind == "given") ++given;
        if (piece.kind == PieceKind::math) {
            given += static_cast<int>(std::distance(
                std::sregex_iterator(piece.text.begin(), piece.text.end(), k_insert), std::sregex_iterator()));
        }
        if (piece.kind != PieceKind::prose && piece.kind != PieceKind::math) continue;
        const std::vector<std::string> lines = split(std::regex_replace(piece.text, k_insert, ""), '\n');
        for (std::size_t k = 0; k < lines.size(); ++k) {
            const Place here{place.file, place.line + static_cast<int>(k)};
            if (const auto number = typed_decimal(lines[k]))
                problems.add(
                    here, fmt::format("decimal number {} typed into the text", *number),
                    fmt::format("{{{{value:name|%.3g}}}} for what the build computes, {{{{given:{}}}}} for what "
                                "is given",
                                *number));
            if (piece.kind != PieceKind::prose) continue;
            const bool in_caption = !block.caption.empty();
            if (const auto number = in_caption ? number_word(lines[k]) : rough_number_word(lines[k]))
                problems.add(here, fmt::format("a number in words, `{}`", *number),
                             fmt::format("{{{{value:name|%.0f}}}} for what the build computes, {{{{given:{}}}}} for "
                                         "what is given",
                                         *number));
            if (lines[k].find("![") != std::string::npos)
                problems.add(here, "a picture in Markdown", "::figure name \"caption\"");
            if (lines[k].find("$$") != std::string::npos)
                problems.add(here, "a displayed formula between $$", "::equation, ::definition or ::derivation");
            else if (lines[k].find('$') != std::string::npos && lines[k].find("\\$") == std::string::npos)
                problems.add(here, "a dollar without its pair", "$formula$, or \\$ for a dollar");
        }
    }
}

void check_fence(const Block& block, Problems& problems)
{
    static const std::set<std::string> k_quoted = {"text", "sh", "toml", "markdown"};
    if (k_quoted.count(block.language) > 0) return;
    if (block.language == "tex")
        problems.add(block.place, "a formula without a directive",
                     "::equation, ::definition or ::derivation on the line before");
    else
        problems.add(block.place, fmt::format("a block of `{}` typed into the text", block.language),
                     "::listing of compiled code, or ```text, ```sh, ```toml, ```markdown");
}

// ---- Completeness ---------------------------------------------------------------------------------------------------

void check_pictures(const Material& material, const Chapter& chapter, const ChapterText& text, Problems& problems)
{
    for (const Block& block : text.blocks) {
        const bool is_figure = block.kind == BlockKind::figure;
        if (!is_figure && block.kind != BlockKind::live) continue;
        const std::string directive = directive_word(block.kind);
        if (block.caption.size() < 10)
            problems.add(block.place,
                         fmt::format("::{} {} without words for those who don't see it", directive, block.name),
                         fmt::format("::{} {} \"what it shows, in a sentence\"", directive, block.name));
        if (block.alt.empty() && block.caption.find('$') != std::string::npos)
            problems.add(block.place, fmt::format("::{} {} with a formula in its caption", directive, block.name),
                         "\"what there is\" after it, without formulas");
        const fs::path file = drawn_file(material, chapter, block.name + (is_figure ? ".svg" : ".ndjson"));
        if (!fs::exists(file))
            problems.add(block.place,
                         fmt::format("::{} {} without {}", directive, block.name, file.filename().string()),
                         fmt::format("{}/figures.cpp to write it", chapter.entry.folder()));
    }
}

/// A chapter's tests stand in tests.cpp, or in several files whose names start so.
bool has_tests(const fs::path& folder)
{
    std::error_code error;
    for (const auto& file : fs::directory_iterator(folder, error))
        if (file.path().filename().string().rfind("tests", 0) == 0 && file.path().extension() == ".cpp") return true;
    return false;
}

/// An output that is shown in parts is shown whole: each table once, in order.
void check_output_parts(const Material& material, const Chapter& chapter, Problems& problems)
{
    std::map<std::string, int> shown; // by program: how many of its tables so far
    for (const Block& block : chapter.text.blocks) {
        if (block.kind != BlockKind::output) continue;
        const auto printed = material.outputs.find(chapter.entry.name + "/" + block.name);
        if (printed == material.outputs.end() || block.options.empty()) continue;
        const int count = static_cast<int>(output_tables(printed->second).size());
        const std::optional<OutputPart> part = output_part(block.options);
        int& before = shown[block.name];
        if (!part || part->first != before + 1 || part->last < part->first || part->last > count)
            problems.add(block.place, fmt::format("the part `{}` of what `{}` printed", block.options, block.name),
                         fmt::format("one that begins with table {}, of {}", before + 1, count));
        else before = part->last;
    }
    for (const auto& [program, count] : shown) {
        const int all = static_cast<int>(output_tables(material.outputs.at(chapter.entry.name + "/" + program)).size());
        if (count != all)
            problems.add({chapter.text.path, 0}, fmt::format("{} tables of `{}` shown", count, program),
                         fmt::format("all {}", all));
    }
}

} // namespace

std::vector<const ChapterText*> texts_of(const Chapter& chapter)
{
    std::vector<const ChapterText*> texts{&chapter.text};
    for (const Exercise& exercise : chapter.exercises) {
        texts.push_back(&exercise.text);
        if (exercise.hint) texts.push_back(&*exercise.hint);
        if (exercise.solution) texts.push_back(&*exercise.solution);
    }
    return texts;
}

Share Coverage::sum() const
{
    Share all;
    for (const Share& share : shares) {
        all.lines += share.lines;
        all.told += share.told;
    }
    return all;
}

Coverage check_coverage(const Material& material, Problems& problems)
{
    const Sources& sources = material.sources;
    Shown shown;
    std::set<int> used;
    for (const Chapter& chapter : material.chapters)
        for (const ChapterText* text : texts_of(chapter))
            note_listings(material, chapter, *text, shown, used, problems);

    // A mark is there for a listing
    std::set<std::string> planned;
    for (const ChapterEntry& entry : material.book.chapters) {
        if (entry.written) continue;
        planned.insert(entry.files.begin(), entry.files.end());
    }
    for (int k = 0; k < static_cast<int>(sources.regions.size()); ++k) {
        const Region& region = sources.regions[k];
        if (region.declared || region.whole_file || used.count(k) > 0 || planned.count(region.file) > 0) continue;
        const std::size_t slash = region.file.find('/', 9);
        const std::string folder = region.file.substr(0, slash);
        const bool is_planned = region.file.rfind("chapters/", 0) == 0 &&
                                std::none_of(material.chapters.begin(), material.chapters.end(),
                                             [&](const Chapter& chapter) { return chapter.entry.folder() == folder; });
        if (is_planned) continue;
        problems.add({region.file, region.first - 1}, fmt::format("marks of `{}`, which no listing shows", region.name),
                     "no marks, or a ::listing");
    }

    Coverage coverage;
    for (const Chapter& chapter : material.chapters) {
        Share share;
        share.chapter = chapter.entry.number;
        share.called = chapter.entry.called();
        for (const std::string& path : chapter.entry.files) {
            const auto file = sources.files.find(path);
            if (file == sources.files.end()) {
                problems.add({"chapters/book.toml", chapter.entry.line}, fmt::format("{}, which is not there", path),
                             "files of the engine");
                continue;
            }
            share.lines +=
                static_cast<int>(std::count(file->second.kinds.begin(), file->second.kinds.end(), LineKind::content));
            share.told += static_cast<int>(shown[path].size());
        }
        if (share.part() < chapter.entry.told)
            problems.add({chapter.text.path, 0},
                         fmt::format("a story that tells {} of the {} lines of its files, {:.1f} %", share.told,
                                     share.lines, 100.0 * share.part()),
                         fmt::format("at least {:.1f} %, as book.toml has it (told)", 100.0 * chapter.entry.told));
        coverage.shares.push_back(share);
    }
    return coverage;
}

int check_prose(const Material& material, Problems& problems)
{
    int given = 0;
    const auto check = [&](const ChapterText& text) {
        for (const Block& block : text.blocks) {
            if (block.kind == BlockKind::text) check_text(block, block.lines, given, problems);
            for (const std::string& words : {block.caption, block.alt})
                if (!words.empty()) check_text(block, Lines{{block.place.line, words}}, given, problems);
            if (block.kind == BlockKind::fence) check_fence(block, problems);
            if (block.kind != BlockKind::derivation) continue;
            for (const Step& step : steps_of(block)) {
                check_text(block, Lines{{step.line, step.reason}}, given, problems);
                if (step.reason.empty())
                    problems.add({block.place.file, step.line}, "a line of a derivation without a reason",
                                 "`% why it follows` after it");
            }
        }
    };
    for (const auto& [name, text] : material.extras) check(text);
    for (const Chapter& chapter : material.chapters)
        for (const ChapterText* text : texts_of(chapter)) check(*text);
    return given;
}

void check_completeness(const Material& material, Problems& problems)
{
    for (const Chapter& chapter : material.chapters) {
        const std::string folder = chapter.entry.folder();
        const Place place{chapter.text.path, 0};
        const auto shows = [&](BlockKind kind) {
            return std::any_of(chapter.text.blocks.begin(), chapter.text.blocks.end(),
                               [kind](const Block& block) { return block.kind == kind; });
        };
        const auto section = [&](const char* name) {
            const auto& names = chapter.text.sections;
            return std::find(names.begin(), names.end(), name) != names.end();
        };
        const auto need = [&](bool there, const char* found, const std::string& expected) {
            if (!there) problems.add(place, found, expected);
        };
        need(chapter.text.title == chapter.entry.title, "a title that is not the one of book.toml",
             "`# " + chapter.entry.title + "`");
        need(fs::exists(material.folders.project / folder / "demo.cpp"), "a chapter without demo",
             folder + "/demo.cpp");
        need(shows(BlockKind::output), "a chapter that never shows its demo's output", "::output demo");
        need(has_tests(material.folders.project / folder), "a chapter without tests", folder + "/tests.cpp");
        need(shows(BlockKind::figure), "a chapter without figure", "::figure name \"caption\"");
        need(shows(BlockKind::exercise), "a chapter without exercise", "::exercise e1");
        need(section("Summary"), "a chapter without summary", "`## Summary`");
        need(section("Symbols") && !chapter.text.symbols.empty(), "a chapter without its table of symbols",
             "`## Symbols` and a table | $symbol$ | meaning | unit | `name` |");

        for (const ChapterText* text : texts_of(chapter)) check_pictures(material, chapter, *text, problems);
        for (const Exercise& exercise : chapter.exercises) {
            const auto poses = [&](const Block& b) { return b.kind == BlockKind::exercise && b.name == exercise.name; };
            if (std::none_of(chapter.text.blocks.begin(), chapter.text.blocks.end(), poses))
                problems.add({exercise.folder, 0}, "an exercise that its chapter never poses",
                             "::exercise " + exercise.name);
        }
        for (const Block& block : chapter.text.blocks) {
            if (block.kind == BlockKind::exercise &&
                std::none_of(chapter.exercises.begin(), chapter.exercises.end(),
                             [&](const Exercise& e) { return e.name == block.name; }))
                problems.add(block.place, fmt::format("exercise {} that is not there", block.name),
                             folder + "/exercises/" + block.name);
            if (block.kind == BlockKind::output && material.outputs.count(chapter.entry.name + "/" + block.name) == 0)
                problems.add(block.place, fmt::format("output of `{}`, which never ran", block.name),
                             "the name of a program of this chapter, such as `demo`");
        }
        check_output_parts(material, chapter, problems);
    }
}

} // namespace flying::weave
