#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <functional>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "../support/sketch.hpp"
#include "scene/read.hpp"
#include "column.hpp"
#include "lying.hpp"
#include "world/world.hpp"
#include "wrong_rest.hpp"

using namespace flying;
using namespace flying::sketch;
using namespace flying::test;

namespace {

/// A stack and what each box bears.
void draw_stack(const std::string& folder)
{
    Sketch s(folder + "/stack.svg", 480, 380);
    RestEngine engine(stack(6));
    engine.advance(5.0);
    std::map<int, double> force;
    for (const RestContact& contact : engine.contacts()) force[contact.b] += contact.normal_force;
    s.line(Vec2(30, 350), Vec2(450, 350), k_ink, 2.4);
    for (int k = 1; k <= 6; ++k) {
        const double y = 350.0 - 52.0 * engine.state(k).position.y();
        s.polygon(sketch::box(Vec2(110, y), 52, 52), pale(k_blue, 0.2), k_blue, 2.0);
        const double foot = y + 26.0;
        s.polygon(sketch::box(Vec2(170 + 1.45 * force[k], foot), 2.9 * force[k], 9.0), k_rust, k_none);
        s.words(Vec2(180 + 2.9 * force[k], foot - 6.0), text_of("%.1f N", force[k]), Anchor::left, k_ink, 17.0);
    }
}

/// Height over time, of the engine and of the closed form.
void draw_zeno(const std::string& folder)
{
    Sketch s(folder + "/zeno.svg", 540, 300);
    const double e = 0.7;
    const double end = end_of_hops(1.0, e);
    const auto at = [](double t, double y) { return Vec2(46.0 + 168.0 * t, 250.0 - 210.0 * y); };
    std::vector<Vec2> curve;
    for (int k = 0; k <= 2000; ++k) curve.push_back(at(2.75 * k / 2000.0, hop_height(1.0, e, 2.75 * k / 2000.0)));
    s.arrow(at(0, 0), at(2.9, 0), k_soft, 1.6);
    s.arrow(at(0, 0), at(0, 1.12), k_soft, 1.6);
    s.path(curve, k_blue, 2.0);
    RestEngine ball = zeno_ball(1.0, e, 1.0 / 20.0);
    for (int k = 0; k <= 54; ++k) {
        const Vec2 p = at(ball.time(), ball.state(1).position.y() - 0.5);
        s.disc(p, 3.6, k_rust, k_none);
        ball.step();
    }
    s.dashed(at(end, 0.0), at(end, 0.55), k_soft);
    s.words(at(end, 0.62), text_of("%.2f s", end), Anchor::middle, k_ink, 17.0);
    s.words(at(2.85, 0) + Vec2(0, 30), "time", Anchor::right, k_soft, 16.0);
    s.words(at(0.06, 1.06), "height", Anchor::left, k_soft, 16.0);
}

/// Impulse and speed of a point: one of the two is nothing.
void draw_corner(const std::string& folder)
{
    Sketch s(folder + "/corner.svg", 460, 280);
    const Vec2 o(90, 230);
    s.arrow(o, Vec2(430, 230), k_soft, 1.6);
    s.arrow(o, Vec2(90, 24), k_soft, 1.6);
    s.line(o, Vec2(410, 230), k_blue, 5.0);
    s.line(o, Vec2(90, 46), k_rust, 5.0);
    s.words(Vec2(300, 216), "parts, and bears nothing", Anchor::middle, k_blue, 17.0);
    s.words(Vec2(106, 70), "bears, and stays", Anchor::left, k_rust, 17.0);
    s.formula(Vec2(420, 258), "u");
    s.formula(Vec2(66, 40), "j");
    s.disc(o, 6.0, k_ink, k_none);
    s.words(Vec2(250, 140), "not allowed", Anchor::middle, k_soft, 17.0);
}

/// A contact: two bodies, the point, the normal, the tangent, and the arms of a push.
void draw_contact(const std::string& folder)
{
    Sketch s(folder + "/contact.svg", 520, 330);
    const Vec2 below(190, 240);
    const Vec2 above(270, 104);
    const Rotation turn = Rotation::of(-0.22);
    std::vector<Vec2> tilted;
    for (const Vec2& corner : box(Vec2::Zero(), 170, 100)) tilted.push_back(above + turn * corner);
    s.polygon(box(below, 300, 130), pale(k_teal, 0.22), k_teal, 2.0);
    const Vec2 point(tilted[3].x(), below.y() - 65.0);
    const Vec2 shift = point - tilted[3];
    for (Vec2& corner : tilted) corner += shift;
    s.polygon(tilted, pale(k_blue, 0.22), k_blue, 2.0);
    const Vec2 centre = above + shift;
    s.dashed(below, point, k_teal, 1.6);
    s.dashed(centre, point, k_blue, 1.6);
    s.disc(below, 4.0, k_teal, k_none);
    s.disc(centre, 4.0, k_blue, k_none);
    s.arrow(point, point + Vec2(0, -86), k_rust, 2.6);
    s.arrow(point, point + Vec2(-70, 0), k_amber, 2.6);
    s.disc(point, 5.0, k_ink, k_none);
    s.formula(point + Vec2(14, -70), "n", Anchor::left, k_rust);
    s.words(point + Vec2(-40, -12), "tangent", Anchor::middle, k_amber, 14.0);
    s.formula(below + Vec2(8, -22), "r_a", Anchor::left, k_teal);
    s.formula(0.5 * (centre + point) + Vec2(16, 8), "r_b", Anchor::left, k_blue);
    s.words(below + Vec2(110, 46), "A", Anchor::middle, k_teal, 20.0);
    s.words(centre + Vec2(58, -4), "B", Anchor::middle, k_blue, 20.0);
}

/// What a step is made of, and where it goes round again.
void draw_step(const std::string& folder)
{
    Sketch s(folder + "/step.svg", 588, 412);
    const auto card = [&](const Vec2& at, double width, const char* words, const char* more, Tone tone) {
        s.polygon(box(at, width, 54), pale(tone, 0.2), tone, 1.8);
        s.words(at + Vec2(0, -3), words, Anchor::middle, k_ink, 16.0);
        s.words(at + Vec2(0, 18), more, Anchor::middle, k_soft, 13.2);
    };
    card(Vec2(84, 44), 136, "pairs", "whose boxes meet", k_soft);
    card(Vec2(246, 44), 136, "contacts", "points, gaps, loads", k_soft);
    card(Vec2(408, 44), 136, "islands", "tied by contacts", k_soft);
    s.arrow(Vec2(152, 44), Vec2(176, 44));
    s.arrow(Vec2(314, 44), Vec2(338, 44));
    s.polygon(box(Vec2(292, 219), 572, 230), pale(k_teal, 0.06), k_teal, 1.6);
    s.words(Vec2(566, 124), "each island", Anchor::right, k_teal, 14.0);
    s.arrow(Vec2(408, 71), Vec2(408, 90), k_soft, 1.6);
    s.line(Vec2(408, 90), Vec2(408, 118), k_soft, 1.6);
    s.line(Vec2(408, 118), Vec2(94, 118), k_soft, 1.6);
    s.arrow(Vec2(94, 118), Vec2(94, 148), k_soft, 1.6);
    card(Vec2(94, 176), 140, "impacts", "at this moment", k_rust);
    card(Vec2(262, 176), 140, "forces", "solved, or swept", k_rust);
    card(Vec2(430, 176), 140, "places", "by mean velocities", k_rust);
    s.arrow(Vec2(164, 176), Vec2(190, 176));
    s.arrow(Vec2(332, 176), Vec2(358, 176));
    card(Vec2(430, 286), 140, "as long as that?", "the verdict", k_ochre);
    s.arrow(Vec2(430, 203), Vec2(430, 257));
    s.words(Vec2(252, 276), "no: cut, and go on from there", Anchor::middle, k_amber, 13.5);
    s.line(Vec2(360, 286), Vec2(94, 286), k_amber, 1.8);
    s.arrow(Vec2(94, 286), Vec2(94, 205), k_amber, 1.8);
    card(Vec2(162, 380), 150, "limit of energy", "what was gained goes", k_blue);
    card(Vec2(330, 380), 130, "move", "write it down", k_blue);
    card(Vec2(496, 380), 150, "sleep", "where no bit changed", k_blue);
    s.line(Vec2(430, 313), Vec2(430, 326), k_soft, 1.6);
    s.line(Vec2(430, 326), Vec2(162, 326), k_soft, 1.6);
    s.arrow(Vec2(162, 326), Vec2(162, 352), k_soft, 1.2);
    s.words(Vec2(446, 328), "yes", Anchor::left, k_soft, 13.5);
    s.arrow(Vec2(237, 380), Vec2(264, 380));
    s.arrow(Vec2(395, 380), Vec2(420, 380));
}

/// What sweeps leave, for columns of several heights.
void draw_sweeps(const std::string& folder)
{
    Sketch s(folder + "/sweeps.svg", 540, 330);
    const LogPlot plot(s, Vec2(80, 270), Vec2(510, 20), Vec2(0, -4), Vec2(4, 0));
    plot.axes(1, 1);
    const Tone tones[] = {k_teal, k_blue, k_rust};
    int which = 0;
    for (const int n : {5, 20, 80}) {
        ColumnSweeps column(std::vector<double>(n, 1.0));
        std::vector<Vec2> points;
        double error = 1.0;
        int k = 1;
        for (; k <= 10000 && error > 1e-4; ++k) {
            error = column.sweep_once();
            if (error > 1e-4) points.push_back(plot.at(k, error));
        }
        s.path(points, tones[which], 2.8);
        const Vec2 end = points.back();
        const bool inside = end.y() > 250.0;
        s.words(inside ? end + Vec2(10, -16) : end + Vec2(-26, -6), std::to_string(n) + " boxes",
                inside ? Anchor::left : Anchor::right, tones[which], 17.0);
        ++which;
    }
    s.words(Vec2(295, 320), "sweeps");
    s.words(Vec2(94, 258), "worst error of a force", Anchor::left, k_soft, 16.0);
}

/// What becomes of a block, over friction and steepness.
void draw_slope(const std::string& folder)
{
    Sketch s(folder + "/slope.svg", 540, 380);
    const auto at = [](double mu, double tangent) { return Vec2(70.0 + 400.0 * mu, 320.0 - 270.0 * tangent); };
    s.arrow(at(0, 0), at(1.12, 0), k_soft, 1.6);
    s.arrow(at(0, 0), at(0, 1.12), k_soft, 1.6);
    const auto mu_of = [](double i) { return 0.04 + 0.075 * i; };
    const auto tangent_of = [](double k) { return 0.06 + 0.075 * k; };
    // Each word stands in place of two dots
    const Vec2 lies = at(mu_of(10.5), tangent_of(3));
    const Vec2 slides = at(mu_of(3.5), tangent_of(11));
    const Vec2 tips = at(mu_of(11.5), tangent_of(11));
    for (int i = 0; i < 14; ++i) {
        for (int k = 0; k < 14; ++k) {
            const double mu = mu_of(i);
            const double tangent = tangent_of(k);
            const auto is_under = [&](const Vec2& word) { return (at(mu, tangent) - word).norm() < 16.0; };
            if (is_under(lies) || is_under(slides) || is_under(tips)) continue;
            const Fate fate = left_on_slope(tangent, mu);
            const Tone tone = fate == Fate::lies ? k_teal : fate == Fate::slides ? k_blue : k_rust;
            s.disc(at(mu, tangent), 6.0, fate == Fate::lies ? pale(tone, 0.3) : tone, tone, 1.6);
        }
    }
    s.line(at(0, 0), at(0.7, 0.7), k_ink, 2.0);
    s.line(at(0.7, 0.7), at(1.1, 0.7), k_ink, 2.0);
    s.line(at(0.7, 0.7), at(0.7, 1.1), k_ink, 2.0);
    s.formula(at(1.08, 0) + Vec2(0, 30), "μ");
    s.words(at(0, 1.1) + Vec2(-34, 4), "tan θ", Anchor::middle, k_ink, 17.0);
    s.words(at(0.7, 0) + Vec2(0, 28), "0.7", Anchor::middle, k_ink, 16.0);
    s.words(at(0, 0.7) + Vec2(-12, 6), "0.7", Anchor::right, k_ink, 16.0);
    s.words(lies + Vec2(0, 6), "lies", Anchor::middle, k_teal);
    s.words(slides + Vec2(0, 6), "slides", Anchor::middle, k_blue);
    s.words(tips + Vec2(0, 6), "tips", Anchor::middle, k_rust);
}

/// Planks over the edge of a table.
void draw_planks(const std::string& folder)
{
    Sketch s(folder + "/planks.svg", 540, 230);
    const double scale = 95.0;
    RestEngine engine(planks(4, 1.0 - 1e-6));
    engine.advance(5.0);
    const auto at = [&](double x, double y) { return Vec2(240.0 + scale * x, 160.0 - scale * y); };
    s.polygon({at(-2.2, 0), at(0, 0), at(0, -0.5), at(-2.2, -0.5)}, pale(k_soft, 0.35), k_ink, 2.0);
    for (int k = 1; k <= 4; ++k) {
        const Vec2 c = engine.state(k).position;
        s.polygon(sketch::box(at(c.x(), c.y()), 2.0 * scale, 0.25 * scale), pale(k_ochre, 0.4), k_ink, 2.0);
        s.disc(at(c.x(), c.y()), 4.0, k_ink, k_none);
    }
    const double reach = engine.state(4).position.x() + 1.0;
    s.dashed(at(0, -0.4), at(0, 1.2));
    s.dashed(at(reach, -0.4), at(reach, 1.2));
    s.arrow(at(0.0, -0.3), at(reach, -0.3), k_rust, 2.2);
    s.words(at(0.5 * reach, -0.54), text_of("%.2f m", reach), Anchor::middle, k_rust, 18.0);
}

/// Height of a body that lies: two wrong ways, and the engine.
void draw_jitter(const std::string& folder)
{
    Sketch s(folder + "/jitter.svg", 540, 330);
    const auto at = [](int k, double mm) { return Vec2(80.0 + 14.0 * k, 40.0 - 4.6 * mm); };
    s.arrow(at(0, -57), at(0, 5.4), k_soft, 1.6);
    for (const int mm : {0, -10, -20, -30, -40, -50}) {
        s.words(at(0, mm) + Vec2(-10, 5), mm == 0 ? "0" : "−" + std::to_string(-mm), Anchor::right, k_ink, 16.0);
        s.line(at(0, mm), at(31, mm), pale(k_soft, 0.3), 1.0);
    }
    Lying bounced;
    Lying pushed;
    RestEngine engine(stack(1));
    std::vector<Vec2> one = {at(0, 0)};
    std::vector<Vec2> two = one;
    std::vector<Vec2> three = one;
    for (int k = 1; k <= 30; ++k) {
        move_then_bounce(bounced, k_gravity, 1.0 / 60.0, 0.5);
        push_by_overlap(pushed, k_gravity, 1.0 / 60.0);
        engine.step();
        one.push_back(at(k, 1e3 * bounced.x));
        two.push_back(at(k, 1e3 * pushed.x));
        three.push_back(at(k, 1e3 * (engine.state(1).position.y() - 0.5)));
    }
    s.path(one, k_rust, 2.6);
    s.path(two, k_blue, 2.2);
    s.path(three, k_teal, 3.4);
    s.words(at(17, -36), "bounced after the move", Anchor::right, k_rust, 17.0);
    s.words(at(30, -11), "pushed by the overlap", Anchor::right, k_blue, 17.0);
    s.words(at(30, 2.8), "the engine", Anchor::right, k_teal, 17.0);
    s.words(at(31, -60), "half a second in 30 steps", Anchor::right, k_soft, 16.0);
    s.words(at(0, 3.6) + Vec2(12, 0), "height, mm", Anchor::left, k_soft, 16.0);
}

/// Speed of a thrown disc, and of its rim.
void draw_roll(const std::string& folder)
{
    Sketch s(folder + "/roll.svg", 520, 290);
    const auto at = [](double t, double v) { return Vec2(60.0 + 370.0 * t, 240.0 - 98.0 * v); };
    s.arrow(at(0, 0), at(1.2, 0), k_soft, 1.6);
    s.arrow(at(0, 0), at(0, 2.25), k_soft, 1.6);
    RestEngine engine = thrown_disc(2.0, 0.2, 1.0 / 60.0);
    std::vector<Vec2> way = {at(0, 2)};
    std::vector<Vec2> rim = {at(0, 0)};
    for (int k = 1; k <= 66; ++k) {
        engine.step();
        way.push_back(at(k / 60.0, engine.state(1).velocity.x()));
        rim.push_back(at(k / 60.0, -0.5 * engine.state(1).spin));
    }
    s.path(way, k_blue, 2.8);
    s.path(rim, k_rust, 2.8);
    for (const int v : {0, 1, 2}) s.words(at(0, v) + Vec2(-10, 5), std::to_string(v), Anchor::right, k_ink, 16.0);
    s.dashed(at(0, 4.0 / 3.0), at(1.1, 4.0 / 3.0));
    s.words(at(0.2, 1.82), "speed, m/s", Anchor::left, k_blue, 17.0);
    s.words(at(0.28, 0.6), "radius times spin", Anchor::left, k_rust, 17.0);
    s.words(at(1.1, 1.42), "two thirds", Anchor::right, k_ink, 17.0);
    s.words(at(1.15, 0) + Vec2(0, 28), "time, s", Anchor::right, k_soft, 16.0);
}

void draw_bodies(Sketch& s, const World& world, const Vec2& corner, double scale)
{
    for (int k = 0; k < world.body_count(); ++k) {
        const Pose pose = pose_of(world.state(k));
        std::vector<Vec2> outline;
        for (const Vec2& vertex : std::get<Polygon>(world.shape(k)).vertices()) {
            const Vec2 at = pose * vertex;
            outline.push_back(corner + scale * Vec2(at.x(), 8.0 - at.y()));
        }
        const bool is_static = world.scene().bodies[k].is_static;
        s.polygon(outline, is_static ? pale(k_soft, 0.35) : pale(k_ochre, 0.4), k_ink, 2.0);
    }
    s.path({corner, corner + scale * Vec2(8, 0), corner + scale * Vec2(8, 8), corner + scale * Vec2(0, 8), corner}, k_ink, 2.4);
}

/// The original's polygons as they begin, and as they lie.
void draw_original(const std::string& folder)
{
    Scene scene = read_scene_file(std::string(FLYING_SCENES) + "/original-polygons-gravity.toml").value();
    scene.world.restitution = 0.5;
    scene.world.friction = 0.4;
    World world = std::move(World::make(scene, {})).value();
    const auto moves = [&] {
        for (int k = 0; k < world.body_count(); ++k) {
            if (!world.state(k).velocity.isZero(0.0) || world.state(k).spin != 0.0) return true;
        }
        return false;
    };
    Sketch s(folder + "/original.svg", 700, 380);
    draw_bodies(s, world, Vec2(20, 20), 40.0);
    s.words(Vec2(180, 364), "at the start", Anchor::middle, k_soft, 17.0);
    double time = 0.0;
    for (; moves() && time < 60.0; time += 0.1) {
        if (world.advance(time + 0.1)) throw std::runtime_error("the run of the original's polygons failed");
    }
    draw_bodies(s, world, Vec2(360, 20), 40.0);
    s.words(Vec2(520, 364), text_of("nothing moves from %.1f s on", time), Anchor::middle, k_soft, 17.0);
}

/// The hopping ball beside its closed form.
void record_zeno(const std::string& folder)
{
    std::ofstream trace(folder + "/zeno.ndjson");
    trace << "{\"view\": [-1.8, -0.15, 1.8, 2.1], \"shapes\": [{\"radius\": 0.5}, {\"rings\": [[[-1.6, -0.15], "
             "[1.6, -0.15], [1.6, 0], [-1.6, 0]]]}], \"fixed\": [false, true]}\n";
    RestEngine ball = zeno_ball(1.0, 0.7, 1.0 / 960.0);
    for (int k = 0; k <= 60 * 3; ++k) {
        ball.advance(k / 60.0);
        trace << "{\"time\": " << k / 60.0 << ", \"bodies\": [[0, " << ball.state(1).position.y()
              << ", 0], [0, 0, 0]], \"ghosts\": [[0, " << 0.5 + hop_height(1.0, 0.7, k / 60.0) << ", 0]]}\n";
    }
}

/// Beside a column of boxes a disc for each contact: as far out as the force that the sweeps have found.
void record_column(const std::string& folder)
{
    constexpr int k_boxes = 8;
    constexpr double k_start = 1.6; // of the discs' ways
    std::ofstream trace(folder + "/column.ndjson");
    const std::vector<double> masses(k_boxes, 1.0);
    const std::vector<double> weights = weights_above(masses, 1.0);
    ColumnSweeps column(masses);
    const auto list = [](const auto& text_of_one) {
        std::string text;
        for (int k = 0; k < k_boxes; ++k) text += (k == 0 ? "" : ", ") + text_of_one(k);
        return text;
    };
    const auto at = [](double x, double y) { return "[" + std::to_string(x) + ", " + std::to_string(y) + ", 0]"; };
    trace << "{\"view\": [-1, -0.6, 11, 8.3], \"shapes\": ["
          << list([](int) { return std::string("{\"radius\": 0.25}"); }) << ", " << list([](int) {
                 return std::string("{\"rings\": [[[-0.5, -0.5], [0.5, -0.5], [0.5, 0.5], [-0.5, 0.5]]]}");
             })
          << "]}\n";
    for (int sweeps = 0; sweeps <= 60; ++sweeps) {
        if (sweeps > 0) column.sweep_once();
        trace << "{\"time\": " << sweeps / 10.0 << ", \"bodies\": ["
              << list([&](int k) { return at(k_start + (sweeps > 0 ? column.impulse(k) : 0.0), k); }) << ", "
              << list([&](int k) { return at(0.0, k + 0.5); }) << "], \"ghosts\": ["
              << list([&](int k) { return at(k_start + weights[static_cast<std::size_t>(k)], k); }) << "]}\n";
    }
}

/// A stack that a ball strikes; it falls and comes to rest.
void record_topple(const std::string& folder)
{
    std::ofstream trace(folder + "/topple.ndjson");
    std::vector<RestBody> bodies = stack(6, {0.2, 0.5});
    bodies.push_back(disc(0.5, Vec2(-5.0, 3.0), 2.0, {0.2, 0.5}));
    bodies.back().state.velocity = Vec2(7.0, 3.5);
    RestEngine engine(bodies);
    const char* square = "{\"rings\": [[[-0.5, -0.5], [0.5, -0.5], [0.5, 0.5], [-0.5, 0.5]]]}";
    trace << "{\"view\": [-6, -0.5, 9, 7], \"shapes\": [";
    for (int k = 0; k < 6; ++k) trace << square << ", ";
    trace << "{\"radius\": 0.5}, {\"rings\": [[[-6, -0.5], [9, -0.5], [9, 0], [-6, 0]]]}], \"fixed\": [false, false, "
             "false, false, false, false, false, true]}\n";
    for (int k = 0; k <= 60 * 5; ++k) {
        trace << "{\"time\": " << k / 60.0 << ", \"bodies\": [";
        for (int i = 1; i <= 7; ++i) {
            const BodyState state = engine.state(i);
            trace << "[" << state.position.x() << ", " << state.position.y() << ", " << state.angle << "], ";
        }
        trace << "[0, 0, 0]]}\n";
        engine.step();
    }
}

/// A box on a slope of 25 degrees with friction 0.4: the engine's, and the closed form as its ghost.
void record_slope(const std::string& folder)
{
    std::ofstream trace(folder + "/slope.ndjson");
    const double slope = 0.4363323129985824;
    const SineCosine tilt = sine_cosine(slope);
    Scene scene;
    scene.world.field = UniformField{9.81 * Vec2(tilt.sine, -tilt.cosine)};
    scene.world.restitution = 0.0;
    scene.world.friction = 0.4;
    scene.bodies.resize(2);
    scene.bodies[0].shape = RectangleDef{1.0, 0.6};
    scene.bodies[0].position = Vec2(0.0, 0.3);
    scene.bodies[1].shape = RectangleDef{40.0, 1.0};
    scene.bodies[1].position = Vec2(10.0, -0.5);
    scene.bodies[1].is_static = true;
    WorldOptions options;
    options.engine = EngineChoice::rest;
    World world = std::move(World::make(scene, options)).value();
    trace << "{\"view\": [-2, -4, 7.4, 1.6], \"fixed\": [false, true], \"shapes\": ["
          << "{\"rings\": [[[-0.5, -0.3], [0.5, -0.3], [0.5, 0.3], [-0.5, 0.3]]]}, "
          << "{\"rings\": [[[-20, -0.5], [20, -0.5], [20, 0.5], [-20, 0.5]]]}]}\n";
    const auto turned = [&](const Vec2& x) {
        return text_of("%.5f, ", tilt.cosine * x.x() + tilt.sine * x.y()) +
               text_of("%.5f, ", tilt.cosine * x.y() - tilt.sine * x.x()) + text_of("%.5f", -slope);
    };
    for (int k = 0; k <= 150; ++k) {
        const double t = k / 60.0;
        if (world.advance(t)) throw std::runtime_error("the run of the slope failed");
        const double slid = 0.5 * 9.81 * (tilt.sine - 0.4 * tilt.cosine) * t * t;
        trace << "{\"time\": " << t << ", \"bodies\": [[" << turned(world.state(0).position) << "], ["
              << turned(Vec2(10.0, -0.5)) << "]], \"ghosts\": [[" << turned(Vec2(slid, 0.3)) << "]]}\n";
    }
}

} // namespace

int main(int argc, char** argv)
{
    if (argc != 2) return 2;
    const std::string folder = argv[1];
    draw_stack(folder);
    draw_zeno(folder);
    draw_corner(folder);
    draw_contact(folder);
    draw_step(folder);
    draw_sweeps(folder);
    draw_slope(folder);
    draw_planks(folder);
    draw_jitter(folder);
    draw_roll(folder);
    draw_original(folder);
    record_zeno(folder);
    record_column(folder);
    record_topple(folder);
    record_slope(folder);
}
