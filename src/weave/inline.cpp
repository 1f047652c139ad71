#include "weave/inline.hpp"

#include <algorithm>

#include "weave/text.hpp"

namespace flying::weave {

std::vector<Piece> pieces_of(const std::vector<std::pair<int, std::string>>& lines)
{
    std::vector<Piece> pieces;
    if (lines.empty()) return pieces;
    std::string all;
    std::vector<int> line_at; // line of each character
    for (const auto& [number, line] : lines) {
        all += line + "\n";
        line_at.resize(all.size(), number);
    }

    std::string prose;
    std::size_t prose_from = 0;
    std::size_t at = 0;
    const auto close_prose = [&] {
        if (!prose.empty()) pieces.push_back({PieceKind::prose, prose, line_at[prose_from]});
        prose.clear();
    };
    const auto take = [&](PieceKind kind, std::size_t opening, const std::string& closing) {
        const std::size_t end = all.find(closing, at + opening);
        const std::size_t blank = all.find("\n\n", at);
        if (end == std::string::npos || blank < end || end == at + opening) return false;
        close_prose();
        std::string text = all.substr(at + opening, end - at - opening);
        std::replace(text.begin(), text.end(), '\n', ' ');
        pieces.push_back({kind, text, line_at[at]});
        at = end + closing.size();
        prose_from = at;
        return true;
    };
    while (at < all.size()) {
        const char c = all[at];
        bool taken = false;
        if (c == '\\' && at + 1 < all.size()) {
            if (prose.empty()) prose_from = at;
            prose += all.substr(at, 2);
            at += 2;
            continue;
        }
        if (c == '`') {
            const std::size_t run = std::min(all.find_first_not_of('`', at), all.size()) - at;
            taken = take(PieceKind::code, run, std::string(run, '`'));
        } else if (all.compare(at, 2, "$$") == 0) {
            if (prose.empty()) prose_from = at;
            prose += "$$";
            at += 2;
            continue;
        } else if (c == '$') {
            taken = take(PieceKind::math, 1, "$");
        } else if (c == '{' && all.compare(at, 2, "{{") == 0) {
            taken = take(PieceKind::insert, 2, "}}");
        } else if (c == ']' && all.compare(at, 2, "](") == 0) {
            prose += ']';
            ++at;
            taken = take(PieceKind::target, 1, ")");
        }
        if (taken) continue;
        if (prose.empty()) prose_from = at;
        prose += all[at++];
    }
    close_prose();
    return pieces;
}

Insert parse_insert(const std::string& text)
{
    Insert insert;
    const std::size_t colon = text.find(':');
    insert.kind = std::string(trim(text.substr(0, colon)));
    if (colon == std::string::npos) return insert;
    const std::size_t bar = text.find('|', colon);
    insert.name =
        std::string(trim(std::string_view(text).substr(colon + 1, bar == std::string::npos ? bar : bar - colon - 1)));
    if (bar != std::string::npos) insert.format = std::string(trim(std::string_view(text).substr(bar + 1)));
    return insert;
}

} // namespace flying::weave
