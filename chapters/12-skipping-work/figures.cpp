#include <algorithm>
#include <cmath>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

#include "../support/sketch.hpp"
#include "plain_engine.hpp"
#include "runs.hpp"
#include "scene/generate.hpp"

using namespace flying;
using namespace flying::sketch;

namespace {

/// Pairs looked at without a plan and with it, for scenes of the course.
void draw_saved(const std::string& folder)
{
    Sketch s(folder + "/saved.svg", 560, 380);
    const std::vector<std::pair<const char*, double>> scenes = {
        {"gas-discs-1000", 0.5},    {"flying-balls", 2.0},      {"gas-polygons-200", 0.5},
        {"gas-dumbbells-100", 0.5}, {"original-polygons", 4.0}, {"pi-billiard", 4.0}};
    const auto x = [](double pairs) { return 182.0 + 56.0 * (std::log10(pairs) - 0.0); };
    for (int k = 0; k <= 6; ++k) {
        const double at = x(std::pow(10.0, k));
        s.line(Vec2(at, 20), Vec2(at, 334), pale(k_soft, 0.4), 1.0);
        s.formula(Vec2(at, 358), k == 0 ? "1" : k == 1 ? "10" : "10^" + std::to_string(k), Anchor::middle, k_ink, 16.0);
    }
    double y = 40.0;
    for (const auto& [name, until] : scenes) {
        const Scene scene = scene_of_course(FLYING_SCENES, name);
        const auto without = static_cast<double>(pairs_looked_at(run(scene, until, all_skips()).report));
        const auto with = static_cast<double>(pairs_looked_at(run(scene, until).report));
        const auto bar = [&](double top, double pairs, Tone tone) {
            s.polygon({Vec2(x(1), top), Vec2(x(pairs), top), Vec2(x(pairs), top + 16), Vec2(x(1), top + 16)}, tone, k_none);
        };
        s.words(Vec2(174, y + 8), name, Anchor::right, k_ink, 15.0);
        bar(y - 15, without, pale(k_rust, 0.7));
        bar(y + 3, with, k_teal);
        y += 52.0;
    }
    s.words(Vec2(x(2e4), y - 57), "nothing left out", Anchor::left, k_rust, 15.0);
    s.words(Vec2(x(2e4), y - 37), "with the plan", Anchor::left, k_teal, 15.0);
}

/// Where the plan stands between scene and engine.
void draw_stages(const std::string& folder)
{
    Sketch s(folder + "/stages.svg", 560, 250);
    const auto card = [&](const Vec2& at, const char* words, const char* more, Tone tone) {
        s.polygon(box(at, 142, 66), pale(tone, 0.2), tone, 2.0);
        s.words(at + Vec2(0, -2), words, Anchor::middle, k_ink, 18.0);
        s.words(at + Vec2(0, 20), more, Anchor::middle, k_soft, 14.0);
    };
    card(Vec2(80, 60), "scene", "a value", k_blue);
    card(Vec2(280, 60), "plan", "pure function", k_rust);
    card(Vec2(480, 60), "engine", "asks once a stage", k_teal);
    card(Vec2(280, 190), "explain", "reasons", k_ochre);
    card(Vec2(480, 190), "report", "work saved, hash", k_ochre);
    s.arrow(Vec2(154, 60), Vec2(206, 60));
    s.arrow(Vec2(354, 60), Vec2(406, 60));
    s.arrow(Vec2(280, 96), Vec2(280, 153));
    s.arrow(Vec2(480, 96), Vec2(480, 153));
    s.words(Vec2(80, 182), "--without NAME", Anchor::middle, k_soft, 15.0);
    s.arrow(Vec2(96, 164), Vec2(216, 98), k_soft, 1.6);
}

/// All pairs as a triangle; the corner of the pairs of static bodies is left out.
void draw_triangle(const std::string& folder)
{
    Sketch s(folder + "/triangle.svg", 480, 340);
    constexpr int k_movers = 5;
    constexpr int k_statics = 6;
    constexpr double k_cell = 26.0;
    const Vec2 origin(120, 12);
    for (int row = 1; row < k_movers + k_statics; ++row) {
        for (int column = 0; column < row; ++column) {
            const bool is_left_out = row >= k_movers && column >= k_movers;
            const bool is_wall = row >= k_movers && !is_left_out;
            const Tone tone = is_left_out ? k_soft : is_wall ? k_teal : k_blue;
            s.polygon(box(origin + k_cell * Vec2(column + 0.5, row + 0.5), k_cell - 3, k_cell - 3),
                      is_left_out ? k_none : pale(tone, 0.5), tone, 1.4);
        }
    }
    s.words(Vec2(108, 92), "movers", Anchor::right, k_blue);
    s.words(Vec2(108, 228), "statics", Anchor::right, k_ink);
    s.words(Vec2(250, 92), "both move", Anchor::left, k_blue);
    s.words(Vec2(110, 328), "one moves", Anchor::left, k_teal);
    s.words(Vec2(352, 208), "left out", Anchor::left, k_soft);
}

/// Two turning polygons pass; the time in which their bounding circles overlap.
void draw_passage(const std::string& folder)
{
    Sketch s(folder + "/passage.svg", 560, 300);
    const Vec2 c(280, 190);
    const double r = 110.0;
    const double b = 62.0;
    const double half = std::sqrt(r * r - b * b);
    const auto hexagon = [&](const Vec2& at, double angle, double radius, Tone tone) {
        std::vector<Vec2> ring;
        for (int k = 0; k < 5; ++k) ring.push_back(at + radius * (Rotation::of(angle + 1.2566 * k) * Vec2(1, 0)));
        s.polygon(ring, pale(tone, 0.3), tone, 2.0);
        s.disc(at, radius, k_none, pale(tone, 0.6), 1.4);
    };
    s.disc(c, r, pale(k_ochre, 0.16), k_ochre, 1.6);
    hexagon(c, 0.4, 58.0, k_blue);
    hexagon(Vec2(70, c.y() - b), 0.2, 52.0, k_rust);
    s.arrow(Vec2(70, c.y() - b), Vec2(540, c.y() - b), k_soft, 1.6);
    s.line(Vec2(c.x() - half, c.y() - b), Vec2(c.x() + half, c.y() - b), k_rust, 4.0);
    s.disc(Vec2(c.x() - half, c.y() - b), 5.0, k_rust, k_none);
    s.disc(Vec2(c.x() + half, c.y() - b), 5.0, k_rust, k_none);
    s.line(c, Vec2(c.x() + half, c.y() - b), k_ink, 1.6);
    s.measure(Vec2(c.x(), c.y()), Vec2(c.x(), c.y() - b), k_ink);
    s.formula(Vec2(c.x() - 14, c.y() - 24), "b", Anchor::right);
    s.formula(Vec2(c.x() + 56, c.y() - 18), "r", Anchor::left);
    s.formula(Vec2(c.x(), c.y() - b - 14), "v τ", Anchor::middle, k_rust);
}

/// A corner of a hexagon on a wall, its bounding circle, and one that is too small.
void draw_spoilt(const std::string& folder)
{
    Sketch s(folder + "/spoilt.svg", 480, 300);
    const double R = 120.0;
    const double floor = 262.0;
    const Vec2 c(240, floor - R + 1);
    std::vector<Vec2> ring;
    for (int k = 0; k < 6; ++k) ring.push_back(c + R * (Rotation::of(1.5708 + 1.0472 * k) * Vec2(1, 0)));
    s.polygon({Vec2(20, floor), Vec2(460, floor), Vec2(460, 292), Vec2(20, 292)}, pale(k_soft, 0.25), k_none);
    s.line(Vec2(20, floor), Vec2(460, floor), k_ink, 2.4);
    s.polygon(ring, pale(k_blue, 0.2), k_blue, 2.2);
    s.disc(c, R, k_none, k_teal, 2.0);
    s.disc(c, 0.88 * R, k_none, k_rust, 2.0);
    s.arrow(c, c + Vec2(0, 60), k_ink, 2.2);
    s.words(Vec2(372, 70), "right", Anchor::left, k_teal);
    s.words(Vec2(240, 58), "spoilt", Anchor::middle, k_rust);
}

/// The hash after each impact as a colour: no skip, the right bound, the spoilt one.
void draw_hashes(const std::string& folder)
{
    Sketch s(folder + "/hashes.svg", 560, 210);
    const Bound bounds[] = {Bound::none, Bound::right, Bound::spoilt};
    const char* names[] = {"none", "right", "spoilt"};
    for (int row = 0; row < 3; ++row) {
        PlainEngine engine(hexagons(121), bounds[row]);
        const double y = 16.0 + 56.0 * row;
        s.words(Vec2(72, y + 26), names[row], Anchor::right);
        for (int k = 0; k < 24; ++k) {
            engine.step();
            const auto code = static_cast<unsigned>(engine.hash() >> 40);
            s.polygon(box(Vec2(92.0 + 19.0 * k, y + 20), 17, 40), {code & 0xffffffu, 0.85}, k_none);
        }
    }
    s.arrow(Vec2(84, 186), Vec2(545, 186), k_soft, 1.6);
    s.words(Vec2(545, 206), "impacts", Anchor::right, k_soft, 15.0);
}

/// Hexagons moved with the spoilt bound; outlines where the right one has them.
void record_hexagons(const std::string& folder)
{
    constexpr int k_bodies = 9;
    std::ofstream trace(folder + "/hexagons.ndjson");
    trace << "{\"view\": [-0.1, -0.1, 6.1, 6.1], \"shapes\": [";
    for (int k = 0; k < k_bodies; ++k) {
        trace << "{\"rings\": [[";
        for (int i = 0; i < 6; ++i) {
            const Vec2 p = Rotation::of(i * 1.0471975512) * Vec2(0.5, 0.0);
            trace << (i == 0 ? "[" : ", [") << p.x() << ", " << p.y() << "]";
        }
        trace << "]]}" << (k + 1 < k_bodies ? ", " : "]}\n");
    }
    PlainEngine now[] = {PlainEngine(hexagons(121), Bound::spoilt), PlainEngine(hexagons(121), Bound::right)};
    PlainEngine next[] = {now[0], now[1]};
    for (int i = 0; i < 2; ++i) next[i].step();
    for (int frame = 0; frame <= 300; ++frame) {
        const double time = frame / 60.0;
        trace << "{\"time\": " << time;
        for (int i = 0; i < 2; ++i) {
            while (next[i].time() <= time) now[i] = next[i], next[i].step();
            trace << (i == 0 ? ", \"bodies\": [" : "], \"ghosts\": [");
            for (int k = 0; k < k_bodies; ++k) {
                const BodyState s = now[i].state(k, time);
                trace << (k == 0 ? "[" : ", [") << s.position.x() << ", " << s.position.y() << ", " << s.angle << "]";
            }
        }
        trace << "]}\n";
    }
}

/// A gas of polygons as the plan has it and with a skip turned off, side by side.
void record_skips(const std::string& folder)
{
    GenerateOptions options;
    options.count = 24;
    options.shape = "polygon";
    options.seed = 4;
    const Scene scene = generate("gas", options).value();
    World left = std::move(World::make(scene, {})).value();
    WorldOptions right_options;
    right_options.without = {skip_names().front()};
    World right = std::move(World::make(scene, right_options)).value();
    const Vec2 size = scene.world.box->max - scene.world.box->min;
    std::ofstream trace(folder + "/skips.ndjson");
    trace.precision(6);
    trace << "{\"shapes\": [";
    for (int k = 0; k < 2 * left.body_count(); ++k) {
        trace << (k > 0 ? ", " : "") << "{\"rings\": [[";
        const char* comma = "";
        for (const Vec2& v : std::get<Polygon>(left.shape(k % left.body_count())).vertices()) {
            trace << comma << "[" << v.x() << ", " << v.y() << "]";
            comma = ", ";
        }
        trace << "]]}";
    }
    trace << "]}\n";
    for (int frame = 0; frame <= 180; ++frame) {
        trace << "{\"time\": " << frame / 60.0 << ", \"bodies\": [";
        for (World* world : {&left, &right}) {
            if (world->advance(frame / 60.0)) throw std::runtime_error("the run of the gas failed");
            for (int k = 0; k < world->body_count(); ++k) {
                const BodyState s = world->state(k);
                const double shift = world == &left ? 0.0 : 1.1 * size.x();
                trace << (k > 0 || world == &right ? ", [" : "[") << s.position.x() + shift << ", " << s.position.y()
                      << ", " << s.angle << "]";
            }
        }
        trace << "]}\n";
    }
}

} // namespace

int main(int argc, char** argv)
{
    if (argc != 2) return 2;
    const std::string folder = argv[1];
    draw_saved(folder);
    draw_stages(folder);
    draw_triangle(folder);
    draw_passage(folder);
    draw_spoilt(folder);
    draw_hashes(folder);
    record_hexagons(folder);
    record_skips(folder);
}
