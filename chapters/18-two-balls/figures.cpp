#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <string>
#include <vector>

#include "../support/sketch.hpp"
#include "billiard.hpp"
#include "few.hpp"
#include "toi/discs.hpp"
#include "wrong_loops.hpp"
#include "wrong_quadratic.hpp"

using namespace flying;
using namespace flying::sketch;

namespace {

/// A room that knows the time.
struct Film
{
    discs::Room room;
    double time = 0.0;
    long impacts = 0;

    /// Everything up to the next impact, or to a time; true at an impact.
    bool advance(double until)
    {
        const discs::Impact next = discs::first_impact(room);
        if (!(time + next.wait <= until)) {
            discs::fly(room, until - time);
            time = until;
            return false;
        }
        discs::fly(room, next.wait);
        discs::happen(room, next);
        time += next.wait;
        ++impacts;
        return true;
    }
};

/// The billiard of 1 : 100 as ways over time, each ball shrunk to a point.
void draw_billiard(const std::string& folder)
{
    Sketch s(folder + "/billiard.svg", 560, 330);
    const auto at = [](double t, double x) {
        return Vec2(30.0 + 185.0 * (t - 0.35), 290.0 - 178.0 * x);
    };
    Film film{billiard_room(100.0)};
    std::vector<Vec2> light;
    std::vector<Vec2> heavy;
    std::vector<Vec2> clicks;
    const auto note = [&] {
        light.push_back(at(film.time, film.room.discs[0].x - 0.25));
        heavy.push_back(at(film.time, film.room.discs[1].x - 1.0));
    };
    film.advance(0.5);
    note();
    while (film.advance(2.95)) {
        note();
        clicks.push_back(light.back());
    }
    note();
    s.polygon({at(0.4, 0.0), at(3.1, 0.0), at(3.1, -0.07), at(0.4, -0.07)},
              pale(k_soft, 0.6), k_none);
    s.path(light, k_rust, 1.6);
    s.path(heavy, k_blue, 3.0);
    for (const Vec2& click : clicks) s.disc(click, 2.6, k_ink, k_none);
    s.words(at(0.66, 0.97), "heavy ball", Anchor::left, k_blue);
    s.words(at(0.4, 0.5), "light ball", Anchor::left, k_rust);
    s.words(at(1.5, -0.18), "wall", Anchor::middle, k_soft);
    s.words(at(3.1, -0.18), "time", Anchor::right, k_soft);
    s.words(at(1.5, 1.3), std::to_string(clicks.size()) + " impacts", Anchor::middle);
}

/// The path of one disc as seen from another, and the circle on which they touch.
void draw_passage(const std::string& folder)
{
    Sketch s(folder + "/passage.svg", 560, 300);
    const double scale = 52.0;
    const Vec2 b(330, 170);
    const auto at = [&](double x, double y) {
        return Vec2(b.x() + scale * x, b.y() - scale * y);
    };
    const double reach = 2.0;
    const double miss = 1.2;
    const Vec2 x(-5.2, miss);
    const Vec2 v(1.0, 0.0);
    const double meet = time_to_meet(x, v, reach);
    const double leave = passage_through_circle(x, v, reach).leave;
    s.disc(b, reach * scale, pale(k_teal, 0.16), k_teal, 2.2);
    s.dashed(at(x.x(), miss), at(4.2, miss), k_ink, 1.8);
    s.arrow(at(x.x(), miss), at(x.x() + 1.5, miss), k_blue, 3.0);
    s.arrow(b, at(x.x(), x.y()), k_soft, 1.8);
    s.measure(at(0.0, 0.06), at(0.0, miss - 0.06));
    s.line(b, at(1.1, -1.67), k_teal, 1.6);
    for (const double t : {meet, leave})
        s.disc(at(x.x() + t, miss), 6.0, t == meet ? k_rust : k_none, k_rust, 2.4);
    s.disc(b, 5.0, k_ink, k_none);
    s.formula(at(-3.1, 0.28), "x", Anchor::middle, k_ink);
    s.formula(at(-4.4, miss) + Vec2(0, -14), "v", Anchor::middle, k_blue);
    s.formula(at(0.78, -0.72), "s", Anchor::middle, k_teal);
    s.formula(at(0.0, 0.5) + Vec2(10, 4), "k / V", Anchor::left, k_ink, 17.0);
    s.words(at(x.x() + meet, miss) + Vec2(-8, -14), "enters", Anchor::right, k_rust);
    s.words(at(x.x() + leave, miss) + Vec2(8, -14), "leaves", Anchor::left, k_rust);
    s.formula(b + Vec2(-14, 22), "B", Anchor::middle, k_ink);
    s.formula(at(x.x(), miss) + Vec2(-12, 24), "A", Anchor::middle, k_ink);
}

/// The billiard shot worked by hand: the line of centres, the velocity before, and the two
/// after it.
void draw_shot(const std::string& folder)
{
    Sketch s(folder + "/shot.svg", 560, 330);
    const double scale = 76.0;
    const Vec2 n(0.8, 0.6);
    const auto at = [&](const Vec2& p) {
        return Vec2(190.0 + scale * p.x(), 196.0 - scale * p.y());
    };
    const Vec2 a(0.0, 0.0);
    const Vec2 b = 2.0 * n;
    discs::Disc first{a.x(), a.y(), 5.0, 0.0, 1.0, 1.0};
    discs::Disc second{b.x(), b.y(), 0.0, 0.0, 1.0, 1.0};
    discs::strike(first, second, 1.0);
    const double span = 0.34; // of an arrow, for each m/s [m]
    s.dashed(at(-0.9 * n), at(3.35 * n), k_soft, 1.4);
    s.disc(at(a), scale, pale(k_blue, 0.16), k_blue, 2.2);
    s.disc(at(b), scale, pale(k_rust, 0.16), k_rust, 2.2);
    s.arrow(at(Vec2(-2.2, 0.0)), at(Vec2(-2.2 + span * 5.0, 0.0)), pale(k_blue, 0.6), 2.6);
    s.arrow(at(a), at(span * Vec2(first.vx, first.vy)), k_blue, 3.0);
    s.arrow(at(b), at(b + span * Vec2(second.vx, second.vy)), k_rust, 3.0);
    s.arrow(at(n), at(1.55 * n), k_ink, 2.4);
    s.disc(at(a), 4.0, k_ink, k_none);
    s.disc(at(b), 4.0, k_ink, k_none);
    s.formula(at(1.42 * n) + Vec2(4, 24), "n", Anchor::middle, k_ink);
    s.formula(at(a) + Vec2(-14, -12), "A", Anchor::middle, k_ink);
    s.formula(at(b) + Vec2(-14, -12), "B", Anchor::middle, k_ink);
    s.words(at(Vec2(-2.2, 0.0)) + Vec2(0, -14), "before", Anchor::left, k_blue, 15.0);
    s.words(at(span * Vec2(first.vx, first.vy)) + Vec2(8, 20), "A after", Anchor::left,
            k_blue, 15.0);
    s.words(at(b + span * Vec2(second.vx, second.vy)) + Vec2(10, 2), "B after",
            Anchor::left, k_rust, 15.0);
}

/// The nine discs of the program: the ways of their first seconds, each ended by its disc.
void draw_room(const std::string& folder)
{
    Sketch s(folder + "/room.svg", 480, 440);
    const auto at = [](double x, double y) {
        return Vec2(40.0 + 40.0 * x, 420.0 - 40.0 * y);
    };
    s.polygon({at(0, 0), at(10, 0), at(10, 10), at(0, 10)}, k_none, k_ink, 2.0);
    Film film{discs::nine_discs()};
    std::vector<std::vector<Vec2>> ways(9);
    const auto note = [&] {
        for (std::size_t k = 0; k < 9; ++k)
            ways[k].push_back(at(film.room.discs[k].x, film.room.discs[k].y));
    };
    const double until = 7.0;
    note();
    while (film.advance(until)) note();
    note();
    const std::array tones{k_blue, k_rust, k_teal, k_ochre};
    for (std::size_t k = 0; k < 9; ++k) {
        const Tone tone = tones[k % tones.size()];
        for (std::size_t i = 1; i < ways[k].size(); ++i) {
            const double age = static_cast<double>(i) / static_cast<double>(ways[k].size());
            s.line(ways[k][i - 1], ways[k][i], pale(tone, 0.2 + 0.7 * age), 2.4);
        }
        s.disc(ways[k].back(), 40.0 * film.room.discs[k].r, pale(tone, 0.35), tone, 2.2);
    }
}

/// Ways of three balls over time: two impacts, and one that was foreseen and never came.
void draw_clocks(const std::string& folder)
{
    Sketch s(folder + "/clocks.svg", 560, 330);
    const auto at = [](double t, double x) {
        return Vec2(52.0 + 108.0 * t, 278.0 - 54.0 * x);
    };
    const double foreseen = 4.0;
    const double until = 4.4;
    s.dashed(at(2.0, 2.0), at(foreseen, 2.0), k_soft, 2.0);
    s.dashed(at(8.0 / 3.0, 8.0 / 3.0), at(foreseen, 2.0), k_soft, 2.0);
    const Tone tones[] = {k_blue, k_rust, k_teal};
    Few few;
    few.discs = {{{0.0, 0.0, 1.0, 0.0, 0.5, 1.0}},
                 {{3.0, 0.0, 0.0, 0.0, 0.5, 1.0}},
                 {{6.0, 0.0, -0.5, 0.0, 0.5, 3.0}}};
    std::vector<std::vector<Vec2>> ways(3);
    std::vector<std::vector<Vec2>> dots(3);
    const auto here = [&](int k, double time) {
        return at(time, at_time(few.discs[k], time).x - k);
    };
    for (int k = 0; k < 3; ++k) ways[k].push_back(here(k, 0.0));
    for (int k = 0; k < 3; ++k) few.foresee(k);
    while (!few.queue.empty() && few.queue.top().time <= until) {
        const Foreseen next = few.queue.top();
        few.queue.pop();
        if (next.stamp != few.discs[next.a].stamp + few.discs[next.b].stamp) continue;
        few.strike(next);
        for (const int k : {next.a, next.b}) {
            few.foresee(k);
            ways[k].push_back(here(k, next.time));
            dots[k].push_back(here(k, next.time));
        }
    }
    for (int k = 0; k < 3; ++k) ways[k].push_back(here(k, until));
    s.arrow(at(0.0, -0.35), at(4.7, -0.35), k_soft, 1.6);
    for (int t = 1; t <= 4; ++t) {
        s.line(at(t, -0.35), at(t, -0.27), k_soft, 1.4);
        s.words(at(t, -0.35) + Vec2(0, 22), std::to_string(t) + " s", Anchor::middle, k_ink,
                15.0);
    }
    for (int k = 0; k < 3; ++k) {
        s.path(ways[k], tones[k], 2.8);
        for (const Vec2& dot : dots[k]) s.disc(dot, 6.0, k_ink, k_none);
        const char* names[] = {"A", "B", "C"};
        s.formula(ways[k].front() + Vec2(-20, 6), names[k], Anchor::middle, tones[k]);
    }
    s.disc(at(foreseen, 2.0), 7.0, {0xffffff, 1.0}, k_soft, 2.2);
    s.words(at(foreseen, 2.0) + Vec2(2, -16), "overtaken", Anchor::middle, k_soft);
}

/// The circle of energy for 1 : 16, its points as the engine leaves them.
void draw_circle(const std::string& folder)
{
    Sketch s(folder + "/circle.svg", 520, 420);
    const Vec2 o(262, 212);
    const double radius = 172.0;
    const double ratio = 16.0;
    const double theta = billiard_angle(ratio);
    const auto at = [&](double x, double y) {
        return Vec2(o.x() + radius * x, o.y() - radius * y);
    };
    std::vector<Vec2> wedge{o};
    for (int k = 0; k <= 20; ++k)
        wedge.push_back(at(std::cos(theta * k / 20.0), std::sin(theta * k / 20.0)));
    s.polygon(wedge, pale(k_teal, 0.4), k_none);
    s.disc(o, radius, k_none, k_soft, 1.6);
    s.arrow(at(-1.2, 0), at(1.22, 0), k_soft, 1.6);
    s.arrow(at(0, -1.16), at(0, 1.18), k_soft, 1.6);

    Film film{billiard_room(ratio)};
    const auto here = [&] {
        return at(film.room.discs[1].vx, film.room.discs[0].vx / std::sqrt(ratio));
    };
    std::vector<Vec2> points{here()};
    while (film.advance(100.0)) points.push_back(here());
    for (std::size_t k = 1; k < points.size(); ++k) {
        s.line(points[k - 1], points[k], k % 2 == 1 ? k_blue : k_rust, 2.0);
    }
    for (const Vec2& p : points) s.disc(p, 4.6, k_ink, k_none);
    s.words(points.front() + Vec2(-8, -14), "start", Anchor::right, k_ink);
    s.words(points.back() + Vec2(12, -4), "end", Anchor::left, k_ink);
    s.words(Vec2(16, 36), "blow", Anchor::left, k_blue);
    s.words(Vec2(16, 60), "wall", Anchor::left, k_rust);
    s.formula(at(1.17, -0.13), "√M V", Anchor::left, k_ink, 17.0);
    s.formula(at(0.06, 1.1), "√m v", Anchor::left, k_ink, 17.0);
    s.formula(at(0.5, 0.05), "θ", Anchor::middle, k_teal);
}

/// Heights of a ball that hops at e = 1/2, up to the moment that all its hops lead to.
void draw_hops(const std::string& folder)
{
    Sketch s(folder + "/hops.svg", 560, 250);
    const auto at = [](double t, double y) {
        return Vec2(40.0 + 228.0 * t, 206.0 - 132.0 * y);
    };
    const double g = 9.8;
    const double speed = 4.9;
    double begin = 0.0;
    std::vector<Vec2> curve;
    for (int hop = 0; hop < 12; ++hop) {
        const double v = speed * std::pow(0.5, hop);
        const double length = 2.0 * v / g;
        const int pieces = hop < 4 ? 40 : 8;
        for (int k = 0; k <= pieces; ++k) {
            const double t = length * k / pieces;
            curve.push_back(at(begin + t, v * t - 0.5 * g * t * t));
        }
        begin += length;
        s.disc(at(begin, 0.0), hop < 6 ? 4.0 : 2.0, k_ink, k_none);
    }
    s.polygon({at(-0.08, 0.0), at(2.3, 0.0), at(2.3, -0.08), at(-0.08, -0.08)},
              pale(k_soft, 0.4), k_none);
    s.path(curve, k_blue, 2.6);
    s.dashed(at(2.0, 0.0), at(2.0, 0.95), k_rust, 2.0);
    s.words(at(2.0, 1.02), "2 s", Anchor::middle, k_rust);
    s.words(at(0.0, -0.24), "0", Anchor::middle, k_ink, 15.0);
    s.words(at(1.0, -0.24), "1 s", Anchor::middle, k_ink, 15.0);
    s.words(at(1.5, -0.24), "1\u00bd s", Anchor::middle, k_ink, 15.0);
    s.words(at(0.5, 1.3), "height", Anchor::middle, k_soft, 15.0);
}

/// How far off the time of two discs is, over their distance, in two forms.
void draw_cancel(const std::string& folder)
{
    Sketch s(folder + "/cancel.svg", 560, 360);
    const LogPlot plot(s, Vec2(76, 300), Vec2(536, 24), Vec2(1, -18), Vec2(9, 2));
    plot.axes(2, 4);
    for (double power = 1.0; power <= 9.0; power += 0.1) {
        const FarPair far = far_pair(std::pow(10.0, power), 0.5);
        const double expected = exactly(far, 1.0);
        const double engine = std::abs(time_to_meet(far.x, far.v, 1.0) - expected);
        const double school = std::abs(school_meet(far.x, far.v, 1.0) - expected);
        if (std::isfinite(school) && school > 0.0)
            plot.dot(std::pow(10.0, power), school, k_rust);
        if (engine > 0.0) plot.dot(std::pow(10.0, power), engine, k_blue);
    }
    s.words(plot.at(40.0, 3e-8), "the school formula", Anchor::left, k_rust);
    s.words(plot.at(5e5, 6e-15), "as the engine has it", Anchor::left, k_blue);
    s.words(Vec2(306, 346), "distance, m");
    s.words(Vec2(84, 18), "off by, s", Anchor::left);
}

/// Two equal discs, one at rest, that meet off their centres, by the loop; ghosts by the
/// two closed forms.
void record_discs(const std::string& folder)
{
    std::ofstream trace(folder + "/discs.ndjson");
    trace << "{\"view\": [-3.6, -1.9, 3.6, 1.9], \"shapes\": [{\"radius\": 0.5}, "
             "{\"radius\": 0.5}]}\n";
    const discs::Disc a{-3.0, 0.45, 2.0, 0.0, 0.5, 1.0};
    const discs::Disc b{0.0, 0.0, 0.0, 0.0, 0.5, 1.0};
    const double meet = time_to_meet(Vec2(a.x, a.y), Vec2(a.vx, a.vy), 1.0);
    Clocked first{a, 0.0, 0};
    Clocked second{b, 0.0, 0};
    first.disc = at_time(first, meet);
    discs::Disc struck = first.disc;
    second.disc = b;
    discs::strike(struck, second.disc, 1.0);
    for (int k = 0; k <= 180; ++k) {
        const double t = k / 60.0;
        const discs::Disc p =
            t < meet ? at_time({a, 0.0, 0}, t) : at_time({struck, meet, 0}, t);
        const discs::Disc q = t < meet ? b : at_time({second.disc, meet, 0}, t);
        trace << "{\"time\": " << t << ", \"bodies\": [[" << p.x << ", " << p.y << ", 0], ["
              << q.x << ", " << q.y << ", 0]]}\n";
    }
}

/// The billiard as motion: the loop's balls, the closed form's ghosts, and a bead for each
/// impact.
void record_billiard(const std::string& folder)
{
    std::ofstream trace(folder + "/billiard.ndjson");
    const double ratio = 100.0;
    Film film{billiard_room(ratio)};
    const long most = whole_steps_below_pi(billiard_angle(ratio));
    trace
        << R"({"view": [-0.4, -0.75, 4.0, 1.15], "shapes": [{"radius": 0.25}, {"radius": 0.5}, )"
        << R"({"rings": [[[-0.4, -0.75], [0, -0.75], [0, 0.75], [-0.4, 0.75]]]})";
    for (long k = 0; k < most; ++k) trace << R"(, {"radius": 0.05})";
    trace << R"(], "fixed": [false, false, true]})"
          << "\n";
    const auto frame = [&](double time) {
        // Beads in tens; those not yet counted wait outside the picture
        const BilliardPlaces exact = billiard_places(ratio, time);
        trace << "{\"time\": " << time << ", \"bodies\": [[" << film.room.discs[0].x
              << ", 0, 0], [" << film.room.discs[1].x << ", 0, 0], [0, 0, 0]";
        for (long k = 0; k < most; ++k) {
            const double x =
                0.15 + 0.115 * static_cast<double>(k) + 0.08 * static_cast<double>(k / 10);
            trace << ", [" << x << ", " << (k < film.impacts ? 0.95 : 2.0) << ", 0]";
        }
        trace << "], \"ghosts\": [[" << exact.light << ", 0, 0], [" << exact.heavy
              << ", 0, 0]]}\n";
    };
    trace.precision(7);
    for (int k = 0; k <= 180; ++k) {
        const double time = k / 60.0;
        while (film.advance(time)) frame(film.time);
        frame(time);
    }
}

} // namespace

int main(int argc, char** argv)
{
    if (argc != 2) return 2;
    const std::string folder = argv[1];
    draw_billiard(folder);
    draw_passage(folder);
    draw_shot(folder);
    draw_room(folder);
    draw_clocks(folder);
    draw_circle(folder);
    draw_hops(folder);
    draw_cancel(folder);
    record_discs(folder);
    record_billiard(folder);
}
