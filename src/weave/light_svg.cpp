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

/// Places and colours have two decimals at most; scales, which may be small, keep theirs.
std::string with_few_decimals(std::string_view text)
{
    constexpr std::size_t k_decimals = 2;
    constexpr std::string_view k_scale = "matrix(";
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
        out += text.substr(digits, std::min(k - digits, k_decimals));
    }
    return out;
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
    return light;
}

} // namespace flying::weave
