#pragma once

#include <string>

#include "canvas.hpp"
#include "curves.hpp"
#include "orbits.hpp"

/// The figures of Kepler's section.
namespace flying::board {

using namespace flying::steps;

inline void draw_anomaly(const std::string& path)
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

inline void draw_conics(const std::string& path)
{
    Canvas c(path, 640, 410, Vec2(-4.2, -2.05), 100.0);
    // All start from the same point across the pull, ever faster
    const double r = 0.9;
    const auto show = [&](double ecc, const Ink& ink, double dots) {
        const Orbit o{1.0, r / std::abs(1.0 - ecc), ecc};
        const bool bound = ecc < 1.0;
        const auto place = [&](double t) {
            return bound ? on_ellipse(o, t).x : on_hyperbola(o, t).x;
        };
        const double span = bound ? 0.5 * o.period() : 9.0;
        c.ink(ink);
        c.line(curve(place, -span, span, 500), 2.2);
        for (double t = 0.0; t < span; t += dots) c.dot(place(t), 3.2);
    };
    show(0.0, k_green, 0.35);
    show(0.6, k_blue, 0.35);
    show(1.6, k_violet, 0.35);
    c.ink(k_sun);
    c.dot(Vec2(0, 0), 9.0);
    c.ink(k_orange);
    for (int k = 0; k <= 9; ++k) { // a fall: from rest, at equal times
        const double whole = fall_time(1.0, 1.25, 0.0);
        double low = 0.0;
        double high = 1.25;
        for (int j = 0; j < 60; ++j) {
            const double middle = 0.5 * (low + high);
            (fall_time(1.0, 1.25, middle) > whole * k / 10 ? low : high) = middle;
        }
        c.dot(Vec2(0.0, -low), 3.2);
    }
    c.line({Vec2(0, -1.25), Vec2(0, -0.12)}, 1.6);
    c.words(Vec2(0, -1.25), "a fall", Vec2(-9, 8), {1.0, 18.0});
    c.ink(k_green);
    c.words(Vec2(-0.9, 0.0), "circle, ε = 0", Vec2(-8, 0), {1.0, 18.0});
    c.ink(k_blue);
    c.words(Vec2(-3.2, 0.0), "ellipse, ε = 0.6", Vec2(0, 44), {0.0, 18.0});
    c.ink(k_violet);
    c.words(Vec2(0.72, 1.2), "hyperbola,", Vec2(12, 12), {0.0, 18.0});
    c.words(Vec2(0.72, 1.2), "ε = 1.6", Vec2(12, -6), {0.0, 18.0});
}

} // namespace flying::board
