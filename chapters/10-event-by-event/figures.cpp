#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <numbers>
#include <string>
#include <vector>

#include "../support/sketch.hpp"
#include "broadphase/grid.hpp"
#include "events/cell_exit.hpp"
#include "gas.hpp"
#include "room.hpp"
#include "three.hpp"

using namespace flying;
using namespace flying::sketch;

namespace {

constexpr double k_pi = std::numbers::pi;

/// Everything up to the next impact, or to a time; true at an impact.
bool advance_one_impact(EventEngine& engine, double until)
{
    const std::int64_t before = engine.counts().impacts;
    while (engine.time() < until && engine.counts().impacts == before) {
        if (engine.advance(until, 1)) return false;
    }
    return engine.counts().impacts > before;
}

/// A disc in its cell, the nine where it may meet others, and those it has yet to look at
/// when it leaves.
void draw_cells(const std::string& folder)
{
    Sketch s(folder + "/cells.svg", 520, 400);
    const double size = 72.0;
    const auto corner = [&](double column, double row) {
        return Vec2(80.0 + size * column, 380.0 - size * row);
    };
    const Flyer flyer{{{2.35, 2.6}, {0.9, 0.35}, 0.0, 0.0, 0.0}};
    const Cell home{2, 2};
    const CellExit exit = next_cell_exit(flyer, home, 1.0, 0.0);
    const auto fill = [&](std::int64_t column, std::int64_t row, Tone tone) {
        const Vec2 low = corner(static_cast<double>(column), static_cast<double>(row));
        s.polygon({low, low + Vec2(size, 0), low + Vec2(size, -size), low + Vec2(0, -size)},
                  tone, k_none);
    };
    for (int row = 1; row <= 3; ++row)
        for (int column = 1; column <= 3; ++column) fill(column, row, pale(k_blue, 0.22));
    for (const Cell& cell : cells_ahead(home, step_over(exit.side)))
        fill(cell.column, cell.row, pale(k_rust, 0.28));
    for (int k = 0; k <= 5; ++k) {
        s.line(corner(k, 0), corner(k, 5), k_soft, 1.2);
        s.line(corner(0, k), corner(5, k), k_soft, 1.2);
    }
    const auto disc = [&](const Vec2& p, Tone tone) {
        s.disc(corner(p.x(), p.y()), 0.45 * size, pale(tone, 0.35), tone, 2.0);
    };
    disc({1.3, 3.55}, k_teal);
    disc({0.55, 1.5}, k_soft);
    disc({4.45, 1.7}, k_rust);
    disc({3.4, 4.4}, k_soft);
    disc(flyer.state.position, k_blue);
    const Vec2 from = corner(2.35, 2.6);
    const BodyState leaving = state_at(flyer, exit.time);
    const Vec2 to = corner(leaving.position.x(), leaving.position.y());
    s.arrow(from, from + 1.55 * (to - from), k_ink, 2.4);
    s.disc(to, 5.0, k_ink, k_none);
}

/// A room and its mirror images: the way with bounces, and the straight one.
void draw_unfold(const std::string& folder)
{
    Sketch s(folder + "/unfold.svg", 560, 330);
    const Room room;
    const double scale = 58.0;
    const auto at = [&](double x, double y) {
        return Vec2(36.0 + scale * x, 286.0 - scale * y);
    };
    for (int k = 0; k <= 3; ++k)
        s.line(at(k * room.width, 0), at(k * room.width, 2.6 * room.height), k_soft, 1.2);
    for (int k = 0; k <= 2; ++k)
        s.line(at(0, k * room.height), at(3 * room.width, k * room.height), k_soft, 1.2);
    s.polygon(
        {at(0, 0), at(room.width, 0), at(room.width, room.height), at(0, room.height)},
        pale(k_teal, 0.16), k_ink, 2.2);
    EventEngine engine = room_of(room);
    const double until = 5.9;
    std::vector<Vec2> way;
    const auto here = [&] {
        const Vec2 p =
            state_at(engine.flyer(0), engine.time()).position - Vec2(0.125, 0.125);
        return at(p.x(), p.y());
    };
    way.push_back(here());
    std::vector<Vec2> crossings;
    while (advance_one_impact(engine, until)) {
        way.push_back(here());
        const Vec2 p = room.x + engine.time() * room.v;
        crossings.push_back(at(p.x(), p.y()));
    }
    way.push_back(here());
    const Vec2 end = room.x + until * room.v;
    s.dashed(at(room.x.x(), room.x.y()), at(end.x(), end.y()), k_blue, 2.4);
    s.path(way, k_rust, 2.4);
    for (const Vec2& p : crossings) s.disc(p, 5.0, k_blue, k_none);
    for (std::size_t k = 1; k + 1 < way.size(); ++k) s.disc(way[k], 5.0, k_rust, k_none);
    s.disc(way.front(), 6.0, {0xffffff, 1.0}, k_ink, 2.2);
    s.disc(way.back(), 6.0, k_rust, k_ink, 2.0);
    s.disc(at(end.x(), end.y()), 6.0, k_blue, k_ink, 2.0);
    s.words(at(0.1, -0.4), "the room", Anchor::left, k_teal);
    s.words(at(room.width + 0.1, -0.4), "mirrored", Anchor::left, k_soft);
    s.words(at(2 * room.width + 0.1, -0.4), "and again", Anchor::left, k_soft);
}

/// How far a ball is off after many bounces.
void draw_drift(const std::string& folder)
{
    Sketch s(folder + "/drift.svg", 540, 370);
    const LogPlot plot(s, Vec2(84, 308), Vec2(520, 26), Vec2(1, -16), Vec2(6, -2));
    plot.axes(1, 2);
    const Room room;
    const double rate = room.v.x() / room.width + room.v.y() / room.height;
    const double speed = room.v.norm();
    const double epsilon = 0x1p-52;
    plot.curve(
        10.0, 1e6, [&](double n) { return epsilon * speed * (n / rate) * n; }, k_soft);
    plot.curve(
        10.0, 1e6, [&](double n) { return epsilon * speed * (n / rate); }, k_teal);
    EventEngine engine = room_of(room);
    for (double n = 10.0; n <= 1e6; n *= 1.3) {
        const double time = n / rate;
        (void)engine.advance(time, -1);
        const Vec2 straight = room.x + time * room.v;
        const Vec2 folded_place(folded(straight.x(), room.width),
                                folded(straight.y(), room.height));
        const Vec2 place = state_at(engine.flyer(0), time).position - Vec2(0.125, 0.125);
        plot.dot(n, std::max((place - folded_place).norm(), 1e-16), k_rust);
    }
    s.words(Vec2(302, 358), "bounces");
    s.words(Vec2(96, 46), "off by, m", Anchor::left);
    s.words(Vec2(252, 128), "all one way", Anchor::middle, k_soft);
    s.words(Vec2(508, 252), "one step of the clock", Anchor::right, k_teal);
}

/// Speeds of a gas that started with one speed.
void draw_speeds(const std::string& folder)
{
    Sketch s(folder + "/speeds.svg", 540, 330);
    EventEngine gas = gas_of(20, 0.29, 109);
    GasWatch watch(gas, 400);
    watch.follow(12.0);
    const GasMeasure m = watch.measure(20.0, 20);
    const auto at = [](double v, double share) {
        return Vec2(60.0 + 180.0 * v, 276.0 - 260.0 * share);
    };
    for (std::size_t k = 0; k < 25; ++k) {
        const double v = 0.1 * static_cast<double>(k);
        const double density =
            10.0 * static_cast<double>(m.speeds[k]) / static_cast<double>(m.samples);
        s.polygon({at(v, 0), at(v + 0.1, 0), at(v + 0.1, density), at(v, density)},
                  pale(k_blue, 0.3), pale(k_blue, 0.8), 1.2);
    }
    std::vector<Vec2> curve;
    for (int k = 0; k <= 125; ++k) {
        const double v = 0.02 * k;
        curve.push_back(at(v, 2.0 * v * std::exp(-v * v)));
    }
    s.path(curve, k_rust, 2.8);
    s.arrow(at(0, 0), at(2.62, 0), k_soft, 1.6);
    s.dashed(at(1.0, 0), at(1.0, 0.98), k_ink, 2.0);
    s.words(at(1.03, 0.93), "all of them, at the start", Anchor::left);
    for (const double v : {0.5, 1.0, 1.5, 2.0}) {
        s.words(at(v, 0) + Vec2(0, 22), text_of("%.1f", v), Anchor::middle, k_ink, 15.0);
    }
    s.words(at(1.3, 0) + Vec2(0, 46), "speed, m/s");
}

/// How far a gas misses its start after it was turned round, over the impacts on the way
/// there.
void draw_reversal(const std::string& folder)
{
    Sketch s(folder + "/reversal.svg", 540, 360);
    const auto at = [](double impacts, double off) {
        return Vec2(84.0 + 26.0 * impacts, 296.0 - 16.0 * (std::log10(off) + 16.0));
    };
    for (int k = -16; k <= 0; k += 4) {
        s.line(at(0, std::pow(10.0, k)), at(16.5, std::pow(10.0, k)), pale(k_soft, 0.3),
               1.0);
        const std::string text = k == 0 ? "1" : "10^{\u2212" + std::to_string(-k) + "}";
        s.formula(at(0, std::pow(10.0, k)) + Vec2(-10, 6), text, Anchor::right, k_ink,
                  16.0);
    }
    for (int k = 0; k <= 16; k += 4)
        s.words(at(k, 1e-16) + Vec2(0, 24), std::to_string(k), Anchor::middle, k_ink, 15.0);
    s.line(at(0, 1e-16), at(16.5, 1e-16), k_soft, 1.4);
    const EventEngine start = gas_of(10, 0.1, 7);
    EventEngine there = gas_of(10, 0.1, 7);
    for (double time = 1.0; time <= 36.0; time += 1.0) {
        (void)there.advance(time, -1);
        EventEngine back = turned_round(there, 100);
        (void)back.advance(time, -1);
        double worst = 1e-16;
        for (int k = 0; k < 100; ++k) {
            const BodyState end = state_at(back.flyer(k), time);
            worst = std::max(worst, (end.position - start.flyer(k).state.position).norm());
        }
        const double impacts = 2.0 * static_cast<double>(there.counts().impacts) / 100.0;
        if (impacts <= 16.5) s.disc(at(impacts, worst), 5.0, k_rust, k_none);
    }
    s.words(at(8, 1e-16) + Vec2(0, 50), "impacts of each disc before the turn");
    s.words(at(0.3, 12.0), "off by, m", Anchor::left);
}

/// Impacts of three balls over what restitution exceeds the threshold by.
void draw_row(const std::string& folder)
{
    Sketch s(folder + "/row.svg", 540, 350);
    const double threshold = 7.0 - 4.0 * std::sqrt(3.0);
    const LogPlot plot(s, Vec2(70, 288), Vec2(520, 26), Vec2(-5, 0), Vec2(0, 3));
    plot.axes(1, 1);
    plot.curve(
        1e-5, 0.928, [&](double over) { return k_pi / row_angle(threshold + over); },
        k_teal);
    for (double over = 1.3e-5; over < 0.93; over *= 1.35) {
        EventEngine engine = three_in_a_row(threshold + over);
        (void)engine.advance(1e5, -1);
        plot.dot(over, static_cast<double>(engine.counts().impacts), k_rust);
    }
    s.formula(Vec2(300, 338), "e − (7 − 4√3)", Anchor::middle, k_ink, 17.0);
    s.words(Vec2(84, 48), "impacts", Anchor::left);
    s.formula(Vec2(240, 92), "π / φ", Anchor::middle, k_teal);
}

/// A gas of sixty-four discs, from its lattice on.
void record_gas(const std::string& folder)
{
    std::ofstream trace(folder + "/gas.ndjson");
    EventEngine gas = gas_of(8, 0.25, 1021);
    const double length = -std::get<HalfPlane>(gas.shape(65)).offset;
    trace << "{\"view\": [0, 0, " << length << ", " << length << "], \"shapes\": [";
    for (int k = 0; k < 64; ++k) trace << (k > 0 ? ", " : "") << R"({"radius": 0.5})";
    trace << ", {\"rings\": [[[0, 0], [" << length << ", 0], [" << length << ", " << length
          << "], [0, " << length << "]], [[0.04, 0.04], [" << length - 0.04 << ", 0.04], ["
          << length - 0.04 << ", " << length - 0.04 << "], [0.04, " << length - 0.04
          << "]]]}], \"fixed\": [";
    for (int k = 0; k < 64; ++k) trace << "false, ";
    trace << "true]}\n";
    trace.precision(5);
    for (int k = 0; k <= 360; ++k) {
        const double time = k / 30.0;
        (void)gas.advance(time, -1);
        trace << "{\"time\": " << time << ", \"bodies\": [";
        for (int n = 0; n < 64; ++n) {
            const BodyState now = state_at(gas.flyer(n), time);
            trace << "[" << now.position.x() << ", " << now.position.y() << ", 0], ";
        }
        trace << "[0, 0, 0]]}\n";
    }
}

} // namespace

int main(int argc, char** argv)
{
    if (argc != 2) return 2;
    const std::string folder = argv[1];
    draw_cells(folder);
    draw_unfold(folder);
    draw_drift(folder);
    draw_speeds(folder);
    draw_reversal(folder);
    draw_row(folder);
    record_gas(folder);
}
