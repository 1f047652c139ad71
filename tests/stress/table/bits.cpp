// The same result whatever is asked, saved, renamed or compiled.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <map>
#include <memory>
#include <numeric>
#include <regex>

#include <fmt/format.h>

#include "math/random.hpp"
#include "rest_trial.hpp"
#include "scene/generate.hpp"
#include "stress/random_scenes.hpp"
#include "table/trials.hpp"
#include "json/saved_run.hpp"

namespace flying::stress {
namespace {

/// A scene that comes to rest: discs and polygons that fall into a bin.
Scene settling(std::uint64_t seed)
{
    GenerateOptions options;
    options.seed = seed;
    options.count = 12;
    options.until = 2.0;
    options.shape = seed % 2 == 0 ? "disc" : "polygon";
    const Expected<Scene> scene = generate("pile", options);
    if (!scene) throw std::runtime_error(scene.faults().front().found);
    return scene.value();
}

/// Random scenes in flight, and every third one that comes to rest.
Scene any_scene(std::uint64_t seed)
{
    return seed % 3 == 0 ? settling(seed) : random_scene(seed);
}

Reached intervals(const Share&)
{
    Reached reached;
    constexpr std::uint64_t k_scenes = 40;
    std::int64_t impacts = 0;
    for (std::uint64_t seed = 1; seed <= k_scenes; ++seed) {
        // Everything a million times as fast where it flies, so that a look every nanosecond comes to an end
        Scene scene = any_scene(seed);
        const bool flies = seed % 3 != 0 && !std::holds_alternative<CentralField>(scene.world.field);
        if (flies) {
            for (BodyDef& body : scene.bodies) {
                body.velocity *= 1e6;
                body.spin *= 1e6;
            }
            if (auto* field = std::get_if<UniformField>(&scene.world.field)) field->gravity *= 1e12;
            scene.until = 4e-6;
        }
        World whole = world_of(scene);
        const bool failed = whole.advance(scene.until, 100'000).has_value();
        impacts += whole.collisions();
        for (const double interval : {1e-9, 3.7e-8, 1e-3, 1e3}) {
            if (scene.until / interval > 1e5) continue;
            World asked = world_of(scene);
            bool stopped = false;
            for (double time = interval; time < scene.until && !stopped; time += interval) {
                stopped = asked.advance(time).has_value();
                for (int body = 0; body < asked.body_count(); ++body) (void)asked.state(body);
            }
            if (!stopped) stopped = asked.advance(scene.until).has_value();
            const bool same =
                stopped == failed && asked.log_hash() == whole.log_hash() && asked.report().hash == whole.report().hash;
            reached.value += same ? 0.0 : 1.0;
        }
    }
    reached.amount = fmt::format("{} scenes, looked at every 1e-9 to 1e3 s, {} impacts", k_scenes, impacts);
    return reached;
}

Reached permuted(const Share&)
{
    // Eight pairs, discs and squares, that meet at one moment
    Scene scene;
    for (int k = 0; k < 8; ++k) {
        for (const double side : {-1.0, 1.0}) {
            const Vec2 place(2.0 * side, 4.0 * k + 0.1 * side);
            scene.bodies.push_back(k % 2 == 0 ? disc(0.5, place, {-side, 0.0})
                                              : rectangle(1.0, 1.0, place, {-side, 0.0}));
        }
    }
    World plain = events_of(scene);
    run_to(plain, 5.0);
    Reached reached;
    Random random(16);
    constexpr int k_orders = 500;
    for (int k = 0; k < k_orders; ++k) {
        std::vector<int> order(scene.bodies.size());
        std::iota(order.begin(), order.end(), 0);
        for (int i = static_cast<int>(order.size()) - 1; i > 0; --i)
            std::swap(order[static_cast<std::size_t>(i)], order[static_cast<std::size_t>(random.below(i + 1))]);
        Scene other = scene;
        for (std::size_t i = 0; i < order.size(); ++i)
            other.bodies[i] = scene.bodies[static_cast<std::size_t>(order[i])];
        World renamed = events_of(other);
        run_to(renamed, 5.0);
        bool same = renamed.collisions() == plain.collisions();
        for (int i = 0; i < renamed.body_count(); ++i) {
            const BodyState one = renamed.state(i);
            const BodyState two = plain.state(order[static_cast<std::size_t>(i)]);
            same = same && one.position == two.position && one.velocity == two.velocity && one.spin == two.spin;
        }
        reached.value += same ? 0.0 : 1.0;
    }
    reached.amount = fmt::format("eight impacts at one time, {} orders of the bodies", k_orders);
    return reached;
}

/// The world goes on from the text of a file.
World through_text(const World& world, const WorldOptions& options)
{
    const Scene& scene = world.scene();
    const Expected<SavedRun> read =
        read_saved_run_text(write_saved_run(scene, options, world.snapshot()), "saved", scene);
    if (!read) throw std::runtime_error("a saved run can't be read");
    Expected<World> again = World::resume(scene, read.value().snapshot, read.value().options);
    if (!again) throw std::runtime_error("a saved run can't be gone on with");
    return std::move(again).value();
}

Reached resumed(const Share&)
{
    Reached reached;
    constexpr std::uint64_t k_scenes = 300;
    int compared = 0;
    int stops = 0;
    for (std::uint64_t seed = 1; seed <= k_scenes; ++seed) {
        const Scene scene = any_scene(seed);
        for (const EngineChoice engine : {EngineChoice::automatic, EngineChoice::rest}) {
            WorldOptions options;
            options.engine = engine;
            if (engine == EngineChoice::rest && seed % 3 != 0) continue; // steps are for what leans
            World whole = world_of(scene, options);
            if (whole.advance(scene.until, 20'000) || whole.time() < scene.until) continue;
            // Once at one of three moments, and twelve times on the way
            const std::vector<std::vector<double>> ways = {
                {0.1}, {0.37}, {0.8}, {0.05, 0.1, 0.2, 0.21, 0.3, 0.4, 0.5, 0.55, 0.6, 0.7, 0.9, 0.99}};
            for (const std::vector<double>& parts : ways) {
                World world = world_of(scene, options);
                for (const double part : parts) {
                    (void)world.advance(part * scene.until);
                    world = through_text(world, options);
                    ++stops;
                }
                (void)world.advance(scene.until);
                const bool same = world.report().hash == whole.report().hash;
                reached.value += same ? 0.0 : 1.0;
                if (!same && reached.remark.empty())
                    reached.remark =
                        fmt::format("first: scene {}, {}, stopped at {} and {} times more", seed,
                                    engine == EngineChoice::rest ? "by steps" : "auto", parts[0], parts.size() - 1);
                ++compared;
            }
        }
    }
    reached.amount =
        fmt::format("{} runs of {} scenes, stopped {} times, through the text of a file", compared, k_scenes, stops);
    return reached;
}

std::string output_of(const std::string& command)
{
    std::string text;
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> pipe(popen(command.c_str(), "r"), pclose);
    if (!pipe) return text;
    char part[256];
    while (std::fgets(part, sizeof part, pipe.get())) text += part;
    return text;
}

Reached compilers(const Share&)
{
    // Those that are built: ./course test --matrix builds them all, WebAssembly among them
    const std::filesystem::path root = FLYING_SOURCE_DIR;
    std::vector<std::string> builds;
    for (const auto& folder : std::filesystem::directory_iterator(root / "build")) {
        if (std::filesystem::exists(folder.path() / "bin/flying")) builds.push_back(folder.path().filename().string());
    }
    std::sort(builds.begin(), builds.end());
    if (builds.size() < 2)
        throw std::runtime_error("fewer than two programs are built: run ./course test --matrix first");
    std::string command = fmt::format("'{}/tests/differential/bits/compare_hashes.sh'", root.string());
    for (const std::string& build : builds) command += fmt::format(" '{}/build/{}/bin/flying'", root.string(), build);
    const std::string said = output_of(command);
    std::smatch found;
    if (!std::regex_search(said, found, std::regex("([0-9]+) scenes agree, ([0-9]+) differ")))
        throw std::runtime_error("the comparison says nothing");
    Reached reached;
    reached.value = std::stod(found[2]);
    reached.amount =
        fmt::format("{} scenes by {} programs: {}", found[1].str(), builds.size(), fmt::join(builds, ", "));
    return reached;
}

Reached fuzzed(const Share&)
{
    // A line for each run of the fuzzer: what it made, how many inputs, in how many seconds, and whether all was well
    std::ifstream file(FLYING_SOURCE_DIR "/out/fuzz/runs.txt");
    if (!file) throw std::runtime_error("the fuzzer has not run: ./course stress fuzz");
    std::map<std::string, bool> was_well; // the last run of each kind that was not just slow
    std::map<std::string, double> inputs;
    double seconds = 0.0;
    std::string kind;
    std::string verdict;
    double some = 0.0;
    for (double lasted = 0.0; file >> kind >> some >> lasted >> verdict;) {
        if (verdict != "slow") was_well[kind] = verdict == "well";
        inputs[kind] += some;
        seconds += lasted;
    }
    Reached reached;
    for (const auto& [name, well] : was_well) reached.value += well ? 0.0 : 1.0;
    reached.amount = fmt::format("{:.0f} texts and {:.0f} scenes in {:.1f} hours, with sanitizers", inputs["text"],
                                 inputs["world"], seconds / 3600.0);
    return reached;
}

constexpr std::array k_trials = {
    Trial{13, "looked at every 1e-9 to 1e3 s", "runs with other bits", 0.0, false, "the interval changes the result",
          intervals},
    Trial{16, "impacts at one time, bodies renumbered", "orders with other bits", 0.0, false, "the order shows",
          permuted},
    Trial{17, "compilers, levels, WebAssembly", "scenes with other bits", 0.0, false,
          "Box2D 3 and Rapier promise it, too", compilers},
    Trial{18, "bytes from a fuzzer", "kinds of input with a finding", 0.0, false, "", fuzzed},
    Trial{20, "stopped, saved, resumed", "runs with other bits", 0.0, false, "Rapier saves a whole world, too",
          resumed},
};

} // namespace

std::span<const Trial> trials_of_bits()
{
    return k_trials;
}

} // namespace flying::stress
