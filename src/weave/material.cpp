#include "weave/material.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "weave/text.hpp"

namespace flying::weave {

namespace {

namespace fs = std::filesystem;

std::optional<ChapterText> read_text(const fs::path& project, const std::string& path, Problems& problems)
{
    const std::optional<std::string> text = read_file(project / path);
    if (!text) return std::nullopt;
    return parse_chapter(path, *text, problems);
}

std::vector<Exercise> read_exercises(const fs::path& project, const ChapterEntry& entry, Problems& problems)
{
    std::vector<std::string> names;
    std::error_code error;
    for (const auto& folder : fs::directory_iterator(project / entry.folder() / "exercises", error))
        if (folder.is_directory()) names.push_back(folder.path().filename().string());
    std::sort(names.begin(), names.end());

    std::vector<Exercise> exercises;
    for (const std::string& name : names) {
        Exercise exercise;
        exercise.name = name;
        exercise.folder = entry.folder() + "/exercises/" + name;
        const auto has = [&](const char* file) { return fs::exists(project / exercise.folder / file); };
        exercise.in_code = has("tests.cpp") || has("stub.hpp") || has("solution.hpp");
        if (std::optional<ChapterText> text = read_text(project, exercise.folder + "/text.md", problems)) {
            exercise.text = std::move(*text);
        } else {
            problems.add({exercise.folder, 0}, "an exercise without text.md", "its title and its task");
        }
        exercise.hint = read_text(project, exercise.folder + "/hint.md", problems);
        if (!exercise.hint) problems.add({exercise.folder, 0}, "an exercise without hint.md", "a hint");
        if (exercise.in_code) {
            for (const char* file : {"stub.hpp", "solution.hpp", "tests.cpp"})
                if (!has(file))
                    problems.add({exercise.folder, 0}, fmt::format("an exercise in code without {}", file),
                                 "stub.hpp, solution.hpp and tests.cpp");
        } else {
            exercise.solution = read_text(project, exercise.folder + "/solution.md", problems);
            if (!exercise.solution)
                problems.add({exercise.folder, 0}, "an exercise without solution",
                             "solution.md, or stub.hpp, solution.hpp and tests.cpp");
        }
        exercises.push_back(std::move(exercise));
    }
    return exercises;
}

/// Numbers the formulas and the figures of a chapter in the order in which its pages show them.
class Numbering
{
public:
    Numbering(const Chapter& chapter, Material& material, Problems& problems)
        : chapter_(chapter), material_(material), problems_(problems)
    {
    }

    void add(const ChapterText& text, const std::string& page)
    {
        for (const Block& block : text.blocks) {
            const bool is_formula = block.kind == BlockKind::equation || block.kind == BlockKind::definition ||
                                    block.kind == BlockKind::derivation;
            if (is_formula) add(block, page);
            if (block.kind == BlockKind::figure || block.kind == BlockKind::live)
                material_.figures.emplace(chapter_.entry.name + "/" + figure_key(block),
                                          fmt::format("{}.{}", chapter_.entry.label(), ++figures_));
            if (block.kind != BlockKind::exercise) continue;
            for (const Exercise& exercise : chapter_.exercises) {
                if (exercise.name != block.name) continue;
                add(exercise.text, page);
                if (exercise.hint) add(*exercise.hint, page);
                if (exercise.solution) add(*exercise.solution, "answers");
            }
        }
    }

private:
    void add(const Block& block, const std::string& page)
    {
        Numbered numbered;
        numbered.kind = block.kind;
        numbered.number = fmt::format("{}.{}", chapter_.entry.label(), ++count_);
        numbered.page = page;
        numbered.anchor = "eq-" + slug(block.name);
        numbered.block = &block;
        const auto [at, is_new] = material_.numbered.emplace(block.name, numbered);
        if (is_new) return;
        const Place& other = at->second.block->place;
        problems_.add(block.place,
                      fmt::format("formula `{}`, which stands at {}:{} too", block.name, other.file, other.line),
                      "each id once; refer to it by {{eq:" + block.name + "}}");
    }

    const Chapter& chapter_;
    Material& material_;
    Problems& problems_;
    int count_ = 0;
    int figures_ = 0;
};

} // namespace

Material read_material(const Folders& folders, Problems& problems)
{
    Material material;
    material.folders = folders;
    material.book = read_book(folders.project, problems);
    material.sources = read_sources(folders.project, problems);
    material.ledger = read_ledger(folders.build / "receipts", problems);

    for (const char* name : {"about", "glossary", "teachers"})
        if (std::optional<ChapterText> text = read_text(folders.project, fmt::format("chapters/{}.md", name), problems))
            material.extras[name] = std::move(*text);
    for (const ChapterEntry& entry : material.book.chapters) {
        if (!entry.written) continue;
        Chapter chapter;
        chapter.entry = entry;
        std::optional<ChapterText> text = read_text(folders.project, entry.folder() + "/chapter.md", problems);
        if (!text) {
            problems.add({"chapters/book.toml", entry.line}, fmt::format("no {}/chapter.md", entry.folder()),
                         "the text of a chapter that is `written = true`");
            continue;
        }
        chapter.text = std::move(*text);
        chapter.exercises = read_exercises(folders.project, entry, problems);
        material.chapters.push_back(std::move(chapter));

        std::error_code error;
        for (const auto& file : fs::directory_iterator(folders.build / "outputs" / entry.name, error)) {
            if (file.path().extension() != ".txt") continue;
            const std::string program = file.path().stem().string();
            const std::string output = read_file(file.path()).value_or("");
            material.outputs[entry.name + "/" + program] = output;
            add_printed_values(fmt::format("{}.{}", entry.name.substr(3), program), output, material.ledger);
        }
    }
    for (const Chapter& chapter : material.chapters) {
        Numbering numbering(chapter, material, problems);
        numbering.add(chapter.text, chapter.entry.page());
    }
    return material;
}

fs::path drawn_file(const Material& material, const Chapter& chapter, const std::string& name)
{
    return material.folders.build / "figures" / chapter.entry.name / name;
}

std::string page_title(const ChapterEntry& entry)
{
    return fmt::format("{} \u00b7 {}", entry.label(), entry.title);
}

} // namespace flying::weave
