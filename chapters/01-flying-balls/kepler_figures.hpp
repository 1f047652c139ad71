#pragma once

#include <string>

#include "canvas.hpp"
#include "curves.hpp"
#include "orbits.hpp"

/// Orbits round a sun.
namespace flying::board {

using namespace flying::steps;

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
