#include "growth_sweep.hpp"

#include <malloc.h>

#include <cmath>
#include <filesystem>

#include "engine.hpp"
#include "machine.hpp"
#include "scene/read.hpp"
#include "scenes.hpp"
#include "world/world.hpp"

namespace flying::bench {
namespace {

constexpr double k_long = 0.5;     // a run of that length is made once [s]
constexpr double k_warning = 0.5;  // a peer that took this part may take ten times as long at the next size
constexpr double k_patience = 5.0; // so many times as long our own may take, to see how far they get
constexpr double k_short = 2e-3;   // a shorter one is made many at a time [s]

/// One series: a scene of any size, and how long of it is simulated.
struct Series
{
    std::string name;
    std::string title;
    std::string what;
    std::function<Scene(int)> scene;
    std::function<double(int)> until; ///< [s]
    int least = 10;
    int most_full = 1000000;
    int most_quick = 1000;
    int most_of_peers = 1000000;
    bool sleeps = false; ///< a second curve of ours, in which none may sleep, is worth while
};

/// Memory that the program has taken and not given back.  [B]
double memory_held()
{
    const auto info = mallinfo2();
    return static_cast<double>(info.uordblks + info.hblkhd);
}

Scene lying(const char* kind, const char* shape, int count)
{
    GenerateOptions options;
    options.seed = 5;
    options.count = count;
    if (shape) options.shape = shape;
    options.restitution = 0.0;
    options.friction = 0.5;
    return scene_of(kind, options);
}

/// Boxes side by side and on each other, three rows deep, which stand from the start.
Scene wall_of_boxes(int count)
{
    Scene scene;
    scene.title = "boxes at rest, three on each other";
    scene.world.field = UniformField{Vec2(0.0, -9.81)};
    scene.world.restitution = 0.0;
    scene.world.friction = 0.5;
    const int columns = (count + 2) / 3;
    for (int k = 0; k < count; ++k) {
        BodyDef box;
        box.shape = SquareDef{1.0};
        box.position = Vec2(0.5 + 1.25 * (k % columns), 0.5 + k / columns);
        scene.bodies.push_back(box);
    }
    scene.world.box = BoxDef{Vec2(-1.0, 0.0), Vec2(1.25 * columns + 1.0, 2.0 + count / columns + 2.0)};
    return scene;
}

std::vector<Series> all_series()
{
    const auto a_second = [](int) { return 1.0; };
    // The same number of impacts for each body, whatever the number
    const auto short_of_many = [](int count) { return count > 100000 ? 0.5 : 1.0; };
    return {{"discs", "discs of a gas, packing 0.3", "seconds for a second",
             [](int count) { return scene_of("gas", gas(count, 0.3)); }, short_of_many, 10, 1000000, 3000},
            {"polygons", "polygons of a gas, packing 0.2", "seconds for a second",
             [](int count) { return scene_of("gas", gas(count, 0.2, "polygon")); }, a_second, 10, 100000, 1000},
            {"at-rest", "boxes at rest, three on each other", "seconds for a second", wall_of_boxes, a_second, 10,
             100000, 3000, 10000, true},
            {"pile", "boxes that fall into a bin", "seconds for two seconds",
             [](int count) { return lying("pile", "box", count); }, [](int) { return 2.0; }, 10, 3162, 300},
            {"stack", "a stack of boxes", "seconds for a second",
             [](int count) { return lying("stack", nullptr, count); }, a_second, 1, 1000, 100, 1000, true}};
}

} // namespace

std::vector<std::string> growth_names()
{
    std::vector<std::string> names;
    for (const Series& series : all_series()) names.push_back(series.name);
    return names;
}

work::GrowthRecord grow(const std::string& name, Coarseness coarseness, double most, int repeats,
                        const std::function<void(const std::string&)>& tell)
{
    work::GrowthRecord record;
    for (const Series& series : all_series()) {
        if (series.name != name) continue;
        record.name = name;
        record.title = series.title;
        record.what = series.what;
        const std::vector<Engine> others = peers();
        std::vector<Engine> engines = {own_engine(false)};
        if (series.sleeps) engines.push_back(own_awake());
        for (const Engine& peer : others) {
            if (peer.name == "Chipmunk" || peer.name == "Box2D") engines.push_back(peer);
        }
        std::vector<bool> is_over(engines.size(), false);
        const int largest = coarseness == Coarseness::full ? series.most_full : series.most_quick;
        const double ratio = coarseness == Coarseness::full ? std::sqrt(10.0) : 10.0;
        for (double size = series.least; size <= 1.01 * largest; size *= ratio) {
            const int count = static_cast<int>(std::lround(size));
            const Scene scene = series.scene(count);
            const double until = series.until(count);
            std::vector<std::vector<double>> times(engines.size());
            for (int repeat = 0; repeat < repeats; ++repeat) {
                for (std::size_t k = 0; k < engines.size(); ++k) {
                    if (is_over[k] && times[k].empty()) continue;
                    if (work::is_peer(engines[k].name) && count > series.most_of_peers) continue;
                    if (repeat > 0 && (times[k].empty() || times[k].back() > 0.1 * most)) continue; // long runs once
                    tell("growth-" + name + ": " + engines[k].name + ", " + std::to_string(count));
                    const double held = memory_held();
                    const Run run = engines[k].start(scene, {60.0});
                    const double start = cpu_seconds();
                    run.advance(until);
                    times[k].push_back(cpu_seconds() - start);
                    record.bytes_per_body[engines[k].name] = (memory_held() - held) / count;
                    if (times[k].back() > (work::is_peer(engines[k].name) ? k_warning * most : k_patience * most))
                        is_over[k] = true;
                }
            }
            for (std::size_t k = 0; k < engines.size(); ++k) {
                if (times[k].empty()) continue;
                // Runs over a part of the time are counted as over the whole
                const double seconds = work::spread_of(times[k]).median * series.until(series.least) / until;
                record.curves[engines[k].name].push_back({static_cast<double>(count), seconds});
            }
        }
    }
    return record;
}

work::SkipsRecord weigh_skips(const std::string& path, double until, int repeats,
                              const std::function<void(const std::string&)>& tell)
{
    const Scene scene = read_scene_file(path).value();
    const double end = std::min(until, scene.until);
    work::SkipsRecord record{std::filesystem::path(path).stem().string(), end, {}};
    const auto start = [&](const std::string& without) {
        WorldOptions options;
        if (!without.empty()) options.without = {without};
        return World::make(scene, options).value();
    };

    // Once each, to see the bits and what is saved; then in turn those that are short
    std::vector<std::string> names = {""};
    for (const Skip& skip : make_plan(scene).skips) {
        if (skip.active) names.push_back(skip.name);
    }
    std::uint64_t bits = 0;
    std::vector<Skip> saved;
    std::vector<work::Prepare> prepares;
    std::vector<std::size_t> of_entry;
    std::vector<int> copies_of;
    for (const std::string& name : names) {
        tell("skips of " + record.scene + ": without " + (name.empty() ? "none" : name));
        World world = start(name);
        const double began = cpu_seconds();
        static_cast<void>(world.advance(end));
        const double took = cpu_seconds() - began;
        const Report report = world.report();
        work::SkipsRecord::Entry entry;
        entry.without = name;
        if (name.empty()) {
            bits = report.hash;
            saved = report.plan.skips;
        }
        for (const Skip& skip : saved) {
            if (skip.name != name) continue;
            entry.saved = skip.saved;
            entry.alters = skip.kind == SkipClass::altering;
        }
        entry.same_bits = report.hash == bits;
        entry.seconds = {took, took, took};
        record.entries.push_back(entry);
        if (took > k_long) continue;
        of_entry.push_back(record.entries.size() - 1);
        const int copies = static_cast<int>(std::clamp(std::ceil(k_short / std::max(took, 1e-9)), 1.0, 1000.0));
        copies_of.push_back(copies);
        prepares.push_back([&, name, copies] {
            const auto worlds = std::make_shared<std::vector<World>>();
            for (int k = 0; k < copies; ++k) worlds->push_back(start(name));
            return [worlds, end] {
                for (World& each : *worlds) static_cast<void>(each.advance(end));
            };
        });
    }
    std::vector<std::vector<double>> times = work::time_in_turn(prepares, repeats, cpu_seconds);
    for (std::size_t k = 0; k < of_entry.size(); ++k) {
        for (double& time : times[k]) time /= copies_of[k];
        record.entries[of_entry[k]].seconds = work::spread_of(times[k]);
    }
    return record;
}

} // namespace flying::bench
