// The figures of the chapter: the table as margins, the throw that was found and the one that is left of it.

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "hunt.hpp"
#include "row.hpp"
#include "silence.hpp"
#include "support/sketch.hpp"

using namespace flying;
using namespace flying::breaking;
using namespace flying::sketch;

namespace {

/// Share that may fail against the number of tries without a failure, on powers of ten.
void draw_silence(const std::string& folder)
{
    Sketch s(folder + "/silence.svg", 560.0, 330.0);
    const auto x = [](double log_n) { return 70.0 + 52.0 * log_n; };
    const auto y = [](double log_p) { return 30.0 - 26.0 * log_p; };
    s.line(Vec2(x(0.0), y(-9.6)), Vec2(x(9.0), y(-9.6)), k_soft, 1.4);
    s.line(Vec2(x(0.0), y(-9.6)), Vec2(x(0.0), y(0.2)), k_soft, 1.4);
    for (int k = 0; k <= 9; k += 3) {
        const std::string up = k == 0 ? "1" : text_of("10^%.0f", k);
        const std::string down = k == 0 ? "1" : text_of("10^{\u2212%.0f}", k);
        s.formula(Vec2(x(k), y(-9.6) + 22.0), up, Anchor::middle, k_soft, 16.0);
        s.formula(Vec2(x(0.0) - 8.0, y(-k) + 5.0), down, Anchor::right, k_soft, 16.0);
    }
    s.words(Vec2(x(9.0), y(-9.6) + 42.0), "tries without a failure", Anchor::right, k_soft, 16.0);
    s.words(Vec2(x(0.0) + 10.0, 18.0), "share of cases that may fail", Anchor::left, k_soft, 16.0);
    for (const double alpha : {0.05, 0.001}) {
        std::vector<Vec2> points;
        for (double log_n = 0.0; log_n <= 9.001; log_n += 0.1)
            points.push_back(Vec2(x(log_n), y(std::log10(share_that_may_fail(std::pow(10.0, log_n), alpha)))));
        s.path(points, alpha > 0.01 ? k_blue : k_rust, 2.2);
    }
    s.words(Vec2(x(9.0), y(-3.2)), "luck of one in a thousand", Anchor::right, k_rust, 16.0);
    s.words(Vec2(x(0.6), y(-5.2)), "luck of one in twenty", Anchor::left, k_blue, 16.0);
}

std::vector<Vec2> way_of(const Throw& how)
{
    Ball ball{{how.x, how.y}, {how.u, how.v}};
    std::vector<Vec2> way = {ball.place};
    for (int k = 0; k < how.steps; ++k) {
        step_wrongly(ball, how);
        way.push_back(ball.place);
    }
    return way;
}

/// The room with a way in it, seen from -margin to 1 + margin.
void draw_room(Sketch& s, const Vec2& corner, double side, double low, double high, const std::vector<Vec2>& way,
               const char* title)
{
    const auto at = [&](const Vec2& p) {
        const Vec2 q = ((p - Vec2(low, low)) / (high - low)).cwiseMax(0.0).cwiseMin(1.0);
        return Vec2(corner.x() + side * q.x(), corner.y() + side * (1.0 - q.y()));
    };
    s.polygon({at(Vec2(0, 0)), at(Vec2(1, 0)), at(Vec2(1, 1)), at(Vec2(0, 1))}, pale(k_ochre, 0.12), k_ink, 1.6);
    std::vector<Vec2> shown;
    for (const Vec2& p : way) shown.push_back(at(p));
    s.path(shown, pale(k_blue, 0.7), 1.2);
    if (shown.size() < 12) {
        for (const Vec2& p : shown) s.disc(p, 4.0, k_blue, k_none);
    }
    s.disc(shown.back(), 6.0, k_rust, k_none);
    s.words(Vec2(corner.x() + 0.5 * side, corner.y() + side + 24.0), title, Anchor::middle, k_ink, 16.0);
}

void draw_hunt(const std::string& folder)
{
    Sketch s(folder + "/hunt.svg", 560.0, 300.0);
    const std::optional<std::uint64_t> seed = hunt(gets_out, 100'000);
    if (!seed) return;
    const Throw found = random_throw(*seed);
    const Throw smallest = shrink(found, gets_out);
    draw_room(s, Vec2(20, 10), 240.0, -0.15, 1.15, way_of(found), text_of("found: %.0f steps", found.steps).c_str());
    draw_room(s, Vec2(300, 10), 240.0, -1.0, 2.4, way_of(smallest),
              text_of("shrunk: %.0f steps", smallest.steps).c_str());
}

/// By how many powers of ten each row is better than asked. Each name stands above its bar: beside it, the letters
/// would have to be too small for a phone.
void draw_margins(const std::string& folder, const Table& table)
{
    const double line = 40.0;
    const double top = 44.0;
    Sketch s(folder + "/margins.svg", 560.0, top + line * static_cast<double>(table.rows.size()) + 34.0);
    const double zero = 290.0;
    const double decade = 30.0;
    s.words(Vec2(zero - 6.0, 20.0), "falls short", Anchor::right, k_rust, 17.0);
    s.words(Vec2(zero + 6.0, 20.0), "better by powers of ten", Anchor::left, k_teal, 17.0);
    const double bottom = top + line * static_cast<double>(table.rows.size());
    for (std::size_t k = 0; k < table.rows.size(); ++k) {
        const Row& row = table.rows[k];
        const double y = top + line * static_cast<double>(k) + 26.0;
        s.words(Vec2(10.0, y - 12.0), row.name, Anchor::left, k_ink, 17.0);
        s.line(Vec2(zero, y - 8.0), Vec2(zero, y + 8.0), k_soft, 1.4);
        const Tone tone = row.holds ? k_teal : k_rust;
        // What must be nought has no power of ten: a filled dot on the line where it is
        const bool has_ratio = row.reached > 0.0 && row.bound > 0.0;
        double decades = has_ratio ? std::log10(row.at_least ? row.reached / row.bound : row.bound / row.reached) : 0.0;
        decades = std::clamp(decades, -9.0, 8.0);
        const Vec2 end(zero + decade * decades, y);
        if (has_ratio) s.line(Vec2(zero, y), end, tone, 3.0);
        s.disc(end, row.is_whole ? 5.0 : 4.0, row.is_whole ? tone : k_none, tone, 2.0);
    }
    for (const int k : {-9, -6, -3, 3, 6})
        s.words(Vec2(zero + decade * k, bottom + 24.0), text_of(k < 0 ? "\u2212%.0f" : "+%.0f", std::abs(k)),
                Anchor::middle, k_soft, 17.0);
}

} // namespace

int main(int argc, char** argv)
{
    if (argc != 2) return 2;
    const std::string folder = argv[1];
    const auto table = read_table_file(FLYING_MEASURED);
    if (!table) {
        std::fprintf(stderr, "%s: found no table; expected the file of a run of ./course stress table\n",
                     FLYING_MEASURED);
        return 1;
    }
    draw_silence(folder);
    draw_hunt(folder);
    draw_margins(folder, *table);
    return 0;
}
