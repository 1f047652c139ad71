#include "weave/annotated.hpp"

#include <algorithm>
#include <regex>
#include <utility>

#include <fmt/format.h>

#include "weave/frame.hpp"
#include "weave/markdown.hpp"
#include "weave/run.hpp"
#include "weave/text.hpp"

namespace flying::weave {

namespace {

namespace fs = std::filesystem;

/// A piece of a file that a chapter's story tells.
struct ToldPiece
{
    int first = 0;
    int last = 0;
    std::string link; ///< to its place in the story
};

/// What the stories tell of each file, by its path.
std::map<std::string, std::vector<ToldPiece>> told_pieces(const Material& material)
{
    std::map<std::string, std::vector<ToldPiece>> told;
    for (const Chapter& chapter : material.chapters) {
        std::string section;
        for (const Block& block : chapter.text.blocks) {
            if (block.kind == BlockKind::text)
                for (const auto& [number, line] : block.lines)
                    if (line.rfind("## ", 0) == 0 || line.rfind("### ", 0) == 0)
                        section = std::string(trim(line.substr(line.find(' '))));
            if (block.kind != BlockKind::listing) continue;
            const Listing listing = listing_of(block);
            if (listing.is_again) continue;
            for (const std::string& name : listing.names) {
                const int index = material.sources.find(name);
                if (index < 0) continue;
                const Region& region = material.sources.regions[index];
                told[region.file].push_back(
                    {region.first, region.last,
                     fmt::format("<a href=\"../{}.html#listing-{}\">{}{}</a>", chapter.entry.page(),
                                 slug(listing.names.front()), escape_html(page_title(chapter.entry)),
                                 section.empty() ? "" : ": " + escape_html(section))});
            }
        }
    }
    return told;
}

bool is_doc(std::string_view line)
{
    return line.substr(0, 3) == "///" && line.substr(0, 4) != "///<";
}

/// `---- Title -----` of a comment that parts a file.
std::string part_title(std::string_view words)
{
    if (words.substr(0, 4) != "----") return "";
    while (!words.empty() && (words.front() == '-' || words.front() == ' ')) words.remove_prefix(1);
    while (!words.empty() && (words.back() == '-' || words.back() == ' ')) words.remove_suffix(1);
    return std::string(words);
}

class AnnotatedFile
{
public:
    AnnotatedFile(const Material& material, const SourceFile& file, const std::map<int, std::string>& html,
                  const std::vector<ToldPiece>& told)
        : material_(material), file_(file), html_(html), told_(told)
    {
    }

    std::string body()
    {
        for (int line = 1; line <= static_cast<int>(file_.lines.size()); ++line) add(line);
        flush();
        return out_;
    }

private:
    void add(int line)
    {
        if (file_.kinds[line - 1] == LineKind::marker) return;
        const std::string& words = file_.lines[line - 1];
        const std::string_view text = trim(words);
        const bool stands_alone = text.substr(0, 2) == "//" && words.substr(0, 2) == "//";
        if (is_doc(text) || stands_alone) {
            if (has_code_) flush();
            std::string_view comment = text.substr(is_doc(text) ? 3 : 2);
            if (comment.substr(0, 1) == " ") comment.remove_prefix(1);
            const std::string title = part_title(comment);
            anchors_ += anchor(line);
            if (title.empty()) prose_.emplace_back(comment);
            else out_ += fmt::format("{}<h2>{}</h2>", std::exchange(anchors_, {}), escape_html(title));
            return;
        }
        for (const ToldPiece& piece : told_)
            if (!is_noted(piece) && piece.first <= line && line <= piece.last) noted_.push_back(&piece);
        // A blank line is shown between others, and is a place to link to anywhere
        if (text.empty() && !has_code_) {
            anchors_ += anchor(line);
            return;
        }
        const auto own = html_.find(line);
        std::string& to = text.empty() ? blank_ : code_;
        if (text.empty()) {
            blank_anchors_ += anchor(line);
        } else {
            code_ += std::exchange(blank_, {});
            blank_anchors_.clear();
        }
        to += fmt::format("<div class=\"line\" id=\"l{:05}\" data-n=\"{}\">{}</div>\n", line, line,
                          indents_.mark(with_whole_words(own != html_.end() ? own->second : escape_html(words))));
        has_code_ = true;
    }

    static std::string anchor(int line) { return fmt::format("<span id=\"l{:05}\"></span>", line); }
    [[nodiscard]] bool is_noted(const ToldPiece& piece) const
    {
        return std::find(noted_.begin(), noted_.end(), &piece) != noted_.end();
    }

    void flush()
    {
        std::string prose = anchors_ + comment_prose(material_, prose_, "../");
        for (std::size_t k = linked_; k < noted_.size(); ++k)
            prose += fmt::format("<p class=\"told\">Told in {}</p>", noted_[k]->link);
        linked_ = noted_.size();
        if (!prose.empty() || !code_.empty())
            out_ += fmt::format("<div class=\"piece\"><div class=\"prose\">{}</div>{}</div>\n", prose,
                                code_.empty() ? "" : "<div class=\"fragment\">" + code_ + "</div>");
        prose_.clear();
        code_.clear();
        anchors_ = std::exchange(blank_anchors_, {});
        blank_.clear();
        has_code_ = false;
    }

    const Material& material_;
    const SourceFile& file_;
    const std::map<int, std::string>& html_;
    const std::vector<ToldPiece>& told_;
    Indents indents_;
    std::string out_;
    std::string code_;
    std::string blank_;         // lines that are shown if code follows
    std::string blank_anchors_; // and their places, if none does
    std::string anchors_;       // of the lines that became prose
    std::vector<std::string> prose_;
    std::vector<const ToldPiece*> noted_;
    std::size_t linked_ = 0; // of them
    bool has_code_ = false;
};

/// What a source belongs to: its module, or its chapter.
std::string home_of(const Material& material, const std::string& path)
{
    const std::size_t slash = path.find('/', 4);
    if (path.rfind("src/", 0) == 0 && slash != std::string::npos) {
        const std::string name = path.substr(4, slash - 4);
        return fmt::format("<p class=\"part\"><a href=\"../module_{0}.html\">Module {0}</a></p>", name);
    }
    for (const Chapter& chapter : material.chapters)
        if (path.rfind(chapter.entry.folder() + "/", 0) == 0)
            return fmt::format("<p class=\"part\"><a href=\"../{}.html\">Chapter {}</a></p>", chapter.entry.page(),
                               escape_html(page_title(chapter.entry)));
    return "<p class=\"part\">Source</p>";
}

} // namespace

std::string comment_prose(const Material& material, const std::vector<std::string>& lines, const std::string& root)
{
    static const std::regex k_equation(R"(\beq\. ([a-z][a-z0-9_.]*[a-z0-9_]))");
    if (lines.empty()) return "";
    std::string html = markdown_to_html(comment_markdown(lines));
    std::string out;
    auto from = html.cbegin();
    for (std::sregex_iterator at(html.begin(), html.end(), k_equation), end; at != end; ++at) {
        const auto found = material.numbered.find((*at)[1].str());
        if (found == material.numbered.end()) continue;
        out.append(from, (*at)[0].first);
        out += fmt::format("<a href=\"{}{}.html#{}\">equation ({})</a>", root, found->second.page, found->second.anchor,
                           found->second.number);
        from = (*at)[0].second;
    }
    out.append(from, html.cend());
    return out;
}

void write_annotated(const Material& material, const Manual& manual, const fs::path& html, Problems& problems)
{
    const std::map<std::string, std::vector<ToldPiece>> told = told_pieces(material);
    static const std::vector<ToldPiece> k_nothing;
    for (const auto& [path, doxygens] : manual.sources) {
        const auto file = material.sources.files.find(path);
        if (file == material.sources.files.end()) continue;
        const auto pieces = told.find(path);
        const std::vector<ToldPiece>& of_file = pieces == told.end() ? k_nothing : pieces->second;
        const std::map<int, std::string> lines = linked_lines(html / "manual" / doxygens);
        Page page;
        page.name = "manual/" + doxygens.substr(0, doxygens.size() - 5);
        page.title = path;
        page.over = home_of(material, path);
        AnnotatedFile annotated(material, file->second, lines, of_file);
        const std::string body = "<div class=\"source\">" + annotated.body() + "</div>";
        if (!write_file(html / "manual" / doxygens, framed(material, page, body, "../")))
            problems.add({doxygens, 0}, "a page that can't be written", "a folder to write to");
    }
}

} // namespace flying::weave
