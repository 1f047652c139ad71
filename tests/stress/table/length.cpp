// What takes hours: a share at a time, gone on with where the last one stopped.

#include <array>
#include <cmath>
#include <ctime>
#include <fstream>
#include <iterator>

#include <fmt/format.h>

#include "scene/generate.hpp"
#include "stress/random_pairs.hpp"
#include "table/trials.hpp"
#include "json/saved_run.hpp"

namespace flying::stress {
namespace {

/// Of computing, so that a busy machine takes nothing from a share.  [s]
double seconds_since(std::clock_t start)
{
    return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

/// Whole or not at all.
void write_text(const std::string& path, const std::string& text)
{
    {
        std::ofstream file(path + ".part", std::ios::binary);
        file << text;
        if (!file.flush()) throw std::runtime_error(path + ": can't be written");
    }
    if (std::rename((path + ".part").c_str(), path.c_str()) != 0) throw std::runtime_error(path + ": can't be renamed");
}

/// Seeds so far, and what came of them.
struct Roots
{
    std::uint64_t next = 1;
    std::uint64_t impacts = 0;
    std::uint64_t wrong = 0;
    std::uint64_t undecided = 0;
};

Reached missed_roots(const Share& share)
{
    constexpr std::uint64_t k_all = 1'000'000'000;
    const std::string path = share.folder + "/roots.txt";
    Roots roots;
    if (std::ifstream file(path); file) file >> roots.next >> roots.impacts >> roots.wrong >> roots.undecided;
    const auto keep = [&] {
        write_text(path, fmt::format("{} {} {} {}\n", roots.next, roots.impacts, roots.wrong, roots.undecided));
    };
    for (const auto start = std::clock(); roots.next <= k_all && seconds_since(start) < share.seconds;) {
        for (int k = 0; k < 2000; ++k, ++roots.next) {
            const RandomPair pair = random_pair(roots.next);
            const Verdict verdict = judge(pair, foresee(pair));
            roots.impacts += verdict.impact ? 1 : 0;
            if (verdict.undecided) ++roots.undecided;
            else if (!verdict.right) ++roots.wrong;
        }
        if (roots.next % 100'000 == 1) keep();
    }
    keep();
    Reached reached;
    reached.value = static_cast<double>(roots.wrong);
    reached.amount = fmt::format("{} pairs of {}, {} impacts", roots.next - 1, k_all, roots.impacts);
    reached.remark = fmt::format("{} that the dense search can't decide", roots.undecided);
    reached.is_whole = roots.next > k_all;
    return reached;
}

Reached long_gas(const Share& share)
{
    // Saved and gone on with by the very means of `flying simulate --save` and `--resume`
    constexpr std::int64_t k_all = 1'000'000'000;
    GenerateOptions options;
    options.seed = 12;
    options.count = 1024;
    options.packing = 0.3;
    options.rms_speed = 1.0;
    const Expected<Scene> made = generate("gas", options);
    if (!made) throw std::runtime_error(made.faults().front().found);
    const Scene& scene = made.value();
    const std::string path = share.folder + "/energy.run";
    WorldOptions exact;
    exact.engine = EngineChoice::events;
    World world = world_of(scene, exact);
    if (std::ifstream file(path, std::ios::binary); file) {
        const std::string text((std::istreambuf_iterator<char>(file)), {});
        const Expected<SavedRun> saved = read_saved_run_text(text, path, scene);
        if (!saved) throw std::runtime_error(path + ": " + saved.faults().front().found);
        Expected<World> resumed = World::resume(scene, saved.value().snapshot, saved.value().options);
        if (!resumed) throw std::runtime_error(path + ": " + resumed.faults().front().found);
        world = std::move(resumed).value();
    }
    auto kept = std::clock();
    for (const auto start = kept; world.collisions() < k_all && seconds_since(start) < share.seconds;) {
        if (const auto failure = world.advance(1e12, 200'000)) throw std::runtime_error(failure->message);
        if (seconds_since(kept) < 60.0) continue;
        write_text(path, write_saved_run(scene, exact, world.snapshot()));
        kept = std::clock();
    }
    write_text(path, write_saved_run(scene, exact, world.snapshot()));
    const Report report = world.report();
    Reached reached;
    reached.value = std::abs(report.energy.total() / report.initial_total - 1.0);
    reached.amount =
        fmt::format("{} collisions of {}, 1024 discs, {:.0f} s of their time", report.collisions, k_all, report.time);
    reached.remark = fmt::format("overlap at most {:.1e} m", report.max_overlap);
    reached.is_whole = report.collisions >= k_all;
    return reached;
}

constexpr std::array k_trials = {
    Trial{9, "first impacts, against a dense search", "impacts missed or wrong", 0.0, false, "", missed_roots},
    Trial{12, "energy over a billion collisions", "relative change", 4e-12, false, "", long_gas},
};

} // namespace

std::span<const Trial> trials_of_length()
{
    return k_trials;
}

} // namespace flying::stress
