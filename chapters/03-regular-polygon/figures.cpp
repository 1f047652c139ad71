#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <initializer_list>
#include <numbers>
#include <string>
#include <vector>

#include "../02-rectangle/door.hpp"
#include "../support/sketch.hpp"
#include "beside_disc.hpp"
#include "by_side.hpp"
#include "math/sine_cosine.hpp"

using namespace flying;
using namespace flying::sketch;

namespace {

constexpr double k_pi = std::numbers::pi;

/// A point at an angle, y down as on the page.
Vec2 around(const Vec2& centre, double radius, double angle)
{
    const SineCosine sc = sine_cosine(angle);
    return centre + radius * Vec2(sc.cosine, -sc.sine);
}

/// Vertices of a regular polygon that stands on a side.
std::vector<Vec2> regular(const Vec2& centre, double radius, int n)
{
    std::vector<Vec2> points;
    for (int k = 0; k < n; ++k) points.push_back(around(centre, radius, -0.5 * k_pi + (2 * k + 1) * k_pi / n));
    return points;
}

/// Radius of the polygon that has the area of the unit disc.
double radius_of_unit_area(int n)
{
    return std::sqrt(k_pi / regular_polygon_mass(n, 1.0, 1.0).mass);
}

/// Polygons of one area in a row, and by how much each is harder to turn than the disc at their end.
void draw_row(const std::string& folder)
{
    Sketch s(folder + "/row.svg", 600, 190);
    const std::vector<Tone> tones{k_rust, k_ochre, k_teal, k_blue};
    double x = 64.0;
    int k = 0;
    for (const int n : {3, 4, 5, 6, 8}) {
        const Vec2 c(x, 84.0);
        const Tone tone = tones[k++ % 4];
        s.polygon(regular(c, 41.0 * radius_of_unit_area(n), n), pale(tone, 0.45), tone, 2.0);
        s.words(Vec2(x, 164.0), text_of("+%.2g %%", 100.0 * (beside_disc_of_same_area(n) - 1.0)), Anchor::middle, k_ink,
                19.0);
        x += n == 3 ? 104.0 : 94.0;
    }
    s.disc(Vec2(x, 84.0), 41.0, pale(k_soft, 0.45), k_soft, 2.0);
    s.words(Vec2(x, 164.0), "0", Anchor::middle, k_ink, 19.0);
}

/// A pentagon, cut into five triangles.
void draw_cut(const std::string& folder)
{
    Sketch s(folder + "/cut.svg", 520, 320);
    const Vec2 c(250, 168);
    const double R = 138.0;
    const std::vector<Vec2> p = regular(c, R, 5);
    s.polygon(p, pale(k_blue, 0.16), k_blue, 2.0);
    s.polygon({c, p[4], p[0]}, pale(k_rust, 0.4), k_rust, 2.0);
    for (const Vec2& vertex : p) s.line(c, vertex, k_blue, 1.3);
    const Vec2 foot = 0.5 * (p[4] + p[0]);
    s.dashed(c, foot, k_ink);
    s.arc(c, 34.0, -0.5 * k_pi - k_pi / 5, -0.5 * k_pi + k_pi / 5, k_ink);
    s.formula(c + Vec2(12, 58), "θ", Anchor::left);
    s.formula(foot + Vec2(-16, -14), "h");
    s.formula(foot + Vec2(0, 26), "l");
    s.formula(0.5 * (c + p[1]) + Vec2(8, -12), "R");
    s.disc(c, 4.5, {0xffffff, 1.0}, k_ink, 2.0);
}

/// One of the triangles, lying on the axis, and a strip of it.
void draw_triangle(const std::string& folder)
{
    Sketch s(folder + "/triangle.svg", 540, 300);
    const Vec2 o(70, 150);
    const double h = 350.0;
    const double half = 112.0;
    const auto at = [&](double x, double y) { return Vec2(o.x() + x, o.y() - y); };
    s.polygon({o, at(h, half), at(h, -half)}, pale(k_blue, 0.16), k_blue, 2.0);
    const double x = 0.62 * h;
    const double top = half * x / h;
    s.polygon({at(x, top), at(x + 16, half * (x + 16) / h), at(x + 16, -half * (x + 16) / h), at(x, -top)},
              pale(k_rust, 0.6), k_rust, 1.4);
    s.arrow(Vec2(24, o.y()), Vec2(510, o.y()), k_soft, 1.5);
    s.arrow(Vec2(o.x(), 280), Vec2(o.x(), 20), k_soft, 1.5);
    s.formula(Vec2(506, o.y() + 24), "x");
    s.formula(Vec2(o.x() - 16, 32), "y");
    const double tilt = std::atan(half / h);
    s.arc(o, 78.0, 0.0, tilt, k_ink);
    s.formula(at(96, 11), "θ/2", Anchor::left);
    s.formula(at(x - 6, top + 12), "l x / 2h", Anchor::right, k_rust);
    s.formula(at(x + 8, -top - 26), "dx", Anchor::middle, k_rust);
    s.formula(at(h + 10, half - 4), "l/2", Anchor::left);
    s.formula(at(h + 10, -half + 2), "−l/2", Anchor::left);
    s.formula(at(h + 8, -22), "h", Anchor::left);
}

/// A hexagon, the circle through its vertices, and the circle of its area.
void draw_circles(const std::string& folder)
{
    Sketch s(folder + "/circles.svg", 560, 300);
    const double R = 112.0;
    const Vec2 a(140, 138);
    s.disc(a, R, pale(k_rust, 0.35), k_rust, 2.0);
    s.polygon(regular(a, R, 6), {0xfdfcf9, 1.0}, k_none);
    s.polygon(regular(a, R, 6), pale(k_blue, 0.2), k_blue, 2.0);
    s.words(a + Vec2(0, 150), "same radius");
    const Vec2 b(410, 138);
    const double r = R / radius_of_unit_area(6);
    s.disc(b, r, pale(k_rust, 0.6), k_none);
    s.polygon(regular(b, R, 6), pale(k_blue, 0.7), k_blue, 2.0);

    // What both hold, in the tone of the hexagon beside
    std::vector<Vec2> both;
    for (int k = 0; k < 360; ++k) {
        const double angle = k_pi * k / 180.0;
        const double from_side = std::abs(std::fmod(angle + k_pi / 6.0, k_pi / 3.0) - k_pi / 6.0);
        const double to_edge = R * std::cos(k_pi / 6.0) / std::cos(k_pi / 6.0 - from_side);
        both.push_back(around(b, std::min(r, to_edge), angle));
    }
    s.polygon(both, {0xfdfcf9, 1.0}, k_none);
    s.polygon(both, pale(k_blue, 0.2), k_none);
    s.disc(b, r, k_none, k_rust, 2.0);
    s.words(b + Vec2(0, 150), "same area");
}

/// Both gaps over the number of sides.
void draw_rates(const std::string& folder)
{
    Sketch s(folder + "/rates.svg", 560, 370);
    const LogPlot plot(s, Vec2(80, 312), Vec2(536, 20), Vec2(0, -12), Vec2(3, 0));
    plot.axes(1, 2);
    plot.curve(
        3.0, 1000.0, [](double n) { return 4 * k_pi * k_pi / (3 * n * n); }, pale(k_rust, 0.55));
    plot.curve(
        3.0, 1000.0, [](double n) { return 4 * std::pow(k_pi / n, 4) / 45; }, pale(k_teal, 0.55));
    for (const int n : {3, 4, 5, 6, 8, 12, 18, 30, 60, 100, 200, 400, 1000}) {
        plot.dot(n, 1.0 - beside_disc_of_same_radius(n), k_rust);
        plot.dot(n, beside_disc_of_same_area(n) - 1.0, k_teal);
    }
    s.words(Vec2(308, 358), "sides");
    s.words(plot.at(60, 6e-3) + Vec2(14, -8), "same radius", Anchor::left, k_rust);
    s.words(plot.at(22, 1e-7) + Vec2(-8, 10), "same area", Anchor::right, k_teal);
}

/// Error of the mass by the law of cosines.
void draw_cosine(const std::string& folder)
{
    Sketch s(folder + "/cosine.svg", 560, 360);
    const LogPlot plot(s, Vec2(80, 302), Vec2(536, 20), Vec2(0, -17), Vec2(9, 0));
    plot.axes(1, 4);
    const auto error = [](int n, double mass) {
        const double right = regular_polygon_mass(n, 1.0, 1.0).mass;
        return std::abs(mass / right - 1.0);
    };
    for (double count = 3.0; count < 4e8; count *= 1.13) {
        const int n = static_cast<int>(count);
        const double wrong = error(n, wrong_polygon_mass(n, 1.0, 1.0).mass);
        const double plain = error(n, polygon_by_cotangent(n, 1.0, 1.0).mass);
        // What has no error at all lies on the axis
        s.disc(plot.at(n, std::max(plain, 1e-17)), 3.0, k_teal, k_none);
        s.disc(plot.at(n, std::max(wrong, 1e-17)), 3.4, k_rust, k_none);
    }
    s.words(Vec2(308, 348), "sides");
    s.words(plot.at(3e4, 3e-5), "law of cosines", Anchor::right, k_rust);
    s.words(plot.at(1e7, 2e-14), "sine", Anchor::middle, k_teal);
}

/// Bodies of one mass, pushed round by the same torque.
void record_race(const std::string& folder)
{
    std::ofstream trace(folder + "/race.ndjson");
    const std::vector<int> sides{3, 4, 6};
    std::string shapes;
    for (const int n : sides) {
        std::string ring;
        for (const Vec2& p : regular(Vec2::Zero(), radius_of_unit_area(n), n))
            ring += "[" + std::to_string(p.x()) + ", " + std::to_string(-p.y()) + "], ";
        ring.resize(ring.size() - 2);
        shapes += "{\"rings\": [[" + ring + "]]}, ";
    }
    shapes += "{\"radius\": 1}";
    for (int k = 0; k < 4; ++k) shapes += ", {\"radius\": 0.13}";
    trace << "{\"view\": [-1.8, -1.9, 9.8, 1.9], \"shapes\": [" << shapes << "]}\n";
    const double of_disc = disc_mass(1.0, 1.0).moment_of_inertia;
    for (int k = 0; k <= 300; ++k) {
        const double time = k / 60.0;
        std::string bodies;
        std::string marks;
        for (int which = 0; which < 4; ++which) {
            const double share = which < 3 ? beside_disc_of_same_area(sides[which]) : 1.0;
            const double angle = angle_turned(share * of_disc, 4.0, time);
            const double x = 2.7 * which;
            const SineCosine sc = sine_cosine(angle + 0.5 * k_pi);
            const std::string turn = std::to_string(angle);
            bodies += "[" + std::to_string(x) + ", 0, " + turn + "], ";
            marks += "[" + std::to_string(x + 0.5 * sc.cosine) + ", " + std::to_string(0.5 * sc.sine) + ", 0], ";
        }
        marks.resize(marks.size() - 2);
        trace << "{\"time\": " << time << ", \"bodies\": [" << bodies << marks << "]}\n";
    }
}

} // namespace

int main(int argc, char** argv)
{
    if (argc != 2) return 2;
    const std::string folder = argv[1];
    draw_row(folder);
    draw_cut(folder);
    draw_triangle(folder);
    draw_circles(folder);
    draw_rates(folder);
    draw_cosine(folder);
    record_race(folder);
}
