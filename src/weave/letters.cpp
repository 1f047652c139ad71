#include "weave/letters.hpp"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "weave/text.hpp"

namespace flying::weave {

namespace {

namespace fs = std::filesystem;

constexpr unsigned k_first_printable = 0x20;
constexpr unsigned k_last_printable = 0x7e;
constexpr unsigned k_hard_space = 0xa0; // pages write it as &nbsp;

struct Font
{
    fs::path source;
    fs::path name; ///< below the pages
};

std::vector<Font> fonts()
{
    const std::string charis = "/usr/share/fonts/truetype/charis/CharisSIL-";
    const std::string inter = "/usr/share/fonts/opentype/inter/Inter-";
    const std::string mono = "/usr/share/fonts/truetype/jetbrains-mono/JetBrainsMono-";
    std::vector<Font> all;
    for (const auto& [name, source] :
         {std::pair{"serif", charis + "Regular.ttf"}, std::pair{"serif-italic", charis + "Italic.ttf"},
          std::pair{"serif-bold", charis + "Bold.ttf"}, std::pair{"sans", inter + "Regular.otf"},
          std::pair{"sans-bold", inter + "SemiBold.otf"}, std::pair{"mono", mono + "Regular.ttf"},
          std::pair{"mono-italic", mono + "Italic.ttf"}})
        all.push_back({source, "theme/fonts/" + std::string(name) + ".woff2"});
    std::error_code error;
    for (const auto& font : fs::directory_iterator("/usr/share/javascript/katex/fonts", error))
        if (font.path().extension() == ".woff2") all.push_back({font.path(), "katex/fonts" / font.path().filename()});
    return all;
}

/// The sign that begins at `at`, which moves behind it.
unsigned sign_at(std::string_view text, std::size_t& at)
{
    const auto byte = [&](std::size_t k) { return k < text.size() ? static_cast<unsigned char>(text[k]) : 0u; };
    const unsigned first = byte(at);
    const std::size_t more = first >= 0xf0 ? 3 : first >= 0xe0 ? 2 : first >= 0xc0 ? 1 : 0;
    unsigned sign = more == 0 ? first : first & (0x3fu >> more);
    for (std::size_t k = 1; k <= more; ++k) sign = sign << 6 | (byte(at + k) & 0x3fu);
    at += 1 + more;
    return sign;
}

std::string signs_of(const fs::path& html)
{
    std::set<unsigned> signs;
    std::error_code error;
    for (const auto& entry : fs::recursive_directory_iterator(html, error)) {
        const fs::path kind = entry.path().extension();
        if (kind == ".html" || kind == ".js" || kind == ".css") add_signs(read_file(entry.path()).value_or(""), signs);
    }
    std::string list = fmt::format("{:x}-{:x}", k_first_printable, k_last_printable);
    for (const unsigned sign : signs)
        if (sign > k_last_printable) list += fmt::format(",{:x}", sign);
    return list;
}

} // namespace

void add_signs(std::string_view text, std::set<unsigned>& signs)
{
    for (unsigned sign = k_first_printable; sign <= k_last_printable; ++sign) signs.insert(sign);
    signs.insert(k_hard_space);
    for (std::size_t at = 0; at < text.size();) {
        const unsigned sign = sign_at(text, at);
        if (sign > k_last_printable) signs.insert(sign);
        if (sign != '\\') continue;
        const std::size_t start = at + (at < text.size() && text[at] == 'u' ? 1 : 0);
        const std::string digits(text.substr(std::min(start, text.size()), 4));
        char* end = nullptr;
        const unsigned long named = std::strtoul(digits.c_str(), &end, 16);
        if (digits.size() == 4 && *end == '\0' && std::isxdigit(static_cast<unsigned char>(digits[0])) != 0)
            signs.insert(static_cast<unsigned>(named));
    }
}

void make_letters(const Folders& folders, const fs::path& html, Problems& problems)
{
    const std::string signs = signs_of(html);
    const fs::path store = folders.build / "letters";
    const bool is_known = read_file(store / "signs").value_or("") == signs;
    std::string call = fmt::format("/usr/bin/python3 '{}' {}", (folders.kit / "letters.py").string(), signs);
    bool is_complete = is_known;
    std::error_code error;
    for (const Font& font : fonts()) {
        const fs::path made = store / font.name;
        fs::create_directories(made.parent_path(), error);
        is_complete = is_complete && fs::exists(made);
        call += fmt::format(" '{}' '{}'", font.source.string(), made.string());
    }
    const fs::path log = folders.build / "letters.log";
    if (!is_complete && (std::system(fmt::format("{} > '{}' 2>&1", call, log.string()).c_str()) != 0 ||
                         !write_file(store / "signs", signs))) {
        problems.add({"letters.py", 0}, "fonts that can't be made small: see " + log.string(),
                     "katex, fonts-sil-charis, fonts-inter, fonts-jetbrains-mono, python3-fonttools, python3-brotli");
        return;
    }
    for (const Font& font : fonts()) {
        fs::create_directories((html / font.name).parent_path(), error);
        fs::copy_file(store / font.name, html / font.name, fs::copy_options::overwrite_existing, error);
        if (error) problems.add({font.name.string(), 0}, error.message(), "a file to copy into the book");
    }
}

} // namespace flying::weave
