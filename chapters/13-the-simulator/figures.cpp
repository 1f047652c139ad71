#include <cairo-svg.h>
#include <cmath>
#include <fstream>
#include <string>
#include <vector>

#include "../support/sketch.hpp"
#include "draw/paint.hpp"
#include "runs.hpp"
#include "weighing.hpp"

using namespace flying;
using namespace flying::sketch;

namespace {

// ---- Who moves a body
// ------------------------------------------------------------------------------------------------

Tone tone_of(BodyMover mover)
{
    return mover == BodyMover::events   ? k_blue
           : mover == BodyMover::rest   ? k_rust
           : mover == BodyMover::asleep ? k_soft
                                        : k_ink;
}

/// The outline of a body of a world, in the world's metres.
std::vector<Vec2> outline(const World& world, int k)
{
    const BodyState state = world.state(k);
    const Rotation turn = Rotation::of(state.angle);
    std::vector<Vec2> ring;
    for (const Vec2& vertex : std::get<Polygon>(world.shape(k)).vertices())
        ring.push_back(state.position + turn * vertex);
    return ring;
}

/// A scene at three moments, each body in the colour of what moves it.
void draw_movers(const std::string& folder)
{
    World world = start(rain(24, 5));
    const BoxDef box = *world.scene().world.box;
    const Vec2 size = box.max - box.min;
    const double scale = 216.0 / size.x();
    Sketch s(folder + "/movers.svg", 700, 216.0 * size.y() / size.x() + 66.0);
    const double moments[] = {0.55, 1.1, 6.0};
    for (int panel = 0; panel < 3; ++panel) {
        go(world, moments[panel]);
        const auto at = [&](const Vec2& p) {
            return Vec2(10.0 + 232.0 * panel + scale * (p.x() - box.min.x()), 10.0 + scale * (box.max.y() - p.y()));
        };
        const std::vector<Vec2> room = {at(box.min), at({box.max.x(), box.min.y()}), at(box.max),
                                        at({box.min.x(), box.max.y()})};
        s.polygon(room, k_none, k_soft, 2.0);
        for (int k = 0; k < world.body_count(); ++k) {
            std::vector<Vec2> ring = outline(world, k);
            for (Vec2& p : ring) p = at(p);
            const Tone tone = tone_of(world.mover(k));
            s.polygon(ring, pale(tone, 0.45), tone, 1.3);
        }
        const double floor = at(box.min).y();
        s.words(Vec2(10.0 + 232.0 * panel, floor + 22.0), text_of("%.2f s", world.time()), Anchor::left, k_soft, 18.0);
    }
    const double line = 10.0 + scale * size.y() + 48.0;
    const std::pair<const char*, Tone> kinds[] = {{"flies", k_blue}, {"moved by steps", k_rust}, {"asleep", k_soft}};
    double x = 150.0;
    for (const auto& [name, tone] : kinds) {
        s.polygon(sketch::box(Vec2(x, line - 5.0), 14, 14), pale(tone, 0.45), tone, 1.3);
        s.words(Vec2(x + 14.0, line), name, Anchor::left, k_ink, 18.0);
        x += 64.0 + 10.5 * static_cast<double>(std::string(name).size());
    }
}

/// The recorded motion of the same, for pages without the engine.
void record_two(const std::string& folder)
{
    World world = start(rain(24, 5));
    std::ofstream trace(folder + "/two.ndjson");
    trace.precision(6);
    trace << "{\"shapes\": [";
    for (int k = 0; k < world.body_count(); ++k) {
        trace << (k > 0 ? ", " : "") << "{\"rings\": [[";
        const char* comma = "";
        for (const Vec2& v : std::get<Polygon>(world.shape(k)).vertices()) {
            trace << comma << "[" << v.x() << ", " << v.y() << "]";
            comma = ", ";
        }
        trace << "]]}";
    }
    trace << "]}\n";
    for (int frame = 0; frame <= 300; ++frame) {
        go(world, frame / 60.0);
        trace << "{\"time\": " << frame / 60.0 << ", \"bodies\": [";
        for (int k = 0; k < world.body_count(); ++k) {
            const BodyState state = world.state(k);
            trace << (k > 0 ? ", [" : "[") << state.position.x() << ", " << state.position.y() << ", " << state.angle
                  << "]";
        }
        trace << "]}\n";
    }
}

// ---- The parts
// -------------------------------------------------------------------------------------------------------

void draw_parts(const std::string& folder)
{
    Sketch s(folder + "/parts.svg", 620, 330);
    const auto card = [&](const Vec2& at, double width, const char* words, const char* more, Tone tone) {
        s.polygon(box(at, width, 58), pale(tone, 0.2), tone, 2.0);
        s.words(at + Vec2(0, -3), words, Anchor::middle, k_ink, 17.0);
        s.words(at + Vec2(0, 18), more, Anchor::middle, k_soft, 13.0);
    };
    card(Vec2(76, 60), 130, "text", "TOML", k_ochre);
    card(Vec2(244, 60), 130, "Scene", "a value", k_blue);
    s.polygon(box(Vec2(466, 118), 270, 192), pale(k_teal, 0.08), k_teal, 2.0);
    s.words(Vec2(466, 46), "World", Anchor::middle, k_ink, 17.0);
    card(Vec2(402, 98), 116, "events", "from impact", k_blue);
    card(Vec2(530, 98), 116, "rest", "by steps", k_rust);
    card(Vec2(466, 176), 244, "hand-over", "two integrators, one world", k_teal);
    s.arrow(Vec2(143, 60), Vec2(177, 60));
    s.arrow(Vec2(311, 60), Vec2(329, 60));
    s.words(Vec2(160, 106), "read, check", Anchor::middle, k_soft, 13.0);
    s.words(Vec2(160, 124), "all faults at once", Anchor::middle, k_soft, 13.0);
    card(Vec2(90, 284), 164, "pictures, films", "looks, changes nothing", k_ochre);
    card(Vec2(274, 284), 164, "report", "counts, energy, hash", k_ochre);
    card(Vec2(480, 284), 206, "snapshot", "goes on with the same bits", k_rust);
    s.arrow(Vec2(360, 214), Vec2(120, 252), k_soft, 1.6);
    s.arrow(Vec2(420, 216), Vec2(310, 252), k_soft, 1.6);
    s.arrow(Vec2(476, 216), Vec2(476, 252), k_soft, 1.6);
    s.arrow(Vec2(516, 252), Vec2(516, 216), k_soft, 1.6);
}

/// Impacts at their own moments above, steps at whole multiples below, and a body that changes hands.
void draw_clock(const std::string& folder)
{
    // A ball that flies past, and one that bounces to rest: the run itself
    Scene scene;
    scene.world.field = UniformField{Vec2(0.0, -9.81)};
    scene.world.restitution = 0.6;
    scene.world.box = BoxDef{Vec2(0.0, 0.0), Vec2(6.0, 4.0)};
    BodyDef body;
    body.shape = DiscDef{0.25};
    body.position = Vec2(1.0, 0.255);
    scene.bodies.push_back(body);
    body.position = Vec2(4.0, 1.0);
    body.velocity = Vec2(9.0, 0.0);
    body.restitution = 1.0;
    scene.bodies.push_back(body);
    World world = start(scene);

    const double until = 0.2;
    Sketch s(folder + "/clock.svg", 640, 190);
    const auto x = [&](double time) { return 116.0 + 500.0 * time / until; };
    s.words(Vec2(100, 55), "events", Anchor::right, k_blue);
    s.words(Vec2(100, 135), "steps", Anchor::right, k_rust);
    s.line(Vec2(x(0), 50), Vec2(x(until), 50), pale(k_blue, 0.5), 1.4);
    s.line(Vec2(x(0), 130), Vec2(x(until), 130), pale(k_rust, 0.5), 1.4);
    for (int k = 0; k <= 12; ++k) {
        const double at = x(k / 60.0);
        s.line(Vec2(at, 122), Vec2(at, 138), pale(k_rust, 0.5), 1.4);
    }
    const auto steps_of = [&] {
        for (const StageCost& stage : world.report().stages) {
            if (stage.name == "move") return stage.count;
        }
        return std::int64_t{0};
    };
    std::size_t handed_over = 0;
    while (world.time() < until) {
        const std::int64_t impacts = world.collisions();
        const std::int64_t steps = steps_of();
        if (world.advance(until, 1)) break;
        const double at = x(world.time());
        if (world.handovers().size() > handed_over) {
            handed_over = world.handovers().size();
            s.arrow(Vec2(at, 58), Vec2(at, 120), k_ink, 2.0);
        }
        if (steps_of() > steps) s.disc(Vec2(at, 130), 5.0, k_rust, k_none);
        else if (world.collisions() > impacts) s.disc(Vec2(at, 50), 5.0, k_blue, k_none);
    }
    s.words(Vec2(x(until), 172), text_of("%.1f s", until), Anchor::right, k_soft, 16.0);
    s.words(Vec2(x(0), 172), "0", Anchor::left, k_soft, 16.0);
}

// ---- Bounds
// ----------------------------------------------------------------------------------------------------------

void draw_bow(const std::string& folder)
{
    Sketch s(folder + "/bow.svg", 560, 260);
    const auto at = [](double t) { return Vec2(70.0 + 420.0 * t, 190.0 - 540.0 * t * (1.0 - t) + 30.0 * t); };
    std::vector<Vec2> way;
    for (int k = 0; k <= 60; ++k) way.push_back(at(k / 60.0));
    s.path(way, k_blue, 2.8);
    s.dashed(at(0.0), at(1.0), k_rust, 1.8);
    const Vec2 middle = 0.5 * (at(0.0) + at(1.0));
    s.measure(middle, at(0.5), k_ink);
    s.formula(at(0.5) + Vec2(14, 76), "b", Anchor::left);
    for (const double t : {0.0, 1.0}) s.disc(at(t), 6.0, k_ink, k_none);
    s.words(at(0.0) + Vec2(6, 30), "this frame", Anchor::middle, k_soft, 15.0);
    s.words(at(1.0) + Vec2(0, 30), "the next", Anchor::middle, k_soft, 15.0);
    s.words(at(0.5) + Vec2(0, -14), "the flight", Anchor::middle, k_blue, 15.0);
    s.words(middle + Vec2(0, 26), "straight", Anchor::middle, k_rust, 15.0);
}

/// Where those that lean can get within a step, and the box of a flight.
void draw_reach(const std::string& folder)
{
    Sketch s(folder + "/reach.svg", 600, 290);
    const double floor = 240.0;
    s.line(Vec2(10, floor), Vec2(590, floor), k_ink, 2.4);
    const auto square = [&](const Vec2& c, double angle, double side, Tone tone, Tone fill) {
        std::vector<Vec2> ring;
        for (int k = 0; k < 4; ++k)
            ring.push_back(c + side / std::sqrt(2.0) *
                                   (Rotation::of(angle + std::numbers::pi * (0.25 + 0.5 * k)) * Vec2(1, 0)));
        s.polygon(ring, fill, tone, 1.8);
    };
    // Two that lean and touch: one island, with one top speed
    const Vec2 left(120, floor - 30);
    const Vec2 right(185, floor - 34);
    for (const Vec2& c : {left, right}) s.polygon(box(c, 132, 132), pale(k_rust, 0.1), pale(k_rust, 0.7), 1.4);
    square(left, 0.0, 60, k_rust, pale(k_rust, 0.4));
    square(right, 0.14, 60, k_rust, pale(k_rust, 0.4));
    s.arrow(right, right + Vec2(-34, 0), k_ink, 2.2);
    s.formula(right + Vec2(-16, -12), "v", Anchor::middle);
    s.measure(Vec2(right.x() + 42, right.y() + 20), Vec2(right.x() + 66, right.y() + 20), k_ink);
    s.formula(Vec2(right.x() + 92, right.y() + 26), "l", Anchor::middle);

    // A flight and the box that holds it for as long
    const Vec2 from(340, 56);
    const Vec2 to(252, 150);
    const double r = 24.0;
    s.polygon({Vec2(to.x() - r, from.y() - r), Vec2(from.x() + r, from.y() - r), Vec2(from.x() + r, to.y() + r),
               Vec2(to.x() - r, to.y() + r)},
              pale(k_blue, 0.12), pale(k_blue, 0.7), 1.4);
    s.disc(from, r, pale(k_blue, 0.4), k_blue, 1.8);
    s.disc(to, r, k_none, k_blue, 1.2);
    s.arrow(from, 0.5 * (from + to), k_ink, 2.2);
    s.words(Vec2(378, 48), "comes near: taken in", Anchor::left, k_blue, 15.0);

    // One that passes, and one that sleeps alone
    s.disc(Vec2(470, 150), r, pale(k_blue, 0.4), k_blue, 1.8);
    s.polygon(box(Vec2(492, 150), 2 * r + 44, 2 * r), pale(k_blue, 0.12), pale(k_blue, 0.7), 1.4);
    s.arrow(Vec2(470, 150), Vec2(512, 150), k_ink, 2.2);
    s.words(Vec2(492, 108), "flies on", Anchor::middle, k_blue, 15.0);
    square(Vec2(400, floor - 24), 0.0, 48, k_soft, pale(k_soft, 0.3));
    s.words(Vec2(434, floor - 18), "asleep: has no reach", Anchor::left, k_soft, 14.0);
}

// ---- The original's scenes
// -------------------------------------------------------------------------------------------

/// A world with the trails of its last moments, as `flying simulate --picture` has it.
Picture picture_with_trails(World& world, double time)
{
    const int samples = time > 0.0 ? 40 : 0;
    std::vector<Trail> trails;
    for (int k = 0; k < world.body_count(); ++k) {
        if (!world.is_static(k)) trails.push_back({k, trail_width(world.shape(k)), {}});
    }
    for (int i = 0; i <= samples; ++i) {
        go(world, time - (samples - i) / 50.0);
        for (Trail& trail : trails) trail.points.push_back(world.state(trail.colour).position);
    }
    Picture picture = picture_of(world);
    picture.trails = std::move(trails);
    picture.title.clear();
    return picture;
}

/// Both scenes at their start and after a minute.
void draw_original(const std::string& folder)
{
    constexpr int k_side = 330;
    constexpr int k_gap = 12;
    cairo_surface_t* surface =
        cairo_svg_surface_create((folder + "/original.svg").c_str(), 2 * k_side + k_gap, 2 * k_side + k_gap);
    cairo_t* cairo = cairo_create(surface);
    for (int row = 0; row < 2; ++row) {
        World world =
            start(scene_of_course(FLYING_SCENES, row == 0 ? "original-polygons" : "original-polygons-gravity"));
        for (int column = 0; column < 2; ++column) {
            const Picture picture = picture_with_trails(world, column == 0 ? 0.0 : 60.0);
            cairo_save(cairo);
            cairo_translate(cairo, column * (k_side + k_gap), row * (k_side + k_gap));
            cairo_rectangle(cairo, 0, 0, k_side, k_side);
            cairo_clip(cairo);
            paint(cairo, picture, {k_side, k_side}, paper_theme());
            cairo_restore(cairo);
        }
    }
    cairo_destroy(cairo);
    cairo_surface_destroy(surface);
}

/// Scenes that people try, each at a moment of its run.
void draw_gallery(const std::string& folder)
{
    struct Panel
    {
        const char* scene;
        double time; // [s]
    };
    const Panel panels[] = {{"dominoes", 0.9}, {"arch", 1.0}, {"cards", 1.0}, {"hopper", 1.2}, {"chain", 1.0},
                            {"bowl", 0.3},     {"seesaw", 1.0}, {"wall", 0.3}, {"pour", 0.6}};
    constexpr int k_wide = 224;
    constexpr int k_high = 180;
    cairo_surface_t* surface = cairo_svg_surface_create((folder + "/gallery.svg").c_str(), 3 * k_wide, 3 * k_high);
    cairo_t* cairo = cairo_create(surface);
    int place = 0;
    for (const Panel& panel : panels) {
        World world = start(scene_of_course(FLYING_SCENES, panel.scene));
        go(world, panel.time);
        Picture picture = picture_of(world);
        picture.title.clear();
        picture.time.reset();
        picture.has_scale_bar = false;
        picture.has_shadows = false;
        if (std::string(panel.scene) == "bowl") picture.view = {{-1.25, -1.25}, {1.25, 0.1}}; // not the ball alone
        cairo_save(cairo);
        cairo_translate(cairo, place % 3 * k_wide, place / 3 * k_high);
        cairo_rectangle(cairo, 0, 0, k_wide, k_high);
        cairo_clip(cairo);
        paint(cairo, picture, {k_wide, k_high}, paper_theme());
        cairo_restore(cairo);
        ++place;
    }
    cairo_destroy(cairo);
    cairo_surface_destroy(surface);
}

/// The house and the dumbbell as the original weighed them.
void draw_weighed(const std::string& folder)
{
    Sketch s(folder + "/weighed.svg", 620, 280);
    const Scene scene = scene_of_course(FLYING_SCENES, "original-polygons");
    double x = 130.0;
    for (const BodyDef& def : scene.bodies) {
        if (!std::holds_alternative<PolygonDef>(def.shape)) continue;
        const Shape made = make_shape(def.shape).value();
        const auto& polygon = std::get<Polygon>(made);
        const Vec2 mean = vertex_mean(polygon.vertices());
        const double scale = def.name == "house" ? 140.0 : 150.0;
        const auto at = [&](const Vec2& p) { return Vec2(x + scale * p.x(), 118.0 - scale * p.y()); };
        std::vector<Vec2> ring;
        for (const Vec2& v : polygon.vertices()) ring.push_back(at(v));
        s.polygon(ring, pale(k_blue, 0.2), k_ink, 2.0);
        const std::size_t n = ring.size();
        for (std::size_t k = 0; k < n; ++k) {
            const Vec2 a = polygon.vertices()[k] - mean;
            const Vec2 b = polygon.vertices()[(k + 1) % n] - mean;
            if (cross(a, b) < -1e-12) s.polygon({at(mean), ring[k], ring[(k + 1) % n]}, pale(k_rust, 0.5), k_rust, 1.2);
            else s.line(at(mean), ring[k], pale(k_soft, 0.7), 1.0);
        }
        s.disc(at(Vec2::Zero()), 5.0, k_blue, k_none);
        if (mean.norm() > 1e-9) s.disc(at(mean), 5.0, k_rust, k_none);
        x += 300.0;
    }
    s.words(Vec2(130, 268), "two middles", Anchor::middle, k_soft, 15.0);
    s.words(Vec2(430, 268), "counted, and not taken off", Anchor::middle, k_rust, 15.0);
}

/// Distance from the run that never stopped, over time.
void draw_apart(const std::string& folder)
{
    Sketch s(folder + "/apart.svg", 600, 330);
    const Scene scene = scene_of_course(FLYING_SCENES, "original-polygons");
    World whole = start(scene);
    go(whole, 10.0);
    World saved = resumed(whole);
    World worlds[] = {start(as_it_looks(whole, 6)), start(as_it_looks(whole, 17))};
    const auto at = [](double t, double d) {
        return Vec2(84.0 + 490.0 * t / 30.0, 270.0 - 13.5 * (std::log10(d) + 16.0));
    };
    for (int k = -16; k <= 0; k += 4) {
        const double y = at(0.0, std::pow(10.0, k)).y();
        s.line(Vec2(84, y), Vec2(574, y), pale(k_soft, 0.3), 1.0);
        s.formula(Vec2(76, y + 6), k == 0 ? "1 m" : "10^{\u2212" + std::to_string(-k) + "}", Anchor::right, k_ink,
                  15.0);
    }
    std::vector<Vec2> lines[2];
    double farthest = 0.0;
    for (int k = 1; k <= 300; ++k) {
        const double t = 0.1 * k;
        go(whole, 10.0 + t);
        go(saved, 10.0 + t);
        farthest = std::max(farthest, apart(whole, saved));
        for (int i = 0; i < 2; ++i) {
            go(worlds[i], t);
            lines[i].push_back(at(t, std::max(1e-16, apart(whole, worlds[i]))));
        }
    }
    if (farthest != 0.0) std::abort(); // the line of the snapshot would have to be drawn
    s.path(lines[0], k_amber, 2.2);
    s.path(lines[1], k_rust, 2.2);
    s.line(Vec2(84, 296), Vec2(574, 296), k_teal, 3.0);
    s.words(Vec2(76, 301), "0", Anchor::right, k_teal, 15.0);
    s.words(Vec2(182, 86), "six digits", Anchor::left, k_amber, 15.0);
    s.words(Vec2(330, 180), "seventeen digits", Anchor::left, k_rust, 15.0);
    s.words(Vec2(330, 289), "snapshot", Anchor::left, k_teal, 15.0);
    for (int t = 0; t <= 30; t += 10)
        s.words(Vec2(at(t, 1.0).x(), 322), std::to_string(t) + " s", Anchor::middle, k_ink, 14.0);
}

} // namespace

int main(int argc, char** argv)
{
    if (argc != 2) return 2;
    const std::string folder = argv[1];
    draw_movers(folder);
    record_two(folder);
    draw_parts(folder);
    draw_clock(folder);
    draw_bow(folder);
    draw_reach(folder);
    draw_original(folder);
    draw_gallery(folder);
    draw_weighed(folder);
    draw_apart(folder);
}
