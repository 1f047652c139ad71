#include "weave/fragments.hpp"

#include <cctype>
#include <utility>

#include <fmt/format.h>

namespace flying::weave {

namespace {

constexpr const char* k_start = "wv0x"; // no word of any language, no name of any program
constexpr std::size_t k_start_length = 4;

} // namespace

std::string block_token(const std::string& token)
{
    return "\n" + token + "\n\n";
}

std::string Fragments::add(Fragment fragment)
{
    list_.push_back(std::move(fragment));
    return fmt::format("{}{}x", k_start, list_.size() - 1);
}

std::string Fragments::add_html(std::string html)
{
    Fragment fragment;
    fragment.text = std::move(html);
    return add(std::move(fragment));
}

std::string Fragments::add_formula(std::string tex, bool display, Place place)
{
    Fragment fragment;
    fragment.kind = FragmentKind::formula;
    fragment.text = std::move(tex);
    fragment.display = display;
    fragment.place = std::move(place);
    return add(std::move(fragment));
}

Fragments::Found Fragments::token_at(const std::string& text, std::size_t at)
{
    if (text.compare(at, k_start_length, k_start) != 0) return {};
    std::size_t end = at + k_start_length;
    int index = 0;
    while (end < text.size() && std::isdigit(static_cast<unsigned char>(text[end])))
        index = 10 * index + (text[end++] - '0');
    if (end == at + k_start_length || end >= text.size() || text[end] != 'x') return {};
    return {index, end + 1 - at};
}

} // namespace flying::weave
