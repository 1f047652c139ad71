#include <algorithm>
#include <cmath>
#include <fstream>
#include <numbers>
#include <string>
#include <vector>

#include "../support/sketch.hpp"
#include "collide/touching.hpp"
#include "vertex_edge.hpp"
#include "geometry/convex_parts.hpp"
#include "math/orientation.hpp"
#include "scenes.hpp"
#include "turns.hpp"
#include "wrong_normal.hpp"

using namespace flying;
using namespace flying::corner;
using namespace flying::sketch;

namespace {

/// From metres, y up, to pixels.
struct View
{
    Vec2 origin;
    double scale;

    [[nodiscard]] Vec2 operator()(const Vec2& p) const { return origin + scale * Vec2(p.x(), -p.y()); }
    [[nodiscard]] std::vector<Vec2> operator()(std::span<const Vec2> ring, const Pose& pose) const
    {
        std::vector<Vec2> points;
        for (const Vec2& p : ring) points.push_back((*this)(pose * p));
        return points;
    }
};

/// What the engine finds: a dot at each contact, the normal from it.
void draw_contacts(Sketch& s, const View& view, const Polygon& a, const Pose& pose_a, const Polygon& b,
                   const Pose& pose_b, double length)
{
    for (const Contact& contact : entered_contacts(a, pose_a, b, pose_b)) {
        const Vec2 p = view(contact.point);
        s.arrow(p, p + length * Vec2(contact.normal.x(), -contact.normal.y()), k_rust, 2.6);
        s.disc(p, 4.5, k_rust, k_none);
    }
}

/// A square has come down on the end of a floor: the edge's normal, and the line of centres.
void draw_struck(const std::string& folder)
{
    Sketch s(folder + "/struck.svg", 580, 250);
    const View view{Vec2(290, 190), 54.0};
    const Polygon floor = corner::box(10, 1);
    const Polygon square = corner::box(1.7, 1.7);
    const double lean = 0.6;
    const Pose pose = at(3.1, 0.5 + 0.85 * (std::sin(lean) + std::cos(lean)), lean);
    s.polygon(view(floor.vertices(), Pose()), pale(k_ochre, 0.45), k_ink);
    s.polygon(view(square.vertices(), pose), pale(k_blue, 0.3), k_blue, 2.0);
    s.dashed(view(Vec2::Zero()), view(pose.position), k_soft, 1.8);
    for (const Vec2& centre : {Vec2(0, 0), pose.position}) s.disc(view(centre), 4.5, {0xffffff, 1.0}, k_ink, 2.0);
    std::vector<Touch> touches;
    find_touches(floor, Pose(), square, pose, 1e-9, touches);
    for (const Touch& touch : touches) {
        const Vec2 p = view(touch.r_a);
        s.arrow(p, p + 82.0 * Vec2(touch.normal.x(), -touch.normal.y()), k_rust, 2.6);
        s.disc(p, 4.5, k_rust, k_none);
    }
    s.words(view(Vec2(0, 0)) + Vec2(0, 22), "A");
    s.words(view(pose.position) + Vec2(16, -6), "B");
    s.words(view(Vec2(0.0, 1.05)), "from centre to centre", Anchor::middle, k_soft);
    s.formula(view(Vec2(2.3, 1.72)), "n", Anchor::middle, k_rust, 22.0);
}

/// Corner on corner, three times: the directions that part the two, and their middle.
void draw_cone(const std::string& folder)
{
    Sketch s(folder + "/cone.svg", 580, 250);
    const double pi = std::numbers::pi;
    const auto panel = [&](double x, double alpha, double beta, const char* words) {
        const View view{Vec2(x, 112), 74.0};
        const Rotation turn_a = Rotation::of(pi / 4 + alpha);
        const Rotation turn_b = Rotation::of(-3 * pi / 4 + beta);
        const Polygon square = corner::box(1, 1);
        const Pose pose_a{-(turn_a * Vec2(0.5, 0.5)), turn_a};
        const Pose pose_b{-(turn_b * Vec2(0.5, 0.5)), turn_b};
        s.polygon(view(square.vertices(), pose_a), pale(k_ochre, 0.45), k_ink);
        s.polygon(view(square.vertices(), pose_b), pale(k_blue, 0.25), k_blue);

        // The cone lies between a normal of either body
        const double low = pi / 2 + std::max(alpha, beta) - pi / 4;
        const double high = pi / 2 + std::min(alpha, beta) + pi / 4;
        std::vector<Vec2> fan{view(Vec2::Zero())};
        for (int k = 0; k <= 24; ++k) {
            const double angle = low + (high - low) * k / 24;
            fan.push_back(view(0.62 * Vec2(std::cos(angle), std::sin(angle))));
        }
        s.polygon(fan, pale(k_rust, 0.22), k_none);
        std::vector<Touch> touches;
        find_touches(square, pose_a, square, pose_b, 1e-9, touches);
        for (const Touch& touch : touches) s.arrow(view(Vec2::Zero()), view(0.86 * touch.normal), k_rust, 2.6);
        s.disc(view(Vec2::Zero()), 4.5, k_rust, k_none);
        s.words(Vec2(x, 240), words, Anchor::middle, k_ink, 14.0);
    };
    panel(96, 0.0, 0.0, "along the diagonals");
    panel(290, 0.35, -0.25, "leaning");
    panel(484, 0.0, 0.5 * pi - 0.001, "face to face");
}

/// A plus sign and a frame, cut into convex parts.
void draw_parts(const std::string& folder)
{
    Sketch s(folder + "/parts.svg", 580, 230);
    const Tone tones[] = {k_teal, k_ochre, k_blue, k_rust, k_soft};
    const auto panel = [&](double x, double scale, const Polygon& polygon) {
        const View view{Vec2(x, 112), scale};
        int k = 0;
        for (const Polygon& part : convex_parts(polygon))
            s.polygon(view(part.vertices(), Pose()), pale(tones[k++ % 5], 0.35), k_ink, 1.2);
    };
    panel(100, 30.0, corner::plus());
    const View shifted{Vec2(290, 157), 30.0};
    int k = 0;
    for (const Polygon& part : convex_parts(corner::table()))
        s.polygon(shifted(part.vertices(), Pose()), pale(tones[k++ % 5], 0.35), k_ink, 1.2);
    panel(480, 45.0, corner::frame());
}

/// Three points, and the parallelogram whose area their turn is.
void draw_turn(const std::string& folder)
{
    Sketch s(folder + "/turn.svg", 560, 240);
    const auto one = [&](const Vec2& c, const Vec2& a, const Vec2& b, Tone tone, const char* sign) {
        s.polygon({c, a, b}, pale(tone, 0.25), k_none);
        s.arrow(a, b, tone, 2.4);
        s.arrow(b, c, tone, 2.4);
        s.arrow(c, a, pale(tone, 0.5), 1.6);
        for (const Vec2& p : {a, b, c}) s.disc(p, 4.5, k_ink, k_none);
        s.words((a + b + c) / 3.0 + Vec2(0, 8), sign, Anchor::middle, tone, 24.0);
    };
    one(Vec2(60, 60), Vec2(90, 205), Vec2(215, 165), k_teal, "+");
    s.formula(Vec2(44, 58), "c");
    s.formula(Vec2(76, 222), "a");
    s.formula(Vec2(228, 184), "b");
    one(Vec2(400, 205), Vec2(330, 90), Vec2(445, 60), k_rust, "−");
    s.formula(Vec2(400, 230), "c");
    s.formula(Vec2(314, 88), "a");
    s.formula(Vec2(460, 56), "b");
}

/// The same 4096 points, judged by a rounded turn and by the exact one.
void draw_grid(const std::string& folder)
{
    Sketch s(folder + "/grid.svg", 580, 310);
    for (int panel = 0; panel < 2; ++panel) {
        const Vec2 corner(18.0 + 288.0 * panel, 270.0);
        const double cell = 4.0;
        const auto sign_at = [&](int i, int j) {
            const Vec2 a(0.5 + i * 0x1p-53, 0.5 + j * 0x1p-53);
            const double rounded = rounded_turn(a, Vec2(12, 12), Vec2(24, 24));
            if (panel == 1) return orientation(a, Vec2(12, 12), Vec2(24, 24));
            return (rounded > 0.0 ? 1 : 0) - (rounded < 0.0 ? 1 : 0);
        };
        for (int i = 0; i < 64; ++i) {
            int end = 0;
            for (int j = 0; j < 64; j = end) {
                const int sign = sign_at(i, j);
                for (end = j; end < 64 && sign_at(i, end) == sign;) ++end;

                // A little more than the run, so that no seam shows; the next one covers what is too much
                const double height = cell * (end - j) + 1.0;
                const Vec2 middle(corner.x() + cell * (i + 0.5) + 0.5, corner.y() - cell * j - 0.5 * height);
                const Tone tone = sign > 0 ? Tone{0x6fa3a6, 1.0} : sign < 0 ? Tone{0xe0b27a, 1.0} : k_ink;
                s.polygon(sketch::box(middle, cell + 1.0, height), tone, k_none);
            }
        }
        s.words(Vec2(corner.x() + 128, 296), panel == 0 ? "rounded" : "exact");
    }
}

/// A corner that has entered, and three that have not.
void draw_entered(const std::string& folder)
{
    Sketch s(folder + "/entered.svg", 580, 190);
    const auto panel = [&](double x, const Vec2& before, const Vec2& corner, const Vec2& after, bool entered,
                           const char* words) {
        const Vec2 o(x, 90);
        s.polygon({o + Vec2(-54, 0), o + Vec2(54, 0), o + Vec2(54, 46), o + Vec2(-54, 46)}, pale(k_ochre, 0.4), k_none);
        s.line(o + Vec2(-54, 0), o + Vec2(54, 0), k_ink, 2.4);
        s.polygon({o + before, o + corner, o + after}, pale(k_blue, 0.16), k_none);
        s.path({o + before, o + corner, o + after}, k_blue, 2.4);
        s.disc(o + corner, 5.0, entered ? k_rust : Tone{0xffffff, 1.0}, k_ink, 1.6);
        s.words(Vec2(x, 170), words, Anchor::middle, entered ? k_rust : k_ink, 14.0);
    };
    panel(72, Vec2(-34, -62), Vec2(0, 24), Vec2(34, -62), true, "entered");
    panel(217, Vec2(-34, -74), Vec2(0, -12), Vec2(34, -74), false, "above the edge");
    panel(362, Vec2(-34, -62), Vec2(36, 24), Vec2(68, -62), false, "past its end");
    panel(508, Vec2(-34, -62), Vec2(10, 24), Vec2(44, 14), false, "one side only");
}

/// Where the side p q of a corner crosses the line u v.
void draw_along(const std::string& folder)
{
    Sketch s(folder + "/along.svg", 520, 230);
    const Vec2 p(150, 40);
    const Vec2 q(350, 190);
    const double y = 140.0;
    const Vec2 x = p + (y - p.y()) / (q.y() - p.y()) * (q - p);
    s.arrow(Vec2(480, y), Vec2(40, y), k_ink, 2.0);
    s.line(p, q, k_blue, 2.6);
    s.dashed(p, Vec2(p.x(), y));
    s.dashed(q, Vec2(q.x(), y));
    s.disc(x, 5.5, k_rust, k_none);
    for (const Vec2& point : {p, q}) s.disc(point, 4.5, k_ink, k_none);
    s.formula(p + Vec2(0, -12), "p");
    s.formula(q + Vec2(0, 25), "q");
    s.formula(Vec2(476, y + 24), "u");
    s.formula(Vec2(48, y + 24), "v");
    s.formula(Vec2(p.x() - 12, 96), "T_p < 0", Anchor::right, k_teal);
    s.formula(Vec2(q.x() + 12, 172), "T_q > 0", Anchor::left, k_teal);
    s.formula(0.5 * (p + x) + Vec2(14, -8), "s", Anchor::left, k_rust);
    s.words(Vec2(440, 204), "inside", Anchor::middle, k_soft);
    s.words(Vec2(440, 90), "outside", Anchor::middle, k_soft);
}

/// A crate half over the end of the floor.
void draw_parallel(const std::string& folder)
{
    Sketch s(folder + "/parallel.svg", 560, 230);
    const View view{Vec2(-20, 185), 74.0};
    const Polygon floor = corner::box(10, 1);
    const Polygon crate = corner::box(3, 1.6);
    const Pose pose = at(5.0, 1.15);
    s.polygon(view(floor.vertices(), Pose()), pale(k_ochre, 0.45), k_ink);
    s.polygon(view(crate.vertices(), pose), pale(k_blue, 0.25), k_blue, 2.0);
    draw_contacts(s, view, floor, Pose(), crate, pose, 66.0);
    s.measure(view(Vec2(3.5, 0.12)), view(Vec2(5.0, 0.12)), k_rust);
    s.formula(view(Vec2(3.5, -0.2)), "x_1");
    s.formula(view(Vec2(5.0, -0.2)) + Vec2(-4, 0), "u_2", Anchor::right);
    s.formula(view(Vec2(6.5, 0.1)), "x_2");
}

/// Two concave scenes with all their contacts.
void draw_pieces(const std::string& folder)
{
    Sketch s(folder + "/pieces.svg", 580, 230);
    const View left{Vec2(145, 160), 40.0};
    const Pose floor_pose = at(0.0, -0.4);
    s.polygon(left(corner::box(6.9, 1).vertices(), floor_pose), pale(k_ochre, 0.45), k_ink);
    s.polygon(left(table().vertices(), Pose()), pale(k_blue, 0.25), k_blue, 2.0);
    draw_contacts(s, left, table(), Pose(), corner::box(20, 1), floor_pose, 36.0);

    const View right{Vec2(440, 112), 50.0};
    const Polygon ring = frame();
    s.polygon(right(ring.vertices().subspan(0, 4), Pose()), pale(k_ochre, 0.45), k_ink);
    s.polygon(right(ring.vertices().subspan(4, 4), Pose()), {0xffffff, 1.0}, k_ink);
    s.polygon(right(diamond().vertices(), Pose()), pale(k_blue, 0.3), k_blue, 2.0);
    draw_contacts(s, right, ring, Pose(), diamond(), Pose(), 36.0);
}

/// The bounces off a long floor, along its own normal and along the line of centres.
void draw_lean(const std::string& folder)
{
    Sketch s(folder + "/lean.svg", 580, 230);
    const View view{Vec2(150, 150), 46.0};
    s.polygon(view(corner::box(20, 1).vertices(), Pose()), pale(k_ochre, 0.45), k_ink);
    const Vec2 falling(0.0, -2.0);
    for (const double x : {0.0, 3.0, 7.0}) {
        const Pose crate = at(x, 0.99);
        s.polygon(view(corner::box(1, 1).vertices(), crate), pale(k_blue, 0.25), k_blue, 1.8);
        const Vec2 right =
            bounced(falling, entered_contacts(corner::box(20, 1), Pose(), corner::box(1, 1), crate).front().normal);
        const Vec2 wrong = bounced(falling, wrong_normal(Vec2::Zero(), crate.position));
        s.arrow(view(crate.position), view(crate.position + right), k_teal, 2.6);
        if (x > 0.0) s.arrow(view(crate.position), view(crate.position + wrong), k_rust, 2.6);
    }
    s.disc(view(Vec2(0, 0)), 4.5, {0xffffff, 1.0}, k_ink, 2.0);
    s.words(view(Vec2(3.0, 3.0)) + Vec2(12, 18), "by the edge", Anchor::left, k_teal, 15.0);
    s.words(view(Vec2(3.55, 0.0)) + Vec2(0, 50), "by the centres", Anchor::left, k_rust, 15.0);
}

/// A crate rocks on the end of a floor, a twentieth of a metre deep, and lies flat between: the dot is the contact.
void record_rocking(const std::string& folder)
{
    std::ofstream trace(folder + "/rocking.ndjson");
    trace << "{\"view\": [1.4, -0.7, 7.4, 2.3], \"fixed\": [true, false, false], \"shapes\": ["
          << "{\"rings\": [[[-5, -0.5], [5, -0.5], [5, 0.5], [-5, 0.5]]]}, "
          << "{\"rings\": [[[-1, -0.5], [1, -0.5], [1, 0.5], [-1, 0.5]]]}, {\"radius\": 0.09}]}\n";
    const Polygon floor = corner::box(10, 1);
    const Polygon crate = corner::box(2, 1);
    for (int k = 0; k <= 360; ++k) {
        // Rock to either side, and lie flat for a while between
        const double swing = std::sin(k * std::numbers::pi / 90.0);
        const double phi = 0.2 * std::copysign(std::max(0.0, std::abs(swing) - 0.3), swing);
        const double x = 4.4;
        // Lower it until the engine finds the depth
        double high = 2.5;
        double low = 0.7;
        for (int halving = 0; halving < 40; ++halving) {
            const double middle = 0.5 * (low + high);
            const auto found = entered_contacts(floor, at(0, 0), crate, at(x, middle, phi));
            (!found.empty() && -found.front().separation > 0.05 ? low : high) = middle;
        }
        const Pose pose = at(x, high, phi);
        const auto contacts = entered_contacts(floor, at(0, 0), crate, pose);
        const Vec2 dot = contacts.empty() ? Vec2(0.0, -9.0) : contacts.front().point;
        trace << "{\"time\": " << k / 60.0 << ", \"bodies\": [[0, 0, 0], [" << x << ", " << pose.position.y() << ", "
              << phi << "], [" << dot.x() << ", " << dot.y() << ", 0]]}\n";
    }
}

} // namespace

int main(int argc, char** argv)
{
    if (argc != 2) return 2;
    const std::string folder = argv[1];
    draw_struck(folder);
    draw_cone(folder);
    draw_parts(folder);
    draw_turn(folder);
    draw_grid(folder);
    draw_entered(folder);
    draw_along(folder);
    draw_parallel(folder);
    draw_pieces(folder);
    draw_lean(folder);
    record_rocking(folder);
}
