#pragma once

// What `chapters/book.toml` says: chapters, their order, what each needs and tells.

#include <filesystem>
#include <string>
#include <vector>

#include "weave/problems.hpp"

namespace flying::weave {

/// A call of a chapter's program with options.
struct Run
{
    std::string options; ///< after `./course chapter NN`, such as `demo 0.9`
    std::string what;    ///< it does
};

/// A chapter as `chapters/book.toml` lists it.
struct ChapterEntry
{
    int number = 0;                 ///< of its folder, which it keeps: what names the chapter in book.toml and its page
    int place = 0;                  ///< in the order of book.toml, from 1: what the book calls it; 0 for an appendix
    std::string appendix;           ///< its letter, where it is an appendix: these come last
    std::string name;               ///< of its folder under `chapters`, such as `02-rectangle`
    std::string title;              ///< what the heading of its page says
    std::string part;               ///< heading under which the contents list it
    std::string question;           ///< the one it answers; shown in the contents and on the map
    std::vector<std::string> files; ///< engine files that belong to it, from the project's folder
    std::vector<int> needs;         ///< numbers of the chapters it builds on directly
    double told = 0.2;              ///< share of the lines of its files that its story has to tell
    int hours = 0;                  ///< that it takes, with its exercises
    std::vector<std::string> goals; ///< what a reader can do afterwards: verb first, no full stop
    std::vector<Run> runs;          ///< its programs with options
    bool written = false;           ///< its text is there: every rule applies to it and to its files
    int line = 0;                   ///< in book.toml

    /// `2`, or `A`: what stands before its title, its equations and its figures.
    [[nodiscard]] std::string label() const { return appendix.empty() ? std::to_string(place) : appendix; }
    /// `chapter 2`, or `appendix A`.
    [[nodiscard]] std::string called() const;
    /// `Chapter 2`, or `Appendix A`.
    [[nodiscard]] std::string called_first() const;
    /// `02`, or `A`: what commands take.
    [[nodiscard]] std::string command_name() const;
    /// `chapter_02`: the name of its page.
    [[nodiscard]] std::string page() const;
    /// `chapters/02-rectangle`
    [[nodiscard]] std::string folder() const { return "chapters/" + name; }
};

/// The exercises of a chapter, or how many of them it has to have.
struct ExerciseCount
{
    int all = 0;
    int in_code = 0;
    int hard = 0;    ///< their titles end in "(hard)"
    int changes = 0; ///< name a source to change, in task or hint: `src/...`, or a file of a chapter

    [[nodiscard]] bool has(const ExerciseCount& least) const
    {
        return all >= least.all && in_code >= least.in_code && hard >= least.hard && changes >= least.changes;
    }
};

/// A folder of `src`.
struct Module
{
    std::string name;
    std::string says; ///< what it does, in a line
};

/// What other books call something that is explained here under another name: for the search.
struct OtherWords
{
    std::vector<std::string> words;
    std::string page;    ///< a chapter, by the name of its folder without number, or a page such as `about`
    std::string section; ///< its heading; empty for the page itself
    int line = 0;        ///< in book.toml
};

/// The first page of the manual of the code.
struct ManualFront
{
    std::string says;    ///< above the example; Markdown, as Doxygen reads it
    std::string example; ///< a text of the project that has the example, such as `docs/USING.md`
    std::string fence;   ///< the words behind its backquotes, such as `cpp example`: the first block with them is shown
    std::string next;    ///< below the modules
};

/// The table of contents.
struct Book
{
    std::string title;
    std::string brief;        ///< what it is, in a few words; under the title of the manual
    std::string front;        ///< what its first page says, above the contents; Markdown
    bool is_playable = false; ///< it runs scenes of this project's engine: a playground, and a figure on the first page
    std::string version;      ///< of the project, as CMakeLists.txt has it; empty where it has none
    std::vector<ChapterEntry> chapters; ///< in the order of the file, then the appendices by their letters
    ExerciseCount least_exercises; ///< that each chapter has; nothing is asked for where book.toml has no `[exercises]`
    std::vector<Module> modules;   ///< of src, in the order of the file
    ManualFront manual;
    std::vector<OtherWords> other_words;

    /// The chapter of that number, or null.
    [[nodiscard]] const ChapterEntry* chapter(int number) const;
    /// Its label, or the number where there is no such chapter.
    [[nodiscard]] std::string label(int number) const;
    /// What the module does; empty where the book has no word for it.
    [[nodiscard]] std::string says_of(const std::string& module) const;
};

/// Reads `chapters/book.toml` of the project in `source`. What is wrong with it goes to `problems`, and what could be
/// read comes back.
[[nodiscard]] Book read_book(const std::filesystem::path& source, Problems& problems);

} // namespace flying::weave
