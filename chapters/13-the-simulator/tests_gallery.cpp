// Scenes that people try, with other numbers than in the picture: against a closed form where there is one, within a
// bound elsewhere.

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "geometry/make_polygon.hpp"
#include "runs.hpp"
#include "scene/write.hpp"
#include "statics.hpp"
#include "support/effort.hpp"
#include "support/receipts.hpp"
#include "gallery.hpp"

using namespace flying;
using flying::testing::tried;

namespace {

/// What a run must show whatever the scene, looked at sixty times a second.
struct Watched
{
    World world;
    double rise = 0.0;    ///< of the energy above the least before [of what it can give]
    double overlap = 0.0; ///< deepest that any step has begun with [m]
};

/// scale  energy against which a rise is measured [J]
Watched watch(const Scene& scene, double until)
{
    Watched run{start(scene)};
    double least = std::numeric_limits<double>::infinity();
    const double kinetic = run.world.report().energy.kinetic;
    const double first = run.world.report().energy.total();
    double lost = 0.0;
    for (int frame = 0; frame / 60.0 <= until; ++frame) {
        go(run.world, frame / 60.0);
        const double total = run.world.report().energy.total();
        run.rise = std::max(run.rise, total - least);
        least = std::min(least, total);
        lost = std::max(lost, first - total);
    }
    run.rise = run.rise == 0.0 ? 0.0 : run.rise / (kinetic + lost);
    run.overlap = run.world.report().max_overlap;
    return run;
}

/// Nothing has moved by as much as a bit.
bool stood(const World& world)
{
    for (int k = 0; k < world.body_count(); ++k) {
        const BodyDef& body = world.scene().bodies[k];
        if (world.state(k).position != body.position || world.state(k).angle != body.angle) return false;
    }
    return true;
}

/// How far the body that went farthest down has gone.  [m]
double deepest_fall(const World& world)
{
    double fall = 0.0;
    for (int k = 0; k < world.body_count(); ++k)
        fall = std::max(fall, world.scene().bodies[k].position.y() - world.state(k).position.y());
    return fall;
}

/// Speed of the wave that topples a row, over the third and the fourth fifth of it.  [sqrt(g height)]
struct Wave
{
    double third = 0.0;
    double fourth = 0.0;
    bool all_fell = false;
};

Wave wave_of(const gallery::Dominoes& row)
{
    World world = start(gallery::dominoes(row));
    const double unit = std::sqrt(gallery::k_g * row.height);
    const double pitch = row.thickness + row.gap;
    const double frame = 0.02 * row.height / unit;

    // When each turns through a small angle, between two looks in proportion
    constexpr double k_tipped = 0.02; // [rad]
    std::vector<double> tipped;
    double before = 0.0;
    int late = 0; // looks after the last has tipped
    for (int k = 0; k < 20000 && late < 200; ++k) {
        go(world, k * frame);
        for (int next = static_cast<int>(tipped.size()) + 1; next <= row.count; ++next) {
            const double angle = -world.state(next).angle;
            if (angle < k_tipped) {
                before = angle;
                break;
            }
            tipped.push_back((k - (angle - k_tipped) / (angle - before)) * frame);
            before = 0.0;
        }
        late += static_cast<int>(tipped.size()) == row.count ? 1 : 0;
    }
    Wave wave;
    const int fifth = row.count / 5;
    if (static_cast<int>(tipped.size()) < row.count) return wave;
    wave.third = pitch * fifth / (tipped[3 * fifth] - tipped[2 * fifth]) / unit;
    wave.fourth = pitch * fifth / (tipped[4 * fifth] - tipped[3 * fifth]) / unit;
    wave.all_fell = true;
    for (int k = 1; k <= row.count; ++k) wave.all_fell = wave.all_fell && world.state(k).angle < -0.5;
    return wave;
}

} // namespace

TEST_CASE("the scenes of the gallery are the texts of the course")
{
    const std::pair<const char*, Scene> scenes[] = {
        {"dominoes", gallery::dominoes({})}, {"arch", gallery::arch({})},     {"cards", gallery::cards({})},
        {"hopper", gallery::hopper({})},     {"chain", gallery::chain({})},   {"seesaw", gallery::seesaw({})},
        {"wall", gallery::brick_wall({})},   {"pour", gallery::pour({})},
    };
    for (const auto& [name, scene] : scenes) {
        CAPTURE(name);
        CHECK(write_scene(scene_of_course(FLYING_SCENES, name)) == write_scene(scene));
    }
}

TEST_CASE("a row of dominoes falls to the last one, in a wave whose speed neither the push nor the size of all decides")
{
    Random random(1401);
    double settles = 0.0; // how far the two fifths differ
    double forgets = 0.0; // how far two pushes differ
    double scales = 0.0;  // how far two sizes differ, which a step of one length sees differently
    for (int k = 0; k < tried(1); ++k) {
        gallery::Dominoes row;
        row.gap = random.uniform(0.3, 0.6) * row.height;
        row.thickness = random.uniform(0.1, 0.2) * row.height;
        row.friction = random.uniform(0.2, 0.6);
        CAPTURE(row.gap);
        CAPTURE(row.thickness);
        CAPTURE(row.friction);
        gallery::Dominoes pushed = row;
        pushed.push = 7.0;
        gallery::Dominoes large = row;
        for (double* length : {&large.height, &large.gap, &large.thickness}) *length *= 3.0;
        large.push /= std::sqrt(3.0);
        const Wave wave = wave_of(row);
        const Wave other = wave_of(pushed);
        const Wave scaled = wave_of(large);
        CHECK(wave.all_fell);
        CHECK(other.all_fell);
        CHECK(scaled.all_fell);
        settles = std::max(settles, std::abs(wave.fourth / wave.third - 1.0));
        forgets = std::max(forgets, std::abs(other.fourth / wave.fourth - 1.0));
        scales = std::max(scales, std::abs(scaled.fourth / wave.fourth - 1.0));
    }
    CHECK(settles < 0.02);
    CHECK(forgets < 0.02);
    CHECK(scales < 0.02);
    RECORD_VALUE("gallery.dominoes.settles", settles);
    RECORD_VALUE("gallery.dominoes.forgets", forgets);
    RECORD_VALUE("gallery.dominoes.scales", scales);
}

TEST_CASE("an arch of wedges stands on either side of the thickness that statics gives, or falls")
{
    for (const int stones : {11, 15, 21}) {
        for (const double friction : {0.5, 0.8}) {
            const double limit = statics::thinnest_arch(stones, friction);
            CAPTURE(stones);
            CAPTURE(limit);
            gallery::Arch arch{stones, 1.005 * limit, friction};
            World stands = start(gallery::arch(arch));
            go(stands, 3.0);
            CHECK(stood(stands));
            arch.thickness = 0.995 * limit;
            World falls = start(gallery::arch(arch));
            go(falls, 3.0);
            CHECK(deepest_fall(falls) > 0.3);
            if (stones == 15) RECORD_VALUE("gallery.arch.limit", limit);
        }
    }
    // Many stones: Milankovitch's limit of a half circle, from outside
    CHECK(statics::thinnest_arch(301, 1.0) == doctest::Approx(0.1075).epsilon(2e-3));
}

TEST_CASE("a house of cards stands with a little more friction than its feet need, and falls with a little less")
{
    Random random(1402);
    for (int k = 0; k < tried(4); ++k) {
        gallery::Cards house;
        house.levels = 1 + k % 2;
        house.lean = random.uniform(0.2, 0.5);
        house.thickness = random.uniform(0.01, 0.03);
        const double limit = statics::least_friction(house);
        CAPTURE(house.levels);
        CAPTURE(house.lean);
        CAPTURE(house.thickness);
        CAPTURE(limit);
        house.friction = limit * (1.0 + 1e-3);
        World stands = start(gallery::cards(house));
        go(stands, 2.0);
        CHECK(stood(stands));
        house.friction = limit * (1.0 - 1e-3);
        World falls = start(gallery::cards(house));
        go(falls, 6.0);
        CHECK(deepest_fall(falls) > 0.2);
    }
    RECORD_VALUE("gallery.cards.limit", statics::least_friction({1, 0.35, 0.4, 1.0, 0.02}));
}

TEST_CASE("a hopper lets out what is above its opening, loses nothing, and holds bodies apart")
{
    double overlap = 0.0;
    Random random(1403);
    for (int k = 0; k < tried(1); ++k) {
        gallery::Hopper hopper;
        hopper.count = 70;
        hopper.seed = 1 + static_cast<std::uint64_t>(k);
        hopper.polygons = k % 2 == 0;
        hopper.friction = random.uniform(0.1, 0.5);
        const Scene scene = gallery::hopper(hopper);
        Watched run = watch(scene, 8.0);
        CAPTURE(k);
        CHECK(run.rise < 1e-9);
        overlap = std::max(overlap, run.overlap / (hopper.size * 2.0 / 3.0));
        int out = 0;
        for (int i = 2; i < run.world.body_count(); ++i) {
            const Vec2 place = run.world.state(i).position;
            CHECK((place.x() > -2.0 && place.x() < 2.0 && place.y() > -2.5));
            out += place.y() < 0.0 ? 1 : 0;
        }
        CHECK(out > 60);
    }
    // An island of more than sixty-four bodies is swept, and what turning brings is taken off in the steps after
    CHECK(overlap < 0.03);
    RECORD_VALUE("gallery.hopper.overlap", overlap);
}

// [gallery.tests.chain]
TEST_CASE("hooks that hang in each other stay as they hang, and the uppermost bears the weight of all")
{
    double worst = 0.0;
    for (const int links : {1, 2, 12, 30}) {
        for (const double friction : {0.0, 0.3}) {
            gallery::Chain chain;
            chain.links = links;
            chain.friction = friction;
            const Scene scene = gallery::chain(chain);
            World world = start(scene);
            go(world, 2.0);
            CAPTURE(links);
            CHECK(stood(world));

            // The same bodies in the resting integrator by itself, which tells the forces
            RestEngine engine = statics::resting(scene);
            double weight = 0.0;
            for (int k = 1; k < engine.body_count(); ++k) weight += gallery::k_g / engine.body(k).inertia.inv_mass;
            for (int k = 0; k < 10; ++k) engine.step();
            double bears = 0.0;
            for (const RestContact& contact : engine.contacts()) {
                if (contact.a == 0 || contact.b == 0) bears += contact.normal_force;
            }
            worst = std::max(worst, std::abs(bears / weight - 1.0));
        }
    }
    CHECK(worst < 1e-12);
    RECORD_VALUE("gallery.chain.error", worst);
}
// [gallery.tests.chain]

TEST_CASE("a see-saw at its limit lies still, and with a millionth more on one side tips as the lever says")
{
    Random random(1404);
    double worst = 0.0;
    for (int k = 0; k < tried(6); ++k) {
        gallery::Seesaw seesaw;
        seesaw.top = random.uniform(0.1, 0.3);
        seesaw.left = random.uniform(1.0, 2.0);
        seesaw.right = random.uniform(1.0, 2.0);
        seesaw.load = random.uniform(1.0, 100.0);
        World stands = start(gallery::seesaw(seesaw));
        go(stands, 2.0);
        CHECK(stood(stands));
        seesaw.heavier = 1e-6;
        const Scene scene = gallery::seesaw(seesaw);
        World tips = start(scene);
        const double time = 1.0;
        go(tips, time);

        // All turn about the edge of the top as one, like a pendulum that stands on its head, from the torque of the millionth
        const Report report = tips.report();
        const Vec2 edge(seesaw.top, 0.0);
        double inertia = 0.0;
        double topples = 0.0; // torque for each radian that all have turned: the weight leans out [N m]
        for (std::size_t i = 1; i < scene.bodies.size(); ++i) {
            const BodyReport& body = report.bodies[i];
            inertia += body.moment_of_inertia + body.mass * (scene.bodies[i].position - edge).squaredNorm();
            topples += body.mass * gallery::k_g * scene.bodies[i].position.y();
        }
        const double torque = 1e-6 * gallery::limit_of(seesaw) * gallery::k_g * (seesaw.right - seesaw.top);
        const double angle = -torque / topples * (std::cosh(std::sqrt(topples / inertia) * time) - 1.0);
        worst = std::max(worst, std::abs(tips.state(1).angle / angle - 1.0));
    }
    CHECK(worst < 1e-4);
    RECORD_VALUE("gallery.seesaw.error", worst);
}

TEST_CASE("a wall struck by a ball gains nothing: on ice, all together keep the ball's momentum")
{
    Random random(1405);
    double overlap = 0.0;
    double drift = 0.0;
    for (int k = 0; k < tried(1); ++k) {
        gallery::BrickWall wall;
        wall.floor = k % 2 == 0 ? 0.0 : 0.6;
        wall.rows = 6 + random.below(4);
        wall.columns = 4 + random.below(2);
        wall.speed = random.uniform(5.0, 20.0);
        wall.mass = random.uniform(20.0, 80.0);
        wall.height = random.uniform(0.3, 0.8);
        Watched run = watch(gallery::brick_wall(wall), 1.5);
        CHECK(run.rise < 1e-9);
        overlap = std::max(overlap, run.overlap / 0.1);
        if (wall.floor > 0.0) continue;
        drift = std::max(drift, std::abs(run.world.report().momentum.x() / (wall.mass * wall.speed) - 1.0));
    }
    CHECK(drift < 1e-12);
    CHECK(overlap < 0.01);
    RECORD_VALUE("gallery.wall.drift", drift);
    RECORD_VALUE("gallery.wall.overlap", overlap);
}

TEST_CASE("shapes like an L that are poured out stay in the box, gain no energy, and hold each other apart")
{
    double overlap = 0.0;
    for (int k = 0; k < tried(1); ++k) {
        gallery::Pour pour;
        pour.count = 60;
        pour.width = 2.5;
        pour.seed = 1 + static_cast<std::uint64_t>(k);
        pour.restitution = k % 2 == 0 ? 0.1 : 0.0;
        Watched run = watch(gallery::pour(pour), 3.0);
        CHECK(run.rise < 1e-9);
        overlap = std::max(overlap, run.overlap / (0.5 * pour.arm));
        for (int i = 0; i < run.world.body_count(); ++i) {
            const Vec2 place = run.world.state(i).position;
            CHECK((place.x() > 0.0 && place.x() < pour.width && place.y() > 0.0));
        }
    }
    CHECK(overlap < 0.01);
    RECORD_VALUE("gallery.pour.overlap", overlap);
}
