#include <cmath>
#include <cstdio>
#include <fstream>
#include <string>
#include <vector>

#include "../support/sketch.hpp"
#include "counts.hpp"
#include "crowd.hpp"
#include "gas.hpp"

using namespace flying;
using namespace flying::sketch;

namespace {

std::string number(double value, const char* format = "%.0f")
{
    return text_of(format, value);
}

/// A crowded room; one disc, and those that it is compared with.
void draw_room(const std::string& folder)
{
    Sketch s(folder + "/room.svg", 560, 420);
    Random random(961);
    const double scale = 28.0;
    const Vec2 origin(0, 420);
    const auto at = [&](const Vec2& x) { return Vec2(origin.x() + scale * x.x(), origin.y() - scale * x.y()); };
    constexpr double k_cell = 1.25;
    std::vector<Vec2> places;
    while (places.size() < 110) {
        const Vec2 x{random.uniform(0.4, 19.6), random.uniform(0.4, 14.6)};
        bool is_free = true;
        for (const Vec2& other : places) is_free = is_free && (x - other).norm() > 0.8;
        if (is_free) places.push_back(x);
    }
    Grid grid(k_cell, 16, 16, static_cast<int>(places.size()));
    for (std::size_t k = 0; k < places.size(); ++k) grid.insert(static_cast<int>(k), grid.cell_at(places[k]));
    int chosen = 0;
    for (std::size_t k = 0; k < places.size(); ++k) {
        if ((places[k] - Vec2(9.5, 7.5)).norm() < (places[chosen] - Vec2(9.5, 7.5)).norm()) chosen = static_cast<int>(k);
    }
    const Cell cell = grid.cell_of(chosen);
    const Vec2 corner = k_cell * Vec2(static_cast<double>(cell.column - 1), static_cast<double>(cell.row - 1));
    s.polygon(box(at(corner + Vec2::Constant(1.5 * k_cell)), 3.0 * k_cell * scale, 3.0 * k_cell * scale),
              pale(k_ochre, 0.3), k_none);
    for (int k = 0; k <= 16; ++k) s.line(at(Vec2(k * k_cell, 0)), at(Vec2(k * k_cell, 15)), pale(k_soft, 0.5), 1.0);
    for (int k = 0; k <= 12; ++k) s.line(at(Vec2(0, k * k_cell)), at(Vec2(20, k * k_cell)), pale(k_soft, 0.5), 1.0);
    for (const Vec2& x : places) s.disc(at(x), 0.4 * scale, pale(k_blue, 0.2), k_blue, 1.4);
    grid.for_each_near(cell, [&](int other) { s.disc(at(places[other]), 0.4 * scale, pale(k_rust, 0.45), k_rust, 2.0); });
    s.disc(at(places[chosen]), 0.4 * scale, k_rust, k_ink, 2.0);
}

/// All pairs of places of two bodies, and those that lie side by side.
void draw_band(const std::string& folder)
{
    Sketch s(folder + "/band.svg", 480, 360);
    const double side = 280.0;
    const Vec2 o(90, 312);
    const auto at = [&](double x, double y) { return Vec2(o.x() + side * x, o.y() - side * y); };
    const double w = 0.28;
    s.polygon({at(0, 0), at(w, 0), at(1, 1 - w), at(1, 1), at(1 - w, 1), at(0, w)}, pale(k_ochre, 0.45), k_none);
    s.polygon({at(w, 0), at(1, 0), at(1, 1 - w)}, pale(k_blue, 0.14), k_blue, 1.6);
    s.polygon({at(0, w), at(0, 1), at(1 - w, 1)}, pale(k_blue, 0.14), k_blue, 1.6);
    s.polygon({at(0, 0), at(1, 0), at(1, 1), at(0, 1)}, k_none, k_ink, 2.0);
    s.words(at(0.5, 0.47), "side by side", Anchor::middle, k_ink);
    s.words(at(0.74, 0.2), "apart", Anchor::middle, k_blue);
    s.words(at(0.26, 0.76), "apart", Anchor::middle, k_blue);
    s.formula(at(1.06, 0.0), "x_1", Anchor::left);
    s.formula(at(-0.05, 0.97), "x_2", Anchor::right);
    s.measure(at(0, -0.06), at(w, -0.06));
    s.formula(at(0.5 * w, -0.06) + Vec2(0, 24), "w");
    s.measure(at(w, -0.06), at(1, -0.06));
    s.formula(at(0.5 + 0.5 * w, -0.06) + Vec2(0, 24), "W - w");
}

/// Boxes, their shadows on the line, and those that the sweeping line touches.
void draw_line(const std::string& folder)
{
    Sketch s(folder + "/line.svg", 560, 360);
    const std::vector<Vec2> middles = {{60, 70}, {118, 160}, {205, 92}, {262, 128}, {316, 196}, {420, 80}, {480, 176}};
    const double x = 276;
    int slot = 0;
    for (const Vec2& m : middles) {
        const bool touched = std::abs(m.x() - x) <= 44.0;
        const Tone tone = touched ? k_rust : k_blue;
        s.polygon(box(m, 88, 62), pale(tone, 0.2), tone, 2.0);
        const double y = 258.0 + 16.0 * (slot++ % 4);
        s.line(Vec2(m.x() - 44, y), Vec2(m.x() + 44, y), tone, 5.0);
        s.formula(m + Vec2(0, 7), std::string(1, static_cast<char>('A' + slot - 1)), Anchor::middle, tone);
    }
    s.line(Vec2(x, 18), Vec2(x, 320), k_ink, 2.2);
    s.arrow(Vec2(x + 6, 28), Vec2(x + 52, 28), k_ink, 2.2);
    s.arrow(Vec2(8, 334), Vec2(552, 334), k_soft, 1.6);
    s.formula(Vec2(544, 324), "x", Anchor::middle, k_soft);
}

/// Boxes compared in one look, over the number of bodies.
void draw_growth(const std::string& folder)
{
    Sketch s(folder + "/growth.svg", 560, 400);
    const LogPlot plot(s, Vec2(70, 340), Vec2(530, 24), Vec2(1, 0), Vec2(4, 8));
    plot.axes(1, 2);
    s.words(Vec2(530, 388), "bodies", Anchor::right, k_soft);
    s.words(Vec2(82, 40), "boxes compared in one look", Anchor::left, k_soft);
    for (const int n : {10, 30, 100, 300, 1000, 3000, 10'000}) {
        Random random(92);
        const double W = 2.0 * std::sqrt(n);
        const Counts c = count(discs_in_room(n, 0.5, W, W, random), 0.5);
        plot.dot(n, static_cast<double>(c.all), k_rust);
        plot.dot(n, static_cast<double>(c.sweep), k_blue);
        plot.dot(n, static_cast<double>(c.grid), k_teal);
    }
    plot.curve(10, 1e4, [](double n) { return 0.5 * n * (n - 1); }, pale(k_rust, 0.5));
    plot.curve(10, 1e4,
               [](double n) {
                   const double gap = 1.0 - 0.5 / std::sqrt(n);
                   return 0.5 * n * (n - 1) * (1.0 - gap * gap);
               },
               pale(k_blue, 0.5));
    plot.curve(10, 1e4, [](double n) { return 4.5 * n; }, pale(k_teal, 0.5));
    s.words(plot.at(1500, 1.4e7), "all pairs", Anchor::right, k_rust);
    s.words(plot.at(1350, 1.5e5), "sweep", Anchor::left, k_blue);
    s.words(plot.at(9000, 4e3), "grid", Anchor::right, k_teal);
}

/// A straight flight over the cells, with a dot at each border that it crosses.
void draw_flight(const std::string& folder)
{
    Sketch s(folder + "/flight.svg", 560, 300);
    const double cell = 70.0;
    const Vec2 from(40, 262);
    const Vec2 to(458, 114);
    for (int k = 0; k <= 8; ++k) s.line(Vec2(k * cell, 6), Vec2(k * cell, 294), pale(k_soft, 0.6), 1.2);
    for (int k = 0; k <= 4; ++k) s.line(Vec2(0, 10 + k * cell), Vec2(560, 10 + k * cell), pale(k_soft, 0.6), 1.2);
    s.polygon(box(Vec2(385, 115), cell, cell), pale(k_blue, 0.25), k_none);
    s.polygon(box(Vec2(525, 115), cell, 3.0 * cell), pale(k_ochre, 0.4), k_none);
    s.polygon(box(Vec2(455, 115), cell, cell), pale(k_rust, 0.25), k_none);
    s.arrow(from, to, k_ink, 2.4);
    const Vec2 way = to - from;
    for (int k = 1; k < 8; ++k) {
        const double t = (k * cell - from.x()) / way.x();
        if (t > 0.0 && t < 1.0) s.disc(from + t * way, 5.0, k_rust, k_none);
    }
    for (int k = 0; k <= 4; ++k) {
        const double t = (10 + k * cell - from.y()) / way.y();
        if (t > 0.0 && t < 1.0) s.disc(from + t * way, 5.0, k_teal, k_none);
    }
    s.words(Vec2(525, 40), "new", Anchor::middle, k_ink);
    s.measure(Vec2(70, 24), Vec2(140, 24), k_ink);
    s.formula(Vec2(105, 46), "s");
}

/// Work of a body that flies and is looked at, over the size of the cells: counted, and by the formula.
void draw_best(const std::string& folder)
{
    Sketch s(folder + "/best.svg", 560, 360);
    constexpr double k_change = 3.0;
    const auto at = [](double share, double value) { return Vec2(64.0 + 190.0 * share, 310.0 - 30.0 * value); };
    s.arrow(at(0, 0), at(2.55, 0), k_soft, 1.6);
    s.arrow(at(0, 0), at(0, 9.6), k_soft, 1.6);
    for (const double share : {0.5, 1.0, 1.5, 2.0}) {
        s.line(at(share, 0), at(share, 0) + Vec2(0, 6), k_soft, 1.4);
        s.words(at(share, 0) + Vec2(0, 24), number(share, "%.1f"), Anchor::middle, k_ink, 15.0);
    }
    for (const double value : {3.0, 6.0, 9.0}) {
        s.line(at(0, value), at(2.5, value), pale(k_soft, 0.3), 1.0);
        s.words(at(0, value) + Vec2(-9, 5), number(value), Anchor::right, k_ink, 15.0);
    }
    std::vector<Vec2> curve;
    for (int k = 35; k <= 190; ++k) {
        const double x = 0.01 * k; // cell size over the distance of neighbours
        curve.push_back(at(x, 4.0 / 3.14159265 * (k_change / x + 3.0 * x)));
    }
    std::erase_if(curve, [](const Vec2& p) { return p.y() < 46.0; });
    s.path(curve, pale(k_blue, 0.55), 3.0);

    // Count borders and new neighbours; the plane is wrapped, so that no wall spoils the mean
    for (const double share : {0.6, 0.7, 0.8, 1.0, 1.2, 1.4, 1.7}) {
        constexpr int k_columns = 16;
        constexpr int k_steps = 1000;
        constexpr double k_step = 0.01; // distances of neighbours
        Random random(962);
        const int bodies = static_cast<int>(std::lround(k_columns * k_columns * share * share));
        Grid grid(share, k_columns, k_columns, bodies);
        std::vector<Vec2> x;
        std::vector<Vec2> v;
        for (int k = 0; k < bodies; ++k) {
            const double angle = random.uniform(0.0, 6.283185307);
            x.push_back(Vec2{random.uniform(0.0, k_columns * share), random.uniform(0.0, k_columns * share)});
            v.push_back(Vec2(std::cos(angle), std::sin(angle)));
            grid.insert(k, grid.cell_at(x.back()));
        }
        double spent = 0.0;
        for (int step = 0; step < k_steps; ++step) {
            for (int k = 0; k < bodies; ++k) {
                x[k] += k_step * v[k];
                const Cell from = grid.cell_of(k);
                const Cell to = grid.cell_at(x[k]);
                if (to == from) continue;
                grid.move(k, to);
                spent += k_change;
                for (std::int64_t row = to.row - 1; row <= to.row + 1; ++row) {
                    for (std::int64_t column = to.column - 1; column <= to.column + 1; ++column) {
                        if (std::abs(row - from.row) <= 1 && std::abs(column - from.column) <= 1) continue;
                        grid.for_each_in({column, row}, [&](int) { spent += 1.0; });
                    }
                }
            }
        }
        s.disc(at(share, spent / (bodies * k_steps * k_step)), 5.5, k_rust, k_none);
    }
    s.words(at(1.25, 0) + Vec2(0, 46), "cell size, in distances of neighbours", Anchor::middle, k_soft);
    s.words(at(0.05, 9.3) + Vec2(4, 0), "comparisons for each distance flown", Anchor::left, k_soft);
}

/// Work of the event engine for a thousand impacts of few discs.
void draw_few(const std::string& folder)
{
    Sketch s(folder + "/few.svg", 560, 350);
    const auto at = [](double n, double value) { return Vec2(76.0 + 9.4 * n, 296.0 - 2.8 * value); };
    s.arrow(at(0, 0), at(50, 0), k_soft, 1.6);
    s.arrow(at(0, 0), at(0, 98), k_soft, 1.6);
    for (int n = 8; n <= 48; n += 8) s.words(at(n, 0) + Vec2(0, 22), std::to_string(n), Anchor::middle, k_ink, 15.0);
    for (int v = 30; v <= 90; v += 30) {
        s.line(at(0, v), at(49, v), pale(k_soft, 0.3), 1.0);
        s.words(at(0, v) + Vec2(-8, 5), std::to_string(v), Anchor::right, k_ink, 15.0);
    }
    std::vector<Vec2> all;
    std::vector<Vec2> grid;
    for (int n = 4; n <= 48; n += 4) {
        all.push_back(at(n, 1e-3 * work(count_work(n, PairFinder::all_pairs))));
        grid.push_back(at(n, 1e-3 * work(count_work(n, PairFinder::grid))));
    }
    s.path(all, k_rust, 2.6);
    s.path(grid, k_teal, 2.6);
    for (const Vec2& p : all) s.disc(p, 4.0, k_rust, k_none);
    for (const Vec2& p : grid) s.disc(p, 4.0, k_teal, k_none);
    s.words(at(34, 74), "all pairs", Anchor::right, k_rust);
    s.words(at(47, 15), "grid", Anchor::right, k_teal);
    s.words(at(25, 0) + Vec2(0, 46), "bodies", Anchor::middle, k_soft);
    s.words(at(0.8, 95), "work for each impact, in comparisons", Anchor::left, k_soft);
}

/// Where four discs are, and where an index over velocities has them.
void draw_wrong(const std::string& folder)
{
    Sketch s(folder + "/wrong.svg", 560, 300);
    const auto room = [&](double left, const char* title) {
        for (int k = 0; k <= 4; ++k) {
            s.line(Vec2(left + 60.0 * k, 44), Vec2(left + 60.0 * k, 284), pale(k_soft, 0.6), 1.0);
            s.line(Vec2(left, 44 + 60.0 * k), Vec2(left + 240, 44 + 60.0 * k), pale(k_soft, 0.6), 1.0);
        }
        s.words(Vec2(left + 120, 28), title);
    };
    room(16, "positions");
    room(304, "velocities");
    const Vec2 a(120, 150);
    const Vec2 b(158, 168);
    const Vec2 c(60, 240);
    const Vec2 d(226, 84);
    const std::vector<Vec2> places = {a, b, c, d};
    const std::vector<Vec2> speeds = {{76, -74}, {-88, 36}, {52, -28}, {-58, 84}};
    const Tone tones[] = {k_rust, k_blue, k_teal, k_ochre};
    const char* names[] = {"A", "B", "C", "D"};
    const Vec2 zero(424, 164);
    s.line(Vec2(304, 164), Vec2(544, 164), k_soft, 1.4);
    s.line(Vec2(424, 44), Vec2(424, 284), k_soft, 1.4);
    for (int k = 0; k < 4; ++k) {
        s.disc(places[k], 24.0, pale(tones[k], 0.25), tones[k], 2.0);
        s.arrow(places[k], places[k] + 0.55 * speeds[k], tones[k], 2.0);
        s.formula(places[k] - 11.0 * speeds[k].normalized() + Vec2(0, 6), names[k], Anchor::middle, k_ink, 17.0);
        s.disc(zero + speeds[k], 6.0, tones[k], k_none);
        s.formula(zero + speeds[k] + Vec2(14, 16), names[k], Anchor::left, k_ink, 17.0);
    }
}

/// Two rooms that start alike: on the left the pairs are found by position, on the right by velocity.
void record_rooms(const std::string& folder)
{
    std::ofstream trace(folder + "/rooms.ndjson");
    constexpr int k_discs = 24;
    constexpr double k_side = 12.0;
    Crowd left = make_crowd(1, k_side, 4.0, 96);
    Random random(97);
    left.position.clear();
    left.velocity.clear();
    for (int k = 0; k < k_discs; ++k) {
        left.position.push_back(Vec2(1.3 + 2.3 * (k % 5), 1.3 + 2.3 * (k / 5)));
        left.velocity.push_back(Vec2{random.uniform(-4.0, 4.0), random.uniform(-4.0, 4.0)});
    }
    Crowd right = left;
    trace << "{\"view\": [-0.3, -0.3, 25.3, 12.3], \"shapes\": [";
    for (int k = 0; k < 2 * k_discs; ++k) trace << "{\"radius\": 0.5}, ";
    trace << "{\"rings\": [[[-0.1, 0], [0.1, 0], [0.1, 12], [-0.1, 12]]]}], \"fixed\": [";
    for (int k = 0; k < 2 * k_discs; ++k) trace << "false, ";
    trace << "true]}\n";
    for (int step = 0; step <= 480; ++step) {
        if (step % 2 == 0) {
            trace << "{\"time\": " << step / 120.0 << ", \"bodies\": [";
            for (const Vec2& x : left.position) trace << "[" << x.x() << ", " << x.y() << ", 0], ";
            for (const Vec2& x : right.position) trace << "[" << x.x() + 13.0 << ", " << x.y() << ", 0], ";
            trace << "[12.5, 0, 0]]}\n";
        }
        left.step(Index::position, 1.0 / 120.0);
        right.step(Index::velocity, 1.0 / 120.0);
    }
}

/// A gas in its room.
void record_cells(const std::string& folder)
{
    constexpr int k_discs = 80;
    std::ofstream trace(folder + "/cells.ndjson");
    EventEngine engine(gas(k_discs), {PairFinder::grid});
    const double side = -std::get<HalfPlane>(engine.shape(k_discs + 1)).offset;
    trace << "{\"view\": [0, 0, " << side << ", " << side << "], \"shapes\": [";
    for (int k = 0; k < k_discs; ++k) trace << (k > 0 ? ", " : "") << "{\"radius\": 0.5}";
    trace << "]}\n";
    trace.precision(5);
    for (int k = 0; k <= 240; ++k) {
        (void)engine.advance(k / 60.0, -1);
        trace << "{\"time\": " << k / 60.0 << ", \"bodies\": [";
        for (int n = 0; n < k_discs; ++n) {
            const BodyState now = state_at(engine.flyer(n), k / 60.0);
            trace << (n > 0 ? ", [" : "[") << now.position.x() << ", " << now.position.y() << ", 0]";
        }
        trace << "]}\n";
    }
}

} // namespace

int main(int argc, char** argv)
{
    if (argc != 2) return 2;
    const std::string folder = argv[1];
    draw_room(folder);
    draw_band(folder);
    draw_line(folder);
    draw_growth(folder);
    draw_flight(folder);
    draw_best(folder);
    draw_few(folder);
    draw_wrong(folder);
    record_rooms(folder);
    record_cells(folder);
}
