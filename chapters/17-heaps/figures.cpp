#include <algorithm>
#include <cmath>
#include <fstream>
#include <numeric>
#include <string>
#include <vector>

#include "../support/sketch.hpp"
#include "heap.hpp"
#include "rest/body_order.hpp"

using namespace flying;
using namespace flying::sketch;
using namespace flying::test;

namespace {

constexpr double k_scale = 33.0; // pixels in a metre
constexpr double k_high = 11.2;  // of the picture of the pit [m]

Vec2 in_pit(const Vec2& place)
{
    return Vec2(215.0 + k_scale * place.x(), 12.0 + k_scale * (k_high - place.y()));
}

void draw_pit(Sketch& s)
{
    s.path({in_pit(Vec2(-6.0, k_high)), in_pit(Vec2(-6.0, 0.0)), in_pit(Vec2(6.0, 0.0)), in_pit(Vec2(6.0, k_high))},
           k_ink, 2.4);
}

double radius_of(const RestEngine& engine, int body)
{
    return std::get<Disc>(engine.body(body).shape).radius;
}

/// A heap at rest, and what goes through it.
void draw_heap(const std::string& folder, const RestEngine& engine)
{
    Sketch s(folder + "/heap.svg", 430, 396);
    draw_pit(s);
    for (int k = 3; k < engine.body_count(); ++k) {
        s.disc(in_pit(engine.state(k).position), k_scale * radius_of(engine, k), pale(k_blue, 0.14), pale(k_blue, 0.6),
               1.0);
    }
    double most = 0.0;
    const std::vector<RestContact> contacts = engine.contacts();
    for (const RestContact& c : contacts) most = std::max(most, c.normal_force);
    for (const RestContact& c : contacts) {
        const double width = 9.0 * c.normal_force / most;
        if (width < 0.15) continue;
        const Vec2 b = engine.state(c.b).position;
        const Vec2 a =
            engine.body(c.a).is_static ? Vec2(b - radius_of(engine, c.b) * c.normal) : Vec2(engine.state(c.a).position);
        s.line(in_pit(a), in_pit(b), k_rust, width);
    }
}

/// Who is coupled with whom, by contacts and by elimination.
void draw_fill(const std::string& folder)
{
    Sketch s(folder + "/fill.svg", 460, 420);
    const int base = 10;
    const int count = base * (base + 1) / 2;
    const Pairs pairs = pyramid_of(base);
    const OnPaper paper = blocks_by_hand(count, pairs);
    std::vector<int> rank(count);
    for (int k = 0; k < count; ++k) rank[paper.order[k]] = k;
    const double cell = 7.0;
    const auto at = [&](int row, int column) { return Vec2(34.0 + cell * (column + 0.5), 14.0 + cell * (row + 0.5)); };
    s.polygon(sketch::box(at(count / 2, count / 2), cell * count + 6.0, cell * count + 6.0), k_none, k_soft, 1.2);
    const auto dot = [&](int one, int two, Tone tone) {
        s.polygon(sketch::box(at(one, two), 6.0, 6.0), tone, k_none);
        s.polygon(sketch::box(at(two, one), 6.0, 6.0), tone, k_none);
    };
    for (int k = 0; k < count; ++k) {
        s.polygon(sketch::box(at(k, k), 6.0, 6.0), k_ink, k_none);
        for (const int other : paper.neighbours[k]) dot(rank[k], rank[other], pale(k_rust, 0.45));
    }
    for (const auto& [a, b] : pairs) dot(rank[a], rank[b], k_blue);
    s.words(Vec2(150, 414), "contact", Anchor::middle, k_blue, 15.0);
    s.words(Vec2(310, 414), "added", Anchor::middle, k_rust, 15.0);
}

/// What sweeps leave, plain and looking back.
void draw_back(const std::string& folder)
{
    Sketch s(folder + "/back.svg", 540, 330);
    const LogPlot plot(s, Vec2(80, 270), Vec2(510, 20), Vec2(0, -4), Vec2(4, 0));
    plot.axes(1, 1);
    const int n = 40;
    ColumnSweeps column(std::vector<double>(n, 1.0));
    std::vector<Vec2> plain;
    for (int k = 1; k <= 10000; ++k) {
        const double error = column.sweep_once();
        if (error > 1e-4 && error < 1.0) plain.push_back(plot.at(k, error));
    }
    std::vector<Vec2> back;
    for (int k = 1; k <= 600; ++k) {
        const double error = error_looking_back(n, k);
        if (error > 1e-4 && error < 1.0) back.push_back(plot.at(k, error));
    }
    s.path(plain, k_blue, 2.8);
    s.path(back, k_rust, 2.8);
    s.words(Vec2(420, 60), "plain", Anchor::left, k_blue, 17.0);
    s.words(Vec2(200, 150), "looking back", Anchor::right, k_rust, 17.0);
    s.words(Vec2(510, 312), "sweeps", Anchor::right, k_soft, 16.0);
    s.words(Vec2(12, 16), "error", Anchor::left, k_soft, 16.0);
}

/// A pyramid, and the colour of each of its contacts.
void draw_colours(const std::string& folder)
{
    Sketch s(folder + "/colours.svg", 520, 352);
    const int base = 7;
    const double size = 44.0;
    std::vector<Vec2> centres;
    for (int row = 0; row < base; ++row) {
        for (int k = 0; k < base - row; ++k)
            centres.emplace_back(260.0 + 1.25 * size * (k - 0.5 * (base - 1 - row)), 326.0 - size * (row + 0.5));
    }
    s.line(Vec2(20, 326), Vec2(500, 326), k_ink, 2.4);
    for (const Vec2& centre : centres) s.polygon(sketch::box(centre, size, size), pale(k_soft, 0.08), k_soft, 1.4);

    // The first colour that neither box has, as in colour_of; boxes of one row don't touch here
    std::vector<unsigned> used(centres.size(), 0u);
    const Tone tones[] = {k_rust, k_blue, k_teal, k_amber, k_ink, k_soft};
    const auto add = [&](int a, int b) {
        const unsigned taken = (a < 0 ? 0u : used[a]) | used[b];
        int colour = 0;
        while ((taken >> colour & 1u) != 0u) ++colour;
        if (a >= 0) used[a] |= 1u << colour;
        used[b] |= 1u << colour;
        const double half = 0.5 * size;
        const double x = a < 0 ? centres[b].x() : 0.5 * (centres[a].x() + centres[b].x());
        s.disc(Vec2(x, centres[b].y() + half), 7.0, tones[colour], k_none);
        s.words(Vec2(x, centres[b].y() + half + 4.5), std::to_string(colour), Anchor::middle, Tone{0xffffff, 1.0},
                11.0);
    };
    for (int k = 0; k < base; ++k) add(-1, k);
    for (const auto& [a, b] : pyramid_of(base)) {
        if (b != a + 1) add(a, b);
    }
}

/// The curve along which bodies lie in memory.
void draw_curve(const std::string& folder, const RestEngine& engine)
{
    Sketch s(folder + "/curve.svg", 430, 396);
    draw_pit(s);
    std::vector<RestBody> bodies;
    for (int k = 3; k < engine.body_count(); ++k) bodies.push_back(engine.body(k));
    for (const RestBody& body : bodies) {
        s.disc(in_pit(body.state.position), k_scale * std::get<Disc>(body.shape).radius, pale(k_blue, 0.14),
               pale(k_blue, 0.5), 1.0);
    }
    std::vector<Vec2> way;
    for (const int k : order_in_memory(bodies, 0)) way.push_back(in_pit(bodies[k].state.position));
    s.path(way, k_rust, 2.0);
    s.disc(way.front(), 5.0, k_ink, k_none);
    s.disc(way.back(), 5.0, k_ink, k_none);
}

/// The discs as they fall, and come to rest.
void record_pour(const std::string& folder)
{
    std::ofstream trace(folder + "/pour.ndjson");
    const std::vector<RestBody> bodies = over_a_pit(80);
    trace << "{\"view\": [-6.5, -0.5, 6.5, 9], \"fixed\": [true";
    for (std::size_t k = 3; k < bodies.size(); ++k) trace << ", false";
    trace << "], \"shapes\": [{\"rings\": [[[-7, -0.5], [7, -0.5], [7, 0], [-7, 0]]]}";
    for (std::size_t k = 3; k < bodies.size(); ++k)
        trace << text_of(", {\"radius\": %.4f}", std::get<Disc>(bodies[k].shape).radius);
    trace << "]}\n";
    RestEngine engine(bodies);
    for (int k = 0; k <= 60 * 5; ++k) {
        trace << "{\"time\": " << k / 60.0 << ", \"bodies\": [[0, 0, 0]";
        for (int i = 3; i < engine.body_count(); ++i) {
            const BodyState state = engine.state(i);
            trace << text_of(", [%.4f, ", state.position.x()) << text_of("%.4f, ", state.position.y())
                  << text_of("%.3f]", state.angle);
        }
        trace << "]}\n";
        engine.step();
    }
}

} // namespace

int main(int argc, char** argv)
{
    if (argc < 2) return 1;
    const std::string folder = argv[1];
    RestEngine heap(over_a_pit(200));
    time_to_sleep(heap, 30.0);
    draw_heap(folder, heap);
    draw_fill(folder);
    draw_back(folder);
    draw_colours(folder);
    draw_curve(folder, heap);
    record_pour(folder);
}
