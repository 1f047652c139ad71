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
constexpr double k_other_word = 1.1; // of other books
constexpr double k_reading = 0.5;    // titles of other books
constexpr double k_symbol = 0.5;
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

/// Goes through a page from heading to heading.
class PageIndex
{
public:
    PageIndex(const Material& material, const Chapter& chapter, json& index)
        : material_(material),
          chapter_(&chapter),
          index_(index),
          page_(chapter.entry.page() + ".html"),
          name_(page_title(chapter.entry)),
          called_(chapter.entry.called_first()),
          section_(chapter.entry.title)
    {
    }

    /// A page beside the chapters.
    PageIndex(const Material& material, const std::string& name, const std::string& title, json& index)
        : material_(material), index_(index), page_(name + ".html"), name_(title), called_("Study"), section_(title)
    {
    }

    void add(const ChapterText& text)
    {
        for (const Block& block : text.blocks) add(block);
    }

    void close()
    {
        const bool is_head = anchor_.empty();
        if (is_head && chapter_ != nullptr) words_ += chapter_->entry.question;
        const double weight = is_head ? k_chapter : is_reading() ? k_reading : k_section;
        entry(section_, is_head ? called_ : name_, address(), weight, words_);
        words_.clear();
    }

private:
    [[nodiscard]] bool is_reading() const { return section_ == "Further reading"; }
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
            entry(fmt::format("({}) {}", numbered.number, section_), name_, page_ + "#" + numbered.anchor, k_formula,
                  replace_all(replace_all(block.name, ".", " "), "_", " "));
            return;
        }
        case BlockKind::figure:
        case BlockKind::live: {
            const auto found = material_.figures.find(chapter_->entry.name + "/" + figure_key(block));
            if (found == material_.figures.end()) return;
            const std::string caption = words_of({{1, block.caption}});
            entry(fmt::format("Figure {}: {}", found->second, caption.substr(0, caption.find(". "))), name_,
                  page_ + "#figure-" + figure_key(block), k_figure, caption + words_of({{1, block.alt}}));
            return;
        }
        case BlockKind::exercise:
            for (const Exercise& exercise : chapter_->exercises)
                if (exercise.name == block.name)
                    entry(fmt::format("Exercise {}.{}: {}", chapter_->entry.label(), block.name.substr(1),
                                      exercise.text.title),
                          name_, page_ + "#exercise-" + block.name, k_figure, exercise.text.title);
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
            const double weight = is_reading() ? k_reading : is_strong ? k_term : k_section;
            entry(term, name_ + ": " + section_, address(), weight, "");
        }
    }

    const Material& material_;
    const Chapter* chapter_ = nullptr; ///< where the page is one
    json& index_;
    std::string page_;
    std::string name_;    ///< what entries of its sections say
    std::string called_;  ///< and that of the page itself
    std::string section_; ///< the present one
    std::string anchor_;
    std::string words_;
    bool is_table_ = false;
    std::set<std::string> terms_;
};

/// The text that words of other books lead to: a chapter, by the name of its folder, or a page beside them; else null.
std::pair<const ChapterText*, const Chapter*> text_of(const Material& material, const std::string& page)
{
    for (const Chapter& chapter : material.chapters)
        if (chapter.entry.name.substr(3) == page) return {&chapter.text, &chapter};
    const auto found = material.extras.find(page);
    return {found == material.extras.end() ? nullptr : &found->second, nullptr};
}

bool has_section(const ChapterText& text, const std::string& section)
{
    for (const Block& block : text.blocks)
        for (const auto& [number, line] : block.lines)
            if (block.kind == BlockKind::text && (line == "## " + section || line == "### " + section)) return true;
    return false;
}

void add_other_words(const Material& material, json& index)
{
    for (const OtherWords& other : material.book.other_words) {
        const auto [text, chapter] = text_of(material, other.page);
        const std::string page = (chapter == nullptr ? other.page : chapter->entry.page()) + ".html";
        const std::string title = chapter != nullptr ? page_title(chapter->entry)
                                  : text != nullptr  ? text->title
                                                     : "Manual of the code";
        const std::string address = page + (other.section.empty() ? "" : "#" + slug(other.section));
        const std::string where = title + (other.section.empty() ? "" : ": " + other.section);
        for (const std::string& word : other.words)
            index.push_back(json::array({word, where, address, k_other_word, ""}));
    }
}

} // namespace

void check_other_words(const Material& material, Problems& problems)
{
    for (const OtherWords& other : material.book.other_words) {
        if (other.page == "manual/index" && other.section.empty()) continue;
        const ChapterText* const text = text_of(material, other.page).first;
        if (text != nullptr && (other.section.empty() || has_section(*text, other.section))) continue;
        problems.add({"chapters/book.toml", other.line},
                     fmt::format("words that lead to `{}` of `{}`", other.section, other.page),
                     "a heading of a chapter, by the name of its folder, or of a page such as `about`");
    }
}

std::string search_index(const Material& material, const Manual& manual)
{
    json index = json::array();
    for (const Chapter& chapter : material.chapters) {
        PageIndex entries(material, chapter, index);
        entries.add(chapter.text);
        entries.close();
        for (const Symbol& symbol : chapter.text.symbols)
            index.push_back(json::array({words_of({{1, symbol.meaning}}),
                                         fmt::format("Symbol {}, {}", symbol.tex, page_title(chapter.entry)),
                                         chapter.entry.page() + ".html#symbols", k_symbol, symbol.code}));
    }
    for (const auto& [name, text] : material.extras) {
        if (name != "glossary") {
            PageIndex entries(material, name, text.title, index);
            entries.add(text);
            entries.close();
            continue;
        }
        index.push_back(json::array({text.title, "Study", name + ".html", k_term, ""}));
        for (const Term& term : terms_of(text))
            index.push_back(json::array({term.term, "Glossary: " + words_of({{1, term.meaning}}),
                                         "glossary.html#" + term.anchor, k_glossary, ""}));
    }
    add_other_words(material, index);
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
