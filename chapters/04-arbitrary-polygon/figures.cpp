#include <algorithm>
#include <cmath>
#include <fstream>
#include <initializer_list>
#include <string>
#include <vector>

#include "../support/sketch.hpp"
#include "geometry/make_polygon.hpp"
#include "geometry/moments.hpp"
#include "math/sine_cosine.hpp"
#include "motion/flight.hpp"
#include "outlines.hpp"
#include "wrong_polygon.hpp"

using namespace flying;
using namespace flying::sketch;
using namespace flying::outlines;

namespace {

constexpr Tone k_white{0xffffff, 1.0};

/// From centimetres, y up, to the page.
struct Place
{
    Vec2 origin;
    double scale;

    Vec2 operator()(const Vec2& p) const { return origin + scale * Vec2(p.x(), -p.y()); }
    Ring operator()(Ring ring) const
    {
        for (Vec2& p : ring) p = (*this)(p);
        return ring;
    }
};

void corners(Sketch& s, const Ring& ring, double radius = 3.2)
{
    for (const Vec2& p : ring) s.disc(p, radius, k_ink, k_none);
}

void cross_at(Sketch& s, const Vec2& p, Tone tone = k_rust, double r = 7.0)
{
    s.line(p + Vec2(-r, -r), p + Vec2(r, r), tone, 3.2);
    s.line(p + Vec2(-r, r), p + Vec2(r, -r), tone, 3.2);
}

void disc_at(Sketch& s, const Vec2& p, double r = 7.0)
{
    s.disc(p, r, k_teal, k_white, 1.6);
}

/// The opening: one outline, twelve corners and sixteen.
void draw_middle(const std::string& folder)
{
    Sketch s(folder + "/middle.svg", 580, 220);
    for (const int more : {0, 4}) {
        const Place at{Vec2(more == 0 ? 145.0 : 435.0, 100.0), 1.55};
        const Ring ring = with_corners(dumbbell(), 9, more);
        s.polygon(at(ring), pale(k_ochre, 0.4), k_ink);
        corners(s, at(ring));
        disc_at(s, at(moments_of_ring(ring).centroid), 8.0);
        cross_at(s, at(vertex_mean(ring)));
        s.words(at(Vec2(0, -70)), more == 0 ? "12 corners" : "16 corners", Anchor::middle, k_ink, 17.0);
    }
}

/// A triangle with its own edges as axes.
void draw_triangle(const std::string& folder)
{
    Sketch s(folder + "/triangle.svg", 540, 330);
    const Vec2 c(60, 270);
    const Vec2 a(470, 300);
    const Vec2 b(330, 40);
    const auto at = [&](double alpha, double beta) { return Vec2(c + alpha * (a - c) + alpha * beta * (b - a)); };
    s.polygon({c, a, b}, pale(k_blue, 0.14), k_blue, 2.0);
    const double alpha = 0.64;
    const double thick = 0.05;
    s.polygon({at(alpha, 0), at(alpha + thick, 0), at(alpha + thick, 1), at(alpha, 1)}, pale(k_ochre, 0.5), k_none);
    const Vec2 p1 = at(alpha, 0);
    const Vec2 p2 = at(alpha, 1);
    const Vec2 q = at(alpha, 0.55);
    const Vec2 on = at(alpha, 0.66);
    const Vec2 up = at(alpha + thick, 0.5) - at(alpha, 0.5);
    s.polygon({q, on, Vec2(on + up), Vec2(q + up)}, pale(k_rust, 0.85), k_rust);
    s.line(p1, p2, k_ochre, 2.0);

    // The height, from C across to the line AB
    const Vec2 along = (b - a).normalized();
    const Vec2 foot = a + along.dot(c - a) * along;
    s.dashed(c, foot, k_soft);
    s.arrow(c, q, k_rust, 2.4);
    s.formula(c + Vec2(-14, 18), "C");
    s.formula(a + Vec2(12, 18), "A");
    s.formula(b + Vec2(-4, -10), "B");
    s.formula(p1 + Vec2(2, 24), "P_1");
    s.formula(p2 + Vec2(-14, -8), "P_2");
    s.formula(q + Vec2(32, 16), "Q", Anchor::middle, k_rust);
    s.formula(0.5 * (c + q) + Vec2(14, 22), "r", Anchor::middle, k_rust);
    s.formula(c + 0.86 * (foot - c) + Vec2(0, 22), "h", Anchor::middle, k_soft);
    s.formula(0.4 * a + 0.6 * b + Vec2(22, -10), "b");
    s.formula(0.5 * (a + c) + Vec2(-60, 30), "u");
}

/// The dumbbell's triangles: those that count, those that take away, what is left.
void draw_signed(const std::string& folder)
{
    Sketch s(folder + "/signed.svg", 600, 215);
    const Ring ring = dumbbell();
    for (int panel = 0; panel < 3; ++panel) {
        const Place at{Vec2(90.0 + 210.0 * panel, 82.0), 1.02};
        for (std::size_t k = 0; k < ring.size() && panel < 2; ++k) {
            const Vec2& a = ring[k];
            const Vec2& b = ring[(k + 1) % ring.size()];
            if ((cross(a, b) > 0.0) != (panel == 0)) continue;
            const Tone tone = panel == 0 ? k_teal : k_rust;
            s.polygon(at(Ring{Vec2(0, 0), a, b}), pale(tone, 0.28), tone, 1.2);
        }
        s.polygon(at(ring), panel == 2 ? pale(k_ochre, 0.5) : k_none, k_ink, 2.0);
        s.disc(at(Vec2(0, 0)), 3.6, k_ink, k_none);
    }
    s.words(Vec2(195, 91), "−", Anchor::middle, k_ink, 26.0);
    s.words(Vec2(405, 91), "=", Anchor::middle, k_ink, 26.0);
    s.words(Vec2(90, 166), "8 triangles", Anchor::middle, k_teal, 20.0);
    s.words(Vec2(90, 192), "56 halves", Anchor::middle, k_teal, 20.0);
    s.words(Vec2(300, 166), "4 triangles", Anchor::middle, k_rust, 20.0);
    s.words(Vec2(300, 192), "8 halves", Anchor::middle, k_rust, 20.0);
    s.words(Vec2(510, 166), "24 squares", Anchor::middle, k_ink, 20.0);
}

/// Why the signs come out right: a ray and the edges that it crosses.
void draw_ray(const std::string& folder)
{
    Sketch s(folder + "/ray.svg", 560, 250);
    const Place at{Vec2(90.0, 170.0), 4.6};
    const Ring half = {{-12, -10}, {40, -10}, {40, -14}, {80, -14}, {80, 32}, {40, 32}, {40, 9}, {-12, 9}};
    s.polygon(at(half), pale(k_blue, 0.14), k_none);
    s.path({at(half[7]), at(half[6]), at(half[5]), at(half[4]), at(half[3]), at(half[2]), at(half[1]), at(half[0])},
           k_blue, 2.0);
    const Vec2 along(1.0, 0.30);
    const auto on = [&](double x) { return at(x * along); };
    s.arrow(at(Vec2(0, 0)), on(97.0), k_ink, 1.8);

    // The triangles of the three edges that it crosses, as far as they are near
    const double first = 9.0 / 0.30;
    for (const double x : {first, 40.0, 80.0}) s.disc(on(x), 6.0, x == 40.0 ? k_rust : k_teal, k_white);
    s.words(on(first) + Vec2(-2, -14), "+1", Anchor::middle, k_teal, 19.0);
    s.words(on(40.0) + Vec2(20, 22), "−1", Anchor::middle, k_rust, 19.0);
    s.words(on(80.0) + Vec2(18, 24), "+1", Anchor::middle, k_teal, 19.0);
    s.arrow(at(Vec2(12, 12.2)), at(Vec2(3, 12.2)), k_teal, 1.8);
    s.arrow(at(Vec2(42.5, 29)), at(Vec2(42.5, 21)), k_rust, 1.8);
    s.arrow(at(Vec2(82.5, 3)), at(Vec2(82.5, 13)), k_teal, 1.8);
    s.disc(at(Vec2(0, 0)), 4.5, k_ink, k_none);
    s.formula(at(Vec2(0, 0)) + Vec2(-6, 24), "C");
    s.words(on(17.0) + Vec2(10, 26), "1", Anchor::middle, k_ink, 18.0);
    s.words(on(35.0) + Vec2(2, 24), "0", Anchor::middle, k_ink, 18.0);
    s.words(on(60.0) + Vec2(0, 26), "1", Anchor::middle, k_ink, 18.0);
    s.words(on(91.0) + Vec2(4, 26), "0", Anchor::middle, k_ink, 18.0);
}

/// The house: its two parts, their middles, and what lies between.
void draw_house(const std::string& folder)
{
    Sketch s(folder + "/house.svg", 520, 300);
    const Place at{Vec2(90.0, 270.0), 1.65};
    const Ring ring = house();
    const Vec2 middle = moments_of_ring(ring).centroid;
    const Vec2 mean = vertex_mean(ring);
    s.polygon(at(Ring{ring[0], ring[1], ring[2], ring[4]}), pale(k_blue, 0.16), k_none);
    s.polygon(at(Ring{ring[4], ring[2], ring[3]}), pale(k_ochre, 0.4), k_none);
    s.dashed(at(ring[4]), at(ring[2]));
    s.polygon(at(ring), k_none, k_ink, 2.0);
    corners(s, at(ring), 4.0);
    for (const Vec2& part : {Vec2(50, 50), Vec2(50, 350.0 / 3.0)}) s.disc(at(part), 5.5, k_white, k_ink, 2.0);
    disc_at(s, at(middle));
    cross_at(s, at(mean), k_rust, 6.0);
    const auto label = [&](const Vec2& p, const char* text, Tone tone, double shift) {
        s.line(at(p) + Vec2(12, 0), at(Vec2(112, p.y())) + Vec2(0, shift), pale(tone, 0.7), 1.2);
        s.words(at(Vec2(114, p.y())) + Vec2(0, shift + 5), text, Anchor::left, tone);
    };
    label(Vec2(50, 350.0 / 3.0), "middle of the roof", k_soft, 0.0);
    label(mean, "mean of the corners", k_rust, -4.0);
    label(middle, "centroid", k_teal, 3.0);
    label(Vec2(50, 50), "middle of the wall", k_soft, 8.0);
    s.measure(at(Vec2(-12, 0)), at(Vec2(-12, 100)));
    s.measure(at(Vec2(-12, 100)), at(Vec2(-12, 150)));
    s.formula(at(Vec2(-24, 48)), "H");
    s.formula(at(Vec2(-24, 122)), "t");
}

/// A plate with a hole: both rings have the inside on their left.
void draw_hole(const std::string& folder)
{
    Sketch s(folder + "/hole.svg", 520, 270);
    const Place at{Vec2(220.0, 135.0), 2.7};
    const Ring outer = square(Vec2(0, 0), 80);
    const Ring inner = reversed(square(Vec2(15, 0), 40));
    s.polygon(at(outer), pale(k_blue, 0.18), k_blue, 2.0);
    s.polygon(at(inner), k_white, k_rust, 2.0);
    const auto arrows = [&](const Ring& ring, Tone tone) {
        for (std::size_t k = 0; k < ring.size(); ++k) {
            const Vec2& a = ring[k];
            const Vec2& b = ring[(k + 1) % ring.size()];
            s.arrow(at(0.58 * a + 0.42 * b), at(0.42 * a + 0.58 * b), tone, 2.4);
        }
    };
    arrows(outer, k_blue);
    arrows(inner, k_rust);
    const AreaMoments moments = moments_of(Polygon({outer, inner}));
    s.disc(at(Vec2(0, 0)), 4.0, k_white, k_ink, 1.8);
    disc_at(s, at(moments.centroid));
    s.measure(at(Vec2(0, 0)) + Vec2(0, 26), at(Vec2(15, 0)) + Vec2(0, 26));
    s.formula(at(Vec2(7.5, 0)) + Vec2(0, 48), "e");
    s.formula(at(Vec2(15, 23)), "s", Anchor::middle, k_rust);
    s.formula(at(Vec2(-44, 0)), "a", Anchor::right, k_blue);
    s.words(at(Vec2(46, 26)), "counts", Anchor::left, k_blue);
    s.words(at(Vec2(46, 18)), "positively", Anchor::left, k_blue);
    s.words(at(Vec2(46, -2)), "takes away", Anchor::left, k_rust);
}

/// What is no polygon.
void draw_refused(const std::string& folder)
{
    Sketch s(folder + "/refused.svg", 600, 180);
    const auto panel = [&](int k, const Ring& ring, const char* text) {
        const Place at{Vec2(75.0 + 150.0 * k, 74.0), 1.0};
        s.polygon(at(ring), pale(k_rust, 0.22), k_rust, 2.0);
        corners(s, at(ring), 3.6);
        s.words(at(Vec2(0, -86)), text, Anchor::middle, k_ink, 18.5);
        return at;
    };
    panel(0, {{-50, -40}, {50, 40}, {50, -40}, {-50, 40}}, "crosses itself");
    panel(1, {{-50, -40}, {50, -40}, {50, 40}, {0, -40}, {-50, 40}}, "touches itself");
    panel(2, {{-52, -30}, {10, 5}, {52, 29}}, "has no area");
    const Place at = panel(3, {{-50, -45}, {30, -45}, {30, 45}, {-50, 45}}, "hole leaves it");
    s.polygon(at(square(Vec2(28, 5), 48)), k_white, k_rust, 2.0);
}

/// Errors of the house's second moment over its distance from the origin.
void draw_far(const std::string& folder)
{
    Sketch s(folder + "/far.svg", 560, 350);
    const LogPlot plot(s, Vec2(76, 296), Vec2(536, 24), Vec2(0, -17), Vec2(7, 14));
    plot.axes(1, 4);
    const double true_moment = moments_of_ring(tilted_house()).second_moment;
    for (int k = 0; k <= 72; ++k) {
        const double far = 100.0 * std::pow(10.0, k / 12.0);
        // The worst of 64 directions
        double wrong = 0.0;
        double right = 0.0;
        for (int d = 0; d < 64; ++d) {
            const SineCosine way = sine_cosine(0.1 * d + 0.037);
            const Ring ring = moved(tilted_house(), Vec2(on_grid(far * way.cosine), on_grid(far * way.sine)));
            const double error = std::abs(moments_about_origin(ring).second_moment / true_moment - 1.0);
            if (std::isfinite(error)) wrong = std::max(wrong, error);
            right = std::max(right, std::abs(moments_of_ring(ring).second_moment / true_moment - 1.0));
        }
        plot.dot(far / 100.0, std::clamp(wrong, 1e-17, 1e14), k_rust);
        plot.dot(far / 100.0, std::max(right, 1e-17), k_teal);
    }
    const auto law = [](double x) { return 2.2e-16 * x * x * x * x; };
    plot.curve(1.0, 1.0e7, law, pale(k_soft, 0.8));
    s.words(plot.at(6e4, 1e8) + Vec2(-8, 0), "about the origin", Anchor::right, k_rust);
    s.words(plot.at(4e3, 1e-15), "about a corner of its own: 0", Anchor::left, k_teal);
    s.words(Vec2(306, 340), "distance from the origin, in sizes of the house");
    s.words(Vec2(90, 44), "relative error of the second moment", Anchor::left, k_soft, 15.0);
}

/// The dumbbell with sixteen corners, thrown.
BodyState thrown(double time)
{
    BodyState body;
    body.velocity = Vec2(290.0, 520.0);
    body.spin = 5.5;
    body.angle = 0.4;
    return flight(body, Vec2(0.0, -981.0), time);
}

void draw_toss(const std::string& folder)
{
    Sketch s(folder + "/toss.svg", 600, 400);
    const Place at{Vec2(125.0, 272.0), 1.16};
    const Ring ring = with_corners(dumbbell(), 9, 4);
    const Vec2 mean = vertex_mean(ring);
    Ring middles;
    Ring means;
    for (int k = 0; k <= 106; ++k) {
        const Pose pose = pose_of(thrown(0.01 * k));
        middles.push_back(at(pose.position));
        means.push_back(at(pose * mean));
        if (k % 53 == 0) {
            Ring now;
            for (const Vec2& p : ring) now.push_back(at(pose * p));
            s.polygon(now, pale(k_ochre, 0.28), pale(k_ink, 0.6), 1.3);
        }
    }
    s.path(means, k_rust, 2.4);
    s.path(middles, k_teal, 2.8);
    for (const int k : {0, 53, 106}) {
        cross_at(s, means[k], k_rust, 5.5);
        disc_at(s, middles[k], 6.5);
    }
}

void record_toss(const std::string& folder)
{
    const Ring ring = with_corners(dumbbell(), 9, 4);
    const Vec2 mean = vertex_mean(ring);
    std::ofstream trace(folder + "/toss.ndjson");
    trace << "{\"view\": [-1.1, -1.2, 4.2, 2.3], \"shapes\": [{\"rings\": [[";
    for (std::size_t k = 0; k < ring.size(); ++k)
        trace << (k ? ", [" : "[") << ring[k].x() / 100.0 << ", " << ring[k].y() / 100.0 << "]";
    trace << "]]}, {\"radius\": 0.06}, {\"radius\": 0.045}]}\n";
    for (int k = 0; k <= 64; ++k) {
        const BodyState body = thrown(k / 60.0);
        const Vec2 p = 0.01 * body.position;
        const Vec2 q = 0.01 * (pose_of(body) * mean);
        trace << "{\"time\": " << body.time << ", \"bodies\": [[" << p.x() << ", " << p.y() << ", " << body.angle
              << "], [" << p.x() << ", " << p.y() << ", 0], [" << q.x() << ", " << q.y() << ", 0]]}\n";
    }
}

/// A polygon that turns about its centroid.
void record_vertices(const std::string& folder)
{
    const Ring ring = {{-1.2, -1.0}, {1.4, -1.1}, {0.6, 0.1}, {2.0, 1.0}, {-0.6, 1.4}, {-1.8, 0.4}};
    const CentredPolygon made = make_polygon(ring).value();
    std::ofstream trace(folder + "/vertices.ndjson");
    trace << "{\"view\": [-3.4, -2.2, 3.4, 2.2], \"shapes\": [{\"rings\": [[";
    for (std::size_t k = 0; k < ring.size(); ++k) {
        const Vec2& vertex = made.polygon.vertices()[k];
        trace << (k ? ", [" : "[") << vertex.x() << ", " << vertex.y() << "]";
    }
    trace << "]]}, {\"radius\": 0.08}]}\n";
    for (int k = 0; k <= 240; ++k)
        trace << "{\"time\": " << k / 60.0 << ", \"bodies\": [[0, 0, " << 0.0261799387799 * k << "], [0, 0, 0]]}\n";
}

} // namespace

int main(int argc, char** argv)
{
    if (argc != 2) return 2;
    const std::string folder = argv[1];
    draw_middle(folder);
    draw_triangle(folder);
    draw_signed(folder);
    draw_ray(folder);
    draw_house(folder);
    draw_hole(folder);
    draw_refused(folder);
    draw_far(folder);
    draw_toss(folder);
    record_toss(folder);
    record_vertices(argv[1]);
}
