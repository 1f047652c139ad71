#include "weave/search_index.hpp"

#include <regex>
#include <set>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "weave/inline.hpp"
#include "weave/study.hpp"
#include "weave/text.hpp"

namespace flying::weave {

namespace {

using nlohmann::json;

// How much an entry counts beside others that hold the same words
constexpr double k_chapter = 1.5;
constexpr double k_section = 1.1;
constexpr double k_term = 1.4;
constexpr double k_glossary = 1.35;
constexpr double k_symbol = 0.9;
constexpr double k_figure = 0.8;
constexpr double k_formula = 0.7;
constexpr double k_code = 0.12; // but for one that is written as the code has it

/// The words of running text, without formulas and inserts.
std::string words_of(const std::vector<std::pair<int, std::string>>& lines)
{
    std::string words;
    for (const Piece& piece : pieces_of(lines))
        if (piece.kind == PieceKind::prose || piece.kind == PieceKind::code) words += piece.text + " ";
    for (const char* sign : {"*", "|", "#", "[", "]", "\\", "\n"}) words = replace_all(words, sign, " ");
    return words;
}

/// Goes through a chapter from heading to heading.
class ChapterIndex
{
public:
    ChapterIndex(const Material& material, const Chapter& chapter, json& index)
        : material_(material), chapter_(chapter), index_(index), page_(chapter.entry.page() + ".html")
    {
        section_ = chapter.entry.title;
    }

    void add(const ChapterText& text)
    {
        for (const Block& block : text.blocks) add(block);
    }

    void close()
    {
        const bool is_head = anchor_.empty();
        const std::string where = is_head ? chapter_.entry.called_first() : chapter_name();
        entry(section_, where, address(), is_head ? k_chapter : k_section,
              words_ + (is_head ? chapter_.entry.question : ""));
        words_.clear();
    }

private:
    [[nodiscard]] std::string chapter_name() const { return page_title(chapter_.entry); }
    [[nodiscard]] std::string address() const { return anchor_.empty() ? page_ : page_ + "#" + anchor_; }

    void entry(const std::string& title, const std::string& where, const std::string& address, double weight,
               const std::string& words)
    {
        index_.push_back(json::array({title, where, address, weight, words}));
    }

    void add(const Block& block)
    {
        switch (block.kind) {
        case BlockKind::text:
            add_text(block);
            return;
        case BlockKind::equation:
        case BlockKind::definition:
        case BlockKind::derivation: {
            const auto found = material_.numbered.find(block.name);
            if (found == material_.numbered.end()) return;
            const Numbered& numbered = found->second;
            entry(fmt::format("({}) {}", numbered.number, section_), chapter_name(), page_ + "#" + numbered.anchor,
                  k_formula, replace_all(replace_all(block.name, ".", " "), "_", " "));
            return;
        }
        case BlockKind::figure:
        case BlockKind::live: {
            const auto found = material_.figures.find(chapter_.entry.name + "/" + figure_key(block));
            if (found == material_.figures.end()) return;
            const std::string caption = words_of({{1, block.caption}});
            entry(fmt::format("Figure {}: {}", found->second, caption.substr(0, caption.find(". "))), chapter_name(),
                  page_ + "#figure-" + figure_key(block), k_figure, caption + words_of({{1, block.alt}}));
            return;
        }
        case BlockKind::exercise:
            for (const Exercise& exercise : chapter_.exercises)
                if (exercise.name == block.name)
                    entry(fmt::format("Exercise {}.{}: {}", chapter_.entry.label(), block.name.substr(1),
                                      exercise.text.title),
                          chapter_name(), page_ + "#exercise-" + block.name, k_figure, exercise.text.title);
            return;
        default:
            return;
        }
    }

    void add_text(const Block& block)
    {
        static const std::regex k_term_words(R"(\*\*([^*]{3,40})\*\*|\*([^*]{3,40})\*)");
        std::vector<std::pair<int, std::string>> lines;
        for (const auto& [number, line] : block.lines) {
            const std::size_t level = line.find_first_not_of('#');
            if (level != 0 && level != std::string::npos && line[level] == ' ') {
                words_ += words_of(lines);
                lines.clear();
                const std::string title(trim(std::string_view(line).substr(level)));
                is_table_ = title == "Symbols";
                if (is_table_) continue;
                close();
                section_ = title;
                anchor_ = slug(title);
                continue;
            }
            if (is_table_ && line.substr(0, 1) == "|") continue;
            lines.emplace_back(number, line);
        }
        words_ += words_of(lines);
        std::string all;
        for (const auto& [number, line] : lines) all += line + " ";
        for (std::sregex_iterator at(all.begin(), all.end(), k_term_words), end; at != end; ++at) {
            const bool is_strong = (*at)[1].matched;
            const std::string term = (*at)[is_strong ? 1 : 2].str();
            if (term.find_first_of("$`{.,") != std::string::npos || !terms_.insert(slug(term)).second) continue;
            entry(term, chapter_name() + ": " + section_, address(), is_strong ? k_term : k_section, "");
        }
    }

    const Material& material_;
    const Chapter& chapter_;
    json& index_;
    std::string page_;
    std::string section_;
    std::string anchor_;
    std::string words_;
    bool is_table_ = false;
    std::set<std::string> terms_;
};

} // namespace

std::string search_index(const Material& material, const Manual& manual)
{
    json index = json::array();
    for (const Chapter& chapter : material.chapters) {
        ChapterIndex entries(material, chapter, index);
        entries.add(chapter.text);
        entries.close();
        for (const Symbol& symbol : chapter.text.symbols)
            index.push_back(json::array({words_of({{1, symbol.meaning}}),
                                         fmt::format("Symbol {}, {}", symbol.tex, page_title(chapter.entry)),
                                         chapter.entry.page() + ".html#symbols", k_symbol, symbol.code}));
    }
    for (const auto& [name, text] : material.extras) {
        index.push_back(json::array({text.title, "Study", name + ".html", k_term, ""}));
        if (name != "glossary") continue;
        for (const Term& term : terms_of(text))
            index.push_back(json::array({term.term, "Glossary: " + words_of({{1, term.meaning}}),
                                         "glossary.html#" + term.anchor, k_glossary, ""}));
    }
    const std::pair<const char*, const char*> pages[] = {{"answers", "Answers"},
                                                         {"playground", "Playground"},
                                                         {"equations", "Equations and their receipts"},
                                                         {"symbols", "Symbols of the book"},
                                                         {"told", "What is told, and what is not"},
                                                         {"sources", "The sources, by module"},
                                                         {"manual/index", "Manual of the code"}};
    for (const auto& [page, title] : pages)
        index.push_back(json::array({title, "Reference", std::string(page) + ".html", k_term, ""}));
    for (const Module& module : material.book.modules)
        index.push_back(
            json::array({"Module " + module.name, module.says, "module_" + module.name + ".html", k_section, ""}));
    for (const auto& [name, target] : manual.names) {
        const bool is_inner = name.rfind("weave::", 0) == 0 || name.rfind("test::", 0) == 0 || name.back() == '_' ||
                              manual.names.count("flying::" + name) == 0;
        if (!is_inner) index.push_back(json::array({name, "Manual of the code", "manual/" + target, k_code, ""}));
    }
    return "window.flyingIndex = " + index.dump(-1, ' ', false, json::error_handler_t::replace) + ";\n";
}

} // namespace flying::weave
