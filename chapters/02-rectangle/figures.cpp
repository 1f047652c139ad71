#include <cmath>
#include <cstdio>
#include <fstream>
#include <initializer_list>
#include <numbers>
#include <string>

#include "../support/sketch.hpp"
#include "door.hpp"
#include "rectangle.hpp"
#include "math/sine_cosine.hpp"
#include "pieces.hpp"
#include "wrong_triangle.hpp"

using namespace flying;
using namespace flying::sketch;

namespace {

/// The door from above: three pushes, and the mass that each finger feels.
void draw_door(const std::string& folder)
{
    Sketch s(folder + "/door.svg", 560, 250);
    const double hinge_x = 70.0;
    const double width = 420.0;
    const double y = 92.0;
    const MassProperties door = rectangle_mass(1.0, 0.04, 500.0);
    const double hinged = about_parallel_axis(door, 0.5);

    s.polygon({Vec2(20, y - 26), Vec2(hinge_x - 8, y - 26), Vec2(hinge_x - 8, y + 26), Vec2(20, y + 26)},
              pale(k_soft, 0.5), k_soft);
    s.polygon(box(Vec2(hinge_x + 0.5 * width, y), width, 17.0), pale(k_ochre, 0.55), k_ink);
    s.disc(Vec2(hinge_x, y), 7.5, {0xffffff, 1.0}, k_ink, 2.4);
    s.words(Vec2(hinge_x + 4, 52), "hinge");
    s.words(Vec2(hinge_x + width, 52), "handle", Anchor::right);
    for (const double d : {0.25, 0.5, 1.0}) {
        const double x = hinge_x + d * width - (d == 1.0 ? 9.0 : 0.0);
        s.arrow(Vec2(x, y + 78), Vec2(x, y + 13), k_rust, 3.0);
        s.words(Vec2(x, y + 102), text_of("%.3g kg", mass_felt(hinged, d)), Anchor::middle, k_rust, 20.0);
        s.formula(Vec2(x, y + 130), text_of(d == 1.0 ? "w" : d == 0.5 ? "w/2" : "w/4", d), Anchor::middle, k_soft);
    }
}

/// Two rods with a mass at either end, one twice as long.
void draw_points(const std::string& folder)
{
    Sketch s(folder + "/points.svg", 560, 210);
    const double y = 92.0;
    const auto rod = [&](double x, double r, Tone tone, const char* inertia, const char* name) {
        s.line(Vec2(x - r, y), Vec2(x + r, y), k_ink, 3.0);
        for (const double side : {-1.0, 1.0}) {
            s.disc(Vec2(x + side * r, y), 15.0, tone, k_ink);
            s.arrow(Vec2(x + side * r, y - side * 18), Vec2(x + side * r, y - side * (18 + 0.5 * r)), k_rust, 2.2);
        }
        s.disc(Vec2(x, y), 5.0, {0xffffff, 1.0}, k_ink, 2.2);
        s.formula(Vec2(x, y - 13), name);
        s.formula(Vec2(x, 192), inertia, Anchor::middle, k_ink, 20.0);
    };
    rod(110.0, 62.0, {0x6fa3a6, 1.0}, "I = 2 m r^2", "r");
    rod(385.0, 124.0, {0x6fa3a6, 1.0}, "I = 8 m r^2", "2r");
}

/// The rectangle, its axes, and a piece of it.
void draw_slice(const std::string& folder)
{
    Sketch s(folder + "/slice.svg", 520, 330);
    const Vec2 c(250, 165);
    const double w = 340.0;
    const double h = 200.0;
    s.polygon(box(c, w, h), pale(k_blue, 0.16), k_blue, 2.0);
    s.arrow(Vec2(40, c.y()), Vec2(490, c.y()), k_soft, 1.5);
    s.arrow(Vec2(c.x(), 318), Vec2(c.x(), 14), k_soft, 1.5);
    s.formula(Vec2(492, c.y() + 24), "x");
    s.formula(Vec2(c.x() - 16, 28), "y");
    const Vec2 p = c + Vec2(104, -58);
    s.polygon(box(p, 26, 20), pale(k_rust, 0.75), k_rust);
    s.arrow(c, p + Vec2(-13, 8), k_rust, 2.4);
    s.dashed(p + Vec2(0, 10), Vec2(p.x(), c.y()), k_soft);
    s.dashed(p + Vec2(-13, 0), Vec2(c.x(), p.y()), k_soft);
    s.formula(c + Vec2(40, -34), "r", Anchor::middle, k_rust);
    s.formula(p + Vec2(0, -16), "dx dy", Anchor::middle, k_rust);
    s.formula(Vec2(p.x(), c.y() + 22), "x");
    s.formula(Vec2(c.x() - 14, p.y() + 6), "y");
    s.formula(Vec2(c.x() + 0.5 * w + 8, c.y() + 24), "w/2", Anchor::left);
    s.formula(Vec2(c.x() - 0.5 * w - 8, c.y() + 24), "−w/2", Anchor::right);
    s.formula(Vec2(c.x() + 10, c.y() - 0.5 * h - 8), "h/2", Anchor::left);
    s.formula(Vec2(c.x() + 10, c.y() + 0.5 * h + 24), "−h/2", Anchor::left);
}

/// A square as one point, four, nine, sixteen, and what each finds of its moment of inertia.
void draw_pieces(const std::string& folder)
{
    Sketch s(folder + "/pieces.svg", 580, 190);
    const MassProperties square = rectangle_mass(1.0, 1.0, 1.0);
    for (int n = 1; n <= 4; ++n) {
        const Vec2 c(80.0 + 140.0 * (n - 1), 74.0);
        const double side = 112.0;
        s.polygon(box(c, side, side), pale(k_blue, 0.16), k_blue, 1.8);
        for (int k = 1; k < n; ++k) {
            const double at = side * k / n - 0.5 * side;
            s.line(c + Vec2(at, -0.5 * side), c + Vec2(at, 0.5 * side), pale(k_blue, 0.6), 1.0);
            s.line(c + Vec2(-0.5 * side, at), c + Vec2(0.5 * side, at), pale(k_blue, 0.6), 1.0);
        }
        for (int i = 0; i < n; ++i)
            for (int j = 0; j < n; ++j)
                s.disc(c + Vec2((2 * i - n + 1) * side / (2 * n), (2 * j - n + 1) * side / (2 * n)),
                       12.0 / std::sqrt(n), k_rust, k_none);
        const double share = inertia_by_pieces(1.0, 1.0, 1.0, n) / square.moment_of_inertia;
        s.words(c + Vec2(0, 86), text_of("%.1f %%", 100.0 * share), Anchor::middle, k_ink, 20.0);
    }
}

/// A plate, the axis through its centre of mass and another beside it.
void draw_axes(const std::string& folder)
{
    Sketch s(folder + "/axes.svg", 520, 262);
    const Vec2 c(330, 118);
    const Vec2 a(120, 118);
    s.polygon(box(c, 300, 170), pale(k_blue, 0.16), k_blue, 2.0);
    const Vec2 p = c + Vec2(84, -52);
    s.arrow(c, p, k_teal, 2.2);
    s.arrow(a, p, k_rust, 2.2);
    s.polygon(box(p, 15, 15), pale(k_ink, 0.7), k_ink);
    for (const Vec2& axis : {a, c}) {
        s.disc(axis, 7.0, {0xffffff, 1.0}, k_ink, 2.2);
        s.disc(axis, 2.2, k_ink, k_none);
    }
    s.formula(c + Vec2(6, 28), "C");
    s.formula(a + Vec2(-2, 28), "A");
    s.formula(c + Vec2(52, -10), "(x, y)", Anchor::left, k_teal);
    s.formula(a + Vec2(130, -42), "(x + d, y)", Anchor::middle, k_rust);
    s.measure(Vec2(a.x(), 242), Vec2(c.x(), 242));
    s.dashed(a + Vec2(0, 36), Vec2(a.x(), 236));
    s.dashed(c + Vec2(0, 36), Vec2(c.x(), 236));
    s.formula(Vec2(0.5 * (a.x() + c.x()), 233), "d");
}

/// A disc as rings, and a ring with a hole.
void draw_rings(const std::string& folder)
{
    Sketch s(folder + "/rings.svg", 540, 262);
    const Vec2 c(135, 122);
    for (int k = 6; k >= 1; --k) s.disc(c, 17.0 * k, pale(k_blue, k == 5 ? 0.0 : 0.10), pale(k_blue, 0.6), 1.0);
    s.ring(c, 68.0, 85.0, pale(k_rust, 0.6), k_rust, 1.4);
    s.arrow(c, c + 76.0 * Vec2(0.8, -0.6), k_ink, 1.8);
    s.formula(c + Vec2(20, -30), "r");
    s.formula(c + Vec2(112, -48), "dr", Anchor::left, k_rust);
    s.line(c + Vec2(106, -52), c + Vec2(74, -40), k_rust, 1.2);
    s.formula(c + Vec2(0, 124), "2π r dr", Anchor::middle, k_rust);
    const Vec2 e(400, 122);
    s.ring(e, 52.0, 102.0, pale(k_teal, 0.4), k_teal, 2.0);
    s.arrow(e, e + 52.0 * Vec2(-0.7071, 0.7071), k_ink, 1.8);
    s.arrow(e, e + 102.0 * Vec2(0.8, -0.6), k_ink, 1.8);
    s.formula(e + Vec2(-13, 36), "a");
    s.formula(e + Vec2(56, -52), "R", Anchor::right);
}

/// A square is two triangles, and their centres of mass lie beside its own.
void draw_half(const std::string& folder)
{
    Sketch s(folder + "/half.svg", 480, 260);
    const double side = 200.0;
    const Vec2 corner(140, 226);
    const Vec2 right = corner + Vec2(side, 0);
    const Vec2 top = corner + Vec2(0, -side);
    s.polygon({right, corner + Vec2(side, -side), top}, pale(k_soft, 0.16), pale(k_soft, 0.7), 1.4);
    s.polygon({corner, right, top}, pale(k_blue, 0.22), k_blue, 2.2);
    const Vec2 middle = corner + Vec2(0.5 * side, -0.5 * side);
    const Vec2 centroid = corner + Vec2(side / 3.0, -side / 3.0);
    s.line(middle, centroid, k_rust, 2.2);
    s.disc(middle, 6.0, {0xffffff, 1.0}, k_ink, 2.2);
    s.disc(centroid, 6.0, k_rust, k_ink, 1.6);
    s.formula(middle + Vec2(14, -4), "M", Anchor::left);
    s.formula(centroid + Vec2(-16, 20), "C");
    s.formula(0.5 * (middle + centroid) + Vec2(-12, -6), "d", Anchor::middle, k_rust);
    s.formula(corner + Vec2(0.5 * side, 24), "L");
    s.formula(corner + Vec2(-16, -0.5 * side), "L");
}

/// Moments of inertia of the half square over its leg: the right ones, and those that grow too fast.
void draw_wrong(const std::string& folder)
{
    Sketch s(folder + "/wrong.svg", 560, 360);
    const LogPlot plot(s, Vec2(76, 306), Vec2(536, 24), Vec2(-2, -14), Vec2(2, 12));
    plot.axes(1, 4);
    plot.curve(
        0.01, 100.0, [](double leg) { return half_square_mass(leg, 1.0).moment_of_inertia; }, k_teal);
    plot.curve(
        0.01, 100.0, [](double leg) { return wrong_half_square_mass(leg, 1.0).moment_of_inertia; }, k_rust);
    plot.dot(2.0, half_square_mass(2.0, 1.0).moment_of_inertia, k_ink);
    s.words(Vec2(304, 350), "leg of the triangle, m");
    s.words(Vec2(92, 44), "moment of inertia at 1 kg/m², kg m²", Anchor::left, k_soft, 15.0);
    s.formula(plot.at(9.0, 4e5), "m L^4 / 36", Anchor::right, k_rust);
    s.formula(plot.at(9.0, 30.0) + Vec2(12, 8), "m L^2 / 9", Anchor::left, k_teal);
    s.words(plot.at(2.0, 0.5) + Vec2(16, 30), "one agreement", Anchor::left);
}

/// Three doors, the same push at three distances.
void record_doors(const std::string& folder)
{
    const MassProperties door = rectangle_mass(1.0, 0.06, 20.0 / 0.06);
    const double hinged = about_parallel_axis(door, 0.5);
    std::ofstream trace(folder + "/doors.ndjson");
    const std::string plan = "{\"rings\": [[[-0.5, -0.03], [0.5, -0.03], [0.5, 0.03], [-0.5, 0.03]]]}";
    const std::string knob = "{\"radius\": 0.045}";
    trace << "{\"view\": [-0.15, -0.2, 4.05, 1.2], \"shapes\": [" << plan << ", " << plan << ", " << plan << ", "
          << knob << ", " << knob << ", " << knob << "]}\n";
    for (int k = 0; k <= 132; ++k) {
        const double time = k / 60.0;
        std::string doors;
        std::string fingers;
        for (int which = 0; which < 3; ++which) {
            const double reach = which == 0 ? 0.25 : which == 1 ? 0.5 : 1.0;
            const double angle = angle_turned(hinged, 4.0 * reach, time);
            const SineCosine turned = sine_cosine(angle);
            const Vec2 hinge(1.4 * which, 0.0);
            const auto at = [&](double along, double across, double turn) {
                const Vec2 p =
                    hinge + along * Vec2(turned.cosine, turned.sine) + across * Vec2(-turned.sine, turned.cosine);
                return "[" + std::to_string(p.x()) + ", " + std::to_string(p.y()) + ", " + std::to_string(turn) + "], ";
            };
            doors += at(0.5, 0.0, angle);
            fingers += at(reach - (which == 2 ? 0.05 : 0.0), -0.08, 0.0);
        }
        fingers.resize(fingers.size() - 2);
        trace << "{\"time\": " << time << ", \"bodies\": [" << doors << fingers << "]}\n";
    }
}

} // namespace

int main(int argc, char** argv)
{
    if (argc != 2) return 2;
    const std::string folder = argv[1];
    draw_door(folder);
    draw_points(folder);
    draw_slice(folder);
    draw_pieces(folder);
    draw_axes(folder);
    draw_rings(folder);
    draw_half(folder);
    draw_wrong(folder);
    record_doors(folder);
}
