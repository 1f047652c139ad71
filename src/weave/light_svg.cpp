#include "weave/light_svg.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <sstream>

namespace flying::weave {

namespace {

constexpr double k_steps = 10.0; ///< in a unit of the drawing

std::string as_tenths(long steps)
{
    const std::string whole = std::to_string(std::abs(steps) / 10);
    const long rest = std::abs(steps) % 10;
    std::string text = steps < 0 ? "-" : "";
    if (whole != "0" || rest == 0) text += whole;
    if (rest != 0) text += "." + std::to_string(rest);
    return text;
}

/// The points are rounded, not the steps, so that no error adds up along a path.
std::string by_steps(const std::string& path)
{
    std::istringstream words(path);
    std::string out;
    std::array<long, 2> at = {0, 0};
    std::array<long, 2> start = at;
    char last = 'Z';
    for (char command = 0; words >> command; last = command) {
        // Read the points that the command goes through
        const bool is_known = command == 'M' || command == 'L' || command == 'C' || command == 'Z';
        if (!is_known || (out.empty() && command != 'M')) return path;
        const std::size_t count = command == 'Z' ? 0 : command == 'C' ? 6 : 2;
        std::array<long, 6> to{};
        for (std::size_t k = 0; k < count; ++k) {
            double value = 0.0;
            if (!(words >> value)) return path;
            to[k] = std::lround(k_steps * value);
        }

        // Write them as seen from where it starts; a command that repeats needs no letter, numbers a space or a sign
        if (command != last || command == 'M')
            out += static_cast<char>(std::tolower(static_cast<unsigned char>(command)));
        for (std::size_t k = 0; k < count; ++k) {
            const std::string number = as_tenths(to[k] - at[k % 2]);
            if (std::isdigit(static_cast<unsigned char>(out.back())) != 0 && number.front() != '-') out += ' ';
            out += number;
        }

        // Be where it ends
        if (count > 0) at = {to[count - 2], to[count - 1]};
        if (command == 'M') start = at;
        if (command == 'Z') at = start;
    }
    return out;
}

/// Places, `x` and `y`, have one decimal at most, colours two; scales, which may be small, keep theirs.
std::string with_few_decimals(std::string_view text)
{
    constexpr std::string_view k_scale = "matrix(";
    const auto is_place = [&](std::size_t end) {
        const std::size_t start = text.find_last_of('"', end);
        return start != std::string_view::npos && start >= 3 &&
               (text.substr(start - 3, 3) == " x=" || text.substr(start - 3, 3) == " y=");
    };
    const auto is_digit = [](char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; };
    std::string out;
    for (std::size_t k = 0; k < text.size();) {
        const bool is_scale = text.substr(k, k_scale.size()) == k_scale;
        const std::size_t same = is_scale ? std::min(text.find(')', k), text.size() - 1) + 1 - k : 1;
        out += text.substr(k, same);
        k += same;
        if (out.back() != '.') continue;
        const std::size_t digits = k;
        while (k < text.size() && is_digit(text[k])) ++k;
        out += text.substr(digits, std::min<std::size_t>(k - digits, is_place(digits - 1) ? 1 : 2));
    }
    return out;
}

/// Without the letters that no text of the drawing has: Cairo begins each font with the sign for a letter it lacks.
std::string without_unused_letters(const std::string& svg)
{
    constexpr std::string_view k_open = "<symbol ";
    constexpr std::string_view k_close = "</symbol>\n";
    constexpr std::string_view k_id = " id=\"";
    std::string out;
    std::size_t at = 0;
    for (std::size_t open = svg.find(k_open); open != std::string::npos; open = svg.find(k_open, open + 1)) {
        const std::size_t close = svg.find(k_close, open);
        const std::size_t id = svg.find(k_id, open);
        if (close == std::string::npos || id > close) continue;
        const std::size_t name = id + k_id.size();
        const std::string use = "#" + svg.substr(name, svg.find('"', name) + 1 - name);
        if (svg.find(use) != std::string::npos) continue;
        out += svg.substr(at, open - at);
        at = close + k_close.size();
    }
    return out + svg.substr(at);
}

} // namespace

std::string light_svg(std::string_view svg)
{
    constexpr std::string_view k_path = " d=\"";
    std::string light;
    for (std::size_t at = 0; at < svg.size();) {
        const std::size_t start = std::min(svg.find(k_path, at), svg.size());
        const std::size_t path = std::min(start + k_path.size(), svg.size());
        const std::size_t end = std::min(svg.find('"', path), svg.size());
        light += with_few_decimals(svg.substr(at, path - at));
        light += by_steps(std::string(svg.substr(path, end - path)));
        at = end;
    }
    return without_unused_letters(light);
}

} // namespace flying::weave
