#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "collide/separation.hpp"
#include "literature/disc_gas.hpp"
#include "math/random.hpp"
#include "stress/random_scenes.hpp"
#include "stress/reversal.hpp"
#include "support/worlds.hpp"
#include "world/world.hpp"

using namespace flying;
using namespace flying::testing;
using namespace flying::stress;

namespace {

/// 0 ... count - 1 in a random order.
std::vector<int> shuffled(Random& random, int count)
{
    std::vector<int> order(static_cast<std::size_t>(count));
    std::iota(order.begin(), order.end(), 0);
    for (int k = count - 1; k > 0; --k) std::swap(order[k], order[random.below(k + 1)]);
    return order;
}

/// The scene with its bodies in another order: body k is the one that was order[k].
Scene reordered(const Scene& scene, const std::vector<int>& order)
{
    Scene other = scene;
    for (std::size_t k = 0; k < order.size(); ++k) other.bodies[k] = scene.bodies[static_cast<std::size_t>(order[k])];
    return other;
}

} // namespace

// ---- Impacts at one time
// -----------------------------------------------------------------------------------------------

TEST_CASE("a ball that meets two at one time throws both aside alike, whoever is listed first")
{
    // Along normals 30 degrees to either side, with e: the ball is left with a part of its speed, the two share the
    // rest. Compression ends both approaches, p = cos 30 (1 - 2 p cos 30) for masses of 1, and (1 + e) p is given back
    for (const double e : {1.0, 0.5}) {
        for (const bool upper_is_first : {true, false}) {
            const double up = upper_is_first ? 0.5 : -0.5;
            Scene scene;
            scene.world.restitution = e;
            scene.bodies = {disc(0.5, {-2.0, 0.0}, {1.0, 0.0}), disc(0.5, {0.0, up}), disc(0.5, {0.0, -up})};
            World world = events_of(scene);
            REQUIRE_FALSE(world.advance(10.0).has_value());
            CHECK(world.collisions() == 2);
            CHECK((world.state(1).velocity - (1.0 + e) * Vec2(0.3, up * 0.2 * std::sqrt(3.0))).norm() <= 1e-14);
            CHECK((world.state(2).velocity - (1.0 + e) * Vec2(0.3, -up * 0.2 * std::sqrt(3.0))).norm() <= 1e-14);
            CHECK((world.state(0).velocity - Vec2(1.0 - 0.6 * (1.0 + e), 0.0)).norm() <= 1e-14);
        }
    }
}

TEST_CASE("impacts at one time that share no body don't care for the order of ids, bit for bit")
{
    // Eight pairs far apart meet at one moment, discs and squares
    Scene scene;
    for (int k = 0; k < 8; ++k) {
        const double y = 4.0 * k;
        const bool round = k % 2 == 0;
        for (const double side : {-1.0, 1.0}) {
            BodyDef body =
                round ? disc(0.5, {2.0 * side, y + 0.1 * side}) : rectangle(1.0, 1.0, {2.0 * side, y + 0.1 * side});
            body.velocity = {-side, 0.0};
            scene.bodies.push_back(body);
        }
    }
    World plain = events_of(scene);
    REQUIRE_FALSE(plain.advance(5.0).has_value());
    CHECK(plain.collisions() == 8);
    Random random(11);
    for (int k = 0; k < 20; ++k) {
        const std::vector<int> order = shuffled(random, 16);
        World other = events_of(reordered(scene, order));
        REQUIRE_FALSE(other.advance(5.0).has_value());
        for (int body = 0; body < 16; ++body) {
            CHECK(other.state(body).position == plain.state(order[body]).position);
            CHECK(other.state(body).velocity == plain.state(order[body]).velocity);
            CHECK(other.state(body).spin == plain.state(order[body]).spin);
        }
    }
}

TEST_CASE("the order of ids changes no bit of a gas of discs, whose impacts never fall together")
{
    Random random(12);
    std::int64_t collisions = 0;
    for (std::uint64_t seed = 1; seed <= 90; ++seed) {
        if (kind_of(seed) != SceneKind::discs && kind_of(seed) != SceneKind::crowd) continue;
        const Scene scene = random_scene(seed);
        const int count = static_cast<int>(scene.bodies.size());
        World plain = events_of(scene);
        if (plain.advance(scene.until)) continue;
        const std::vector<int> order = shuffled(random, count);
        World other = events_of(reordered(scene, order));
        REQUIRE_FALSE(other.advance(scene.until).has_value());
        INFO("scene " << seed << ", " << plain.collisions() << " collisions");
        CHECK(other.collisions() == plain.collisions());
        for (int body = 0; body < count; ++body) {
            CHECK(other.state(body).position == plain.state(order[body]).position);
            CHECK(other.state(body).velocity == plain.state(order[body]).velocity);
        }
        collisions += plain.collisions();
    }
    CHECK(collisions > 500);
}

TEST_CASE("a blow runs through a chain of touching balls to its end, whatever their ids")
{
    Random random(13);
    for (int k = 0; k < 30; ++k) {
        Scene line;
        line.bodies.push_back(disc(0.5, {-3.0, 0.0}, {1.0, 0.0}));
        for (int ball = 0; ball < 20; ++ball) line.bodies.push_back(disc(0.5, {static_cast<double>(ball), 0.0}));
        const std::vector<int> order =
            k == 0 ? std::vector<int>{20, 19, 18, 17, 16, 15, 14, 13, 12, 11, 10, 9, 8, 7, 6, 5, 4, 3, 2, 1, 0}
                   : shuffled(random, 21);
        World world = events_of(reordered(line, order));
        REQUIRE_FALSE(world.advance(10.0).has_value());
        CHECK(world.collisions() == 20);
        for (int body = 0; body < 21; ++body)
            CHECK(world.state(body).velocity == Vec2(order[body] == 20 ? 1.0 : 0.0, 0.0));
    }
}

// ---- Grazing
// ----------------------------------------------------------------------------------------------------------

TEST_CASE(
    "a disc that passes at exactly the sum of the radii is left alone, and a graze by rounding keeps all but rounding")
{
    for (const double miss : {0.0, 1e-16, 1e-15, 1e-12, 1e-9}) {
        Scene scene;
        scene.bodies = {disc(0.5, {-3.0, 1.0 - miss}, {1.0, 0.0}), disc(0.5, {0.0, 0.0})};
        World world = events_of(scene);
        REQUIRE_FALSE(world.advance(10.0).has_value());
        INFO("miss " << miss << ", " << world.collisions() << " collisions");
        // The normal speed of a graze is sqrt(2 miss); what it hands on is no more
        const double handed = world.state(1).velocity.norm();
        CHECK(handed <= std::sqrt(2.0 * miss) + 1e-8 * (miss > 0.0 ? 1.0 : 0.0));
        const Report report = world.report();
        CHECK(std::abs(report.energy.total() / report.initial_total - 1.0) <= 4e-16);
        CHECK(report.max_overlap <= 1e-15);
    }
}

// ---- Long times, high and low speeds -------------------------------------------------------------------------------

TEST_CASE("after a billion seconds a ball is where unfolding says, to the rounding of the clock")
{
    // Dyadic numbers: 25,000 bounces of two speeds, every one at a time that is a double
    Scene scene;
    scene.world.box = BoxDef{{0.0, 0.0}, {65537.0, 32769.0}};
    scene.bodies = {disc(0.5, {100.5, 200.5}, {1.0, 0.5})};
    World world = events_of(scene);
    const double until = 1e9;
    REQUIRE_FALSE(world.advance(until).has_value());
    const auto fold = [](double x, double length) {
        const double turns = std::floor(x / length);
        const double rest = x - turns * length;
        return std::fmod(turns, 2.0) == 0.0 ? rest : length - rest;
    };
    CHECK(world.state(0).position.x() == 0.5 + fold(100.0 + until, 65536.0));
    CHECK(world.state(0).position.y() == 0.5 + fold(200.0 + 0.5 * until, 32768.0));
    CHECK(world.collisions() ==
          static_cast<long>(std::floor((100.0 + until) / 65536.0) + std::floor((200.0 + 0.5 * until) / 32768.0)));

    // A gas that starts its clock there keeps its energy and never overlaps by more than the clock allows
    std::vector<EventBody> bodies;
    gas::Gas box = gas::make_gas({8, 0.3, 1.0, 5});
    for (int k = 0; k < box.engine.body_count(); ++k) {
        Flyer flyer = box.engine.flyer(k);
        flyer.state.time = k < box.count ? 1e9 : 0.0;
        bodies.push_back({box.engine.shape(k), flyer, box.engine.inertia(k), {1.0, 0.0}, k >= box.count});
    }
    EventEngine late(std::move(bodies), {});
    REQUIRE_FALSE(late.advance(1e9 + 50.0, -1).has_value());
    double energy = 0.0;
    for (int k = 0; k < box.count; ++k) energy += 0.5 * late.flyer(k).state.velocity.squaredNorm();
    CHECK(late.counts().impacts > 1000);
    CHECK(energy == doctest::Approx(box.count).epsilon(1e-12));
    CHECK(late.max_overlap() <= 8.0 * 1.2e-7); // half an ulp of 1e9 s is 6e-8 s, at a few diameters a second
}

TEST_CASE(
    "at a million sizes a second nothing leaves a room whose walls are a billionth thick, for four thousand bounces")
{
    // They take 0.04 s. From 0.1 s on the clock's rounding, 1e-17 s, lets such a body move by a hundredth of the wall's
    // thickness: nothing passes even then, but an impact can't tell the two faces of the wall apart any more
    constexpr long k_bounces = 4'000;
    for (const bool round : {true, false}) {
        // The corners of the room are left open by gaps that no body fits through
        Scene scene;
        const double t = 1e-9;
        scene.bodies = {still(rectangle(t, 10.9, {-5.0, 0.0})), still(rectangle(t, 10.9, {5.0, 0.0})),
                        still(rectangle(9.9, t, {0.0, -5.5})), still(rectangle(9.9, t, {0.0, 5.5}))};
        BodyDef body = round ? disc(0.5, {0.3, 0.2}) : rectangle(1.0, 0.6, {0.3, 0.2});
        body.velocity = {1e6, 0.61803e6};
        if (!round) body.spin = 1e6;
        scene.bodies.push_back(body);
        World world = events_of(scene);
        while (world.collisions() < k_bounces) {
            const auto failure = world.advance(1.0, 500);
            REQUIRE_FALSE(failure.has_value());
            const Vec2 position = world.state(4).position;
            REQUIRE(std::abs(position.x()) < 5.0);
            REQUIRE(std::abs(position.y()) < 5.5);
            REQUIRE(world.time() < 1.0);
        }
        const Report report = world.report();
        CHECK(std::abs(report.energy.total() / report.initial_total - 1.0) <= 1e-11);
        CHECK(report.max_overlap <= 1e-9);
    }
}

TEST_CASE("bodies at speeds from 1e-12 to 1e6 sizes a second share one box, and none overlaps")
{
    Scene scene;
    scene.world.box = BoxDef{{0.0, 0.0}, {12.0, 12.0}};
    Random random(14);
    for (int k = 0; k < 16; ++k) {
        BodyDef body = k % 2 == 0 ? disc(0.4, Vec2::Zero()) : rectangle(0.8, 0.5, Vec2::Zero());
        body.position = 3.0 * Vec2(k % 4 + 0.5, k / 4 + 0.5);
        const double way = random.uniform(0.0, 6.3);
        // Heavy where slow, so that speeds stay apart
        const double speed = std::pow(10.0, k == 5 ? 6.0 : -12.0 + 0.5 * k);
        body.velocity = speed * Vec2(std::cos(way), std::sin(way));
        body.density = k == 5 ? 1e-6 : 1e3;
        scene.bodies.push_back(body);
    }
    World world = events_of(scene);
    for (int k = 1; k <= 20; ++k) {
        REQUIRE_FALSE(world.advance(5e-5 * k).has_value());
        const Report report = world.report();
        CHECK(report.max_overlap <= 1e-11);
        CHECK(std::abs(report.energy.total() / report.initial_total - 1.0) <= 1e-12);
    }
    CHECK(world.collisions() > 50);
}

// ---- What stays, at every event
// ----------------------------------------------------------------------------------------

TEST_CASE(
    "every impact of a gas keeps momentum, angular momentum and energy of its pair to a few units in the last place")
{
    gas::Gas box = gas::make_gas({16, 0.4, 1.0, 6});
    std::vector<BodyState> before(static_cast<std::size_t>(box.count));
    for (int k = 0; k < box.count; ++k) before[static_cast<std::size_t>(k)] = box.engine.flyer(k).state;
    double worst_momentum = 0.0;
    double worst_energy = 0.0;
    double worst_turning = 0.0;
    std::int64_t impacts = 0;
    while (impacts < 20'000) {
        REQUIRE_FALSE(box.engine.advance(1e9, 1).has_value());
        if (box.engine.counts().impacts == impacts) continue;
        impacts = box.engine.counts().impacts;
        const Event& event = box.engine.last_impacts().back();
        const auto a = static_cast<std::size_t>(event.a);
        const auto b = static_cast<std::size_t>(event.b);
        const BodyState now_a = box.engine.flyer(event.a).state;
        if (event.b < box.count) {
            const BodyState now_b = box.engine.flyer(event.b).state;
            const double speed = before[a].velocity.norm() + before[b].velocity.norm();
            const Vec2 momentum = now_a.velocity + now_b.velocity - before[a].velocity - before[b].velocity;
            const double energy = now_a.velocity.squaredNorm() + now_b.velocity.squaredNorm() -
                                  before[a].velocity.squaredNorm() - before[b].velocity.squaredNorm();
            const double turning = cross(now_a.position, Vec2(now_a.velocity - before[a].velocity)) +
                                   cross(now_b.position, Vec2(now_b.velocity - before[b].velocity));
            worst_momentum = std::max(worst_momentum, momentum.norm() / speed);
            worst_energy = std::max(worst_energy, std::abs(energy) / (speed * speed));
            worst_turning = std::max(worst_turning, std::abs(turning) / (speed * box.width));
            before[b] = now_b;
        } else {
            worst_energy = std::max(worst_energy, std::abs(now_a.velocity.norm() / before[a].velocity.norm() - 1.0));
        }
        before[a] = now_a;
    }
    MESSAGE("momentum " << worst_momentum << ", energy " << worst_energy << ", angular momentum " << worst_turning);
    // A few roundings of speeds; the normal is a unit vector to rounding, and positions are rounded to the box's width
    CHECK(worst_momentum <= 4e-16);
    CHECK(worst_energy <= 1e-15);
    CHECK(worst_turning <= 1e-15);
}

TEST_CASE("1024 discs thrown back after 10 collisions each end where they began, to 1e-6 of their size")
{
    const Reversal found = reverse_gas(32, 10.0, 1);
    MESSAGE("at most " << found.farthest << " diameters from the start");
    CHECK_FALSE(found.failed);
    CHECK(found.collisions >= 10.0);
    CHECK(found.farthest <= 1e-6);
    // Not so far back that nothing had happened
    CHECK(found.farthest > 0.0);
}

TEST_CASE("seen from a train that passes by, bodies meet at the same times and part with the same velocities")
{
    int compared = 0;
    for (std::uint64_t seed = 1; seed <= 200; ++seed) {
        Scene scene = random_scene(seed);
        scene.world.box.reset();
        scene.world.friction = 0.0;
        const bool has_statics =
            std::any_of(scene.bodies.begin(), scene.bodies.end(), [](const BodyDef& body) { return body.is_static; });
        if (has_statics || kind_of(seed) == SceneKind::central) continue;
        const Vec2 train(3.0, -1.25);
        Scene moving = scene;
        for (BodyDef& body : moving.bodies) body.velocity += train;
        World plain = events_of(scene);
        World other = events_of(moving);
        double size = 0.0;
        for (const BodyDef& body : scene.bodies) size = std::max(size, body.velocity.norm());
        // Few impacts, before roundings have grown
        const auto stop = [](World& world) {
            while (world.collisions() < 6 && world.time() < world.scene().until)
                (void)world.advance(world.scene().until, 1);
        };
        stop(plain);
        if (plain.collisions() < 6) continue;
        const double time = plain.time();
        REQUIRE_FALSE(other.advance(time * (1.0 + 1e-9)).has_value());
        REQUIRE_FALSE(plain.advance(time * (1.0 + 1e-9)).has_value());
        if (plain.collisions() != 6) continue;
        ++compared;
        INFO("scene " << seed);
        CHECK(other.collisions() == plain.collisions());
        for (int body = 0; body < plain.body_count(); ++body) {
            CHECK((other.state(body).velocity - plain.state(body).velocity - train).norm() <= 1e-9 * (size + 3.0));
        }
    }
    MESSAGE(compared << " scenes compared");
    CHECK(compared >= 10);
}

TEST_CASE("a gas in gravity presses on its floor with its weight")
{
    // Momentum handed to floor and ceiling in a long time is the weight's, but for what the gas itself holds in the end
    std::vector<EventBody> bodies;
    gas::Gas box = gas::make_gas({10, 0.2, 1.0, 7});
    const double g = 0.1;
    for (int k = 0; k < box.engine.body_count(); ++k) {
        Flyer flyer = box.engine.flyer(k);
        if (k < box.count) flyer.acceleration = {0.0, -g};
        bodies.push_back({box.engine.shape(k), flyer, box.engine.inertia(k), {1.0, 0.0}, k >= box.count});
    }
    EventEngine engine(std::move(bodies), {});
    const auto momentum = [&] {
        double sum = 0.0;
        for (int k = 0; k < box.count; ++k) sum += state_at(engine.flyer(k), engine.time()).velocity.y();
        return sum;
    };
    const double start = momentum();
    std::vector<BodyState> before(static_cast<std::size_t>(box.count));
    for (int k = 0; k < box.count; ++k) before[static_cast<std::size_t>(k)] = engine.flyer(k).state;
    const double until = 400.0;
    double handed = 0.0;
    std::int64_t impacts = 0;
    while (engine.time() < until) {
        REQUIRE_FALSE(engine.advance(until, 1).has_value());
        if (engine.counts().impacts == impacts) continue;
        impacts = engine.counts().impacts;
        const Event& event = engine.last_impacts().back();
        for (const int body : {event.a, event.b}) {
            if (body >= box.count) continue;
            const auto k = static_cast<std::size_t>(body);
            const BodyState now = engine.flyer(body).state;
            const double free = before[k].velocity.y() - g * (now.time - before[k].time);
            if (event.b >= box.count) handed += now.velocity.y() - free;
            before[k] = now;
        }
    }
    const double weight = box.count * g;
    CHECK(handed + start - momentum() == doctest::Approx(weight * until).epsilon(1e-12));
    // What the gas may hold: its momentum then, a few times the square root of the count
    CHECK(handed / until == doctest::Approx(weight).epsilon(5.0 * std::sqrt(box.count) / (weight * until)));
}

TEST_CASE("whether it is asked every nanosecond or once in a thousand seconds, a run has the same bits")
{
    // Everything a million times as fast: ten microseconds hold as much as ten seconds do else
    for (const std::uint64_t seed : {1u, 2u, 3u, 4u}) {
        Scene scene = random_scene(seed);
        constexpr double k_faster = 1e6;
        for (BodyDef& body : scene.bodies) {
            body.velocity *= k_faster;
            body.spin *= k_faster;
        }
        if (auto* field = std::get_if<UniformField>(&scene.world.field)) field->gravity *= k_faster * k_faster;
        scene.until = 8e-6;
        World whole = events_of(scene);
        const bool crowded = whole.advance(scene.until).has_value();
        const std::uint64_t hash = whole.report().hash;
        REQUIRE(whole.collisions() > 5);
        for (const double interval : {1e-9, 3.7e-8, 1e-6, 1e3}) {
            World world = events_of(scene);
            bool other = false;
            for (double time = interval; time < scene.until && !other; time += interval) {
                other = world.advance(time).has_value();
                for (int body = 0; body < world.body_count(); ++body) (void)world.state(body);
            }
            if (!other) other = world.advance(scene.until).has_value();
            INFO("scene " << seed << " every " << interval << " s");
            CHECK(other == crowded);
            CHECK(world.log_hash() == whole.log_hash());
            CHECK(world.report().hash == hash);
        }
    }
}
