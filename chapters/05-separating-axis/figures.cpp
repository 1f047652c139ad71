#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <numbers>
#include <string>
#include <vector>

#include "../support/sketch.hpp"
#include "collide/manifold.hpp"
#include "collide/separating_axis.hpp"
#include "head_on.hpp"
#include "shadows.hpp"

using namespace flying;
using namespace flying::sketch;

namespace {

constexpr double k_degree = std::numbers::pi / 180.0;

/// From metres, y up, to pixels.
struct Map
{
    Vec2 origin;
    double scale;

    Vec2 operator()(const Vec2& p) const { return origin + scale * Vec2(p.x(), -p.y()); }
};

std::vector<Vec2> outline(const Map& map, const Polygon& polygon, const Pose& pose)
{
    std::vector<Vec2> points;
    for (const Vec2& p : polygon.vertices()) points.push_back(map(pose * p));
    return points;
}

/// The direction of an axis in the world, from A to B.
Vec2 direction(const Axis& axis, const Polygon& a, const Pose& pose_a, const Polygon& b, const Pose& pose_b)
{
    if (axis.owner == Owner::a) return pose_a.rotation * a.edges()[axis.edge].normal;
    return -(pose_b.rotation * b.edges()[axis.edge].normal);
}

/// Left, two polygons and a ruler between them. Right, two that let none through.
void draw_ruler(const std::string& folder)
{
    Sketch s(folder + "/ruler.svg", 580, 270);
    const Polygon a = regular(5, 1.0);
    const Polygon b = regular(3, 1.1);
    const Pose pose_a = placed(0.0, 0.0, 0.35);
    const auto pair = [&](const Map& map, const Pose& pose_b) {
        s.polygon(outline(map, a, pose_a), pale(k_blue, 0.3), k_blue, 2.0);
        s.polygon(outline(map, b, pose_b), pale(k_ochre, 0.4), k_ochre, 2.0);
    };
    const Map left{Vec2(105, 150), 72.0};
    const Pose apart = placed(1.95, 0.35, 2.6);
    const Axis axis = greatest_separation(a, b, relative_pose(pose_a, apart));
    const Vec2 n = direction(axis, a, pose_a, b, apart);
    const Vec2 t = perp(n);
    const Vec2& corner = axis.owner == Owner::a ? a.vertices()[axis.edge] : b.vertices()[axis.edge];
    const Vec2 on = (axis.owner == Owner::a ? pose_a : apart) * corner;
    const double half = 0.5 * axis.separation * (axis.owner == Owner::a ? 1.0 : -1.0);
    const Vec2 middle = on + half * n - t.dot(on + half * n - Vec2(0.9, 0.1)) * t;
    const double thick = 0.34 * axis.separation;
    s.polygon({left(middle - 1.6 * t - thick * n), left(middle + 1.6 * t - thick * n),
               left(middle + 1.6 * t + thick * n), left(middle - 1.6 * t + thick * n)},
              pale(k_rust, 0.35), k_rust, 1.4);
    for (int k = -15; k <= 15; ++k) {
        const Vec2 mark = middle + 0.1 * k * t - thick * n;
        s.line(left(mark), left(mark + (k % 5 == 0 ? 1.1 : 0.6) * thick * n), k_rust, 1.0);
    }
    pair(left, apart);
    pair({Vec2(405, 150), 72.0}, placed(1.12, 0.2, 2.6));
    s.formula(left(Vec2(0, -0.08)), "A", Anchor::middle, k_blue);
    s.formula(left(apart.position) + Vec2(0, 6), "B");
}

/// Two polygons, an axis on which their shadows are apart, and one on which they overlap.
void draw_shadows(const std::string& folder)
{
    Sketch s(folder + "/shadows.svg", 560, 412);
    const Map map{Vec2(190, 182), 82.0};
    const Polygon a = box_of(1.7, 1.2);
    const Polygon b = regular(3, 1.0);
    const Pose pose_a = placed(0.0, 0.0);
    const Pose pose_b = placed(2.0, 0.35, 0.5);
    const auto shadow = [&](const Polygon& polygon, const Pose& pose, const Vec2& n, const Vec2& line, Tone tone) {
        double least = 1e300;
        double most = -1e300;
        for (const Vec2& p : polygon.vertices()) {
            const double u = n.dot(pose * p);
            least = std::min(least, u);
            most = std::max(most, u);
        }
        const auto at = [&](double u) { return map(line + u * n); };
        for (const double u : {least, most}) {
            for (const Vec2& p : polygon.vertices()) {
                if (std::abs(n.dot(pose * p) - u) < 1e-9) {
                    s.dashed(map(pose * p), at(u), pale(tone, 0.7), 1.1);
                    break;
                }
            }
        }
        s.line(at(least), at(most), tone, 7.0);
    };
    const auto axis = [&](const Vec2& n, const Vec2& line, double from, double to) {
        s.arrow(map(line + from * n), map(line + to * n), k_soft, 1.4);
    };
    s.polygon(outline(map, a, pose_a), pale(k_blue, 0.3), k_blue, 2.0);
    s.polygon(outline(map, b, pose_b), pale(k_ochre, 0.4), k_ochre, 2.0);
    const Vec2 below(0.0, -2.1);
    axis(Vec2(1, 0), below, -1.7, 3.6);
    shadow(a, pose_a, Vec2(1, 0), below, k_blue);
    shadow(b, pose_b, Vec2(1, 0), below, k_ochre);
    const double g = gap(a, pose_a, b, pose_b, Vec2(1, 0));
    s.measure(map(below + Vec2(0.85, -0.16)), map(below + Vec2(0.85 + g, -0.16)), k_rust);
    s.formula(map(below + Vec2(0.85 + 0.5 * g, -0.48)), "g > 0", Anchor::middle, k_rust);
    const Vec2 aside(-1.75, 0.0);
    axis(Vec2(0, 1), aside, -1.3, 1.75);
    shadow(a, pose_a, Vec2(0, 1), aside, k_blue);
    shadow(b, pose_b, Vec2(0, 1), aside + Vec2(-0.14, 0.0), k_ochre);
    s.formula(map(aside + Vec2(0.0, 1.82)), "g < 0", Anchor::middle, k_rust);
    s.formula(map(Vec2(0, -0.08)), "A", Anchor::middle, k_blue);
    s.formula(map(pose_b.position) + Vec2(0, 6), "B");
}

/// The nearest points, the line that parts, and a point that cannot be.
void draw_proof(const std::string& folder)
{
    Sketch s(folder + "/proof.svg", 540, 300);
    const Map map{Vec2(190, 160), 80.0};
    const Polygon a({{Vec2(-1.9, -0.9), Vec2(-0.5, -1.1), Vec2(0.0, 0.0), Vec2(-0.7, 1.0), Vec2(-1.8, 0.7)}});
    const Polygon b({{Vec2(1.4, -1.0), Vec2(3.0, -1.2), Vec2(3.4, 0.6), Vec2(1.4, 1.1)}});
    s.polygon(outline(map, a, {}), pale(k_blue, 0.3), k_blue, 2.0);
    s.polygon(outline(map, b, {}), pale(k_ochre, 0.4), k_ochre, 2.0);
    s.dashed(map(Vec2(0.0, -1.6)), map(Vec2(0.0, 1.6)), k_soft);
    s.dashed(map(Vec2(1.4, -1.6)), map(Vec2(1.4, 1.6)), k_soft);
    const Vec2 p(0, 0);
    const Vec2 q(1.4, 0);
    const Vec2 x(0.6, 1.25);
    s.dashed(map(p), map(x), k_rust);
    s.disc(map(x), 5.0, {0xffffff, 1.0}, k_rust, 1.8);
    s.line(map(0.3 * x), map(q), k_rust, 1.6);
    s.disc(map(0.3 * x), 3.5, k_rust, k_none);
    s.arrow(map(p), map(q), k_ink, 2.2);
    s.disc(map(p), 5.0, k_ink, k_none);
    s.disc(map(q), 5.0, k_ink, k_none);
    s.formula(map(p) + Vec2(-16, 7), "p");
    s.formula(map(q) + Vec2(16, 7), "q");
    s.formula(map(Vec2(0.62, -0.28)), "d");
    s.formula(map(x) + Vec2(14, -4), "x", Anchor::left, k_rust);
    s.formula(map(Vec2(-1.2, -0.1)), "A", Anchor::middle, k_blue);
    s.formula(map(Vec2(2.5, -0.1)), "B");
}

/// The gap over the direction, for squares that are apart and for squares that overlap.
void draw_turn(const std::string& folder)
{
    Sketch s(folder + "/turn.svg", 580, 400);
    const Polygon square = box_of(1.0, 1.0);
    const Pose pose_a = placed(0.0, 0.0);
    const auto at = [&](double degrees, double g) {
        return Vec2(70.0 + (degrees + 90.0) / 180.0 * 480.0, 165.0 - 105.0 * g);
    };
    for (int d = -90; d <= 90; d += 30) {
        s.line(at(d, -1.75), at(d, 1.2), pale(k_soft, 0.3), 1.0);
        s.formula(at(d, -1.75) + Vec2(0, 22), (d < 0 ? "\u2212" : "") + std::to_string(std::abs(d)) + "°",
                  Anchor::middle, k_ink, 15.0);
    }
    s.line(at(-90, 0), at(90, 0), k_soft, 1.5);
    for (const int g : {-1, 1})
        s.formula(at(-90, g) + Vec2(-10, 6), g < 0 ? "\u22121" : "1", Anchor::right, k_ink, 15.0);
    s.formula(at(-90, 0) + Vec2(-10, 6), "0", Anchor::right, k_ink, 15.0);
    const auto curve = [&](const Pose& pose_b, Tone tone) {
        std::vector<Vec2> points;
        for (int k = -360; k <= 360; ++k) {
            const double degrees = 0.25 * k;
            const Vec2 n = Rotation::of(degrees * k_degree) * Vec2(1.0, 0.0);
            points.push_back(at(degrees, std::max(-1.75, gap(square, pose_a, square, pose_b, n))));
        }
        s.path(points, tone, 2.6);
        for (const double normal : {-90.0, -60.0, 0.0, 30.0, 90.0}) {
            const Vec2 n = Rotation::of(normal * k_degree) * Vec2(1.0, 0.0);
            const double g = gap(square, pose_a, square, pose_b, n);
            if (g > -1.75) s.disc(at(normal, g), 5.0, tone, k_none);
        }
    };
    curve(placed(1.75, 0.5, 30.0 * k_degree), k_teal);
    curve(placed(0.7, 0.35, 30.0 * k_degree), k_rust);
    s.words(at(-84, 1.02), "gap, m", Anchor::left, k_soft, 15.0);
    s.words(at(44, 0.62), "apart", Anchor::left, k_teal, 16.0);
    s.words(at(-16, -1.0), "overlapping", Anchor::left, k_rust, 16.0);
    s.words(at(0, -1.75) + Vec2(0, 46), "direction");
}

/// Two overlapping polygons and the pushes along all edges of A, the shortest marked.
void draw_push(const std::string& folder)
{
    Sketch s(folder + "/push.svg", 560, 290);
    const Map map{Vec2(175, 155), 88.0};
    const Polygon a = regular(5, 1.2);
    const Polygon b = box_of(1.5, 1.1);
    const Pose pose_a = placed(0.0, 0.0, 0.2);
    const Pose pose_b = placed(1.25, 0.25, 0.75);
    const Axis axis = greatest_separation(a, b, relative_pose(pose_a, pose_b));
    const Vec2 v = -axis.separation * direction(axis, a, pose_a, b, pose_b);
    s.polygon(outline(map, b, {pose_b.position + v, pose_b.rotation}), pale(k_ochre, 0.1), pale(k_ochre, 0.7), 1.4);
    s.polygon(outline(map, a, pose_a), pale(k_blue, 0.3), k_blue, 2.0);
    s.polygon(outline(map, b, pose_b), pale(k_ochre, 0.4), k_ochre, 2.0);
    s.arrow(map(pose_b.position), map(pose_b.position + v), k_rust, 3.0);
    s.formula(map(pose_b.position + v) + Vec2(12, -8), "v", Anchor::left, k_rust);
    s.formula(map(Vec2(-0.2, -0.08)), "A", Anchor::middle, k_blue);
    s.formula(map(pose_b.position) + Vec2(-14, 20), "B");
}

/// Reference edge, facing edge, cut and contacts.
void draw_clip(const std::string& folder)
{
    Sketch s(folder + "/clip.svg", 560, 300);
    const Map map{Vec2(330, 190), 92.0};
    const Polygon shelf = box_of(4.0, 1.0);
    const Polygon crate = box_of(1.6, 1.6);
    const Pose pose_a = placed(0.0, -0.5);
    const Pose pose_b = placed(-1.9, 0.62, -0.12);
    s.polygon(outline(map, shelf, pose_a), pale(k_blue, 0.25), k_blue, 1.6);
    s.polygon(outline(map, crate, pose_b), pale(k_ochre, 0.3), k_ochre, 1.6);
    s.line(map(Vec2(-2, 0)), map(Vec2(2, 0)), k_blue, 4.5);
    const Vec2 low = pose_b * Vec2(-0.8, -0.8);
    const Vec2 high = pose_b * Vec2(0.8, -0.8);
    s.line(map(low), map(high), k_ochre, 4.5);
    s.dashed(map(Vec2(-2.0, -1.15)), map(Vec2(-2.0, 1.0)), k_rust, 1.8);
    const Manifold manifold = make_manifold(shelf, pose_a, crate, pose_b, 0.0);
    for (int k = 0; k < manifold.count; ++k) {
        const Vec2 x = manifold.contacts[k].point;
        s.arrow(map(x), map(x + Vec2(0, 0.72)), k_rust, 2.4);
        s.disc(map(x), 5.5, k_rust, k_ink, 1.2);
    }
    s.words(map(Vec2(1.1, 0.1)), "reference edge", Anchor::middle, k_blue, 15.0);
    s.words(map(Vec2(-0.98, -0.47)), "facing edge", Anchor::left, k_ink, 15.0);
    s.words(map(Vec2(-2.06, -1.08)), "cut", Anchor::right, k_rust, 15.0);
}

/// Crossing bars, and squares head on with what either rule says.
void draw_wrong(const std::string& folder)
{
    Sketch s(folder + "/wrong.svg", 580, 240);
    const Map bars{Vec2(110, 112), 48.0};
    s.polygon(outline(bars, box_of(4.0, 0.5), {}), pale(k_blue, 0.3), k_blue, 2.0);
    s.polygon(outline(bars, box_of(0.5, 4.0), {}), pale(k_ochre, 0.4), k_ochre, 2.0);
    for (const double x : {-1.0, 1.0}) {
        for (const double y : {-1.0, 1.0}) {
            s.disc(bars(Vec2(2.0 * x, 0.25 * y)), 4.5, k_blue, k_none);
            s.disc(bars(Vec2(0.25 * x, 2.0 * y)), 4.5, k_ochre, k_none);
        }
    }
    const Map squares{Vec2(345, 125), 120.0};
    const Polygon square = box_of(1.0, 1.0);
    s.polygon(outline(squares, square, placed(0, 0)), pale(k_blue, 0.3), k_blue, 2.0);
    s.polygon(outline(squares, square, placed(0.88, 0)), pale(k_ochre, 0.4), k_ochre, 2.0);
    s.arrow(squares(Vec2(0.44, 0.5)), squares(Vec2(0.44, 0.88)), k_rust, 3.0);
    s.arrow(squares(Vec2(0.44, 0.0)), squares(Vec2(0.86, 0.0)), k_teal, 3.0);
    s.words(squares(Vec2(0.52, 0.76)), "nearest edge", Anchor::left, k_rust, 17.0);
    s.words(squares(Vec2(0.44, -0.69)), "greatest separation", Anchor::middle, k_teal, 17.0);
}

/// The two rules in motion, one above the other.
void record_head_on(const std::string& folder)
{
    std::ofstream trace(folder + "/head-on.ndjson");
    const std::string square = "{\"rings\": [[[-0.5, -0.5], [0.5, -0.5], [0.5, 0.5], [-0.5, 0.5]]]}";
    trace << "{\"view\": [-3, -0.8, 3, 2.6], \"shapes\": [" << square << ", " << square << ", " << square << ", "
          << square << "]}\n";
    HeadOn right;
    HeadOn wrong;
    for (int k = 0; k <= 120; ++k) {
        const auto body = [](const Pose& pose, double y) {
            return "[" + std::to_string(pose.position.x()) + ", " + std::to_string(y) + ", 0]";
        };
        trace << "{\"time\": " << k / 60.0 << ", \"bodies\": [" << body(right.pose_a, 1.8) << ", "
              << body(right.pose_b, 1.8) << ", " << body(wrong.pose_a, 0.0) << ", " << body(wrong.pose_b, 0.0)
              << "]}\n";
        right.step(Rule::greatest_separation, 1.0 / 60.0);
        wrong.step(Rule::nearest_edge, 1.0 / 60.0);
    }
}

/// A pentagon that passes a rectangle; dashed, where the shortest push would have it.
void record_axes(const std::string& folder)
{
    std::ofstream trace(folder + "/axes.ndjson");
    const Polygon a = box_of(2.0, 1.2);
    const Polygon b = regular(5, 1.0);
    const auto ring = [](const Polygon& polygon) {
        std::string text;
        for (const Vec2& v : polygon.vertices())
            text += (text.empty() ? "[" : ", [") + std::to_string(v.x()) + ", " + std::to_string(v.y()) + "]";
        return "{\"rings\": [[" + text + "]]}";
    };
    trace << "{\"view\": [-4, -2.1, 4, 2.1], \"shapes\": [" << ring(a) << ", " << ring(b) << "]}\n";
    const Pose pose_a = placed(-0.9, -0.2, 0.2);
    for (int k = 0; k <= 240; ++k) {
        const double angle = 0.35;
        const Pose pose_b = placed(3.2 - 0.02 * k, 0.35, angle);
        const Axis axis = greatest_separation(a, b, relative_pose(pose_a, pose_b));
        const Vec2 n = axis.owner == Owner::a ? Vec2(pose_a.rotation * a.edges()[axis.edge].normal)
                                              : Vec2(pose_b.rotation * -b.edges()[axis.edge].normal);
        const Vec2 pushed = pose_b.position - std::min(axis.separation, 0.0) * n;
        const auto at = [](const Vec2& x, double turn) {
            return "[" + std::to_string(x.x()) + ", " + std::to_string(x.y()) + ", " + std::to_string(turn) + "]";
        };
        trace << "{\"time\": " << k / 60.0 << ", \"bodies\": [" << at(pose_a.position, 0.2) << ", "
              << at(pose_b.position, angle) << "], \"ghosts\": [" << at(pose_a.position, 0.2) << ", "
              << at(pushed, angle) << "]}\n";
    }
}

} // namespace

int main(int argc, char** argv)
{
    if (argc != 2) return 2;
    const std::string folder = argv[1];
    draw_ruler(folder);
    draw_shadows(folder);
    draw_proof(folder);
    draw_turn(folder);
    draw_push(folder);
    draw_clip(folder);
    draw_wrong(folder);
    record_head_on(folder);
    record_axes(folder);
}
