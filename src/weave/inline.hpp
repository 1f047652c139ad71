#pragma once

#include <string>
#include <utility>
#include <vector>

namespace flying::weave {

/// What a piece of running text is.
enum class PieceKind
{
    prose,  ///< words and Markdown's signs
    code,   ///< `between backquotes`
    math,   ///< $between dollars$
    insert, ///< {{what the build fills in}}
    target, ///< of a link: what stands in (brackets) after [its text]
};

struct Piece
{
    PieceKind kind = PieceKind::prose;
    std::string text; ///< without the signs around it
    int line = 0;     ///< on which it starts
};

/// Takes the lines of a text apart. Prose keeps its ends of lines. Quoted pieces may run over the end of a line, but
/// not over a blank one.
[[nodiscard]] std::vector<Piece> pieces_of(const std::vector<std::pair<int, std::string>>& lines);

/// An insert `{{kind:name|format}}`, taken apart.
struct Insert
{
    std::string kind;
    std::string name;
    std::string format;
};
[[nodiscard]] Insert parse_insert(const std::string& text);

} // namespace flying::weave
