#include "weave/light_svg.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>

namespace flying::weave {

namespace {

constexpr double k_unit = 100.0;      ///< steps in a unit of the drawing
constexpr double k_grain = 5.0;       ///< of the outlines of letters, which make most of a figure  [steps]
constexpr double k_straight = 2.5;    ///< points so near to a line are on it  [steps]
constexpr std::size_t k_decimals = 3; ///< of an opacity

struct Point
{
    double x = 0.0;
    double y = 0.0;
};

/// One command of a path, to absolute points.
struct Piece
{
    char command = 'M'; ///< M, L, C or Z
    std::array<Point, 3> points{};
    int count = 0;
    [[nodiscard]] const Point& end() const { return points[static_cast<std::size_t>(std::max(count, 1) - 1)]; }
};

class PathReader
{
public:
    explicit PathReader(std::string_view text) : text_(text) {}

    /// The path as pieces, in steps; nothing where it has other commands.
    std::optional<std::vector<Piece>> read()
    {
        std::vector<Piece> pieces;
        Point at;
        Point start;
        char command = 0;
        for (skip(); k_ < text_.size(); skip()) {
            if (std::isalpha(static_cast<unsigned char>(text_[k_]))) command = text_[k_++];
            else if (command == 'M') command = 'L';
            else if (command == 'Z') return std::nullopt;
            Piece piece;
            piece.command = command;
            bool is_good = true;
            const auto number = [&](double& value) { is_good = is_good && take(value); };
            switch (command) {
            case 'M':
            case 'L':
            case 'C':
                piece.count = command == 'C' ? 3 : 1;
                for (int k = 0; k < piece.count; ++k) {
                    number(piece.points[static_cast<std::size_t>(k)].x);
                    number(piece.points[static_cast<std::size_t>(k)].y);
                }
                at = piece.end();
                if (command == 'M') start = at;
                break;
            case 'H':
            case 'V':
                number(command == 'H' ? at.x : at.y);
                piece = {'L', {at}, 1};
                break;
            case 'Z':
                at = start;
                piece.points[0] = start;
                break;
            default:
                return std::nullopt;
            }
            if (!is_good || (pieces.empty() && command != 'M')) return std::nullopt;
            pieces.push_back(piece);
        }
        return pieces;
    }

private:
    void skip()
    {
        while (k_ < text_.size() && (std::isspace(static_cast<unsigned char>(text_[k_])) || text_[k_] == ',')) ++k_;
    }

    bool take(double& value)
    {
        skip();
        const std::string rest(text_.substr(k_, 32));
        char* end = nullptr;
        value = k_unit * std::strtod(rest.c_str(), &end);
        k_ += static_cast<std::size_t>(end - rest.c_str());
        return end != rest.c_str();
    }

    std::string_view text_;
    std::size_t k_ = 0;
};

void put_on_grain(std::vector<Piece>& pieces)
{
    for (Piece& piece : pieces)
        for (Point& point : piece.points)
            point = {k_grain * std::round(point.x / k_grain), k_grain * std::round(point.y / k_grain)};
}

double off_line(const Point& a, const Point& b, const Point& p)
{
    const double dx = b.x - a.x;
    const double dy = b.y - a.y;
    const double length = dx * dx + dy * dy;
    const double share = length > 0.0 ? std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / length, 0.0, 1.0) : 0.0;
    return std::hypot(a.x + share * dx - p.x, a.y + share * dy - p.y);
}

/// Which of the points first ... last of a chain are needed, by halving at the farthest (Douglas and Peucker).
void mark_needed(const std::vector<Point>& chain, std::vector<bool>& needed)
{
    std::vector<std::pair<std::size_t, std::size_t>> waiting = {{0, chain.size() - 1}};
    needed.front() = needed.back() = true;
    while (!waiting.empty()) {
        const auto [first, last] = waiting.back();
        waiting.pop_back();
        double most = k_straight;
        std::size_t farthest = first;
        for (std::size_t k = first + 1; k < last; ++k) {
            const double off = off_line(chain[first], chain[last], chain[k]);
            if (off > most) {
                most = off;
                farthest = k;
            }
        }
        if (farthest == first) continue;
        needed[farthest] = true;
        waiting.push_back({first, farthest});
        waiting.push_back({farthest, last});
    }
}

std::vector<Piece> straightened(const std::vector<Piece>& pieces)
{
    std::vector<Piece> out;
    for (std::size_t k = 0; k < pieces.size(); ++k) {
        if (pieces[k].command != 'L' || out.empty()) {
            out.push_back(pieces[k]);
            continue;
        }
        std::vector<Point> chain = {out.back().end()};
        for (; k < pieces.size() && pieces[k].command == 'L'; ++k) chain.push_back(pieces[k].end());
        --k;
        std::vector<bool> needed(chain.size(), false);
        mark_needed(chain, needed);
        for (std::size_t n = 1; n < chain.size(); ++n)
            if (needed[n]) out.push_back({'L', {chain[n]}, 1});
    }
    // Cairo goes back to the start of a contour that it has closed, where nothing follows
    while (out.size() > 1 && out.back().command == 'M') out.pop_back();
    return out;
}

class PathWriter
{
public:
    std::string write(const std::vector<Piece>& pieces)
    {
        for (const Piece& piece : pieces) {
            if (piece.command == 'Z') {
                add_command('z');
                x_ = start_x_;
                y_ = start_y_;
                exact_ = start_;
                continue;
            }
            // The steps of a curve are its own, so that equal ones are written by equal bytes; what rounding leaves
            // over, the next line or move makes good
            const Point from = piece.command == 'C' ? exact_ : Point{static_cast<double>(x_), static_cast<double>(y_)};
            std::vector<std::int64_t> steps;
            for (int k = 0; k < piece.count; ++k) {
                const Point& point = piece.points[static_cast<std::size_t>(k)];
                steps.push_back(std::llround(point.x - from.x));
                steps.push_back(std::llround(point.y - from.y));
            }
            const std::int64_t dx = steps[steps.size() - 2];
            const std::int64_t dy = steps.back();
            if (piece.command == 'L' && dx != 0 && dy == 0) {
                add_command('h');
                add(dx);
            } else if (piece.command == 'L' && dx == 0 && dy != 0) {
                add_command('v');
                add(dy);
            } else {
                add_command(static_cast<char>(std::tolower(piece.command)));
                for (const std::int64_t step : steps) add(step);
            }
            x_ += dx;
            y_ += dy;
            exact_ = piece.end();
            if (std::abs(exact_.x - static_cast<double>(x_)) > k_drift ||
                std::abs(exact_.y - static_cast<double>(y_)) > k_drift)
                exact_ = {static_cast<double>(x_), static_cast<double>(y_)};
            if (piece.command == 'M') {
                start_x_ = x_;
                start_y_ = y_;
                start_ = exact_;
            }
        }
        return out_;
    }

private:
    static constexpr double k_drift = 2.0; ///< [steps]

    void add_command(char command)
    {
        // Lines behind a move need no letter of their own, others none where they repeat
        if (command != command_ || command == 'm' || command == 'z') out_ += command;
        command_ = command;
    }

    void add(std::int64_t steps)
    {
        std::string number = std::to_string(std::abs(steps) / 100);
        if (const std::int64_t part = std::abs(steps) % 100; part != 0) {
            number += part < 10 ? ".0" : ".";
            number += std::to_string(part);
            if (number.back() == '0') number.pop_back();
            if (number.front() == '0') number.erase(0, 1);
        }
        const bool has_point = number.find('.') != std::string::npos;
        const bool begins = out_.empty() || std::isalpha(static_cast<unsigned char>(out_.back())) != 0;
        if (steps < 0) out_ += '-';
        else if (!begins && !(number.front() == '.' && had_point_)) out_ += ' ';
        had_point_ = has_point;
        out_ += number;
    }

    std::string out_;
    char command_ = 0;
    bool had_point_ = false; ///< the last number: then one that begins with a point needs nothing before it
    std::int64_t x_ = 0;     ///< where the steps written have led
    std::int64_t y_ = 0;
    std::int64_t start_x_ = 0;
    std::int64_t start_y_ = 0;
    Point exact_; ///< where the path itself is
    Point start_;
};

/// A number with fewer decimals.
std::string rounded(std::string_view number)
{
    const std::size_t point = number.find('.');
    return std::string(number.substr(0, point == std::string_view::npos ? point : point + 1 + k_decimals));
}

/// "12%,40.5%,100%" as "#1f67ff"; nothing where it is something else.
std::optional<std::string> colour(const std::string& percents)
{
    double parts[3] = {};
    int end = 0;
    if (std::sscanf(percents.c_str(), "%lf%%,%lf%%,%lf%%%n", &parts[0], &parts[1], &parts[2], &end) != 3)
        return std::nullopt;
    if (end != static_cast<int>(percents.size())) return std::nullopt;
    std::string code = "#";
    for (const double part : parts) code += fmt::format("{:02x}", std::lround(2.55 * std::clamp(part, 0.0, 100.0)));
    return code;
}

/// Cairo writes, of each font, a sign for those that the font hasn't: it goes, as whatever is never shown.
std::string without_unused_signs(std::string svg)
{
    constexpr std::string_view k_open = "<symbol overflow=\"visible\" id=\"";
    constexpr std::string_view k_close = "</symbol>\n";
    std::string kept;
    std::size_t at = 0;
    for (std::size_t open = svg.find(k_open); open != std::string::npos; open = svg.find(k_open, open + 1)) {
        const std::size_t name = open + k_open.size();
        const std::size_t close = svg.find(k_close, name);
        if (close == std::string::npos) break;
        const std::string use = "\"#" + svg.substr(name, svg.find('"', name) - name) + "\"";
        if (svg.find(use) != std::string::npos) continue;
        kept += svg.substr(at, open - at);
        at = close + k_close.size();
    }
    return kept + svg.substr(at);
}

/// Cairo writes the same region anew for all that is clipped by it: the first of each stays, and is what the others
/// meant.
std::string with_each_clip_once(std::string svg)
{
    constexpr std::string_view k_open = "<clipPath id=\"";
    constexpr std::string_view k_close = "</clipPath>\n";
    constexpr std::string_view k_use = "\"url(#";
    std::map<std::string, std::string> first_of; // by the region
    std::map<std::string, std::string> meant;    // by the name of a later one
    std::string kept;
    std::size_t at = 0;
    for (std::size_t open = svg.find(k_open); open != std::string::npos; open = svg.find(k_open, at)) {
        const std::size_t name = open + k_open.size();
        const std::size_t region = svg.find('"', name);
        const std::size_t close = svg.find(k_close, name);
        if (region == std::string::npos || close == std::string::npos) break;
        const std::string id = svg.substr(name, region - name);
        const auto [known, is_new] = first_of.try_emplace(svg.substr(region, close - region), id);
        const std::size_t end = close + k_close.size();
        kept += svg.substr(at, (is_new ? end : open) - at);
        if (!is_new) meant[id] = known->second;
        at = end;
    }
    kept += svg.substr(at);
    if (meant.empty()) return svg;

    std::string out;
    at = 0;
    for (std::size_t use = kept.find(k_use); use != std::string::npos; use = kept.find(k_use, at)) {
        const std::size_t name = use + k_use.size();
        const std::size_t end = std::min(kept.find(')', name), kept.size());
        const std::string id = kept.substr(name, end - name);
        const auto other = meant.find(id);
        out += kept.substr(at, name - at) + (other == meant.end() ? id : other->second);
        at = end;
    }
    return out + kept.substr(at);
}

} // namespace

std::string light_svg(std::string_view svg)
{
    struct Mark
    {
        std::string_view open;
        char close;
    };
    constexpr Mark k_marks[] = {{" d=\"", '"'}, {"opacity:", ';'}, {"rgb(", ')'}, {" x=\"", '"'}, {" y=\"", '"'}};
    std::string light;
    light.reserve(svg.size());
    for (std::size_t at = 0; at < svg.size();) {
        std::size_t first = svg.size();
        const Mark* mark = nullptr;
        for (const Mark& one : k_marks) {
            const std::size_t found = svg.substr(0, first).find(one.open, at);
            if (found == std::string_view::npos) continue;
            first = found;
            mark = &one;
        }
        const std::string_view between = svg.substr(at, first - at);
        const bool is_letter = between.find("<symbol") != std::string_view::npos;
        light += between;
        at = first;
        if (mark == nullptr) break;
        const std::size_t start = at + mark->open.size();
        const std::size_t end = std::min(svg.find(mark->close, start), svg.size());
        const std::string_view inside = svg.substr(start, end - start);
        at = end;
        if (mark->close == ')') {
            const auto code = colour(std::string(inside));
            light += code ? *code : "rgb(" + std::string(inside) + ")";
            at = std::min(end + 1, svg.size());
            continue;
        }
        light += mark->open;
        const bool is_path = mark->open == k_marks[0].open;
        if (!is_path) {
            light += rounded(inside);
            continue;
        }
        auto pieces = PathReader(inside).read();
        if (pieces && is_letter) put_on_grain(*pieces);
        light += pieces ? PathWriter().write(straightened(*pieces)) : std::string(inside);
    }
    return without_unused_signs(with_each_clip_once(std::move(light)));
}

} // namespace flying::weave
