#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <string>
#include <vector>

#include "../support/sketch.hpp"
#include "bar.hpp"
#include "figures_central.hpp"
#include "math/safe_step.hpp"
#include "response/impact.hpp"
#include "wrong_steps.hpp"

using namespace flying;
using namespace flying::sketch;

namespace {

/// A disc at each of sixty looks a second, a wall between two of them, and the moment that the engine finds.
void draw_between(const std::string& folder)
{
    Sketch s(folder + "/between.svg", 560, 230);
    const double scale = 860.0;
    const double speed = 10.0;
    const Flyer flyer = thrown(-2.08, speed);
    const auto at = [&](double x) { return Vec2(285.0 + scale * x, 108.0); };
    s.polygon(box(at(0.0), k_wall_thickness * scale, 150.0), pale(k_ink, 0.35), k_ink, 1.8);
    for (int k = 11; k <= 14; ++k) {
        const double x = state_at(flyer, k / 60.0).position.x();
        s.disc(at(x), k_disc_radius * scale, pale(k_blue, 0.2), k_blue, 2.0);
        s.words(at(x) + Vec2(0, 6), std::to_string(k), Anchor::middle, k_blue, 17.0);
    }
    const double found = predict(Disc{k_disc_radius}, flyer, thin_wall(), {}, 0.0, {.windows = 1000}).time;
    const double x = state_at(flyer, found).position.x();
    s.disc(at(x), k_disc_radius * scale, k_none, k_rust, 2.6);
    s.arrow(at(x) + Vec2(-34, 94), at(x) + Vec2(-12, 52), k_rust, 2.0);
    s.words(at(x) + Vec2(-42, 110), "between two looks", Anchor::middle, k_rust);
    s.arrow(at(0.155) + Vec2(0, -80), at(0.155) + Vec2(76, -80), k_soft, 2.0);
}

/// Heights of the four corners of a square that falls and turns.
void draw_heights(const std::string& folder)
{
    Sketch s(folder + "/heights.svg", 560, 320);
    const auto at = [](double t, double y) { return Vec2(56.0 + 290.0 * t, 262.0 - 82.0 * y); };
    const double spin = 7.0;
    const double start = 2.05;
    const double speed = 1.2;
    Flyer flyer;
    flyer.state.position = {0.0, start};
    flyer.state.velocity = {0.0, -speed};
    flyer.state.spin = spin;
    const Polygon square({{{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}}});
    const Prediction answer = predict(square, flyer, k_floor, {}, 0.0, {.windows = 1000});
    s.arrow(at(0, 0), at(1.7, 0), k_soft, 1.6);
    s.arrow(at(0, 0), at(0, 3.05), k_soft, 1.6);
    const Tone tones[] = {k_blue, k_teal, k_ochre, k_rust};
    for (int k = 0; k < 4; ++k) {
        std::vector<Vec2> curve;
        for (int i = 0; i <= 160; ++i) {
            const double t = 0.01 * i;
            const double y = start - speed * t + (Rotation::of(spin * t) * square.vertices()[k]).y();
            if (y < -0.4) break;
            curve.push_back(at(t, y));
        }
        s.path(curve, tones[k], k == answer.feature.vertex ? 3.2 : 2.0);
    }
    s.dashed(at(0, start), at(1.6, start - 1.6 * speed), k_ink);
    s.disc(at(answer.time, 0.0), 6.5, k_rust, k_none);
    s.words(at(answer.time, 0.0) + Vec2(0, 30), "the first", Anchor::middle, k_rust);
    s.words(at(0.03, 3.0) + Vec2(4, 2), "height of each corner", Anchor::left);
    s.formula(at(1.68, 0) + Vec2(-4, 26), "t", Anchor::middle, k_soft);
}

/// A gap, the parabola below it, and the tangent that Newton follows.
void draw_parabola(const std::string& folder)
{
    Sketch s(folder + "/parabola.svg", 560, 330);
    const auto at = [](double t, double y) { return Vec2(56.0 + 300.0 * t, 210.0 - 150.0 * y); };
    // f = 0.55 + 0.55 cos(w t) - d: dips a little below zero and rises again
    const double w = 3.6;
    const double from = 0.2;
    const auto f = [&](double t) { return 0.5 + 0.62 * std::cos(w * t); };
    const auto rate = [&](double t) { return -w * 0.62 * std::sin(w * t); };
    const double bend = 0.62 * w * w;
    const double step = safe_step(f(from), rate(from), bend);
    const double newton = -f(from) / rate(from);
    s.arrow(at(0, 0), at(1.66, 0), k_soft, 1.6);
    s.arrow(at(0, -0.6), at(0, 1.28), k_soft, 1.6);
    std::vector<Vec2> curve;
    for (int k = 0; k <= 150; ++k) curve.push_back(at(0.01 * k, f(0.01 * k)));
    std::vector<Vec2> below;
    for (double t = from; t < from + 1.32 * step; t += 0.01) {
        const double u = t - from;
        below.push_back(at(t, f(from) + rate(from) * u - 0.5 * bend * u * u));
    }
    s.path(below, k_teal, 2.6);
    s.dashed(at(from, f(from)), at(from + 1.12 * newton, f(from) + 1.12 * newton * rate(from)), k_soft, 1.8);
    s.path(curve, k_blue, 3.0);
    s.disc(at(from, f(from)), 6.0, k_ink, k_none);
    s.disc(at(from + step, 0), 6.0, k_teal, k_none);
    s.disc(at(from + newton, 0), 6.0, k_none, k_soft, 2.2);
    s.measure(at(from, 0) + Vec2(0, 34), at(from + step, 0) + Vec2(0, 34));
    s.dashed(at(from, 0) + Vec2(0, 30), at(from, f(from)), pale(k_soft, 0.7), 1.2);
    s.formula(at(from + 0.5 * step, 0) + Vec2(0, 58), "τ", Anchor::middle, k_ink, 21.0);
    s.formula(at(1.42, f(1.42)) + Vec2(-14, 0), "f", Anchor::right, k_blue, 22.0);
    s.formula(below.back() + Vec2(10, 4), "g", Anchor::left, k_teal, 22.0);
    s.words(at(from + newton, 0) + Vec2(12, -12), "Newton", Anchor::left, k_ink, 15.0);
    s.formula(at(1.64, 0) + Vec2(0, 26), "t", Anchor::middle, k_soft);
}

/// Readings of the march on the corner of a bar that comes down as it turns.
void draw_march(const std::string& folder)
{
    Sketch s(folder + "/march.svg", 560, 320);
    const double y = 2.75;
    const double spin = 5.0;
    const auto at = [](double t, double h) { return Vec2(50.0 + 178.0 * t, 276.0 - 66.0 * h); };
    std::vector<Vec2> dots;
    const auto reading = [&](double time) {
        EdgeReading now = read_corner(y, spin, time);
        now.gap -= time;
        now.gap_rate -= 1.0;
        return now;
    };
    const auto read = [&](double time) {
        const EdgeReading now = reading(time);
        dots.push_back(at(time, now.gap));
        return now;
    };
    const MarchEnd end = march(read(0.0), read, bar_bounds(y, spin, 1.0), 0.0, k_never);
    std::vector<Vec2> curve;
    for (double t = 0.0; t < end.time + 0.16; t += 0.01) curve.push_back(at(t, reading(t).gap));
    s.arrow(at(0, 0), at(2.8, 0), k_soft, 1.6);
    s.arrow(at(0, 0), at(0, 3.8), k_soft, 1.6);
    s.path(curve, k_blue, 2.4);
    for (const Vec2& dot : dots) s.dashed(dot, Vec2(dot.x(), at(0, 0).y()), pale(k_soft, 0.6), 1.0);
    for (const Vec2& dot : dots) s.disc(dot, 5.0, k_ink, k_none);
    s.disc(dots.back(), 6.5, k_rust, k_none);
    s.formula(at(0, 3.7) + Vec2(14, 6), "f", Anchor::left, k_blue, 22.0);
    s.formula(at(2.76, 0) + Vec2(0, 26), "t", Anchor::middle, k_soft);
}

/// The gap near its root, read at one double after another.
void draw_noise(const std::string& folder)
{
    Sketch s(folder + "/noise.svg", 560, 310);
    const double y = 0.75;
    const double spin = 2.0;
    const double root = bar_strikes(y, spin);
    const double unit = tolerance::k_epsilon / 4.0; // the distance of doubles there
    const double noise = bar_bounds(y, spin, 1.0).tolerance.noise;

    // Where the root lies by longer numbers, in doubles from the one that is nearest to the closed form
    const long double wide = (std::asin(0.75L / std::hypot(1.0L, 0.01L)) - std::atan2(0.01L, 1.0L)) / 2.0L;
    const double offset = static_cast<double>((wide - root) / unit);
    const double slope = read_corner(y, spin, root).gap_rate * unit;
    const auto at = [&](double doubles, double gap) {
        return Vec2(280.0 + 8.6 * doubles, 155.0 - 15.0 * gap / tolerance::k_epsilon);
    };
    s.polygon({at(-29, noise), at(29, noise), at(29, -noise), at(-29, -noise)}, pale(k_teal, 0.14), k_none);
    s.arrow(at(-30, 0), at(31.5, 0), k_soft, 1.4);
    s.line(at(-28, -(28 + offset) * slope), at(28, (28 - offset) * slope), pale(k_ink, 0.45), 1.4);
    for (int k = -27; k <= 27; ++k) s.disc(at(k, read_corner(y, spin, root + k * unit).gap), 3.4, k_blue, k_none);
    s.disc(at(offset, 0), 7.0, k_none, k_rust, 2.4);
    s.words(at(offset, 0) + Vec2(14, -16), "root", Anchor::left, k_rust);
    s.words(at(-28, -0.84 * noise), "here the march ends", Anchor::left, k_teal);
    s.words(at(28, 0.78 * noise), "gap, double by double", Anchor::right, k_blue, 15.0);
    s.formula(at(31, 0) + Vec2(-4, 26), "t", Anchor::middle, k_soft);
}

/// Three waves: one strikes, one comes so near to zero that no eye sees it miss, one stays above.
void draw_graze(const std::string& folder)
{
    Sketch s(folder + "/graze.svg", 560, 290);
    const auto at = [](double t, double y) { return Vec2(92.0 + 70.0 * t, 226.0 - 78.0 * y); };
    const Tone tones[] = {k_rust, k_teal, k_blue};
    const double depths[] = {0.42, -1e-12, -0.42};
    const char* names[] = {"strikes", "grazes", "passes"};
    s.arrow(at(0, 0), at(6.5, 0), k_soft, 1.6);
    for (int k = 0; k < 3; ++k) {
        const double depth = depths[k];
        std::vector<Vec2> dots;
        const auto wave = [&](double t) {
            const SineCosine sc = sine_cosine(t);
            dots.push_back(at(t, 1.0 - depth + sc.cosine));
            return EdgeReading{1.0 - depth + sc.cosine, -sc.sine, 0.0, 0.0};
        };
        const MarchBounds bounds{1.0 + 1e-9, k_never, k_never, {1e-13, 1e-15, 1e-15}};
        const MarchEnd end = march(wave(0.0), wave, bounds, 0.0, 6.2);
        std::vector<Vec2> curve;
        for (int i = 0; i <= 125; ++i) {
            const double t = 0.05 * i;
            if (end.kind == MarchEnd::Kind::strike && depth > 0.0 && t > end.time) break;
            curve.push_back(at(t, 1.0 - depth + std::cos(t)));
        }
        s.path(curve, pale(tones[k], 0.6), 2.0);
        for (const Vec2& dot : dots) s.disc(dot, 3.6, tones[k], k_none);
        s.words(at(0.0, 2.0 - depth) + Vec2(-12, 5), names[k], Anchor::right, tones[k], 15.0);
    }
    s.formula(at(6.45, 0) + Vec2(0, 26), "t", Anchor::middle, k_soft);
}

/// A bar that turns above the floor and bounces: the engine's time, with a ghost by the closed forms.
void record_bar(const std::string& folder)
{
    const double y = 0.75;
    const double spin = 2.0;
    const double found = predict(bar(), turning_bar(y, spin), k_floor, {}, 0.0, {.windows = 1000}).time;
    const BodyState state = state_at(turning_bar(y, spin), found);
    const Vec2 arm = Rotation::of(state.angle) * Vec2(k_half_length, -k_half_thickness);
    const double moment = (k_half_length * k_half_length + k_half_thickness * k_half_thickness) / 3.0;
    const ImpactBody body{state.velocity, state.spin, {1.0, 1.0 / moment}};
    const ImpactPoint point{{0.0, 0.0}, arm, {0.0, 1.0}};
    const ImpactResult after = resolve_impact({}, body, {&point, 1}, {1.0, 0.0});

    // The ghost: the arc sine for the time, and j = 2 v_n / (1/m + c^2 / I) for the bounce, all on paper
    const double meet = bar_strikes(y, spin);
    const double c = k_arm * std::cos(spin * meet + k_lean);
    const double j = 2.0 * spin * c / (1.0 + c * c / moment);
    const double spin_after = -spin + c * j / moment;

    std::ofstream trace(folder + "/bar.ndjson");
    trace << "{\"view\": [-1.5, -0.4, 1.5, 2.0], \"shapes\": [{\"rings\": [[[-1, -0.01], [1, -0.01], [1, 0.01], [-1, "
             "0.01]]]}, {\"rings\": [[[-1.5, -0.3], [1.5, -0.3], [1.5, 0], [-1.5, 0]]]}], \"fixed\": [false, true]}\n";
    std::vector<double> times{found};
    for (int k = 0; k <= 84; ++k) times.push_back(k / 60.0);
    std::sort(times.begin(), times.end());
    for (const double t : times) {
        const double late = t - found;
        const double ghost = t - meet;
        const double height = late < 0.0 ? y : y + after.velocity_b.y() * late;
        const double angle = late < 0.0 ? -spin * t : state.angle + after.spin_b * late;
        const double ghost_height = ghost < 0.0 ? y : y + j * ghost;
        const double ghost_angle = ghost < 0.0 ? -spin * t : -spin * meet + spin_after * ghost;
        trace << "{\"time\": " << t << ", \"bodies\": [[0, " << height << ", " << angle
              << "], [0, 0, 0]], \"ghosts\": [[0, " << ghost_height << ", " << ghost_angle << "]]}\n";
    }
}

} // namespace

int main(int argc, char** argv)
{
    if (argc != 2) return 2;
    const std::string folder = argv[1];
    draw_between(folder);
    draw_heights(folder);
    draw_parabola(folder);
    draw_march(folder);
    draw_noise(folder);
    draw_graze(folder);
    draw_outlook(folder);
    record_bar(folder);
}
