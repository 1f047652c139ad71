#include "weave/book.hpp"

#include <algorithm>
#include <regex>

#include <fmt/format.h>
#define TOML_HEADER_ONLY 1
#include <toml++/toml.h>

#include "weave/text.hpp"

namespace flying::weave {

namespace {

constexpr const char* k_book = "chapters/book.toml";

int line_of(const toml::node& node)
{
    return static_cast<int>(node.source().begin.line);
}

ChapterEntry read_chapter(const toml::table& table, Problems& problems)
{
    ChapterEntry entry;
    entry.line = line_of(table);
    entry.number = table["number"].value_or(-1);
    entry.appendix = table["appendix"].value_or(std::string());
    entry.name = table["name"].value_or(std::string());
    entry.title = table["title"].value_or(std::string());
    entry.part = table["part"].value_or(std::string());
    entry.question = table["question"].value_or(std::string());
    entry.told = table["told"].value_or(entry.told);
    entry.written = table["written"].value_or(false);
    if (const toml::array* files = table["files"].as_array())
        for (const toml::node& file : *files) entry.files.push_back(file.value_or(std::string()));
    if (const toml::array* needs = table["needs"].as_array())
        for (const toml::node& need : *needs) entry.needs.push_back(need.value_or(-1));
    entry.hours = table["hours"].value_or(0);
    if (const toml::array* goals = table["goals"].as_array())
        for (const toml::node& goal : *goals) entry.goals.push_back(goal.value_or(std::string()));
    if (const toml::array* runs = table["runs"].as_array())
        for (const toml::node& node : *runs)
            if (const toml::array* run = node.as_array(); run != nullptr && run->size() == 2)
                entry.runs.push_back({(*run)[0].value_or(std::string()), (*run)[1].value_or(std::string())});

    if (entry.number < 0) problems.add({k_book, entry.line}, "a chapter without number", "`number = N`, N >= 0");
    if (entry.title.empty())
        problems.add({k_book, entry.line}, "a chapter without title", "`title = \"...\"`, as it stands over the page");
    if (entry.written && (entry.hours <= 0 || entry.goals.empty()))
        problems.add({k_book, entry.line}, fmt::format("chapter {} without hours or goals", entry.number),
                     "`hours = N`, and `goals = [\"...\"]`: what a reader can do afterwards");
    if (entry.name.rfind(fmt::format("{:02}-", entry.number), 0) != 0)
        problems.add({k_book, entry.line}, fmt::format("chapter {} in a folder named `{}`", entry.number, entry.name),
                     fmt::format("`name = \"{:02}-...\"`", entry.number));
    return entry;
}

/// The library sorts keys by name; the order of the file is the reader's.
std::vector<Module> read_modules(const toml::table& book)
{
    std::vector<std::pair<int, Module>> by_line;
    if (const toml::table* modules = book["modules"].as_table())
        for (const auto& [name, says] : *modules)
            by_line.push_back({line_of(says), {std::string(name.str()), says.value_or(std::string())}});
    std::sort(by_line.begin(), by_line.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<Module> list;
    for (auto& [line, module] : by_line) list.push_back(std::move(module));
    return list;
}

std::vector<OtherWords> read_other_words(const toml::table& book)
{
    std::vector<OtherWords> list;
    const toml::array* const also = book["also"].as_array();
    if (also == nullptr) return list;
    for (const toml::node& node : *also) {
        const toml::table* const table = node.as_table();
        if (table == nullptr) continue;
        OtherWords& other = list.emplace_back();
        other.page = (*table)["page"].value_or(std::string());
        other.section = (*table)["section"].value_or(std::string());
        other.line = line_of(*table);
        if (const toml::array* words = (*table)["words"].as_array())
            for (const toml::node& word : *words) other.words.push_back(word.value_or(std::string()));
    }
    return list;
}

} // namespace

std::string ChapterEntry::called() const
{
    return (appendix.empty() ? "chapter " : "appendix ") + label();
}

std::string ChapterEntry::called_first() const
{
    return (appendix.empty() ? "Chapter " : "Appendix ") + label();
}

std::string ChapterEntry::command_name() const
{
    return appendix.empty() ? fmt::format("{:02}", place) : appendix;
}

std::string ChapterEntry::page() const
{
    return fmt::format("chapter_{:02}", number);
}

const ChapterEntry* Book::chapter(int number) const
{
    const auto found = std::find_if(chapters.begin(), chapters.end(),
                                    [number](const ChapterEntry& entry) { return entry.number == number; });
    return found == chapters.end() ? nullptr : &*found;
}

std::string Book::label(int number) const
{
    const ChapterEntry* const entry = chapter(number);
    return entry == nullptr ? std::to_string(number) : entry->label();
}

std::string Book::says_of(const std::string& module) const
{
    const auto found =
        std::find_if(modules.begin(), modules.end(), [&](const Module& one) { return one.name == module; });
    return found == modules.end() ? "" : found->says;
}

Book read_book(const std::filesystem::path& source, Problems& problems)
{
    Book book;
    const std::optional<std::string> text = read_file(source / k_book);
    if (!text) {
        problems.add({k_book, 0}, "no such file", "the list of chapters");
        return book;
    }
    toml::table table;
    try {
        table = toml::parse(*text);
    } catch (const toml::parse_error& error) {
        problems.add({k_book, static_cast<int>(error.source().begin.line)}, std::string(error.description()),
                     "valid TOML");
        return book;
    }

    book.title = table["title"].value_or(std::string("A book"));
    book.brief = table["brief"].value_or(std::string());
    book.front = table["front"].value_or(std::string());
    book.is_playable = table["playground"].value_or(false);
    static const std::regex k_version(R"(project\([^)]*VERSION ([0-9.]+))");
    const std::string project = read_file(source / "CMakeLists.txt").value_or("");
    std::smatch version;
    if (std::regex_search(project, version, k_version)) book.version = version[1].str();
    if (const toml::array* chapters = table["chapter"].as_array())
        for (const toml::node& node : *chapters)
            if (const toml::table* chapter = node.as_table()) book.chapters.push_back(read_chapter(*chapter, problems));
    if (const toml::table* least = table["exercises"].as_table())
        book.least_exercises = {(*least)["least"].value_or(0), (*least)["in_code"].value_or(0),
                                (*least)["hard"].value_or(0), (*least)["changes"].value_or(0)};
    book.modules = read_modules(table);
    book.other_words = read_other_words(table);
    const auto manual = table["manual"];
    book.manual = {manual["says"].value_or(std::string()), manual["example"].value_or(std::string()),
                   manual["fence"].value_or(std::string()), manual["next"].value_or(std::string())};
    std::stable_sort(book.chapters.begin(), book.chapters.end(),
                     [](const ChapterEntry& a, const ChapterEntry& b) { return a.appendix < b.appendix; });
    int place = 0;
    for (ChapterEntry& entry : book.chapters)
        if (entry.appendix.empty()) entry.place = ++place;

    // An appendix needs no place: any chapter may send its reader there
    const auto comes_before = [&](int need, const ChapterEntry& entry) {
        const ChapterEntry* const other = book.chapter(need);
        return other != nullptr && other != &entry && (!entry.appendix.empty() || other->place < entry.place);
    };
    for (const ChapterEntry& entry : book.chapters)
        for (const int need : entry.needs)
            if (!comes_before(need, entry))
                problems.add({k_book, entry.line}, fmt::format("chapter {} needs chapter {}", entry.number, need),
                             "only chapters that are listed and come earlier");
    return book;
}

} // namespace flying::weave
