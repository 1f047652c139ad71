#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "../01-flying-balls/canvas.hpp"
#include "../01-flying-balls/curves.hpp"
#include "../01-flying-balls/orbits.hpp"

namespace {

using namespace flying;
using namespace flying::board;
using namespace flying::steps;

/// The ellipse in pieces that are swept in equal times.
void draw_areas(const std::string& path)
{
    Canvas c(path, 620, 330, Vec2(-1.78, -0.92), 180.0);
    const Orbit o{1.0, 1.0, 0.6};
    const int pieces = 12;
    const auto place = [&](double t) { return on_ellipse(o, t).x; };
    for (int k = 0; k < pieces; ++k) {
        const double from = k * o.period() / pieces;
        std::vector<Vec2> swept{Vec2(0, 0)};
        for (const Vec2& p : curve(place, from, from + o.period() / pieces)) swept.push_back(p);
        c.ink(k_orange, 0.25);
        if (k % 2 == 0) c.area(swept);
        c.ink(k_grey);
        c.line({Vec2(0, 0), place(from)}, 1.0);
    }
    c.ink(k_blue);
    c.line(curve(place, 0.0, o.period(), 400), 2.4);
    for (int k = 0; k < pieces; ++k) c.dot(place(k * o.period() / pieces), 4.0);
    c.ink(k_sun);
    c.dot(Vec2(0, 0), 9.0);
}

/// Half an ellipse under its circle, with the angle E.
void draw_anomaly(const std::string& path)
{
    Canvas c(path, 620, 330, Vec2(-1.68, -0.22), 215.0);
    const double ecc = 0.6;
    const double flat = 0.8;
    const double E = 1.15;
    const Vec2 centre(0, 0);
    const Vec2 sun(ecc, 0);
    const auto ellipse = [&](double w) { return Vec2(std::cos(w), flat * std::sin(w)); };
    const auto outer = [&](double w) { return Vec2(std::cos(w), std::sin(w)); };
    std::vector<Vec2> swept{sun};
    for (const Vec2& p : curve(ellipse, 0.0, E)) swept.push_back(p);
    c.ink(k_orange, 0.22);
    c.area(swept);
    c.ink(k_grey);
    c.line(curve(outer, 0.0, std::numbers::pi), 1.4, true);
    c.ink(k_blue);
    c.line(curve(ellipse, 0.0, std::numbers::pi), 2.4);
    c.ink(k_dark);
    c.line({Vec2(-1.15, 0), Vec2(1.2, 0)}, 1.0);
    c.line({centre, outer(E)}, 1.4);
    c.line({outer(E), Vec2(std::cos(E), 0)}, 1.0, true);
    c.arc(centre, 36, 0.0, E);
    c.words(centre, "E", Vec2(42, 22));
    c.ink(k_orange);
    c.line({sun, ellipse(E)}, 2.2);
    c.words(0.5 * (sun + ellipse(E)), "r", Vec2(8, 4));
    c.arc(sun, 30, 0.0, std::atan2(ellipse(E).y(), ellipse(E).x() - ecc));
    c.words(sun, "ν", Vec2(24, 34));
    c.ink(k_sun);
    c.dot(sun, 9.0);
    c.ink(k_blue);
    c.dot(ellipse(E), 6.0);
    c.words(ellipse(E), "the body", Vec2(34, 26), {0.0, 18.0});
    c.ink(k_dark);
    c.dot(centre, 3.5);
    c.dot(outer(E), 3.5);
    c.words(centre, "middle", Vec2(0, -15), {0.5, 18.0});
    c.words(sun, "centre", Vec2(4, -20), {0.5, 18.0});
    c.words(Vec2(-0.5, 0), "a", Vec2(0, 11), {0.5, 19.0});
    c.words(Vec2(0.5 * ecc, 0), "ε a", Vec2(6, -13), {0.5, 17.0});
    c.ink(k_grey);
    c.words(outer(2.45), "the circle", Vec2(-16, 20), {1.0, 17.0});
    c.words(outer(2.45), "round the ellipse", Vec2(-16, 4), {1.0, 17.0});
}

} // namespace

int main(int argc, char** argv)
{
    if (argc != 2) return 2;
    const std::string folder = argv[1];
    draw_areas(folder + "/areas.svg");
    draw_anomaly(folder + "/anomaly.svg");
}
