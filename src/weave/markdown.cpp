#include "weave/markdown.hpp"

#include <md4c-html.h>

namespace flying::weave {

std::string markdown_to_html(const std::string& markdown)
{
    const auto append = [](const MD_CHAR* text, MD_SIZE size, void* html) {
        static_cast<std::string*>(html)->append(text, size);
    };
    std::string html;
    const unsigned kind = MD_FLAG_TABLES | MD_FLAG_NOHTML | MD_FLAG_NOINDENTEDCODEBLOCKS;
    if (md_html(markdown.data(), static_cast<MD_SIZE>(markdown.size()), append, &html, kind, 0) != 0) return "";
    return html;
}

} // namespace flying::weave
