#include <array>
#include <cstdio>
#include <fstream>
#include <functional>
#include <string>

#include "canvas.hpp"
#include "curves.hpp"
#include "kepler_figures.hpp"
#include "many.hpp"
#include "math/random.hpp"
#include "motion/flight.hpp"
#include "orbits.hpp"
#include "walls.hpp"

namespace {

using namespace flying;
using namespace flying::board;
using namespace flying::steps;

std::string folder;

std::string file(const std::string& name)
{
    return folder + "/" + name;
}

// ---- Balls in a box
// -------------------------------------------------------------------------

struct Ball
{
    BodyState start;
    double radius;
};

const Vec2 k_box_min(0.0, 0.0);
const Vec2 k_box_max(8.0, 4.5);
const Vec2 k_box_gravity(0.0, -4.0);

std::vector<Ball> some_balls(int count)
{
    Random random(7);
    std::vector<Ball> balls;
    for (int k = 0; k < count; ++k) {
        Ball ball;
        ball.radius = random.uniform(0.12, 0.26);
        const double x = random.uniform(0.4, 7.6);
        const double y = random.uniform(1.2, 4.0);
        ball.start.position = Vec2(x, y);
        const double v_x = random.uniform(-2.5, 2.5);
        const double v_y = random.uniform(-1.0, 2.0);
        ball.start.velocity = Vec2(v_x, v_y);
        ball.start.spin = random.uniform(-4.0, 4.0);
        balls.push_back(ball);
    }
    return balls;
}

BodyState ball_at(const Ball& ball, double t)
{
    return walls::fly_between(
        ball.start, walls::box_walls(k_box_min, k_box_max, ball.radius), k_box_gravity, t);
}

/// A long exposure: where each ball was in the last moments, fainter the longer ago.
void draw_box()
{
    Canvas c(file("box.svg"), 656, 376, Vec2(-0.1, -0.1), 80.0);
    c.ink(k_grey);
    c.line({k_box_min, Vec2(8, 0), k_box_max, Vec2(0, 4.5), k_box_min}, 3.0);
    int k = 0;
    for (const Ball& ball : some_balls(9)) {
        const Ink hue = k_hues[static_cast<std::size_t>(k++) % k_hues.size()];
        constexpr int k_dots = 75;
        for (int j = 0; j <= k_dots; ++j) {
            const double share = static_cast<double>(j) / k_dots;
            c.ink(hue, 0.04 + 0.20 * share);
            c.dot(ball_at(ball, 1.5 + 1.6 * share).position,
                  80.0 * ball.radius * (0.25 + 0.35 * share));
        }
        const BodyState last = ball_at(ball, 3.1);
        c.ink(hue);
        c.area(circle(last.position, ball.radius));
        c.ink(Ink{1, 1, 1});
        c.line({last.position, pose_of(last) * Vec2(0.8 * ball.radius, 0.0)}, 2.0);
    }
}

void record_box()
{
    std::ofstream out(file("box.ndjson"));
    const std::vector<Ball> balls = some_balls(9);
    out << "{\"view\": [-0.1, -0.1, 8.1, 4.6], \"shapes\": [";
    for (const Ball& ball : balls) out << "{\"radius\": " << ball.radius << "}, ";
    out << "{\"rings\": [[[0, 0], [8, 0], [8, -0.1], [0, -0.1]]]}, {\"rings\": [[[0, 4.5], "
           "[8, "
           "4.5], [8, 4.6], [0, "
           "4.6]]]}, "
           "{\"rings\": [[[0, 0], [0, 4.5], [-0.1, 4.5], [-0.1, 0]]]}, {\"rings\": [[[8, "
           "0], "
           "[8, 4.5], [8.1, 4.5], "
           "[8.1, "
           "0]]]}], \"fixed\": [";
    for (std::size_t k = 0; k < balls.size(); ++k) out << "false, ";
    out << "true, true, true, true]}\n";
    for (int k = 0; k <= 720; ++k) {
        const double t = k / 60.0;
        out << "{\"time\": " << t << ", \"bodies\": [";
        for (const Ball& ball : balls) {
            const BodyState b = ball_at(ball, t);
            out << "[" << b.position.x() << ", " << b.position.y() << ", " << b.angle
                << "], ";
        }
        out << "[0, 0, 0], [0, 0, 0], [0, 0, 0], [0, 0, 0]]}\n";
    }
}

// ---- One body
// -------------------------------------------------------------------------------

void draw_frames()
{
    Canvas c(file("frames.svg"), 600, 330, Vec2(-0.35, -0.3), 100.0);
    BodyState body;
    body.position = Vec2(3.1, 1.35);
    body.angle = 0.5;
    const Pose pose = pose_of(body);
    const Vec2 r(0.9, 0.62);

    c.ink(k_dark);
    c.arrow(Vec2(0, 0), Vec2(5.2, 0));
    c.arrow(Vec2(0, 0), Vec2(0, 2.8));
    c.words(Vec2(5.2, 0), "x", Vec2(6, 0));
    c.words(Vec2(0, 2.8), "y", Vec2(8, 0));
    c.words(Vec2(0, 0), "the world's frame", Vec2(10, -16), {0.0, 18.0});

    c.ink(k_blue, 0.16);
    std::vector<Vec2> outline;
    for (const Vec2& p : {Vec2(-1.1, -0.62), Vec2(0.9, -0.62), Vec2(0.9, 0.62),
                          Vec2(-1.1, 0.62), Vec2(-1.1, -0.62)})
        outline.push_back(pose * p);
    c.area(outline);
    c.ink(k_blue);
    c.line(outline, 1.5);
    c.arrow(pose * Vec2(0, 0), pose * Vec2(1.75, 0), 1.6);
    c.arrow(pose * Vec2(0, 0), pose * Vec2(0, 1.15), 1.6);
    c.words(pose * Vec2(-1.1, -0.62), "the body's frame", Vec2(-4, -14), {0.0, 18.0});
    c.ink(k_grey);
    c.line({body.position, body.position + Vec2(1.5, 0.0)}, 1.2, true);
    c.ink(k_dark);
    c.arc(body.position, 62, 0.0, body.angle);
    c.words(body.position, "φ", Vec2(72, 17));
    c.ink(k_green);
    c.arrow(Vec2(0, 0), body.position, 2.2);
    c.words(0.5 * body.position, "c", Vec2(-4, 13));
    c.ink(k_orange);
    c.arrow(body.position, pose * r, 2.6);
    c.dot(pose * r, 4.5);
    c.words(body.position + 0.5 * (pose * r - body.position), "r", Vec2(-13, 8));
    c.words(pose * r, "a point of the body", Vec2(9, 10), {0.0, 18.0});
}

void draw_throw()
{
    Canvas c(file("throw.svg"), 640, 430, Vec2(-0.75, -0.95), 66.0);
    const Vec2 g(0.0, -8.0);
    BodyState ball;
    ball.velocity = Vec2(3.0, 10.0);
    // Time runs a quarter of a unit wide, so that the picture holds the height
    const auto place = [&](double t) {
        return Vec2(flight(ball, g, t).position.cwiseProduct(Vec2(1.0, 0.75)));
    };
    c.ink(k_grey);
    c.line({Vec2(-0.5, 0), Vec2(8.4, 0)}, 1.5);
    c.ink(k_faint);
    c.line({Vec2(3.75, 0), Vec2(3.75, 0.75 * 6.25)}, 1.2, true);
    c.ink(k_blue);
    c.line(curve(place, 0.0, 2.5), 2.2);
    for (int k = 0; k <= 10; ++k) {
        c.ink(k_blue);
        c.dot(place(0.25 * k), k % 2 == 0 ? 6.0 : 3.5);
        if (k % 5 != 0) continue;
        const BodyState now = flight(ball, g, 0.25 * k);
        c.ink(k_orange);
        c.arrow(place(0.25 * k),
                place(0.25 * k) + 0.115 * Vec2(now.velocity.cwiseProduct(Vec2(1.0, 0.75))),
                2.2);
    }
    c.ink(k_dark);
    c.words(place(0.0), "t = 0", Vec2(6, -18), {0.0, 18.0});
    c.words(place(1.25), "at the top: 6.25 m, after 1.25 s", Vec2(0, 20), {0.5, 18.0});
    c.words(place(2.5), "2.5 s", Vec2(-6, -18), {1.0, 18.0});
    c.ink(k_orange);
    c.words(place(0.0), "(3, 10) m/s", Vec2(36, 34), {0.0, 18.0});
    c.words(place(2.5), "(3, −10) m/s", Vec2(-6, -42), {1.0, 18.0});
    c.ink(k_grey);
    c.words(Vec2(3.75, 0.75 * 2.4), "3.75 m from", Vec2(-8, 12), {1.0, 17.0});
    c.words(Vec2(3.75, 0.75 * 2.4), "the start", Vec2(-8, -10), {1.0, 17.0});
}

/// The way of a disc between two walls, and the straight line that it is when the room is
/// mirrored.
void draw_fold()
{
    Canvas c(file("fold.svg"), 640, 290, Vec2(-0.1, -0.62), 70.0);
    const double L = 2.9;
    const double height = 3.2;
    for (int k = 0; k < 3; ++k) {
        c.ink(k == 0 ? k_blue : k_grey, k == 0 ? 0.10 : 0.06);
        c.area({Vec2(k * L, 0), Vec2((k + 1) * L, 0), Vec2((k + 1) * L, height),
                Vec2(k * L, height)});
    }
    for (int k = 0; k <= 3; ++k) {
        c.ink(k < 2 ? k_dark : k_grey);
        c.line({Vec2(k * L, 0), Vec2(k * L, height)}, k < 2 ? 3.0 : 1.5, k >= 2);
    }
    // Through the engine, in a room without floor
    BodyState disc;
    disc.position = Vec2(0.5, 0.25);
    disc.velocity = Vec2(2.6, 1.0);
    const auto sides = walls::box_walls(Vec2(0.0, -100.0), Vec2(L, 100.0), 0.0);
    const double t_end = 2.85;
    c.ink(k_grey);
    c.line({disc.position, disc.position + t_end * disc.velocity}, 2.0, true);
    c.ink(k_blue);
    c.line(curve(
               [&](double t) {
                   return walls::fly_between(disc, sides, Vec2::Zero(), t).position;
               },
               0.0, t_end, 2000),
           2.6);
    c.dot(disc.position, 6.0);
    const BodyState last = walls::fly_between(disc, sides, Vec2::Zero(), t_end);
    c.dot(last.position, 6.0);
    c.ink(k_grey);
    c.dot(disc.position + t_end * disc.velocity, 6.0);
    c.ink(k_dark);
    c.words(Vec2(0.5 * L, 0), "the room", Vec2(0, -18), {0.5, 18.0});
    c.words(Vec2(1.5 * L, 0), "its mirror image", Vec2(0, -18), {0.5, 18.0});
    c.words(Vec2(2.5 * L, 0), "and the image's image", Vec2(0, -18), {0.5, 18.0});
}

// ---- Steps
// ----------------------------------------------------------------------------------

void draw_one_step()
{
    Canvas c(file("one-step.svg"), 640, 330, Vec2(-1.45, -1.18), 132.0);
    const CentralPull pull{1.0};
    const double h = 0.5;
    for (int panel = 0; panel < 3; ++panel) {
        const Vec2 shift(1.62 * panel - 0.7, 0.0);
        Moving b{Vec2(0.62, 0.0), Vec2(0.0, 1.27)};
        c.ink(k_faint);
        c.line(circle(shift, 0.62), 2.0);
        c.ink(k_sun);
        c.dot(shift, 9.0);
        const double step = 0.62 * h / 1.27;
        std::vector<Vec2> way{b.x + shift};
        for (int k = 0; k < 5; ++k) {
            if (panel == 0) b = euler(b, pull, step);
            if (panel == 1) b = symplectic_euler(b, pull, step);
            if (panel == 2) b = verlet(b, pull, step);
            way.push_back(b.x + shift);
        }
        c.ink(panel == 0 ? k_orange : panel == 1 ? k_violet : k_blue);
        c.line(way, 2.2);
        for (const Vec2& p : way) c.dot(p, 4.5);
        c.words(shift + Vec2(0.0, -1.0),
                panel == 0   ? "explicit Euler"
                : panel == 1 ? "symplectic Euler"
                             : "Verlet",
                Vec2(0, 0), {0.5, 19.0});
    }
}

const Orbit k_orbit{1.0, 1.0, 0.5};

void draw_spiral()
{
    Canvas c(file("spiral.svg"), 640, 420, Vec2(-3.35, -2.15), 100.0);
    const CentralPull pull{k_orbit.mu};
    const auto trail = [&](const auto& step, int steps_a_period, int periods) {
        std::vector<Vec2> way;
        Moving b = on_ellipse(k_orbit, 0.0);
        for (int k = 0; k <= steps_a_period * periods; ++k) {
            way.push_back(b.x);
            b = step(b, pull, k_orbit.period() / steps_a_period);
        }
        return way;
    };
    c.ink(k_orange, 0.85);
    c.line(trail(k_euler, 240, 3), 1.6);
    c.ink(k_violet, 0.6);
    c.line(trail(k_symplectic, 240, 24), 1.2);
    c.ink(k_blue);
    c.line(curve([](double t) { return on_ellipse(k_orbit, t).x; }, 0.0, k_orbit.period(),
                 300),
           2.6);
    c.ink(k_sun);
    c.dot(Vec2(0, 0), 9.0);
    c.ink(k_blue);
    c.words(Vec2(-0.9, 0.0), "closed form", Vec2(0, 0), {0.5, 18.0});
    c.ink(k_orange);
    c.words(Vec2(1.75, 1.55), "explicit Euler", Vec2(0, 0), {0.0, 18.0});
    c.words(Vec2(1.75, 1.55), "three periods", Vec2(0, -17), {0.0, 17.0});
    c.ink(k_violet);
    c.words(Vec2(1.1, -1.25), "symplectic Euler", Vec2(0, 0), {0.0, 18.0});
    c.words(Vec2(1.1, -1.25), "twenty-four periods", Vec2(0, -17), {0.0, 17.0});
}

void record_orbits()
{
    std::ofstream out(file("orbits.ndjson"));
    out << "{\"view\": [-3.4, -2, 2.6, 2], \"shapes\": [{\"radius\": 0.08}, {\"radius\": "
           "0.08}, {\"radius\": 0.08}, "
           "{\"radius\": 0.16}], \"fixed\": [false, false, false, true]}\n";
    const CentralPull pull{k_orbit.mu};
    std::array<Moving, 3> b;
    b.fill(on_ellipse(k_orbit, 0.0));
    const int a_period = 240;
    const double h = k_orbit.period() / a_period;
    for (int k = 0; k <= 4 * a_period; ++k) {
        out << "{\"time\": " << k / 60.0 << ", \"bodies\": [";
        for (const Moving& m : b) out << "[" << m.x.x() << ", " << m.x.y() << ", 0], ";
        const Vec2 exact = on_ellipse(k_orbit, k * h).x;
        out << "[0, 0, 0]], \"ghosts\": [[" << exact.x() << ", " << exact.y() << ", 0]]}\n";
        b = {euler(b[0], pull, h), symplectic_euler(b[1], pull, h), verlet(b[2], pull, h)};
    }
}

/// Miss over steps, both by powers of ten.
void draw_orders()
{
    Canvas c(file("orders.svg"), 620, 408, Vec2(-1.1, -0.75), 43.0);
    const auto place = [](double n, double miss) {
        return Vec2(3.3 * (std::log10(n) - 2.0) + 0.2, 0.72 * (std::log10(miss) + 10.5));
    };
    for (int k = 2; k <= 5; ++k) {
        c.ink(k_faint);
        c.line({place(std::pow(10, k), 1e-10), place(std::pow(10, k), 3.0)}, 1.0);
        c.ink(k_dark);
        c.words(place(std::pow(10, k), 1e-10), "10", Vec2(-7, -19), {0.5, 17.0});
        c.words(place(std::pow(10, k), 1e-10), std::to_string(k), Vec2(9, -11),
                {0.5, 13.0});
    }
    for (int k = -10; k <= 0; k += 2) {
        c.ink(k_faint);
        c.line({place(100, std::pow(10, k)), place(1e5, std::pow(10, k))}, 1.0);
        c.ink(k_dark);
        c.words(place(100, std::pow(10, k)), "10", Vec2(-25, 0), {1.0, 17.0});
        c.words(place(100, std::pow(10, k)),
                (k < 0 ? "−" : "") + std::to_string(std::abs(k)), Vec2(-24, 8),
                {0.0, 13.0});
    }
    const double t = 0.75 * k_orbit.period();
    const auto draw = [&](const auto& step, const Ink& ink, const std::string& name,
                          const std::string& slope) {
        std::vector<Vec2> points;
        double miss = 0.0;
        for (double x = 2.0; x < 5.01; x += 0.25) {
            const long n = std::lround(std::pow(10.0, x));
            const Moving end = run(step, on_ellipse(k_orbit, 0.0), CentralPull{1.0},
                                   t / static_cast<double>(n), n);
            miss = (end.x - on_ellipse(k_orbit, t).x).norm();
            points.push_back(place(static_cast<double>(n), miss));
        }
        c.ink(ink);
        c.line(points, 2.2);
        for (const Vec2& p : points) c.dot(p, 3.6);
        c.words(place(1e5, miss), name, Vec2(10, 7), {0.0, 18.0});
        c.words(place(1e5, miss), slope, Vec2(10, -12), {0.0, 15.0});
    };
    draw(k_euler, k_orange, "Euler", "slope 1");
    draw(k_symplectic, k_violet, "symplectic", "slope 1");
    draw(k_verlet, k_blue, "Verlet", "slope 2");
    c.ink(k_dark);
    c.words(place(1e5, 1e-10), "steps", Vec2(24, -19), {0.0, 18.0});
    c.words(place(100, 3.0), "miss, in half axes", Vec2(-20, 12), {0.0, 18.0});
}

/// Two equal bodies that circle each other, moved one after the other: their middle doesn't
/// stay.
void draw_order()
{
    Canvas c(file("order.svg"), 640, 270, Vec2(-1.85, -1.05), 122.0);
    for (int panel = 0; panel < 2; ++panel) {
        const Vec2 shift(panel == 0 ? -0.65 : 2.1, 0.0);
        std::vector<Puller> bodies = {{{Vec2(-0.7, 0.0), Vec2(0.0, -0.45)}, 1.0},
                                      {{Vec2(0.7, 0.0), Vec2(0.0, 0.45)}, 1.0}};
        std::array<std::vector<Vec2>, 3> ways;
        for (int k = 0; k < 430; ++k) {
            for (std::size_t j = 0; j < 2; ++j)
                ways[j].push_back(bodies[j].motion.x + shift);
            ways[2].push_back(0.5 * (bodies[0].motion.x + bodies[1].motion.x) + shift);
            if (panel == 0) step_together(bodies, 0.02);
            else step_in_place(bodies, 0.02);
        }
        c.ink(k_blue, 0.55);
        c.line(ways[0], 1.3);
        c.ink(k_orange, 0.55);
        c.line(ways[1], 1.3);
        c.ink(k_dark);
        c.line(ways[2], 2.6);
        c.dot(ways[2].front(), 4.0);
        c.dot(ways[2].back(), 4.0);
        c.ink(k_blue);
        c.dot(ways[0].back(), 7.0);
        c.ink(k_orange);
        c.dot(ways[1].back(), 7.0);
        c.ink(k_dark);
        c.words(Vec2(shift.x(), -0.9),
                panel == 0 ? "ask all, then move all" : "move each as it is asked",
                Vec2(0, 0), {0.5, 19.0});
    }
}

/// A throw by Euler's steps, and the closed form as its ghost.
void record_throw()
{
    std::ofstream out(file("throw.ndjson"));
    out << "{\"view\": [-0.5, -1.4, 13.5, 5.6], \"shapes\": [{\"radius\": 0.22}]}\n";
    BodyState start;
    start.velocity = Vec2(6.3, 9.0);
    const Vec2 g(0.0, -9.8);
    const double h = 0.15;
    Moving b{start.position, start.velocity};
    for (int k = 0; k * h < 1.9; ++k) {
        const Vec2 exact = flight(start, g, k * h).position;
        out << "{\"time\": " << k * h << ", \"bodies\": [[" << b.x.x() << ", " << b.x.y()
            << ", 0]], \"ghosts\": [[" << exact.x() << ", " << exact.y() << ", 0]]}\n";
        b = euler(
            b, [&](const Vec2&) { return g; }, h);
    }
}

} // namespace

int main(int argc, char** argv)
{
    if (argc != 2) return 2;
    folder = argv[1];
    draw_box();
    record_box();
    draw_frames();
    draw_throw();
    draw_fold();
    draw_one_step();
    draw_spiral();
    record_orbits();
    draw_orders();
    draw_conics(file("conics.svg"));
    draw_order();
    record_throw();
}
