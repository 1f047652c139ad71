#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <string>
#include <vector>

#include "../support/sketch.hpp"
#include "math/sine_cosine.hpp"
#include "strikes.hpp"

using namespace flying;
using namespace flying::sketch;

namespace {

/// A turned rectangle; the picture's y is down, so that the angle is turned over.
std::vector<Vec2> turned_box(const Vec2& centre, double width, double height, double angle)
{
    const SineCosine at = sine_cosine(-angle);
    const Vec2 x = 0.5 * width * Vec2(at.cosine, at.sine);
    const Vec2 y = 0.5 * height * Vec2(-at.sine, at.cosine);
    return {centre - x - y, centre + x - y, centre + x + y, centre - x + y};
}

/// Five balls after an impact, with the velocities that two laws give them.
void draw_row(const std::string& folder)
{
    Sketch s(folder + "/row.svg", 560, 330);
    const Row start{1.0, 0.0, 0.0, 0.0, 0.0};
    const auto row = [&](double y, const char* words, const Row& v, Tone tone) {
        s.words(Vec2(18, y - 42), words, Anchor::left, k_soft, 16.0);
        for (int k = 0; k < 5; ++k) {
            const Vec2 c(140.0 + 64.0 * k, y);
            s.disc(c, 31.0, pale(tone, 0.25), tone, 2.0);
            const double length = 80.0 * v[k];
            if (std::abs(length) > 8.0) s.arrow(c, c + Vec2(length, 0.0), k_ink, 2.6);
        }
    };
    row(64, "before", start, k_blue);
    row(174, "after, each pair in turn", struck_in_turn(start, 1.0), k_teal);
    row(284, "after, all pairs at once", struck_at_once(start, 1.0), k_rust);
}

/// Two bodies that touch, with the names of the parts.
void draw_point(const std::string& folder)
{
    Sketch s(folder + "/point.svg", 540, 330);
    const Vec2 p(262, 186);
    const Vec2 a(150, 220);
    const Vec2 b(400, 112);
    s.polygon({Vec2(50, 150), Vec2(262, 90), Vec2(262, 290), Vec2(80, 300)}, pale(k_blue, 0.18), k_blue, 2.0);
    s.polygon({p, Vec2(430, 30), Vec2(500, 140), Vec2(370, 210)}, pale(k_teal, 0.2), k_teal, 2.0);
    s.arrow(a, p, k_blue, 2.2);
    s.arrow(b, p, k_teal, 2.2);
    s.dashed(a, Vec2(p.x(), a.y()), k_soft);
    s.arrow(p, p + Vec2(84, 0), k_rust, 2.8);
    s.arrow(p, p + Vec2(0, -84), k_rust, 2.8);
    s.disc(a, 6.0, {0xffffff, 1.0}, k_ink, 2.0);
    s.disc(b, 6.0, {0xffffff, 1.0}, k_ink, 2.0);
    s.disc(p, 4.5, k_ink, k_none);
    s.formula(p + Vec2(76, -12), "n", Anchor::middle, k_rust);
    s.formula(p + Vec2(-16, -76), "t", Anchor::middle, k_rust);
    s.formula(Vec2(190, 188), "r_a", Anchor::middle, k_blue);
    s.formula(Vec2(386, 148), "r_b", Anchor::middle, k_teal);
    s.measure(Vec2(p.x() + 18, a.y()), Vec2(p.x() + 18, p.y() + 2));
    s.formula(Vec2(p.x() + 40, 216), "c_a", Anchor::middle, k_ink);
    s.formula(Vec2(96, 280), "A", Anchor::left);
    s.formula(Vec2(470, 128), "B");
}

/// Two pushes, hard and short, soft and long, of one area.
void draw_push(const std::string& folder)
{
    Sketch s(folder + "/push.svg", 540, 280);
    const Vec2 origin(60, 240);
    s.arrow(origin, Vec2(520, 240), k_soft, 1.6);
    s.arrow(origin, Vec2(60, 18), k_soft, 1.6);
    s.formula(Vec2(510, 266), "t", Anchor::middle, k_soft);
    s.formula(Vec2(38, 32), "F", Anchor::middle, k_soft);
    const auto pulse = [&](double from, double duration, Tone tone) {
        std::vector<Vec2> points;
        for (int k = 0; k <= 80; ++k) {
            const double share = k / 80.0;
            points.emplace_back(from + share * duration,
                                240.0 - 11000.0 / duration * sine_cosine(share * 3.14159265).sine);
        }
        s.polygon(points, pale(tone, 0.3), tone, 2.4);
    };
    pulse(90, 58, k_rust);
    pulse(190, 290, k_teal);
    s.formula(Vec2(119, 190), "j", Anchor::middle, k_rust, 22.0);
    s.formula(Vec2(335, 226), "j", Anchor::middle, k_teal, 22.0);
    s.words(Vec2(150, 70), "steel on steel", Anchor::left, k_rust);
    s.words(Vec2(335, 186), "a tennis ball", Anchor::middle, k_teal);
}

/// Energy over the impulse: a parabola whose lowest point ends the approach.
void draw_valley(const std::string& folder)
{
    Sketch s(folder + "/valley.svg", 540, 340);
    const auto at = [](double j, double energy) { return Vec2(70.0 + 190.0 * j, 90.0 - 400.0 * energy); };
    const auto valley = [](double j) { return -j + 0.5 * j * j; };
    s.arrow(at(0.0, 0.0), at(2.4, 0.0), k_soft, 1.6);
    s.arrow(at(0.0, -0.58), at(0.0, 0.18), k_soft, 1.6);
    std::vector<Vec2> curve;
    for (int k = 0; k <= 100; ++k) curve.push_back(at(0.0216 * k, valley(0.0216 * k)));
    s.path(curve, k_blue, 2.8);
    s.words(at(0.06, 0.12), "energy won", Anchor::left, k_soft);
    s.formula(at(2.36, -0.06), "j", Anchor::middle, k_soft);
    const auto mark = [&](double e, const char* words, Anchor side, const Vec2& off) {
        const Vec2 p = at(1.0 + e, valley(1.0 + e));
        s.dashed(at(1.0 + e, 0.0), p, k_soft);
        s.disc(p, 5.5, k_rust, k_none);
        s.formula(p + off, words, side, k_rust);
    };
    mark(0.0, "e = 0", Anchor::middle, Vec2(0, 28));
    mark(0.5, "e = 1/2", Anchor::left, Vec2(12, 14));
    mark(1.0, "e = 1", Anchor::right, Vec2(-14, -12));
    s.disc(at(0.0, 0.0), 5.5, k_ink, k_none);
    s.words(at(0.42, -0.14), "compression", Anchor::left, k_blue);
    s.words(at(1.25, -0.14), "restitution", Anchor::middle, k_blue);
}

/// The cone of Coulomb and what a disc on the floor asks of it.
void draw_cone(const std::string& folder)
{
    Sketch s(folder + "/cone.svg", 540, 320);
    const Vec2 o(270, 280);
    const auto at = [&](double q, double j) { return Vec2(o.x() + 110.0 * q, o.y() - 110.0 * j); };
    s.polygon({o, at(-1.15, 2.3), at(1.15, 2.3)}, pale(k_teal, 0.18), k_none);
    s.line(o, at(-1.15, 2.3), k_teal, 2.2);
    s.line(o, at(1.15, 2.3), k_teal, 2.2);
    s.arrow(at(-2.2, 0.0), at(2.2, 0.0), k_soft, 1.6);
    s.arrow(o, at(0.0, 2.45), k_soft, 1.6);
    s.dashed(at(-2.2, 2.0), at(2.2, 2.0), k_soft);
    s.formula(at(2.15, -0.22), "q", Anchor::middle, k_soft);
    s.formula(at(0.12, 2.38), "j", Anchor::left, k_soft);
    for (const double slip : {1.0, 2.0, 3.0, 4.0, 6.0}) {
        const ImpactResult after = strike_floor(slip, {1.0, 0.5});
        const Vec2 p = at(after.velocity_b.x() - slip, after.velocity_b.y() + 1.0);
        const bool sticks = slip <= 3.0;
        if (!sticks) {
            const Vec2 asked = at(-slip / 3.0, 2.0);
            s.disc(asked, 6.0, k_none, k_rust, 2.0);
            continue;
        }
        s.disc(p, 6.0, k_rust, k_none);
    }
    s.words(at(0.0, 1.4) + Vec2(10, 0), "stick", Anchor::left, k_teal);
    s.words(at(-1.5, 0.8), "slip", Anchor::middle, k_ink);
    s.words(at(1.5, 0.8), "slip", Anchor::middle, k_ink);
    s.formula(at(1.2, 2.3) + Vec2(6, 0), "q = μ j", Anchor::left, k_teal);
}

/// Normal speed over the normal impulse, where slip ends during compression.
void draw_course(const std::string& folder)
{
    Sketch s(folder + "/course.svg", 540, 330);
    const auto at = [](double j, double v) { return Vec2(60.0 + 170.0 * j, 182.0 - 118.0 * v); };
    const double j_s = 0.7;
    const double v_s = -0.65;
    const double k_then = 1.0;
    const double j_c = j_s - v_s / k_then;
    const double e = 0.6;
    const double out = e * std::sqrt(v_s * v_s - k_then * j_s * (-1.0 + v_s));
    const double j_f = j_c + out / k_then;
    s.polygon({at(0, 0), at(0, -1), at(j_s, v_s), at(j_c, 0)}, pale(k_blue, 0.22), k_none);
    s.polygon({at(j_c, 0), at(j_f, out), at(j_f, 0)}, pale(k_rust, 0.3), k_none);
    s.arrow(at(0, 0), at(2.72, 0), k_soft, 1.6);
    s.arrow(at(0, -1.12), at(0, 1.25), k_soft, 1.6);
    s.path({at(0, -1) + Vec2(0, 0), at(j_s, v_s), at(j_f, out)}, k_ink, 2.6);
    s.dashed(at(j_s, 0), at(j_s, v_s), k_soft);
    s.disc(at(j_s, v_s), 5.0, k_ink, k_none);
    s.disc(at(j_f, out), 5.0, k_ink, k_none);
    s.formula(at(j_s, 0) + Vec2(0, -10), "j_s");
    s.formula(at(j_s, v_s) + Vec2(12, 20), "v_s", Anchor::left);
    s.formula(at(0, -1) + Vec2(-22, 6), "v_n");
    s.formula(at(2.7, 0) + Vec2(0, 26), "j", Anchor::middle, k_soft);
    s.formula(at(0.45, -0.38), "W", Anchor::middle, k_blue, 22.0);
    s.formula(at(j_f, 0.16) + Vec2(-34, 4), "e^2 W", Anchor::middle, k_rust);
    s.words(at(0.34, -1.0) + Vec2(8, 4), "slip", Anchor::left, k_soft);
    s.words(at(1.06, -0.42) + Vec2(22, 0), "stick", Anchor::left, k_soft);
}

/// A disc's slip before and after, at three frictions.
void draw_slip(const std::string& folder)
{
    Sketch s(folder + "/slip.svg", 540, 320);
    const auto at = [](double x, double y) { return Vec2(64.0 + 48.0 * x, 262.0 - 38.0 * y); };
    s.arrow(at(0, 0), at(8.2, 0), k_soft, 1.6);
    s.arrow(at(0, 0), at(0, 6.3), k_soft, 1.6);
    for (int k = 2; k <= 8; k += 2) s.words(at(k, 0) + Vec2(0, 22), std::to_string(k), Anchor::middle, k_ink, 15.0);
    for (int k = 2; k <= 6; k += 2) s.words(at(0, k) + Vec2(-10, 5), std::to_string(k), Anchor::right, k_ink, 15.0);
    const Tone tones[] = {k_teal, k_blue, k_rust};
    int which = 0;
    for (const double mu : {0.25, 0.5, 1.0}) {
        std::vector<Vec2> points;
        for (int k = 0; k <= 75; ++k) {
            const double slip = 0.1 * k;
            const ImpactResult after = strike_floor(slip, {1.0, mu});
            points.push_back(at(slip, after.velocity_b.x() + after.spin_b));
        }
        s.path(points, tones[which], 2.8);
        s.formula(points.back() + Vec2(8, 6), "μ = " + text_of("%.2g", mu), Anchor::left, tones[which], 18.0);
        ++which;
    }
    s.words(at(4.2, 0) + Vec2(0, 46), "slip before, m/s");
    s.words(at(0.2, 6.1), "slip after, m/s", Anchor::left);
}

/// A ball strikes a rod at its end: where both are, ten times a second.
void draw_strike(const std::string& folder)
{
    Sketch s(folder + "/strike.svg", 480, 320);
    const double scale = 170.0;
    const Vec2 middle(210, 218);
    const ImpactResult after = strike_rod(1.0, 0.5, 1.0);
    for (int k = -3; k <= 9; k += 3) {
        const double time = 0.1 * k;
        const double ball = (k < 0 ? 1.0 : after.velocity_a.y()) * time - 0.12;
        const double rod = k < 0 ? 0.0 : after.velocity_b.y() * time;
        const double angle = k < 0 ? 0.0 : after.spin_b * time;
        const double cover = k < 0 ? 0.12 : 0.12 + 0.035 * k;
        s.disc(middle + scale * Vec2(0.5, -ball), 0.1 * scale, pale(k_rust, cover), k_rust, 1.6);
        if (k >= 0)
            s.polygon(turned_box(middle + scale * Vec2(0.0, -rod), scale, 0.04 * scale, angle), pale(k_blue, cover),
                      k_blue, 1.6);
        if (k >= 0) s.disc(middle + scale * Vec2(0.0, -rod), 3.5, k_ink, k_none);
    }
    s.arrow(middle + Vec2(0.5 * scale + 34, 60), middle + Vec2(0.5 * scale + 34, 0), k_ink, 2.4);
    s.words(middle + Vec2(0.5 * scale + 48, 38), "1 m/s", Anchor::left);
    s.words(middle + Vec2(0.5 * scale + 48, -98), text_of("%.1f m/s", after.velocity_a.y()), Anchor::left, k_rust);
    s.words(middle + Vec2(-102, -56), text_of("%.1f m/s", after.velocity_b.y()), Anchor::right, k_blue);
}

/// The same, as motion.
void record_strike(const std::string& folder)
{
    std::ofstream trace(folder + "/strike.ndjson");
    trace << "{\"view\": [-0.8, -0.75, 1.0, 0.95], \"shapes\": [{\"radius\": 0.1}, "
          << "{\"rings\": [[[-0.5, -0.02], [0.5, -0.02], [0.5, 0.02], [-0.5, 0.02]]]}]}\n";
    const ImpactResult after = strike_rod(1.0, 0.5, 1.0);
    for (int k = -36; k <= 84; ++k) {
        const double time = k / 60.0;
        const double ball = (k < 0 ? 1.0 : after.velocity_a.y()) * time - 0.12;
        const double rod = k < 0 ? 0.0 : after.velocity_b.y() * time;
        const double angle = k < 0 ? 0.0 : after.spin_b * time;
        trace << "{\"time\": " << time + 0.6 << ", \"bodies\": [[0.5, " << ball << ", 0], [0, " << rod << ", " << angle
              << "]]}\n";
    }
}

} // namespace

int main(int argc, char** argv)
{
    if (argc != 2) return 2;
    const std::string folder = argv[1];
    draw_row(folder);
    draw_point(folder);
    draw_push(folder);
    draw_valley(folder);
    draw_cone(folder);
    draw_course(folder);
    draw_slip(folder);
    draw_strike(folder);
    record_strike(folder);
}
